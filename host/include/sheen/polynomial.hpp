// SPDX-License-Identifier: MIT
/// \file
/// Contract 1: a channel is an exact polynomial. Quadratics over the screen (paper `quadratic`, eq. 4), fitted to a
/// triangle's nodes, rounded once, and turned into the six words that devices step.
#pragma once

#include <array>
#include <cstdint>

#include "sheen/raster.hpp"

namespace sheen {

/// Quadruple precision (113-bit significand). The coefficients of slivers that still cover a pixel centre reach 10^18,
/// and their terms cancel down to 8-bit steps: in double, slivers of 4095 px are 15 steps off (tests/polynomial_test).
#if __LDBL_MANT_DIG__ >= 113
using Coefficient = long double;
#else
using Coefficient = __float128;
#endif

/// A two-variate quadratic T₅X² + T₄XY + T₃Y² + T₂X + T₁Y + T₀ (paper `quadratic`, eq. 4) in whole pixels relative to
/// pixel (origin_x, origin_y), sampled at pixel centres: X = x − origin_x gives the value at the centre of pixel x.
struct Polynomial {
    std::array<Coefficient, 6> t{};  ///< T₀…T₅
    int origin_x = 0;
    int origin_y = 0;
    /// Value at the centre of pixel (x, y).
    [[nodiscard]] double at(int x, int y) const;
};

/// A pixel, by its indices.
struct PixelIndex {
    int x = 0;
    int y = 0;
};

/// The pixel that holds the bounding box's centre: rounding coefficients about it costs the least.
PixelIndex centre_pixel(const std::array<SnappedPoint, 3>& triangle);
/// The pixel in the middle of the walk's covered pixels.
PixelIndex centre_pixel(const TriangleWalk& walk);

/// The linear function with the given values at the vertices; a constant, their mean, when the triangle has no area.
/// `origin` lies in the triangle's bounding box.
Polynomial fit_linear(const std::array<SnappedPoint, 3>& triangle, const std::array<double, 3>& values,
                      const PixelIndex& origin);

/// The quadratic with the given values at vertices 0, 1, 2 and at the midpoints of edges 01, 12, 20 (paper
/// `quadratic`, section 3), about `origin`, which lies in the triangle's bounding box. Solved in barycentric form: one
/// division, by the doubled area, so that no edge is special. The printed T₃ is singular when edge 12 of the
/// paper is horizontal. A constant, the mean of the values, when the triangle has no area.
///
/// With values within ±306 the result is at most 2^−21 off the exact quadratic anywhere in the triangle, whatever its
/// shape. That is why the work is done in double while s = L²/(2·area) ≤ 64, L the longest edge, and in Coefficient
/// beyond: a barycentric coordinate's three terms add up to at most 2.5·s in magnitude, the 12 products of two of them
/// with their weights to 18·306·(2.5·s)², and each has met at most 17 roundings of 2^−53: 6.5·10^−11·s² in all.
Polynomial fit_quadratic(const std::array<SnappedPoint, 3>& triangle, const std::array<double, 6>& values,
                         const PixelIndex& origin);

/// The six words {I, D, E, h, dD, dE} of a channel, modulo 2^32.
struct ChannelWords {
    std::array<std::uint32_t, 6> words{};
    friend bool operator==(const ChannelWords& a, const ChannelWords& b) { return a.words == b.words; }
};

/// Closed form of contract 1: I + u·D + j·E + C(u,2)·h + u·j·dD + C(j,2)·dE modulo 2^32, u counted from κ·j on row j.
std::uint32_t channel_value(const ChannelWords& channel, std::int64_t u, std::int64_t j);

/// Rounds each coefficient once to `fraction_bits` (nearest, modulo 2^32), adds ½ when `round_half`, and derives the
/// six words at the walk's start pixel exactly. At pixel (x, y) the channel then differs from the polynomial (plus ½)
/// by at most ½·(1 + |X| + |Y| + X² + |XY| + Y²)·2^−fraction_bits, X and Y counted from the polynomial's origin.
ChannelWords channel_words(const Polynomial& polynomial, const TriangleWalk& walk, int fraction_bits, bool round_half);

}  // namespace sheen
