// SPDX-License-Identifier: MIT
/// \file
/// A triangle's rows for methods that interpolate along edges and then along spans.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sheen/scene.hpp"

namespace sheen {

/// Where the centre line of each row meets the triangle's edges, and where a pixel's centre lies between: from exact
/// integers, for the whole triangle, so that neither the image's border nor the thinness of a sliver matters.
class SpanFrame {
 public:
    /// Edges between the vertices sorted from top to bottom (by y, then x): an order that the triangles on both sides
    /// of an edge share.
    enum class Side { whole, upper, lower };  ///< top to bottom, top to middle, middle to bottom vertex

    /// A point of an edge: t = 0 at its upper vertex, 1 at its lower one.
    struct EdgePoint {
        Side side = Side::whole;
        double t = 0.0;
    };

    /// One row.
    class Span {
     public:
        EdgePoint left, right;
        /// Share of the way from the left to the right edge at the centre of pixel x, 0…1; pixels outside the triangle
        /// are taken to the nearer edge.
        [[nodiscard]] double position(int x) const;
        /// position() per pixel: one over the span's width. Infinite only where no pixel is covered.
        [[nodiscard]] double position_step() const;

     private:
        friend class SpanFrame;
        std::int64_t offset_ = 0;  ///< doubled area between the long edge and the centre of pixel 0
        std::int64_t step_ = 0;    ///< … per pixel
        double scale_ = 0.0;       ///< from doubled areas to the share of the way away from the long edge
        bool long_edge_is_left_ = true;
    };

    explicit SpanFrame(const std::array<ScreenVertex, 3>& vertices);

    /// Indices of an edge's upper and lower vertex.
    [[nodiscard]] std::array<std::size_t, 2> ends(Side side) const;
    /// Row y must have its centre on or below the top vertex and above the bottom one, as covered rows have.
    [[nodiscard]] Span span(int y) const;
    /// The pixels first…end−1 that the whole triangle covers in such a row, inside the image or not.
    struct Pixels {
        std::int64_t first = 0;
        std::int64_t end = 0;
    };
    [[nodiscard]] Pixels pixels(int y) const;

 private:
    std::array<std::size_t, 3> order_{};  ///< indices of the top, middle and bottom vertex
    std::array<SnappedPoint, 3> points_;  ///< in that order
    std::int64_t area_;  ///< doubled, of the middle vertex against the long edge; negative on its right
};

}  // namespace sheen
