// SPDX-License-Identifier: MIT
/// \file
/// highlight_stage: what the colour and log channels add up to: max(0, diffuse) + ambient + Σ highlights.
///
///     diffuse ─▶ max(0, ·) + ambient ────────── delay ─────────┐
///     log k ──▶ exp2_rom or power_rom (material's kinds) ─▶ Σ ─▶ + ─▶ colour_stage
///
/// A triangle without log channels passes as it is (its ambient is in its colour channels): max(0, colour) is what
/// colour_stage would have made of it.
///
/// Materials keep their place among the pixels. The decoder holds a new material, or fills the power bank that is not
/// read, and sends a message of its packet's opcode through the span queue; when it arrives here, the material is taken
/// over, or the banks change roles, and the message ends. `applied` tells the decoder, which holds back the next one.
///
/// Formats: diffuse s10.4, ambient u8.4, log s8.6 (z, or 16·cos), highlights u8.4; sums are exact. Latency: 4 + L for L
/// log channels (tables 4, their sum L − 1, the whole sum 1). Source: docs/methods.md, log-quadratic and taylor.
#pragma once

#include <cstddef>
#include <utility>

#include "sheen/hls/exp2_rom.hpp"
#include "sheen/hls/power_rom.hpp"
#include "sheen/hls/types.hpp"

namespace sheen::hls {

/// \tparam log_channels 1 to 3
/// \tparam has_power    each log channel has a power_rom beside its exp2_rom
template <int log_channels, bool has_power>
struct highlight_stage {
    static_assert(log_channels >= 1 && log_channels <= max_log_channels, "1 to 3 log channels");

    using exp2 = exp2_rom<exp2_address_bits, exp2_data_bits, colour_sum_fraction_bits>;
    using power = power_rom<power_address_bits, colour_sum_fraction_bits>;
    static_assert(exp2::z_bits == power::t_bits && exp2::latency == power::latency, "one takes the other's place");

    static constexpr int rom_latency = exp2::latency;
    static constexpr int latency = rom_latency + log_channels;
    using diffuse_t = ac_int<colour_integer_bits + colour_sum_fraction_bits, true>;
    using log_t = typename exp2::z_t;
    using value_t = typename exp2::value_t;                                        ///< u8.4
    using base_t = ac_int<colour_integer_bits + colour_sum_fraction_bits, false>;  ///< u10.4
    using sum_t = base_t;
    using integer_t = ac_int<colour_integer_bits, false>;
    using depth_t = ac_int<depth_bits, false>;

    struct values_t {
        diffuse_t red = 0, green = 0, blue = 0;
        log_t log[log_channels];
        depth_t depth = 0;
        values_t() { clear(std::make_index_sequence<log_channels>{}); }

     private:
        template <std::size_t... k>
        void clear(std::index_sequence<k...>) {
            ((log[k] = 0), ...);
        }
    };

    /// A pixel on its way beside the tables.
    struct lane_t {
        fragment_t fragment;
        base_t red = 0, green = 0, blue = 0;  ///< max(0, diffuse) + ambient
        depth_t depth = 0;
        ac_int<max_log_channels, false> power = 0;  ///< its material's kinds
    };

    /// One log channel's tables.
    struct tables_t {
        typename exp2::state_t exp2_state;
        typename power::state_t power_state;
    };

    struct state_t {
        material_t material;
        bit_t bank = 0;              ///< of the power tables: the one that is read
        bit_t material_applied = 0;  ///< a message came through: for the decoder
        bit_t table_applied = 0;
        lane_t lane[latency - 1];
        tables_t tables[log_channels];
        sum_t sum = 0;       ///< of the first highlights
        sum_t late_sum = 0;  ///< and of all three
        value_t late = 0;    ///< the third highlight, a clock later
        // Outputs.
        fragment_t fragment;
        integer_t red = 0, green = 0, blue = 0;  ///< s10.0, never negative
        depth_t depth = 0;
    };

    /// What the power memories give: the word at tables[k].power_state.address before this clock's write.
    struct reads_t {
        word_t word[log_channels];
        reads_t() { clear(std::make_index_sequence<log_channels>{}); }

     private:
        template <std::size_t... k>
        void clear(std::index_sequence<k...>) {
            ((word[k] = 0), ...);
        }
    };

