// SPDX-License-Identifier: MIT
/// \file
/// bell_rom: cos^p of an angle by one table read (paper `spherical`, section 4, the ROMs of figure 12).
///
/// The value is cos^p ξ inside |ξ| < π/2 and 0 outside (eq. 19; p = exponent_tenths / 10). cos is even and bins lie
/// symmetrically about 0, so a negative angle's bin is the complement of a positive one's: value(NOT ra) = value(ra).
///
///     ra        s w…w q…q      sign, wrap_bits, quadrant_bits; in quadrants, s(1+wrap_bits).quadrant_bits
///     outside   the sign and the wrap bits are not all equal: |ξ| ≥ π/2, the value is 0
///     address   folded: q…q XOR s (the table holds one quadrant); else s q…q (it holds both halves, no logic before
///     it)
///
/// Folding halves the memory and never changes a value. The paper addresses its 6×6 ROM by the register's six top bits
/// alone: address_bits = 6, data_bits = 6, wrap_bits = 0, not folded. Without wrap bits the angle comes round again
/// past ±π/2, so whoever makes the angle must keep it inside, or the highlight shows a ghost; 3 to 5 wrap bits let it
/// run over 8 to 32 quadrants either way.
///
/// Formats: value is u0.data_bits whose full scale 2^data_bits − 1 stands for 1 (bell_table.hpp).
/// Error against cos^p ξ, in units of the value's last place: at most ½ from rounding, and the slope's maximum
/// √p·((p−1)/p)^((p−1)/2) times half a bin, (2^data_bits − 1)·(π/4)/2^quadrant_bits.
///
/// Latency: 3 (address register, data register, output register). One call is one clock; value and value_valid of the
/// state that it returns stand at the ports after the clock's edge.
#pragma once

#include "sheen/hls/bell_table.hpp"
#include "sheen/hls/types.hpp"

namespace sheen::hls {

/// \tparam address_bits    the ROM has 2^address_bits words of data_bits bits
/// \tparam exponent_tenths ten times the exponent p of the base cos^p: 10 for cos, 20 for cos², 95 for cos^9.5
/// \tparam wrap_bits       bits of ra between its sign and the quadrant's bins
/// \tparam folded          the ROM holds one quadrant instead of both halves
template <int address_bits, int data_bits, int exponent_tenths, int wrap_bits, bool folded>
struct bell_rom {
    static_assert(wrap_bits >= 0 && wrap_bits <= 8, "0 <= wrap_bits <= 8");

    static constexpr int latency = 3;
    static constexpr int quadrant_bits = folded ? address_bits : address_bits - 1;
    static constexpr int ra_bits = 1 + wrap_bits + quadrant_bits;
    using ra_t = ac_int<ra_bits, true>;
    using address_t = ac_int<address_bits, false>;
    using value_t = ac_int<data_bits, false>;

    struct input_t {
        ra_t ra = 0;
        bit_t ra_valid = 0;
    };

    struct state_t {
        address_t address = 0;  ///< address register
        bit_t address_outside = 0;
        bit_t address_valid = 0;
        value_t data = 0;  ///< data register: the table's entry
        bit_t data_outside = 0;
        bit_t data_valid = 0;
        value_t value = 0;  ///< output register
        bit_t value_valid = 0;
    };

    static state_t step(state_t state, input_t in) {
        state_t next;
        next.address = address_of(in.ra);
        next.address_outside = outside(in.ra);
        next.address_valid = in.ra_valid;
        next.data = entry(state.address);
        next.data_outside = state.address_outside;
        next.data_valid = state.address_valid;
        next.value = select(state.data_outside, value_t(0), state.data);
        next.value_valid = state.data_valid;
        return next;
    }

 private:
    static bit_t outside(ra_t ra) {
        const ac_int<1 + wrap_bits, true> top = ra.template slc<1 + wrap_bits>(quadrant_bits);
        return bit_t(top != 0) & bit_t(top != -1);
    }

    static address_t address_of(ra_t ra) {
        const ac_int<quadrant_bits, false> bin = ra.template slc<quadrant_bits>(0);
        const bit_t sign = ra[ra_bits - 1];
        if constexpr (folded) {
            return select(sign, ac_int<quadrant_bits, false>(~bin), bin);
        } else {
            address_t address = 0;
            address.set_slc(0, bin);
            address.set_slc(quadrant_bits, sign);
            return address;
        }
    }

    static value_t entry(address_t address) {
        if constexpr (folded) {
            return bell_table<quadrant_bits, data_bits, exponent_tenths>[address.to_uint()];
        } else {
            return whole_bell_table<quadrant_bits, data_bits, exponent_tenths>[address.to_uint()];
        }
    }
};

}  // namespace sheen::hls
