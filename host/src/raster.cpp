// SPDX-License-Identifier: MIT
#include "sheen/raster.hpp"

#include <algorithm>
#include <array>

#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"

namespace sheen {
namespace {

constexpr std::int64_t pixel = std::int64_t{1} << hls::subpixel_bits;  // one pixel in 1/256 px
constexpr std::int64_t centre = pixel / 2;                             // of a pixel, from its corner
constexpr int coordinate_mask = (1 << hls::coordinate_bits) - 1;
constexpr std::int64_t coordinate_limit = coordinate_mask * pixel;

// The phases are exact while rows·dy ≤ 2^32 (dy in 1/256 px): after j steps the rounded phase is off by less than
// (j + 1)/2 units of 2^−32, and the true one stays 1/(2·dy) from every carry. The tallest triangle fits.
static_assert(coordinate_mask * coordinate_limit <= std::int64_t{1} << hls::phase_bits);

std::int64_t floor_div(std::int64_t n, std::int64_t d) {
    const std::int64_t q = n / d;
    return n % d < 0 ? q - 1 : q;  // d > 0
}

/// First row whose centres lie at or below y: ⌈(y − 128)/256⌉.
std::int64_t first_row(std::int64_t y) { return -floor_div(centre - y, pixel); }

/// A falling edge seen along the span's direction: u = s·x. position() is the first pixel inside when this is the
/// long edge, and the exclusive end when it is the other one.
class Edge {
 public:
    Edge(const SnappedPoint& top, const SnappedPoint& bottom, int s)
        : top_(top), s_(s), dx_(bottom.x - top.x), dy_(bottom.y - top.y) {}

    /// U = ⌊ν/d⌋ + 1 at a row's centres, d = 256·dy.
    [[nodiscard]] std::int64_t position(std::int64_t row) const { return floor_div(nu(row), pixel * dy_) + 1; }

    /// Whole step of U per row: κ = ⌊s·dx/dy⌋.
    [[nodiscard]] std::int64_t kappa() const { return floor_div(s_ * dx_, dy_); }

    /// P = round(2^32·(2φ+1)/(2·dy)) with φ = ⌊(ν mod d)/256⌋, and the step round(2^32·ρ/dy) with ρ = s·dx mod dy.
    [[nodiscard]] EdgePhase phase(std::int64_t row) const {
        constexpr std::int64_t one = std::int64_t{1} << hls::phase_bits;
        const std::int64_t phi = (nu(row) - (position(row) - 1) * pixel * dy_) / pixel;
        const std::int64_t rho = s_ * dx_ - kappa() * dy_;
        return {static_cast<std::uint32_t>((one * (2 * phi + 1) + dy_) / (2 * dy_)),
                static_cast<std::uint32_t>((2 * one * rho + dy_) / (2 * dy_))};
    }

 private:
    /// ν = n − 1 (rightward) or −n (leftward), where n/d is the edge's x at the row's centres, less half a pixel.
    [[nodiscard]] std::int64_t nu(std::int64_t row) const {
        const std::int64_t n = (top_.x - centre) * dy_ + dx_ * (pixel * row + centre - top_.y);
        return s_ > 0 ? n - 1 : -n;
    }

    SnappedPoint top_;
    std::int64_t s_, dx_, dy_;
};

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

std::optional<TriangleWalk> walk_triangle(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c) {
    std::array<SnappedPoint, 3> v{a, b, c};
    for (const SnappedPoint& p : v) require_in_range(p);
    std::sort(v.begin(), v.end(),
              [](const SnappedPoint& p, const SnappedPoint& q) { return p.y != q.y ? p.y < q.y : p.x < q.x; });

    const std::int64_t area = doubled_area(v[0], v[1], v[2]);
    if (area == 0) return std::nullopt;
    const int s = area > 0 ? 1 : -1;  // the middle vertex lies on the right: the long edge is on the left
    const Edge long_edge(v[0], v[2], s);
    const Edge upper(v[0], v[1], s);
    const Edge lower(v[1], v[2], s);

    // Rows first…middle−1 end on the upper edge, rows middle…end−1 on the lower one. Trim the empty ones outside.
    std::int64_t first = first_row(v[0].y);
    std::int64_t middle = first_row(v[1].y);
    std::int64_t end = first_row(v[2].y);
    const auto length_at = [&](std::int64_t row) {
        return (row < middle ? upper : lower).position(row) - long_edge.position(row);
    };
    while (first < end && length_at(first) == 0) ++first;
    while (first < end && length_at(end - 1) == 0) --end;
    if (first == end) return std::nullopt;
    const std::int64_t split = std::clamp(middle, first, end);

    TriangleWalk walk;
    walk.x = static_cast<int>(s * long_edge.position(first));
    walk.y = static_cast<int>(first);
    walk.rows_above = static_cast<int>(split - first);
    walk.rows_below = static_cast<int>(end - split);
    walk.leftward = s < 0;
    walk.kappa = static_cast<int>(long_edge.kappa());
    walk.long_edge = long_edge.phase(first);
    if (walk.rows_above > 0) {
        walk.length = static_cast<int>(length_at(first));
        walk.m = static_cast<int>(upper.kappa() - long_edge.kappa());
        walk.upper = upper.phase(first);
    }
    if (walk.rows_below > 0) {
        walk.length_reload = static_cast<int>(length_at(split));
        walk.m_below = static_cast<int>(lower.kappa() - long_edge.kappa());
        walk.lower = lower.phase(split);
    }
    return walk;
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
