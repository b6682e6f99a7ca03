// SPDX-License-Identifier: MIT
/// \file
/// select(c, a, b): the one way in which kernels choose between two values.
///
/// The choice is made by masks, r = b XOR ((a XOR b) AND m) with m = all ones when c, else all zeros: the value is a
/// plain expression of its inputs, with no branch that an HLS tool could turn into a state of its own.
///
/// Formats: c is one bit (a bool converts); a, b and the result have one and the same type, so a wider expression is
/// narrowed by the caller, where its width is known.
#pragma once

#include <ac_fixed.h>
#include <ac_int.h>

namespace sheen::hls {

/// a if c, else b, for integers of any width.
template <int W, bool S>
ac_int<W, S> select(ac_int<1, false> c, const ac_int<W, S>& a, const ac_int<W, S>& b) {
    const ac_int<W, S> mask = -c;  // −1 or 0 in two bits, sign-extended or cut to W
    return b ^ ((a ^ b) & mask);
}

/// a if c, else b, for fixed-point numbers of any format: the same choice on their bits.
template <int W, int I, bool S, ac_q_mode Rounding, ac_o_mode Overflow>
ac_fixed<W, I, S, Rounding, Overflow> select(ac_int<1, false> c, const ac_fixed<W, I, S, Rounding, Overflow>& a,
                                             const ac_fixed<W, I, S, Rounding, Overflow>& b) {
    const ac_int<W, S> bits = select(c, ac_int<W, S>(a.template slc<W>(0)), ac_int<W, S>(b.template slc<W>(0)));
    ac_fixed<W, I, S, Rounding, Overflow> chosen = b;
    chosen.set_slc(0, bits);
    return chosen;
}

}  // namespace sheen::hls
