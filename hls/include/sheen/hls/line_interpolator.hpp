// SPDX-License-Identifier: MIT
/// \file
/// line_interpolator: the angle register of one span (paper `spherical`, section 4 and the printed entity).
///
/// Along a span the angle that a bell table is read with is linear, ξ(X) = s·X + b, so one addition a pixel makes it:
///
///     ξ(X_start) = sxsb = s·X_start + b,      ξ(X+1) = ξ(X) + s    (modulo 2^phase_bits).
///
/// (The text gives this step once as s and once, beside figure 12, as b; s is right.) The addition is exact, so after
/// X steps the register holds sxsb + X·s modulo 2^phase_bits for any two words. If the host rounds both to nearest, the
/// angle is off by at most (X + 1)/2 units of the register's last place, all of it from rounding s and b once.
///
/// Formats: phase, sxsb and s are s(1+w).(phase_bits−1−w) in quadrants (π/2 of the table's cosine), w being the wrap
/// bits of the bell_rom that follows; ra is the phase's top ra_bits bits, s(1+w).(ra_bits−1−w), rounded down: the
/// number of the bin that the angle lies in. Preset `paper`: phase_bits = 12, ra_bits = 6, w = 0.
///
/// Latency: 1. One call is one clock; what it returns stands at the ports after the clock's edge.
#pragma once

#include "sheen/hls/types.hpp"

namespace sheen::hls {

/// \tparam phase_bits width of the angle; 12 in preset `paper`
/// \tparam ra_bits    width of ra, the angle's top
template <int phase_bits, int ra_bits>
struct line_interpolator {
    static_assert(ra_bits >= 1 && ra_bits <= phase_bits, "ra is the top of the angle: 1 <= ra_bits <= phase_bits");

    static constexpr int latency = 1;
    using angle_t = ac_int<phase_bits, true>;
    using ra_t = ac_int<ra_bits, true>;

    struct input_t {
        bit_t init = 0;    ///< with step: take sxsb, not the sum
        bit_t step = 0;    ///< one pixel further; without it the phase rests
        angle_t sxsb = 0;  ///< the span's first angle, s·X_start + b
        angle_t s = 0;     ///< the angle from one pixel to the next
    };

    struct output_t {
        angle_t phase = 0;   ///< the state: the angle of the present pixel
        ra_t ra = 0;         ///< the bell table's address
        bit_t ra_valid = 0;  ///< this clock brought a new ra
    };

    static output_t step(angle_t phase, input_t in) {
        const angle_t add_out = phase + in.s;  // modulo 2^phase_bits, as the register is
        const angle_t mpx_out = select(in.init, in.sxsb, add_out);
        const angle_t reg_out = select(in.step, mpx_out, phase);
        return {reg_out, reg_out.template slc<ra_bits>(phase_bits - ra_bits), in.step};
    }
};

}  // namespace sheen::hls
