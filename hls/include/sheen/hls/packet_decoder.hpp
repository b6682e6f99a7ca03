// SPDX-License-Identifier: MIT
/// \file
/// packet_decoder: beats of the setup stream in, jobs (triangles and messages) out, in order.
///
/// One step is one clock. While a triangle is drawn, the words of the next one fill `words` (double-buffered setup);
/// a complete packet raises job.valid until the edge walker takes it. The header of the packet after that is taken in
/// the meantime, so a stream that is never late costs no clock between packets.
///
/// The header is judged in two clocks while the payload arrives; a message waits for the packet's last beat.
///
/// Framing: every beat but the last is full, the last one holds exactly the words that the header announces and carries
/// `last`. Anything else, an unknown opcode, or a length or flag that the core can't serve gives one message and is
/// skipped up to the next `last`; what stands before and after it is not touched.
///
/// Formats: docs/packet-protocol.md. Latency: 1. Source: Sheen's own protocol.
#pragma once

#include <cstddef>
#include <utility>

#include "sheen/hls/types.hpp"

namespace sheen::hls {

/// \tparam words_per_beat stream width in words: 1, 2 or 4
/// \tparam has_depth      the core has a depth channel
/// \tparam has_quadratic  the core has second-order colour channels
template <int words_per_beat, bool has_depth, bool has_quadratic>
struct packet_decoder {
    static_assert(words_per_beat == 1 || words_per_beat == 2 || words_per_beat == 4,
                  "stream width: 32, 64 or 128 bits");

    static constexpr int beat_shift = words_per_beat == 4 ? 2 : words_per_beat == 2 ? 1 : 0;
    static constexpr int channel_base = geometry_words + phase_words;
    static constexpr int channel_words = has_quadratic ? quadratic_words : linear_words;
    /// Registers, in order: geometry, phases, colour channels of channel_words each, depth.
    static constexpr int depth_base = channel_base + colour_channels * channel_words;
    static constexpr int register_count = depth_base + (has_depth ? linear_words : 0);
    static constexpr int beat_index_bits = 6;

    using length_t = ac_int<header_length_bits, false>;
    using keep_t = ac_int<words_per_beat, false>;

    enum phase_of_packet { expect_header, payload, message };

    struct beat_t {
        bit_t valid = 0;
        bit_t last = 0;
        ac_int<words_per_beat, false> keep = 0;  ///< bit k: word k is present
        word_t words[words_per_beat];
    };

    /// What a header says by itself, worked out in two clocks.
    struct verdict_t {
        ac_int<2, false> age = 0;  ///< clocks since the header came, up to 3
        bit_t triangle = 0, answered = 0, known = 0, served = 0;
        length_t expected = 0;
        ac_int<beat_index_bits, false> final_index = 0;  ///< the last beat's
        keep_t final_keep = 0;
        bit_t at_final = 0;         ///< the beat offered should be the last; valid at age 3
        ac_int<2, false> code = 0;  ///< error code, 0 for none; valid at age 3
    };

    struct state_t {
        ac_int<2, false> phase = expect_header;
        ac_int<beat_index_bits, false> beat_index = 0;
        bit_t broken = 0;  ///< the packet's framing is not what its header announces
        word_t header = 0;
        word_t held[words_per_beat];  ///< the header's beat: its payload words wait until the job before is taken
        verdict_t verdict;
        job_t job;
        beat_t write;  ///< the payload beat that `words` takes in in this clock
        ac_int<beat_index_bits, false> write_index = 0;
        word_t words[register_count];

        /// An ac_int that nothing has set may hold bits above its width, which select() would keep for ever.
        state_t() {
            for (word_t& word : held) word = 0;
            for (word_t& word : words) word = 0;
        }
    };

    /// True when the beat offered in this clock is taken.
    static bit_t ready(const state_t& state) {
        const bit_t waits = bit_t(state.phase == payload) & state.job.valid;
        return ~waits & bit_t(state.phase != message);
    }

