// SPDX-License-Identifier: MIT
#include "sheen/raster.hpp"

#include <algorithm>
#include <array>

#include "edge.hpp"
#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"

namespace sheen {
namespace {

constexpr int coordinate_mask = (1 << hls::coordinate_bits) - 1;
constexpr std::int64_t coordinate_limit = coordinate_mask * subpixels;

// Every row of the tallest triangle is within Edge::exact_rows().
static_assert(coordinate_mask * coordinate_limit <= std::int64_t{1} << hls::phase_bits);

void require_in_range(const SnappedPoint& p) {
    if (std::min(p.x, p.y) < 0 || std::max(p.x, p.y) > coordinate_limit) {
        throw Error("triangle vertex (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
                    ") in 1/256 px: coordinates must lie in 0…" + std::to_string(coordinate_limit) +
                    " (clip the triangle first)");
    }
}

int wrapped(int value) { return value & coordinate_mask; }

/// P += step; returns the carry-out.
int advance(EdgePhase& edge) {
    edge.phase += edge.step;
    return edge.phase < edge.step ? 1 : 0;
}

}  // namespace

std::int64_t doubled_area(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::optional<TriangleWalk> make_walk(const EdgeWalk& shape) {
    const Edge& long_edge = shape.long_edge;
    const Edge& upper = shape.upper;
    const Edge& lower = shape.lower;
    const int s = shape.s;
    const auto length_at = [&](std::int64_t row) {
        return (row < shape.middle ? upper : lower).position(row, s) - long_edge.position(row, s);
    };
    // Trim the empty rows outside.
    std::int64_t first = shape.first;
    std::int64_t end = shape.end;
    while (first < end && length_at(first) == 0) ++first;
    while (first < end && length_at(end - 1) == 0) --end;
    if (first == end) return std::nullopt;
    const std::int64_t split = std::clamp(shape.middle, first, end);

    TriangleWalk walk;
    walk.x = static_cast<int>(s * long_edge.position(first, s));
    walk.y = static_cast<int>(first);
    walk.rows_above = static_cast<int>(split - first);
    walk.rows_below = static_cast<int>(end - split);
    walk.leftward = s < 0;
    walk.kappa = static_cast<int>(long_edge.kappa(s));
    walk.long_edge = long_edge.phase(first, s);
    if (walk.rows_above > 0) {
        walk.length = static_cast<int>(length_at(first));
        walk.m = static_cast<int>(upper.kappa(s) - long_edge.kappa(s));
        walk.upper = upper.phase(first, s);
    }
    if (walk.rows_below > 0) {
        walk.length_reload = static_cast<int>(length_at(split));
        walk.m_below = static_cast<int>(lower.kappa(s) - long_edge.kappa(s));
        walk.lower = lower.phase(split, s);
    }
    return walk;
}

std::optional<TriangleWalk> walk_triangle(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c) {
    std::array<SnappedPoint, 3> v{a, b, c};
    for (const SnappedPoint& p : v) require_in_range(p);
    std::sort(v.begin(), v.end(),
              [](const SnappedPoint& p, const SnappedPoint& q) { return p.y != q.y ? p.y < q.y : p.x < q.x; });

    const std::int64_t area = doubled_area(v[0], v[1], v[2]);
    if (area == 0) return std::nullopt;
    const int s = area > 0 ? 1 : -1;  // the middle vertex lies on the right: the long edge is on the left
    return make_walk({Edge(v[0], v[2]), Edge(v[0], v[1]), Edge(v[1], v[2]), first_row(v[0].y), first_row(v[1].y),
                      first_row(v[2].y), s});
}

void for_each_row(const TriangleWalk& walk, const std::function<void(const WalkRow& row)>& visit) {
    const int rows_above = wrapped(walk.rows_above);
    const int rows = rows_above + wrapped(walk.rows_below);
    const bool starts_below = rows_above == 0;
    const int s = walk.leftward ? -1 : 1;

    EdgePhase long_edge = walk.long_edge;
    EdgePhase end_edge = starts_below ? walk.lower : walk.upper;
    int m = starts_below ? walk.m_below : walk.m;
    WalkRow state{wrapped(walk.x), wrapped(walk.y), wrapped(starts_below ? walk.length_reload : walk.length), 0, 0};
    while (state.row < rows) {
        visit(state);
        const int carry = advance(long_edge);
        state.x = wrapped(state.x + s * (wrapped(walk.kappa) + carry));
        state.y = wrapped(state.y + 1);
        state.carries += carry;
        ++state.row;
        if (state.row == rows_above) {
            state.length = wrapped(walk.length_reload);
            m = walk.m_below;
            end_edge = walk.lower;
        } else {
            state.length = wrapped(state.length + wrapped(m) + advance(end_edge) - carry);
        }
    }
}

void for_each_span(const TriangleWalk& walk, const std::function<void(int x, int y, int length, int step)>& span) {
    const int step = walk.leftward ? -1 : 1;
    for_each_row(walk, [&](const WalkRow& row) {
        if (row.length > 0) span(row.x, row.y, row.length, step);
    });
}

}  // namespace sheen
