// SPDX-License-Identifier: MIT
/// \file
/// exp2_rom: the highlight 2^(8 − z) in 8-bit steps, by one table read and a shift (Sheen's log-quadratic).
///
///     z < 0        taken as 0: the highlight's peak
///     fraction     address of the table, one octave (exp2_table.hpp)
///     integer      the table's value goes right by it; from 16 on nothing is left
///
/// No multiplier: the exponent n, and the highlight's strength, are in z.
///
/// Formats: z s8.address_bits; value u8.fraction_bits, truncated by the shift.
/// Error against 2^(8 − z) where 0 ≤ z: ½ unit of the table and half a bin, 2^8·ln 2/2^(address_bits + 1), both
/// divided by 2^⌊z⌋, and one unit of the value for the shift; at z = 0 the table's greatest entry.
///
/// Latency: 4 (address, data, two stages of shift). One call is one clock.
#pragma once

#include "sheen/hls/exp2_table.hpp"
#include "sheen/hls/types.hpp"

namespace sheen::hls {

/// \tparam address_bits  the table has 2^address_bits words of data_bits bits
/// \tparam fraction_bits of the value; at least data_bits − 8
template <int address_bits, int data_bits, int fraction_bits>
struct exp2_rom {
    static_assert(fraction_bits >= data_bits - component_bits, "the value holds all bits of the table");

    static constexpr int latency = 4;
    static constexpr int z_bits = log_integer_bits + address_bits;
    static constexpr int value_bits = component_bits + fraction_bits;
    static constexpr int shift_bits = 4;
    using z_t = ac_int<z_bits, true>;
    using address_t = ac_int<address_bits, false>;
    using data_t = ac_int<data_bits, false>;
    using value_t = ac_int<value_bits, false>;
    using shift_t = ac_int<shift_bits, false>;

    struct state_t {
        // Address.
        address_t address = 0;
        shift_t address_shift = 0;
        bit_t address_none = 0;
        // Data: the table's entry.
        data_t data = 0;
        shift_t data_shift = 0;
        bit_t data_none = 0;
        // Shifted by the two low bits.
        value_t near = 0;
        ac_int<2, false> near_shift = 0;
        bit_t near_none = 0;
        // Output.
        value_t value = 0;
    };

    static state_t step(const state_t& state, z_t z) {
        state_t next;
        const bit_t negative = z[z_bits - 1];
        const ac_int<log_integer_bits - 1 - shift_bits, false> far =
            z.template slc<log_integer_bits - 1 - shift_bits>(address_bits + shift_bits);
        next.address = select(negative, address_t(0), address_t(z.template slc<address_bits>(0)));
        next.address_shift = select(negative, shift_t(0), shift_t(z.template slc<shift_bits>(address_bits)));
        next.address_none = ~negative & bit_t(far != 0);

        next.data = exp2_table<address_bits, data_bits>[state.address.to_uint()];
        next.data_shift = state.address_shift;
        next.data_none = state.address_none;

        value_t whole = state.data;
        whole <<= fraction_bits - (data_bits - component_bits);
        next.near = whole >> ac_int<2, false>(state.data_shift.template slc<2>(0));
        next.near_shift = state.data_shift.template slc<2>(2);
        next.near_none = state.data_none;

        const ac_int<4, false> rest = ac_int<4, false>(state.near_shift) << 2;
        next.value = select(state.near_none, value_t(0), value_t(state.near >> rest));
        return next;
    }
};

}  // namespace sheen::hls