    /// \param taken the edge walker takes state.job in this clock
    static state_t step(const state_t& state, const beat_t& beat, bit_t taken) {
        state_t next = state;
        const bit_t accept = beat.valid & ready(state);
        const bit_t header_beat = accept & bit_t(state.phase == expect_header);
        const bit_t payload_beat = accept & bit_t(state.phase == payload);
        const bit_t judged = bit_t(state.verdict.age == 3);
        const bit_t emit = bit_t(state.phase == message) & judged & ~state.job.valid;

        // Framing: what a beat should look like, and what is wrong with it.
        const bit_t full = bit_t(beat.keep == (1 << words_per_beat) - 1);
        const bit_t alone = beat.last & bit_t(beat.keep == 1) & bit_t(opcode(beat.words[0]) != opcode_triangle);
        const bit_t inner = ~beat.last & full;
        const bit_t outer = beat.last & bit_t(beat.keep == state.verdict.final_keep);
        // No packet of three beats is sound, so the beats right behind the header need not wait for the verdict.
        const bit_t framed =
            select(judged, bit_t(state.verdict.triangle & select(state.verdict.at_final, outer, inner)), inner);
        const bit_t sound = ~state.broken & framed;
        const bit_t complete = payload_beat & beat.last & sound & judged & bit_t(state.verdict.code == 0);
        next.broken = select(header_beat, bit_t(~(alone | inner)), select(payload_beat, bit_t(~sound), state.broken));

        using phase_t2 = ac_int<2, false>;
        const phase_t2 at_last = select(complete, phase_t2(expect_header), phase_t2(message));
        next.phase = select(accept, select(beat.last, at_last, phase_t2(payload)), next.phase);
        next.phase = select(emit, phase_t2(expect_header), next.phase);
        next.header = select(header_beat, beat.words[0], state.header);
        next.beat_index = select(header_beat, ac_int<beat_index_bits, false>(1),
                                 ac_int<beat_index_bits, false>(state.beat_index + payload_beat));
        next.verdict = judge(state, header_beat, accept);

        next.job.valid = (state.job.valid & ~taken) | complete | emit;
        next.job.message = select(emit, bit_t(1), select(payload_beat, bit_t(0), state.job.message));
        const ac_int<2, false> framing_code =
            select(state.broken, ac_int<2, false>(error_bad_length), ac_int<2, false>(0));
        next.job.code =
            select(emit, select(bit_t(state.verdict.code == 0), framing_code, state.verdict.code), state.job.code);
        next.job.header = select(emit, state.header, state.job.header);
        next.job.leftward = select(payload_beat, bit_t(state.header[flag_leftward_bit]), state.job.leftward);
        next.job.linear = select(payload_beat, bit_t(state.header[flag_linear_bit]), state.job.linear);
        next.job.depth = select(payload_beat, bit_t(state.header[flag_depth_bit]), state.job.depth);

        hold(next, beat, header_beat, std::make_index_sequence<words_per_beat>{});
        next.write = beat;
        next.write.valid = payload_beat;
        next.write_index = state.beat_index;
        store(next, state, std::make_index_sequence<register_count>{});
        return next;
    }

    /// The geometry fields out of the first ten registers.
    static geometry_t geometry(const state_t& state) {
        ac_int<geometry_words * word_bits, false> packed = 0;
        packed.set_slc(0, state.words[0]);
        packed.set_slc(word_bits, state.words[1]);
        packed.set_slc(2 * word_bits, state.words[2]);
        packed.set_slc(3 * word_bits, state.words[3]);
        geometry_t fields;
        fields.x = packed.template slc<coordinate_bits>(0);
        fields.y = packed.template slc<coordinate_bits>(coordinate_bits);
        fields.rows_above = packed.template slc<coordinate_bits>(2 * coordinate_bits);
        fields.rows_below = packed.template slc<coordinate_bits>(3 * coordinate_bits);
        fields.kappa = packed.template slc<coordinate_bits>(4 * coordinate_bits);
        fields.length = packed.template slc<coordinate_bits>(5 * coordinate_bits);
        fields.m = packed.template slc<coordinate_bits>(6 * coordinate_bits);
        fields.length_reload = packed.template slc<coordinate_bits>(7 * coordinate_bits);
        fields.m_below = packed.template slc<coordinate_bits>(8 * coordinate_bits);
        fields.long_phase = state.words[geometry_words];
        fields.long_step = state.words[geometry_words + 1];
        fields.upper_phase = state.words[geometry_words + 2];
        fields.upper_step = state.words[geometry_words + 3];
        fields.lower_phase = state.words[geometry_words + 4];
        fields.lower_step = state.words[geometry_words + 5];
        return fields;
    }

 private:
    static ac_int<8, false> opcode(const word_t& header) { return header.template slc<8>(header_opcode_lsb); }

