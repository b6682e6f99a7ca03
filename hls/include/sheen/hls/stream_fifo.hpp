// SPDX-License-Identifier: MIT
/// \file
/// stream_fifo: the control of a queue with registered flags. The memory belongs to whoever calls the step.
///
/// Both flags are sign bits of up/down counters, so nothing is compared: `ready` falls while `reserve` places are still
/// free (for writers that see it some clocks late), `valid` says that the output register holds an entry. The entry at
/// read_address is fetched into that register one clock ahead, so that the memory may be block RAM.
///
/// Latency: 2 from write to valid. Source: Sheen's own.
#pragma once

#include "sheen/hls/types.hpp"

namespace sheen::hls {

/// \tparam depth_log2 the memory has 2^depth_log2 places
/// \tparam reserve    places that stay free after `ready` falls
template <int depth_log2, int reserve>
struct stream_fifo {
    static_assert(reserve < (1 << depth_log2), "the reserve must be smaller than the queue");
    using address_t = ac_int<depth_log2, false>;
    using counter_t = ac_int<depth_log2 + 2, true>;

    struct state_t {
        address_t write_address = 0, read_address = 0;
        counter_t room = (1 << depth_log2) - reserve - 1;  ///< places left before ready falls, less one
        counter_t stored = -1;                             ///< entries in the memory, less one
        bit_t valid = 0;                                   ///< the output register holds an entry
    };

    static bit_t ready(const state_t& state) { return ~bit_t(state.room[depth_log2 + 1]); }

    /// True when the entry at read_address moves to the output register in this clock.
    static bit_t fetches(const state_t& state, bit_t taken) {
        return ~bit_t(state.stored[depth_log2 + 1]) & (~state.valid | taken);
    }

    /// \param write an entry is written at write_address in this clock (the caller heeds `ready` and `reserve`)
    /// \param taken the entry in the output register is taken in this clock (only while valid)
    static state_t step(const state_t& state, bit_t write, bit_t taken) {
        state_t next;
        const bit_t fetch = fetches(state, taken);
        next.write_address = state.write_address + write;
        next.read_address = state.read_address + fetch;
        next.room = state.room + fetch - write;
        next.stored = state.stored + write - fetch;
        next.valid = fetch | (state.valid & ~taken);
        return next;
    }
};

}  // namespace sheen::hls
