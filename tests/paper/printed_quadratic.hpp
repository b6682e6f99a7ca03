// SPDX-License-Identifier: MIT
/// \file
/// T0 to T5 as paper `quadratic`, section 3, prints them, over any Real: drawn with double, counted with Counted.
#pragma once

#include <array>

namespace sheen::paper {

/// Vertices 2 and 3 from vertex 1, in pixels.
template <typename Real>
struct PrintedGeometry {
    Real x2, y2, x3, y3;
};

/// One colour at the vertices and in the middle of the edges.
template <typename Real>
struct PrintedNodes {
    Real i1, i2, i3, i12, i13, i23;
};

/// T0…T5, X and Y in pixels from vertex 1. Every factor that is printed twice is made once, and C23 is 4·(I1 − I12 −
/// I13 + I23). T3 has no value where vertices 1 and 2 are at one height.
template <typename Real>
std::array<Real, 6> printed_terms(const PrintedGeometry<Real>& at, const PrintedNodes<Real>& node) {
    const auto& [x2, y2, x3, y3] = at;
    const auto& [i1, i2, i3, i12, i13, i23] = node;
    const Real two(2.0);
    const Real three(3.0);
    const Real four(4.0);
    const Real c2 = four * i12 - three * i1 - i2;
    const Real c12 = i1 + i2 - two * i12;
    const Real c3 = four * i13 - three * i1 - i3;
    const Real c13 = i1 + i3 - two * i13;
    const Real c23 = four * (i1 - i12 - i13 + i23);

    const Real area = x2 * y3 - y2 * x3;
    const Real t1 = (c3 * x2 - c2 * x3) / area;
    const Real t2 = (c2 * y3 - c3 * y2) / area;

    const Real p = two * x2 * x2 * y3 - two * x2 * y2 * x3;
    const Real q = two * y2 * x3 * x3 - two * x2 * x3 * y3;
    const Real r = y2 * x3 * y3 - x2 * y3 * y3;
    const Real s = x2 * y2 * y3 - y2 * y2 * x3;
    const Real first = four * c13 * y2 - c23 * y3;
    const Real second = four * c12 * y3 - c23 * y2;
    const Real divisor = p * r - s * q;
    const Real t4 = (first * p - second * q) / divisor;
    const Real t5 = (second * r - first * s) / divisor;
    const Real t3 = (two * c12 - t5 * x2 * x2 - t4 * x2 * y2) / (y2 * y2);
    return {i1, t1, t2, t3, t4, t5};
}

}  // namespace sheen::paper
