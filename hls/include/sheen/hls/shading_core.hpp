// SPDX-License-Identifier: MIT
/// \file
/// shading_core: the units joined; setup beats in, pixel and message words out.
///
///     beats ─▶ packet_decoder ─▶ edge_walker ─▶ span queue ─▶ span_walker ─▶ (highlight_stage) ─▶ colour_stage ─▶
///     words
///                     └─ words ─▶ forward_difference ×channels (edge part, queue, span part) ─┘
///
/// The highlight stage is there when the core has log channels.
///
/// One call of clock() is one clock of every unit. Three triangles are in work at once: one arrives in the decoder, one
/// is walked along its edges, one is drawn span by span.
#pragma once

#include "sheen/hls/colour_stage.hpp"
#include "sheen/hls/edge_walker.hpp"
#include "sheen/hls/forward_difference.hpp"
#include "sheen/hls/highlight_stage.hpp"
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
/// \tparam log_channels_    log channels, 0 to 3; each is a highlight
/// \tparam has_power_       each log channel has a loadable power table, too
template <int words_per_beat_ = 2, bool has_depth_ = true, bool has_quadratic_ = true, int colour_bits_ = word_bits,
          int depth_width_ = word_bits, int log_channels_ = 0, bool has_power_ = false>
struct core_config {
    static constexpr int words_per_beat = words_per_beat_;
    static constexpr bool has_depth = has_depth_;
    static constexpr bool has_quadratic = has_quadratic_;
    static constexpr int log_channels = log_channels_;
    static constexpr bool has_power = has_power_;
    using colour_t = ac_fixed<colour_bits_, colour_integer_bits, true, AC_TRN, AC_WRAP>;
    using depth_t = ac_fixed<depth_width_, depth_integer_bits, false, AC_TRN, AC_WRAP>;
    using log_t = log_value_t;

    /// The four data words of the reply to a query (docs/packet-protocol.md).
    static core_description_t description() {
        core_description_t d;
        d.data[0] = protocol_version | log_channels << 8 | (has_depth ? 1 << 10 : 0) | (has_quadratic ? 1 << 11 : 0) |
                    (has_power ? 1 << 12 : 0);
        d.data[1] = colour_bits_ | (colour_bits_ - colour_integer_bits) << 8 | (has_depth ? depth_width_ : 0) << 16 |
                    phase_bits << 24;
        constexpr int has_log = log_channels > 0 ? 1 : 0;
        d.data[2] = max_extent | has_log * (exp2_address_bits << 12 | log_t::width << 16 | log_fraction_bits << 24);
        d.data[3] = core_version | has_log * (exp2_data_bits << 24) | (has_power ? power_address_bits << 28 : 0);
        return d;
    }
};

template <typename config>
struct shading_core {
    using decoder = packet_decoder<config::words_per_beat, config::has_depth, config::has_quadratic,
                                   config::log_channels, config::has_power>;
    using colour_channel = forward_difference<typename config::colour_t, config::has_quadratic>;
    using log_channel = forward_difference<typename config::log_t, true>;
    using depth_channel = forward_difference<typename config::depth_t, false>;
    using stage = colour_stage<typename config::colour_t, typename config::depth_t>;
    /// A core without log channels doesn't use it.
    using highlights = highlight_stage<config::log_channels == 0 ? 1 : config::log_channels, config::has_power>;
    using log_count_t = ac_int<flag_log_channels_bits, false>;
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
    channel_t<log_channel> log[max_log_channels];
    channel_t<depth_channel> depth;
    typename highlights::state_t highlight_state;
    word_t power_memory[max_log_channels][highlights::power::words];

    /// An ac_int that nothing has set may hold any bits.
    shading_core() {
        for (auto& memory : power_memory) {
            for (word_t& word : memory) word = 0;
        }
    }
    core_description_t description = config::description();

    /// True when the beat offered in the next clock() is taken.
    [[nodiscard]] bit_t ready() const { return decoder::ready(decoder_state); }

    /// True while anything is under way inside.
    [[nodiscard]] bit_t busy() const {
        return decoder_state.job.valid | bit_t(decoder_state.phase == decoder::message) |
               bit_t(edge_state.walk != edge_walker::idle) | edge_state.push |
               ~bit_t(queue_state.stored[span_queue_log2 + 1]) | queue_state.valid | span_state.active |
               span_state.fragment.valid | lit() | stage_state.fragment.valid | stage_state.valid;
    }

