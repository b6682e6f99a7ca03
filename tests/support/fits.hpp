// SPDX-License-Identifier: MIT
/// \file
/// Judging fitted polynomials: nodes on pixel centres, the rounding bound, a triangle's shape.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fitted_setups.hpp"
#include "sheen/polynomial.hpp"

namespace sheen::test {

/// Largest possible effect of rounding the six coefficients, X and Y pixels from the origin.
inline double rounding_bound(const Polynomial& p, int px, int py) {
    const double x = std::abs(px - p.origin_x);
    const double y = std::abs(py - p.origin_y);
    return 0.5 * (1 + x + y + x * x + x * y + y * y) / (1 << hls::colour_fraction_bits);
}

/// Longest edge² over the doubled area: 1.15 for an equilateral triangle, beyond 1e6 for extreme slivers.
inline double slenderness(const Triangle& t) {
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto dx = static_cast<double>(t[k].x - t[(k + 1) % 3].x);
        const auto dy = static_cast<double>(t[k].y - t[(k + 1) % 3].y);
        longest = std::max(longest, dx * dx + dy * dy);
    }
    return longest / std::abs(static_cast<double>(doubled_area(t[0], t[1], t[2])));
}

/// A triangle with area whose vertices and edge midpoints are pixel centres.
inline Triangle triangle_on_centres(Rng& rng) {
    Triangle t{};
    do {
        for (SnappedPoint& p : t) p = {512 * uniform(rng, 0, 60) + 128, 512 * uniform(rng, 0, 60) + 128};
    } while (doubled_area(t[0], t[1], t[2]) == 0);
    return t;
}

inline SnappedPoint middle(const SnappedPoint& a, const SnappedPoint& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

/// The polynomial takes the node values at vertices 0, 1, 2 and midpoints 01, 12, 20, all of them pixel centres.
inline void expect_interpolates(const Polynomial& p, const Triangle& t, const Nodes& nodes) {
    const std::array<SnappedPoint, 6> points{
        t[0], t[1], t[2], middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
    for (std::size_t k = 0; k < 6; ++k) {
        const auto x = static_cast<int>(points[k].x / 256);
        const auto y = static_cast<int>(points[k].y / 256);
        ASSERT_NEAR(p.at(x, y), nodes[k], 1e-9) << "node " << k;
    }
}

}  // namespace sheen::test
