// SPDX-License-Identifier: MIT
/// \file
/// The left edges of a triangle's pixels, along which loops step from row to row.
#pragma once

#include <cstddef>
#include <vector>

#include "sheen/loop.hpp"

namespace sheen {

/// From row `index` of triangle_rows() on the leftmost pixel moves by `kappa` a row, and by one more where the edge
/// carries.
struct LeftEdge {
    std::size_t index = 0;
    PixelRow row;  ///< the edge's first
    int kappa = 0;
};

/// The left edges, from top to bottom: one above and one below the middle vertex where that lies on the left, else one;
/// for each walk. Integers of the rasteriser: no part of a method's cost.
std::vector<LeftEdge> left_edges(const ScreenTriangle& triangle);

}  // namespace sheen