    /// The verdict on state.header: the first clock looks at opcode and flags, the second compares lengths.
    static verdict_t judge(const state_t& state, bit_t header_beat, bit_t accept) {
        using code_t = ac_int<2, false>;
        const word_t header = state.header;
        const verdict_t& v = state.verdict;
        const length_t length = header.template slc<header_length_bits>(0);
        verdict_t next;
        next.age =
            select(header_beat, ac_int<2, false>(1), select(bit_t(v.age == 3), v.age, ac_int<2, false>(v.age + 1)));

        const ac_int<8, false> op = opcode(header);
        const bit_t linear = header[flag_linear_bit];
        const bit_t depth = header[flag_depth_bit];
        const ac_int<2, false> log_channels = header.template slc<flag_log_channels_bits>(flag_log_channels_lsb);
        const length_t none = 0;
        const length_t colour_words = select(linear, length_t(channel_base + colour_channels * linear_words),
                                             length_t(channel_base + colour_channels * quadratic_words));
        const length_t log_words = select(linear, length_t(linear_words), length_t(quadratic_words));
        next.triangle = bit_t(op == opcode_triangle);
        next.answered = bit_t(op == opcode_query) | bit_t(op == opcode_fence);
        next.known = bit_t(op <= opcode_fence);
        next.served = bit_t(header.template slc<5>(flag_log_channels_lsb) == 0) & (bit_t(has_depth) | ~depth) &
                      (bit_t(has_quadratic) | linear);
        next.expected = select(next.triangle,
                               length_t(colour_words + select(bit_t(log_channels[0]), log_words, none) +
                                        select(bit_t(log_channels[1]), length_t(log_words << 1), none) +
                                        select(depth, length_t(linear_words), none)),
                               none);
        // The header is word 0, so the last word is number `length`.
        next.final_index = length >> beat_shift;
        const ac_int<beat_index_bits, false> beat_index_next = state.beat_index + accept;
        next.at_final = bit_t(beat_index_next == v.final_index);
        next.final_keep = keep_t((ac_int<5, false>(2) << ac_int<2, false>(length & (words_per_beat - 1))) - 1);

        const code_t refused = select(v.served | v.answered, code_t(0), code_t(error_unsupported));
        const code_t length_code = select(bit_t(length == v.expected), refused, code_t(error_bad_length));
        const code_t known_code = select(v.triangle | v.answered, length_code, code_t(error_unsupported));
        next.code = select(v.known, known_code, code_t(error_unknown_opcode));
        return next;
    }

    /// Payload index of register r in a quadratic or linear packet; −1: not in it.
    static constexpr int position(int r, bool linear) {
        if (r < channel_base) return r;
        if (r >= depth_base)
            return channel_base + colour_channels * (linear ? linear_words : quadratic_words) + (r - depth_base);
        const int channel = (r - channel_base) / channel_words;
        const int k = (r - channel_base) % channel_words;
        if (linear) return k < linear_words ? channel_base + channel * linear_words + k : -1;
        return has_quadratic ? channel_base + channel * quadratic_words + k : -1;
    }
    static constexpr int beat_of(int p) { return (p + 1) / words_per_beat; }
    static constexpr int lane_of(int p) { return (p + 1) % words_per_beat; }

    /// One register's next value: the word at its place when that beat passes, else what it was.
    template <int index, bool linear>
    static word_t stored(const word_t& old, const state_t& state) {
        constexpr int p = position(index, linear);
        if constexpr (p < 0) {
            return old;
        } else if constexpr (beat_of(p) == 0) {
            return select(state.write.valid & bit_t(state.write_index == 1), state.held[lane_of(p)], old);
        } else {
            const bit_t hit = state.write.valid & bit_t(state.write_index == beat_of(p)) &
                              bit_t(bit_t(state.header[flag_linear_bit]) == bit_t(linear));
            return select(hit, state.write.words[lane_of(p)], old);
        }
    }

    template <std::size_t... index>
    static void store(state_t& next, const state_t& state, std::index_sequence<index...>) {
        ((next.words[index] = stored<int(index), true>(stored<int(index), false>(state.words[index], state), state)),
         ...);
    }

    template <std::size_t... lane>
    static void hold(state_t& next, const beat_t& beat, bit_t header_beat, std::index_sequence<lane...>) {
        ((next.held[lane] = select(header_beat, beat.words[lane], next.held[lane])), ...);
    }
};

}  // namespace sheen::hls
