// SPDX-License-Identifier: MIT
/// \file
/// A triangle's edge at the rows' centres, in exact integers: what coverage and walks are made of
/// (docs/architecture.md, "Coverage").
#pragma once

#include <cstdint>
#include <optional>

#include "sheen/hls/formats.hpp"
#include "sheen/raster.hpp"

namespace sheen {

inline constexpr std::int64_t subpixels = std::int64_t{1} << hls::subpixel_bits;  ///< of a pixel
inline constexpr std::int64_t half_pixel = subpixels / 2;

inline std::int64_t floor_div(std::int64_t n, std::int64_t d) {
    const std::int64_t q = n / d;
    return n % d < 0 ? q - 1 : q;  // d > 0
}

/// First row whose centres lie at or below y: ⌈(y − 128)/256⌉.
inline std::int64_t first_row(std::int64_t y) { return -floor_div(half_pixel - y, subpixels); }

/// A falling edge (top.y < bottom.y, coordinates within ±2^29, rows within 0…4095).
class Edge {
 public:
    Edge(const SnappedPoint& top, const SnappedPoint& bottom)
        : top_(top), dx_(bottom.x - top.x), dy_(bottom.y - top.y) {}

    /// S = ⌈n/d⌉, d = 256·dy: the first pixel at or right of the edge at a row's centres.
    [[nodiscard]] std::int64_t boundary(std::int64_t row) const { return floor_div(n(row) - 1, subpixels * dy_) + 1; }

    /// U in the span's direction u = s·x: the first pixel inside when this is the long edge, and the exclusive end
    /// when it is the other one. U = ⌊ν/d⌋ + 1 with ν = n − 1 (s = +1) or −n (s = −1), so it is S or 1 − S.
    [[nodiscard]] std::int64_t position(std::int64_t row, int s) const {
        return s > 0 ? boundary(row) : 1 - boundary(row);
    }

    /// Whole step of U per row: κ = ⌊s·dx/dy⌋.
    [[nodiscard]] std::int64_t kappa(int s) const { return floor_div(s * dx_, dy_); }

    /// P = round(2^32·(2φ+1)/(2·dy)) with φ = ⌊(ν mod d)/256⌋, and the step round(2^32·ρ/dy) with ρ = s·dx mod dy.
    [[nodiscard]] EdgePhase phase(std::int64_t row, int s) const {
        const std::int64_t nu = s > 0 ? n(row) - 1 : -n(row);
        const std::int64_t phi = (nu - (position(row, s) - 1) * subpixels * dy_) / subpixels;
        const std::int64_t rho = s * dx_ - kappa(s) * dy_;
        return {rounded_fraction(2 * phi + 1), rounded_fraction(2 * rho)};
    }

    /// Rows that a walk may step this edge. The phases are exact while rows·dy ≤ 2^32: after j steps the rounded phase
    /// is off by less than (j + 1)/2 units of 2^−32, and the true one stays 1/(2·dy) from every carry.
    [[nodiscard]] std::int64_t exact_rows() const { return (std::int64_t{1} << hls::phase_bits) / dy_; }

    friend bool operator==(const Edge& a, const Edge& b) {
        return a.top_ == b.top_ && a.dx_ == b.dx_ && a.dy_ == b.dy_;
    }

 private:
    /// n/d is the edge's x at the row's centres, less half a pixel.
    [[nodiscard]] std::int64_t n(std::int64_t row) const {
        return (top_.x - half_pixel) * dy_ + dx_ * (subpixels * row + half_pixel - top_.y);
    }
    /// round(2^32·halves/(2·dy)) modulo 2^32; halves ≤ 2·dy ≤ 2^31, so the product fits 64 bits.
    [[nodiscard]] std::uint32_t rounded_fraction(std::int64_t halves) const {
        const auto dy = static_cast<std::uint64_t>(dy_);
        return static_cast<std::uint32_t>(((static_cast<std::uint64_t>(halves) << hls::phase_bits) + dy) / (2 * dy));
    }

    SnappedPoint top_;
    std::int64_t dx_, dy_;
};

/// A shape between a long edge and, on the other side, one edge down to row `middle` and another one below it: rows
/// first…end−1. `s` is +1 when the long edge is on the left.
struct EdgeWalk {
    Edge long_edge, upper, lower;
    std::int64_t first = 0, middle = 0, end = 0;
    int s = 1;
};

/// The walk of such a shape, trimmed; nothing when no pixel is covered. Covered pixels must lie in 0…4094.
std::optional<TriangleWalk> make_walk(const EdgeWalk& shape);

}  // namespace sheen
