// SPDX-License-Identifier: MIT
/// \file
/// packet_decoder: beats of the setup stream in, jobs (triangles and messages) out, in order.
///
/// One step is one clock. While a triangle is drawn, the words of the next one fill `words` (double-buffered setup); a
/// complete packet raises job.valid until the edge walker takes it. The header of the packet after that is taken in the
/// meantime, so a stream that is never late costs no clock between packets.
///
/// The header is judged in two clocks while the payload arrives; a message waits for the packet's last beat.
///
/// Materials and power tables are for the highlight stage, and keep their place among the triangles: a material waits
/// in `material`, a table goes word by word into the bank that is not read, and a message of the packet's opcode
/// follows the pixels before it. The next material, or table, waits until that message has arrived.
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
/// \tparam log_channels   the core's log channels, 0 to 3
/// \tparam has_power      each of them has a power_rom
template <int words_per_beat, bool has_depth, bool has_quadratic, int log_channels = 0, bool has_power = false>
struct packet_decoder {
    static_assert(words_per_beat == 1 || words_per_beat == 2 || words_per_beat == 4,
                  "stream width: 32, 64 or 128 bits");
    static_assert(log_channels >= 0 && log_channels <= max_log_channels, "0 to 3 log channels");
    static_assert(has_quadratic || log_channels == 0, "log channels are quadratics");
    static_assert(log_channels > 0 || !has_power, "a power table serves log channels");

    static constexpr int beat_shift = words_per_beat == 4 ? 2 : words_per_beat == 2 ? 1 : 0;
    static constexpr int channel_base = geometry_words + phase_words;
    static constexpr int channel_words = has_quadratic ? quadratic_words : linear_words;
    static constexpr int channels = colour_channels + log_channels;
    /// Registers, in order: geometry, phases, colour and log channels of channel_words each, depth.
    static constexpr int depth_base = channel_base + channels * channel_words;
    static constexpr int register_count = depth_base + (has_depth ? linear_words : 0);
    /// Beats are counted up to the longest packet's, and no further.
    static constexpr int beat_index_bits = has_power ? power_word_bits + 1 : 6;

