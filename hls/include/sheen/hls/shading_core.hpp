// SPDX-License-Identifier: MIT
/// \file
/// shading_core: the units joined; setup beats in, pixel and message words out.
///
///     beats ─▶ packet_decoder ─▶ edge_walker ─▶ span queue ─▶ span_walker ─▶ colour_stage ─▶ words
///                     └─ words ─▶ forward_difference ×channels (edge part, queue, span part) ─┘
///
/// One call of clock() is one clock of every unit. Three triangles are in work at once: one arrives in the decoder, one
/// is walked along its edges, one is drawn span by span.
#pragma once

#include "sheen/hls/colour_stage.hpp"
#include "sheen/hls/edge_walker.hpp"
#include "sheen/hls/forward_difference.hpp"
#include "sheen/hls/packet_decoder.hpp"
#include "sheen/hls/span_walker.hpp"
#include "sheen/hls/stream_fifo.hpp"

namespace sheen::hls {

/// What a core is built with; the VHDL core's generics have the same names.
/// \tparam words_per_beat_  setup stream width in words: 1, 2 or 4
/// \tparam has_depth_       a linear depth channel
/// \tparam has_quadratic_   second-order colour channels (without: `flat` and `gouraud` only)
/// \tparam colour_bits_     width of a colour channel, 10 of them integer
/// \tparam depth_width_     width of the depth channel, 16 of them integer
template <int words_per_beat_ = 2, bool has_depth_ = true, bool has_quadratic_ = true, int colour_bits_ = word_bits,
          int depth_width_ = word_bits>
struct core_config {
    static constexpr int words_per_beat = words_per_beat_;
    static constexpr bool has_depth = has_depth_;
    static constexpr bool has_quadratic = has_quadratic_;
    using colour_t = ac_fixed<colour_bits_, colour_integer_bits, true, AC_TRN, AC_WRAP>;
    using depth_t = ac_fixed<depth_width_, depth_integer_bits, false, AC_TRN, AC_WRAP>;

    /// The four data words of the reply to a query (docs/packet-protocol.md).
    static core_description_t description() {
        core_description_t d;
        d.data[0] = protocol_version | (has_depth ? 1 << 10 : 0) | (has_quadratic ? 1 << 11 : 0);
        d.data[1] = colour_bits_ | (colour_bits_ - colour_integer_bits) << 8 | (has_depth ? depth_width_ : 0) << 16 |
                    phase_bits << 24;
        d.data[2] = max_extent;
        d.data[3] = core_version;
        return d;
    }
};

template <typename config>
struct shading_core {
    using decoder = packet_decoder<config::words_per_beat, config::has_depth, config::has_quadratic>;
    using colour_channel = forward_difference<typename config::colour_t, config::has_quadratic>;
    using depth_channel = forward_difference<typename config::depth_t, false>;
    using stage = colour_stage<typename config::colour_t, typename config::depth_t>;
    using queue = stream_fifo<span_queue_log2, span_queue_reserve>;
    static constexpr int queue_depth = 1 << span_queue_log2;

    /// A channel: both parts, and its share of the span queue.
    template <typename channel>
    struct channel_t {
        typename channel::edge_state_t edge;
        typename channel::span_state_t span;
        typename channel::start_t memory[queue_depth];
        typename channel::start_t head;
    };

    typename decoder::state_t decoder_state;
    edge_walker::state_t edge_state;
    span_walker::state_t span_state;
    typename stage::state_t stage_state;
    typename queue::state_t queue_state;
    span_t queue_memory[queue_depth];
    span_t queue_head;
    channel_t<colour_channel> red, green, blue;
    channel_t<depth_channel> depth;
    core_description_t description = config::description();

    /// True when the beat offered in the next clock() is taken.
    [[nodiscard]] bit_t ready() const { return decoder::ready(decoder_state); }

    /// True while anything is under way inside.
    [[nodiscard]] bit_t busy() const {
        return decoder_state.job.valid | bit_t(decoder_state.phase == decoder::message) |
               bit_t(edge_state.walk != edge_walker::idle) | edge_state.push |
               ~bit_t(queue_state.stored[span_queue_log2 + 1]) | queue_state.valid | span_state.active |
               span_state.fragment.valid | stage_state.fragment.valid | stage_state.valid;
    }

    /// One clock of all units: the word that leaves is stage_state.word, when stage_state.valid. \param go the sink
    /// takes pixels
    void clock(const typename decoder::beat_t& beat, bit_t go) {
        const bit_t room = queue::ready(queue_state);
        const bit_t job_taken = edge_walker::taken(edge_state, decoder_state.job, room);
        const bit_t span_taken = span_walker::taken(span_state, queue_state.valid, go);
        const bit_t fetch = queue::fetches(queue_state, span_taken);

        stage_state = stage::step(stage_state, span_state.fragment, values(), description);
        clock_channel<colour_channel>(red, bit_t(1), colour_words<0>());
        clock_channel<colour_channel>(green, bit_t(1), colour_words<1>());
        clock_channel<colour_channel>(blue, bit_t(1), colour_words<2>());
        if constexpr (config::has_depth) clock_channel<depth_channel>(depth, edge_state.command.depth, depth_words());
        fetch_before = fetch;
        fetch_address_before = queue_state.read_address;

        const span_t head = queue_head;
        const bit_t head_valid = queue_state.valid;
        if (fetch) queue_head = queue_memory[queue_state.read_address];
        if (edge_state.push) queue_memory[queue_state.write_address] = edge_state.span;
        queue_state = queue::step(queue_state, edge_state.push, span_taken);
        edge_state = edge_walker::step(edge_state, decoder_state.job, decoder::geometry(decoder_state), room,
                                       span_taken & head.first);
        span_state = span_walker::step(span_state, head, head_valid, go);
        decoder_state = decoder::step(decoder_state, beat, job_taken);
    }

 private:
    // Channels follow the walkers by one clock, and so does their side of the span queue.
    bit_t fetch_before = 0;
    typename queue::address_t fetch_address_before = 0;

    template <typename channel>
    void clock_channel(channel_t<channel>& c, bit_t present, const typename channel::words_t& words) {
        c.span = channel::span_step(c.span, span_state.command, c.head, c.edge);
        if (fetch_before) c.head = c.memory[fetch_address_before];
        if (edge_state.push) c.memory[queue_state.write_address] = channel::start(c.edge);
        c.edge = channel::edge_step(c.edge, edge_state.command, present, words);
    }

    [[nodiscard]] typename stage::values_t values() const {
        typename stage::values_t v;
        v.red = red.span.i;
        v.green = green.span.i;
        v.blue = blue.span.i;
        v.depth = depth.span.i;
        return v;
    }

    template <int index>
    [[nodiscard]] typename colour_channel::words_t colour_words() const {
        const word_t* w = decoder_state.words + decoder::channel_base + index * decoder::channel_words;
        if constexpr (config::has_quadratic) {
            return {w[0], w[1], w[2], w[3], w[4], w[5]};
        } else {
            return {w[0], w[1], w[2]};
        }
    }

    [[nodiscard]] typename depth_channel::words_t depth_words() const {
        const word_t* w = decoder_state.words + decoder::depth_base;
        return {w[0], w[1], w[2]};
    }
};

}  // namespace sheen::hls