    /// \param pending the material that the decoder holds
    static state_t step(const state_t& state, const fragment_t& fragment, const values_t& values,
                        const material_t& pending, const reads_t& reads) {
        state_t next;
        const bit_t applies = fragment.valid & fragment.message & ~fragment.query & bit_t(tail_code(fragment) == 0);
        next.material_applied = applies & bit_t(tail_opcode(fragment) == opcode_material);
        next.table_applied = applies & bit_t(tail_opcode(fragment) == opcode_table);
        next.material.red = select(next.material_applied, pending.red, state.material.red);
        next.material.green = select(next.material_applied, pending.green, state.material.green);
        next.material.blue = select(next.material_applied, pending.blue, state.material.blue);
        next.material.power = select(next.material_applied, pending.power, state.material.power);
        next.bank = state.bank ^ next.table_applied;

        const bit_t lit = bit_t(fragment.log != 0);
        lane_t& entry = next.lane[0];
        entry.fragment = fragment;
        entry.fragment.valid = fragment.valid & ~next.material_applied & ~next.table_applied;
        entry.red = base(values.red, lit, state.material.red);
        entry.green = base(values.green, lit, state.material.green);
        entry.blue = base(values.blue, lit, state.material.blue);
        entry.depth = values.depth;
        entry.power = state.material.power;
        delay(next, state, std::make_index_sequence<latency - 2>{});
        look_up(next, state, values, reads, std::make_index_sequence<log_channels>{});

        // The sum of the highlights, then the whole sum.
        const value_t first = highlight<0>(state);
        sum_t highlights = first;
        if constexpr (log_channels >= 2) {
            next.sum = sum_t(first) + highlight<1>(state);
            highlights = state.sum;
        }
        if constexpr (log_channels >= 3) {
            next.late = highlight<2>(state);
            next.late_sum = state.sum + state.late;
            highlights = state.late_sum;
        }
        const lane_t& last = state.lane[latency - 2];
        next.fragment = last.fragment;
        next.red = whole(last.red, highlights);
        next.green = whole(last.green, highlights);
        next.blue = whole(last.blue, highlights);
        next.depth = last.depth;
        return next;
    }

 private:
    static ac_int<2, false> tail_code(const fragment_t& f) { return f.tail.template slc<2>(0); }
    static ac_int<8, false> tail_opcode(const fragment_t& f) { return f.tail.template slc<8>(4); }

    /// max(0, diffuse), and the material's ambient where the triangle has log channels.
    static base_t base(diffuse_t diffuse, bit_t lit, value_t ambient) {
        const diffuse_t positive = select(bit_t(diffuse[diffuse_t::width - 1]), diffuse_t(0), diffuse);
        return base_t(positive) + select(lit, ambient, value_t(0));
    }

    template <std::size_t... k>
    static void delay(state_t& next, const state_t& state, std::index_sequence<k...>) {
        ((next.lane[k + 1] = state.lane[k]), ...);
    }

    template <std::size_t... k>
    static void look_up(state_t& next, const state_t& state, const values_t& values, const reads_t& reads,
                        std::index_sequence<k...>) {
        ((next.tables[k].exp2_state = exp2::step(state.tables[k].exp2_state, values.log[k])), ...);
        if constexpr (has_power) {
            ((next.tables[k].power_state =
                  power::step(state.tables[k].power_state, values.log[k], state.bank, reads.word[k])),
             ...);
        }
    }

    /// Log channel k's highlight: nothing where the pixel's triangle doesn't have that channel.
    template <int k>
    static value_t highlight(const state_t& state) {
        const lane_t& lane = state.lane[rom_latency - 1];
        value_t value = state.tables[k].exp2_state.value;
        if constexpr (has_power) {
            value = select(bit_t(lane.power[k]), state.tables[k].power_state.value, value);
        }
        return select(bit_t(lane.fragment.log > k), value, value_t(0));
    }

    /// The whole sum's integer part, at most 511 so that it stays positive; colour_stage saturates it.
    static integer_t whole(base_t base_sum, sum_t highlights) {
        const ac_int<base_t::width + 1, false> sum = base_sum + highlights;
        const bit_t over = bit_t(sum.template slc<base_t::width + 1 - value_t::width>(value_t::width) != 0);
        integer_t integer = sum.template slc<component_bits>(colour_sum_fraction_bits);
        integer.set_slc(component_bits, over);
        return integer;
    }
};

}  // namespace sheen::hls