    using beat_index_t = ac_int<beat_index_bits, false>;
    using length_t = ac_int<header_length_bits, false>;
    using code_t = ac_int<2, false>;
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
        bit_t triangle = 0, known = 0, served = 0;
        length_t expected = 0;
        beat_index_t final_index = 0;  ///< the last beat's
        keep_t final_keep = 0;
        bit_t at_final = 0;         ///< the beat offered should be the last; valid at age 3
        ac_int<2, false> code = 0;  ///< error code, 0 for none; valid at age 3
    };

    struct state_t {
        ac_int<2, false> phase = expect_header;
        beat_index_t beat_index = 0;
        bit_t broken = 0;  ///< a beat before the last one was not full
        keep_t last_keep = 0;
        bit_t settled = 0;  ///< in phase message since a clock ago
        bit_t framed = 0;   ///< the last beat was the one that the header announces; valid when settled, at age 3
        word_t header = 0;
        word_t held[words_per_beat];  ///< the header's beat: its payload words wait until the job before is taken
        verdict_t verdict;
        job_t job;
        material_t material;        ///< the last one
        bit_t material_waits = 0;   ///< it has not arrived at the highlight stage
        bit_t table = 0;            ///< the packet is a power table
        bit_t table_waits = 0;      ///< the table before has not arrived at the highlight stage
        bit_t table_bank = 1;       ///< where the next table goes
        ac_int<3, false> left = 0;  ///< table: words in `held` that are not written yet
        ac_int<2, false> lane = 0;  ///< table: the first of them
        ac_int<power_word_bits, false> table_address = 0;
        table_write_t table_write;  ///< output
        beat_t write;               ///< the payload beat that `words` takes in in this clock
        beat_index_t write_index = 0;
        word_t words[register_count];

        /// An ac_int that nothing has set may hold bits above its width, which select() would keep for ever.
        state_t() {
            for (word_t& word : held) word = 0;
            for (word_t& word : words) word = 0;
        }
    };

    /// True when the beat offered in this clock is taken.
    static bit_t ready(const state_t& state) {
        const bit_t unwritten = state.table & (state.table_waits | bit_t(state.left > 1));
        const bit_t waits = bit_t(state.phase == payload) & (state.job.valid | unwritten);
        return ~waits & bit_t(state.phase != message);
    }

    /// What comes back from the highlight stage: a material's, or a table's message has arrived there.
    struct applied_t {
        bit_t material = 0;
        bit_t table = 0;
    };

    /// \param taken the edge walker takes state.job in this clock
    static state_t step(const state_t& state, const beat_t& beat, bit_t taken, const applied_t& applied = {}) {
        state_t next = state;
        const bit_t accept = beat.valid & ready(state);
        const bit_t header_beat = accept & bit_t(state.phase == expect_header);
        const bit_t payload_beat = accept & bit_t(state.phase == payload);
        const bit_t judged = bit_t(state.verdict.age == 3);
        const ac_int<8, false> op = opcode(state.header);
        const bit_t is_material = bit_t(op == opcode_material);
        // A core without power tables refuses a material that asks for one.
        const bit_t kinds_served = bit_t(has_power) | ~is_material | bit_t(kinds(state) == 0);
        const bit_t good = state.framed & bit_t(state.verdict.code == 0) & kinds_served;
        const bit_t held_back = (is_material & state.material_waits) | bit_t(state.left != 0);
        const bit_t emit = bit_t(state.phase == message) & state.settled & judged & ~state.job.valid & ~held_back;

        // Framing. Every sound triangle is so long that its last beat finds it judged; other packets wait in `message`.
        const bit_t full = bit_t(beat.keep == (1 << words_per_beat) - 1);
        const bit_t at_end = beat.last & state.verdict.at_final & bit_t(beat.keep == state.verdict.final_keep);
        const bit_t complete =
            payload_beat & at_end & judged & state.verdict.triangle & ~state.broken & bit_t(state.verdict.code == 0);
        next.broken = select(accept & ~beat.last, bit_t((state.broken & ~header_beat) | ~full),
                             bit_t(state.broken & ~header_beat));
        next.last_keep = select(accept, beat.keep, state.last_keep);
        next.settled = bit_t(state.phase == message);
        next.framed = ~state.broken & bit_t(state.beat_index == beat_index_t(state.verdict.final_index + 1)) &
                      bit_t(state.last_keep == state.verdict.final_keep);

        using phase_t2 = ac_int<2, false>;
        const phase_t2 at_last = select(complete, phase_t2(expect_header), phase_t2(message));
        next.phase = select(accept, select(beat.last, at_last, phase_t2(payload)), next.phase);
        next.phase = select(emit, phase_t2(expect_header), next.phase);
        next.header = select(header_beat, beat.words[0], state.header);
        const bit_t counts = payload_beat & bit_t(state.beat_index != beat_index_t(-1));
        next.beat_index = select(header_beat, beat_index_t(1), beat_index_t(state.beat_index + counts));
        next.verdict = judge(state, header_beat, accept);

        next.job.valid = (state.job.valid & ~taken) | complete | emit;
        next.job.message = select(emit, bit_t(1), select(payload_beat, bit_t(0), state.job.message));
        const code_t content_code = select(kinds_served, code_t(0), code_t(error_unsupported));
        const code_t framing_code = select(state.framed, content_code, code_t(error_bad_length));
        next.job.code =
            select(emit, select(bit_t(state.verdict.code == 0), framing_code, state.verdict.code), state.job.code);
        next.job.header = select(emit, state.header, state.job.header);
        next.job.leftward = select(payload_beat, bit_t(state.header[flag_leftward_bit]), state.job.leftward);
        next.job.linear = select(payload_beat, bit_t(state.header[flag_linear_bit]), state.job.linear);
        next.job.depth = select(payload_beat, bit_t(state.header[flag_depth_bit]), state.job.depth);
        if constexpr (log_channels > 0) {
            const ac_int<flag_log_channels_bits, false> log =
                state.header.template slc<flag_log_channels_bits>(flag_log_channels_lsb);
            next.job.log = select(payload_beat, log, state.job.log);
            take_material(next, state, emit & good & is_material, applied);
        }

        hold(next, beat, header_beat | (payload_beat & state.table), std::make_index_sequence<words_per_beat>{});
        if constexpr (has_power) write_table(next, state, beat, accept, header_beat, emit & good, applied);
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
        const word_t header = state.header;
        const verdict_t& v = state.verdict;
        const length_t length = header.template slc<header_length_bits>(0);
        verdict_t next;
        next.age =
            select(header_beat, ac_int<2, false>(1), select(bit_t(v.age == 3), v.age, ac_int<2, false>(v.age + 1)));

        const ac_int<8, false> op = opcode(header);
        const bit_t answered = bit_t(op == opcode_query) | bit_t(op == opcode_fence);
        const bit_t no_flags = bit_t(header.template slc<8>(header_flags_lsb) == 0);
        const bit_t linear = header[flag_linear_bit];
        const bit_t depth = header[flag_depth_bit];
        const ac_int<2, false> log_count = header.template slc<flag_log_channels_bits>(flag_log_channels_lsb);
        const length_t none = 0;
        const length_t colour_words = select(linear, length_t(channel_base + colour_channels * linear_words),
                                             length_t(channel_base + colour_channels * quadratic_words));
        const length_t log_words = select(linear, length_t(linear_words), length_t(quadratic_words));
        next.triangle = bit_t(op == opcode_triangle);
        next.known = bit_t(op <= opcode_fence);
        const bit_t drawn = next.triangle & bit_t(header.template slc<3>(flag_log_channels_lsb + 2) == 0) &
                            bit_t(log_count <= log_channels) & (bit_t(has_depth) | ~depth) &
                            (bit_t(has_quadratic) | linear);
        next.served = answered | drawn | (bit_t(log_channels > 0) & no_flags & bit_t(op == opcode_material)) |
                      (bit_t(has_power) & no_flags & bit_t(op == opcode_table));
        const length_t triangle_words = colour_words + select(bit_t(log_count[0]), log_words, none) +
                                        select(bit_t(log_count[1]), length_t(log_words << 1), none) +
                                        select(depth, length_t(linear_words), none);
        next.expected = select(next.triangle, triangle_words, none);
        next.expected = select(bit_t(op == opcode_material), length_t(material_words), next.expected);
        next.expected = select(bit_t(op == opcode_table), length_t(power_words), next.expected);
        // The header is word 0, so the last word is number `length`.
        next.final_index = length >> beat_shift;
        const beat_index_t beat_index_next = state.beat_index + accept;
        next.at_final = bit_t(beat_index_next == v.final_index);
        next.final_keep = keep_t((ac_int<5, false>(2) << ac_int<2, false>(length & (words_per_beat - 1))) - 1);

        const code_t refused = select(v.served, code_t(0), code_t(error_unsupported));
        const bit_t right_length = bit_t(length == v.expected) | bit_t(op == opcode_spans);
        const code_t length_code = select(right_length, refused, code_t(error_bad_length));
        next.code = select(v.known, length_code, code_t(error_unknown_opcode));
        return next;
    }

    /// Payload index of register r in a quadratic or linear packet with this many log channels; −1: not in it.
    static constexpr int position(int r, bool linear, int logs) {
        const int packet_words = linear ? linear_words : quadratic_words;
        if (r < channel_base) return r;
        if (r >= depth_base) return channel_base + (colour_channels + logs) * packet_words + (r - depth_base);
        const int channel = (r - channel_base) / channel_words;
        const int k = (r - channel_base) % channel_words;
        if (k >= packet_words || packet_words > channel_words) return -1;
        return channel_base + channel * packet_words + k;
    }
    static constexpr int beat_of(int p) { return (p + 1) / words_per_beat; }
    static constexpr int lane_of(int p) { return (p + 1) % words_per_beat; }

    /// One register's next value: the word at its place when that beat passes, else what it was. Only depth has its
    /// place behind the log channels; a log channel that the packet hasn't is never read.
    template <int index, bool linear, int logs = 0>
    static word_t stored(const word_t& old, const state_t& state) {
        constexpr int p = position(index, linear, logs);
        if constexpr (p < 0) {
            return old;
        } else if constexpr (beat_of(p) == 0) {
            return select(state.write.valid & bit_t(state.write_index == 1), state.held[lane_of(p)], old);
        } else {
            bit_t hit = state.write.valid & bit_t(state.write_index == beat_of(p)) &
                        bit_t(bit_t(state.header[flag_linear_bit]) == bit_t(linear));
            if constexpr (index >= depth_base) {
                hit &= bit_t(state.header.template slc<flag_log_channels_bits>(flag_log_channels_lsb) == logs);
            }
            const word_t chosen = select(hit, state.write.words[lane_of(p)], old);
            if constexpr (index >= depth_base && logs < log_channels) {
                return stored<index, linear, logs + 1>(chosen, state);
            } else {
                return chosen;
            }
        }
    }

    template <std::size_t... index>
    static void store(state_t& next, const state_t& state, std::index_sequence<index...>) {
        ((next.words[index] = stored<int(index), true>(stored<int(index), false>(state.words[index], state), state)),
         ...);
    }

    /// A material's field of the log channels' kinds.
    static ac_int<max_log_channels, false> kinds(const state_t& state) {
        return state.words[1].template slc<max_log_channels>(colour_channels * material_field_bits - word_bits);
    }

    /// Fields of 12 bits from bit 0 of word 0: ambient red, green, blue u8.4, the log channels' kinds.
    static void take_material(state_t& next, const state_t& state, bit_t emitted, const applied_t& applied) {
        constexpr int cut = ambient_fraction_bits - colour_sum_fraction_bits;
        constexpr int kept = component_bits + colour_sum_fraction_bits;
        ac_int<2 * word_bits, false> packed = 0;
        packed.set_slc(0, state.words[0]);
        packed.set_slc(word_bits, state.words[1]);
        const material_t& old = state.material;
        next.material.red = select(emitted, packed.template slc<kept>(cut), old.red);
        next.material.green = select(emitted, packed.template slc<kept>(material_field_bits + cut), old.green);
        next.material.blue = select(emitted, packed.template slc<kept>(2 * material_field_bits + cut), old.blue);
        next.material.power = select(emitted, kinds(state), old.power);
        next.material_waits = (state.material_waits | emitted) & ~applied.material;
    }

    /// The table's words, one a clock, out of the beat that is held.
    static void write_table(state_t& next, const state_t& state, const beat_t& beat, bit_t accept, bit_t header_beat,
                            bit_t emitted, const applied_t& applied) {
        using left_t = ac_int<3, false>;
        const bit_t writes = state.table & bit_t(state.left != 0) & ~state.table_waits;
        next.table_write.valid = writes;
        next.table_write.bank = state.table_bank;
        next.table_write.address = state.table_address;
        next.table_write.data = held_word(state, std::make_index_sequence<words_per_beat>{});
        next.table_address = select(header_beat, ac_int<power_word_bits, false>(0),
                                    ac_int<power_word_bits, false>(state.table_address + writes));

        next.table = select(header_beat, bit_t(opcode(beat.words[0]) == opcode_table), state.table);
        const left_t present = words_present(beat.keep, std::make_index_sequence<words_per_beat>{});
        next.left = select(accept, left_t(present - header_beat), left_t(state.left - writes));
        next.left = select(next.table, next.left, left_t(0));
        next.lane = select(accept, ac_int<2, false>(header_beat), ac_int<2, false>(state.lane + writes));

        const bit_t switches = emitted & state.table;
        next.table_bank = state.table_bank ^ switches;
        next.table_waits = (state.table_waits | switches) & ~applied.table;
    }

    template <std::size_t... lane>
    static word_t held_word(const state_t& state, std::index_sequence<lane...>) {
        word_t word = 0;
        ((word = select(bit_t(state.lane == int(lane)), state.held[lane], word)), ...);
        return word;
    }

    template <std::size_t... lane>
    static ac_int<3, false> words_present(const keep_t& keep, std::index_sequence<lane...>) {
        return (ac_int<3, false>(keep[int(lane)]) + ...);
    }

    template <std::size_t... lane>
    static void hold(state_t& next, const beat_t& beat, bit_t header_beat, std::index_sequence<lane...>) {
        ((next.held[lane] = select(header_beat, beat.words[lane], next.held[lane])), ...);
    }
};

}  // namespace sheen::hls
