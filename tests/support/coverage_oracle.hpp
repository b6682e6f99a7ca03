// SPDX-License-Identifier: MIT
/// \file
/// Three independent answers, in exact integers, to "does this shape cover the centre of pixel (x, y)?". None of them
/// shares a line with host/src/raster.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "random_triangles.hpp"

namespace sheen::test {

inline SnappedPoint pixel_centre(std::int64_t x, std::int64_t y) { return {256 * x + 128, 256 * y + 128}; }

/// (b − a) × (p − a)
inline std::int64_t cross(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// The textbook rule: inside by three edge functions; a centre on an edge belongs to top edges (horizontal, going
/// right in clockwise order) and left edges (going up).
inline bool edge_functions_cover(Triangle t, std::int64_t x, std::int64_t y) {
    const std::int64_t area = cross(t[0], t[1], t[2]);
    if (area == 0) return false;
    if (area < 0) std::swap(t[1], t[2]);
    const SnappedPoint p = pixel_centre(x, y);
    for (std::size_t k = 0; k < 3; ++k) {
        const SnappedPoint& a = t[k];
        const SnappedPoint& b = t[(k + 1) % 3];
        const std::int64_t w = cross(a, b, p);
        const bool top_left = (a.y == b.y && b.x > a.x) || b.y < a.y;
        if (w < 0 || (w == 0 && !top_left)) return false;
    }
    return true;
}

/// Strictly inside at the centre plus (ε, ε²): the sign of w + ε·∂w/∂x + ε²·∂w/∂y, by its first term that isn't 0.
inline bool moved_sample_covers(const Triangle& t, std::int64_t x, std::int64_t y) {
    const auto sign = [](std::int64_t v) { return (v > 0) - (v < 0); };
    const int orientation = sign(cross(t[0], t[1], t[2]));
    if (orientation == 0) return false;
    const SnappedPoint p = pixel_centre(x, y);
    for (std::size_t k = 0; k < 3; ++k) {
        const SnappedPoint& a = t[k];
        const SnappedPoint& b = t[(k + 1) % 3];
        int side = sign(cross(a, b, p));
        if (side == 0) side = sign(a.y - b.y);  // ∂w/∂x
        if (side == 0) side = sign(b.x - a.x);  // ∂w/∂y
        if (side != orientation) return false;
    }
    return true;
}

/// Even-odd rule for any simple polygon at the same moved sample: edges that cross the sample's row right of it.
inline bool polygon_covers(const std::vector<SnappedPoint>& polygon, std::int64_t x, std::int64_t y) {
    const SnappedPoint p = pixel_centre(x, y);
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        SnappedPoint a = polygon[k];
        SnappedPoint b = polygon[(k + 1) % polygon.size()];
        if ((a.y <= p.y) == (b.y <= p.y)) continue;  // on the row itself counts as above: the sample is ε² lower
        if (a.y > b.y) std::swap(a, b);
        // Crossing right of the sample: x_cross > p.x, strictly, since the sample is ε to the right.
        const std::int64_t crossing = (b.x - a.x) * (p.y - a.y) + (a.x - p.x) * (b.y - a.y);
        if (crossing > 0) inside = !inside;
    }
    return inside;
}

}  // namespace sheen::test