    /// One clock of all units: the word that leaves is stage_state.word, when stage_state.valid. \param go the sink
    /// takes pixels
    void clock(const typename decoder::beat_t& beat, bit_t go) {
        const bit_t room = queue::ready(queue_state);
        const bit_t job_taken = edge_walker::taken(edge_state, decoder_state.job, room);
        const bit_t span_taken = span_walker::taken(span_state, queue_state.valid, go);
        const bit_t fetch = queue::fetches(queue_state, span_taken);

        const typename decoder::applied_t applied = {highlight_state.material_applied, highlight_state.table_applied};
        if constexpr (config::log_channels > 0) {
            stage_state = stage::step(stage_state, highlight_state.fragment, lit_values(), description);
            clock_highlights(std::make_index_sequence<config::log_channels>{});
            clock_logs(job_taken, std::make_index_sequence<config::log_channels>{});
        } else {
            stage_state = stage::step(stage_state, span_state.fragment, values(), description);
        }
        clock_channel<colour_channel>(red, bit_t(1), words_of<colour_channel, 0>());
        clock_channel<colour_channel>(green, bit_t(1), words_of<colour_channel, 1>());
        clock_channel<colour_channel>(blue, bit_t(1), words_of<colour_channel, 2>());
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
        decoder_state = decoder::step(decoder_state, beat, job_taken, applied);
    }

 private:
    // Channels follow the walkers by one clock, and so does their side of the span queue.
    bit_t fetch_before = 0;
    typename queue::address_t fetch_address_before = 0;
    // The triangle's number of log channels, on the way of the channels' constants.
    log_count_t job_log = 0, edge_log = 0, span_log = 0;

    template <typename channel>
    void clock_channel(channel_t<channel>& c, bit_t present, const typename channel::words_t& words) {
        c.span = channel::span_step(c.span, span_state.command, c.head, c.edge);
        if (fetch_before) c.head = c.memory[fetch_address_before];
        if (edge_state.push) c.memory[queue_state.write_address] = channel::start(c.edge);
        c.edge = channel::edge_step(c.edge, edge_state.command, present, words);
    }

    /// True while something is in the highlight stage, or on its way there.
    [[nodiscard]] bit_t lit() const {
        bit_t any = decoder_state.material_waits | decoder_state.table_waits | highlight_state.fragment.valid;
        for (const typename highlights::lane_t& lane : highlight_state.lane) any |= lane.fragment.valid;
        return any;
    }

    template <std::size_t... k>
    void clock_logs(bit_t job_taken, std::index_sequence<k...>) {
        (clock_channel<log_channel>(log[k], bit_t(1), words_of<log_channel, colour_channels + int(k)>()), ...);
        span_log = select(span_state.command.load & span_state.command.first, edge_log, span_log);
        edge_log = select(edge_state.command.load, job_log, edge_log);
        job_log = select(job_taken, decoder_state.job.log, job_log);
    }

    template <std::size_t... k>
    void clock_highlights(std::index_sequence<k...>) {
        using config_log_t = typename config::log_t;
        constexpr int log_bits = highlights::log_t::width;
        typename highlights::values_t v;
        v.red = diffuse(red.span.i);
        v.green = diffuse(green.span.i);
        v.blue = diffuse(blue.span.i);
        v.depth = depth.span.i.template slc<depth_bits>(config::depth_t::width - depth_bits);
        ((v.log[k] = log[k].span.i.template slc<log_bits>(config_log_t::width - log_bits)), ...);
        fragment_t fragment = span_state.fragment;
        fragment.log = span_log;

        typename highlights::reads_t reads;
        if constexpr (config::has_power) {
            ((reads.word[k] = power_memory[k][highlight_state.tables[k].power_state.address.to_uint()]), ...);
            const table_write_t& write = decoder_state.table_write;
            if (write.valid) ((power_memory[k][highlights::power::place(write).to_uint()] = write.data), ...);
        }
        highlight_state = highlights::step(highlight_state, fragment, v, decoder_state.material, reads);
    }

    static typename highlights::diffuse_t diffuse(const typename config::colour_t& value) {
        constexpr int bits = highlights::diffuse_t::width;
        return value.template slc<bits>(config::colour_t::width - bits);
    }

    [[nodiscard]] typename stage::values_t lit_values() const {
        constexpr int colour_lsb = config::colour_t::width - colour_integer_bits;
        typename stage::values_t v;
        v.red.set_slc(colour_lsb, highlight_state.red);
        v.green.set_slc(colour_lsb, highlight_state.green);
        v.blue.set_slc(colour_lsb, highlight_state.blue);
        v.depth.set_slc(config::depth_t::width - depth_bits, highlight_state.depth);
        return v;
    }

    [[nodiscard]] typename stage::values_t values() const {
        typename stage::values_t v;
        v.red = red.span.i;
        v.green = green.span.i;
        v.blue = blue.span.i;
        v.depth = depth.span.i;
        return v;
    }

    template <typename channel, int index>
    [[nodiscard]] typename channel::words_t words_of() const {
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
