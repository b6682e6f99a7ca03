// SPDX-License-Identifier: MIT
/// \file
/// power_rom: the loadable exponent table of paper `fast-phong`, section 3: what a cosine becomes as a highlight.
///
/// Two banks: one is read while the other is loaded, and `bank` says which one is read, so that a new shininess never
/// disturbs a pixel in flight. A word holds four entries, entry 4w + k in its bits 8k+7…8k. The angle's cosine comes as
/// t = 16·cos (s8): entries lie 2^(address_bits − 4) to the unit of t, so the last one is read just below cos = 1.
///
///     t < 0     entry 0
///     t ≥ 16    the last entry: a polynomial may pass 1
///
/// Formats: t s8.(address_bits − 4); entry u8.0; value u8.fraction_bits (the entry, its fraction 0).
/// Latency: 4, as exp2_rom (address, memory, memory's output register, entry). One call is one clock.
#pragma once

#include "sheen/hls/types.hpp"

namespace sheen::hls {

/// \tparam address_bits  a bank has 2^address_bits entries: 10 are the 1 KB of the paper
/// \tparam fraction_bits of the value
template <int address_bits, int fraction_bits>
struct power_rom {
    static_assert(address_bits >= 6 && address_bits <= 13, "a bank has 64 to 8192 entries");

    static constexpr int latency = 4;
    static constexpr int lane_bits = 2;  ///< four entries a word
    static constexpr int t_fraction_bits = address_bits - power_integer_bits;
    static constexpr int t_bits = log_integer_bits + t_fraction_bits;
    static constexpr int word_address_bits = address_bits - lane_bits;
    static constexpr int words = 2 << word_address_bits;
    using t_t = ac_int<t_bits, true>;
    using address_t = ac_int<address_bits, false>;
    using word_address_t = ac_int<word_address_bits, false>;
    using bank_address_t = ac_int<word_address_bits + 1, false>;  ///< the bank on top
    using lane_t = ac_int<lane_bits, false>;
    using value_t = ac_int<component_bits + fraction_bits, false>;

    struct state_t {
        bank_address_t address = 0;
        lane_t address_lane = 0;
        word_t memory = 0;
        lane_t memory_lane = 0;
        word_t fetched = 0;
        lane_t fetched_lane = 0;
        value_t value = 0;
    };

    /// \param read the memory's word at state.address before this clock's write
    static state_t step(const state_t& state, t_t t, bit_t bank, word_t read) {
        state_t next;
        const bit_t negative = t[t_bits - 1];
        const ac_int<log_integer_bits - 1 - power_integer_bits, false> beyond =
            t.template slc<log_integer_bits - 1 - power_integer_bits>(address_bits);
        const address_t inside = t.template slc<address_bits>(0);
        const address_t last = -1;
        const address_t entry = select(negative, address_t(0), select(bit_t(beyond != 0), last, inside));
        next.address.set_slc(0, word_address_t(entry.template slc<word_address_bits>(lane_bits)));
        next.address.set_slc(word_address_bits, bank);
        next.address_lane = entry.template slc<lane_bits>(0);

        next.memory = read;
        next.memory_lane = state.address_lane;
        next.fetched = state.memory;
        next.fetched_lane = state.memory_lane;
        next.value = value_t(entry_of(state.fetched, state.fetched_lane)) << fraction_bits;
        return next;
    }

    /// Where a word goes in a memory of both banks.
    static bank_address_t place(const table_write_t& write) {
        bank_address_t address = write.address;
        address.set_slc(word_address_bits, write.bank);
        return address;
    }

 private:
    static component_t entry_of(const word_t& word, const lane_t& lane) {
        const component_t low =
            select(lane[0], component_t(word.template slc<component_bits>(8)), component_t(word.template slc<8>(0)));
        const component_t high =
            select(lane[0], component_t(word.template slc<component_bits>(24)), component_t(word.template slc<8>(16)));
        return select(lane[1], high, low);
    }
};

}  // namespace sheen::hls
