// SPDX-License-Identifier: MIT
/// \file
/// Exact coverage (contract 2) in integers: snapped vertices, the top-left rule, and the walk that a device follows.
/// The formulas are those of docs/architecture.md, "Coverage"; y points down, pixel (x, y) has its centre at (x+½,
/// y+½).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace sheen {

/// A point in 1/256 pixel.
struct SnappedPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend bool operator==(const SnappedPoint& a, const SnappedPoint& b) { return a.x == b.x && a.y == b.y; }
};

/// Doubled signed area in (1/256 px)²; positive when a, b, c turn clockwise on screen (y down).
std::int64_t doubled_area(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c);

/// One edge's phase accumulator: P and step of 2^32 fractions; the adder's carry-out is the Bresenham choice.
struct EdgePhase {
    std::uint32_t phase = 0;
    std::uint32_t step = 0;
};

/// The geometry of one triangle packet: what the edge walker is loaded with. A triangle, or what the image leaves of
/// one: a shape between a long edge and, on the other side, two edges that meet at the middle vertex or leave a jump
/// there. Signed fields (kappa, m, m_below) are kept signed here and encoded modulo 2^12.
struct TriangleWalk {
    int x = 0;              ///< first pixel of the first row (in the span's direction)
    int y = 0;              ///< first row
    int rows_above = 0;     ///< rows before the middle vertex
    int rows_below = 0;     ///< rows after it
    int kappa = 0;          ///< whole step of u = s·x on the long edge, per row
    int length = 0;         ///< span length of the first row
    int m = 0;              ///< κ_end − κ before the middle vertex
    int length_reload = 0;  ///< span length of the first row after the middle vertex
    int m_below = 0;        ///< κ_end − κ after it
    bool leftward = false;  ///< s = −1: the long edge is on the right, spans run left
    EdgePhase long_edge, upper, lower;
};

/// The walk of a triangle given in any winding. Leading and trailing empty rows are trimmed; inner empty rows stay.
/// Returns nothing when no pixel centre is covered. Fields of a part without rows are 0.
/// \throws Error when a coordinate lies outside [0, 4095·256].
std::optional<TriangleWalk> walk_triangle(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c);

/// The walks of a triangle's pixels in the image, in any winding, with coordinates within ±2^29, from top to bottom:
/// exactly the centres that the whole triangle covers, each in one walk, however its edges leave the image (1…4095
/// pixels wide and high). Only a triangle that leaves the image at its sides, or is higher than 4096 px, has several.
std::vector<TriangleWalk> walk_in_image(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c, int width,
                                        int height);

/// One row of a walk, as a device sees it: x, y and length in 0…4095.
struct WalkRow {
    int x = 0;  ///< first pixel, in the span's direction
    int y = 0;
    int length = 0;   ///< pixels; 0 for an empty row
    int row = 0;      ///< rows before this one: the j of contract 1
    int carries = 0;  ///< carries of the long edge so far: the u of contract 1 at the row's first pixel
};

/// Calls `visit` for each row of the walk, empty ones included, in the device's order. This is a device's geometry in
/// plain arithmetic, defined for any fields: x, y, length and their steps are taken modulo 2^12, carries come from
/// the phases modulo 2^32, and the first row below the middle vertex reloads length, step and the end edge's phase.
void for_each_row(const TriangleWalk& walk, const std::function<void(const WalkRow& row)>& visit);

/// Calls span(x, y, length, step) for each non-empty row of for_each_row; step is ±1, and the row's pixels are
/// x, x+step, … modulo 2^12. A device leaves out the pixels at x = 4095 (messages have that x); walks of triangles
/// never reach them.
void for_each_span(const TriangleWalk& walk, const std::function<void(int x, int y, int length, int step)>& span);

}  // namespace sheen
