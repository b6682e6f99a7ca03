// SPDX-License-Identifier: MIT
/// \file
/// Forward differences over any Real, as contract 1 and the hardware step them: down the left edges and along the spans
/// (paper `quadratic`, section 4).
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "left_edge.hpp"
#include "screen_terms.hpp"
#include "sheen/hls/formats.hpp"

namespace sheen {

/// Steps a polynomial (or three at once: Value is Real or Vec3<Real>) over a triangle's rows, by additions alone: per
/// component and pixel one an order, per row one (linear) or three (quadratic), and as many again where the edge
/// carries. The constructor does the work per left edge.
template <typename Real, typename Value>
class ForwardDifference {
 public:
    /// `terms` about the point `origin` of the screen; those of an order above `order` (0, 1, 2) are not looked at.
    ForwardDifference(int order, const std::array<Value, 6>& terms, const SnappedPoint& origin,
                      const std::vector<LeftEdge>& edges)
        : ForwardDifference(order, terms, glm::dvec2(origin.x, origin.y) / subpixels, edges) {}
    /// The same about a point in pixels.
    ForwardDifference(int order, const std::array<Value, 6>& terms, const glm::dvec2& origin,
                      const std::vector<LeftEdge>& edges)
        : order_(order), second_(order > 1 ? terms[5] + terms[5] : Value(0.0)) {
        for (const LeftEdge& edge : edges) starts_.push_back(start(terms, origin, edge));
    }

    /// To the first pixel of the next row; rows come as triangle_rows() lists them.
    void start_row(const PixelRow& row) {
        if (next_start_ < starts_.size() && rows_started_ == starts_[next_start_].edge.index) {
            at_edge_ = starts_[next_start_++];
        } else {
            int carries = row.x - row_.x - at_edge_.edge.kappa * (row.y - row_.y);
            for (int y = row_.y; y < row.y; ++y) step_down();
            for (; carries > 0; --carries) step_right();
        }
        ++rows_started_;
        row_ = row;
        value_ = at_edge_.value;
        step_ = at_edge_.right;
    }

    /// The value at the row's next pixel.
    Value next() {
        const Value value = value_;
        if (order_ > 0) value_ += step_;
        if (order_ > 1) step_ += second_;
        return value;
    }

 private:
    static constexpr double subpixels = 1 << hls::subpixel_bits;

    /// The registers of contract 1 at a left edge's pixel: I, its steps D to the right and E to the next row, and the
    /// steps dD and dE of those down the edge.
    struct Registers {
        LeftEdge edge;
        Value value{0.0}, right{0.0}, down{0.0}, right_down{0.0}, down_down{0.0};
    };

    Registers start(const std::array<Value, 6>& t, const glm::dvec2& origin, const LeftEdge& edge) const {
        Registers at;
        at.edge = edge;
        at.value = t[0];
        if (order_ == 0) return at;
        const Real x = Real(edge.row.x + 0.5) - Real(origin.x);
        const Real y = Real(edge.row.y + 0.5) - Real(origin.y);
        const Real kappa(edge.kappa);
        if (order_ == 1) {
            at.value = t[0] + t[1] * y + t[2] * x;
            at.right = t[2];
            at.down = t[1] + t[2] * kappa;
            return at;
        }
        const Value slope = t[2] + t[4] * y;
        at.value = t[0] + (t[1] + t[3] * y) * y + (slope + t[5] * x) * x;
        at.right = slope + t[5] * (x + x + Real(1.0));
        at.down = t[1] + t[3] * (y + y + Real(1.0)) + t[4] * x + (slope + t[4] + t[5] * (x + x + kappa)) * kappa;
        at.right_down = t[4] + second_ * kappa;
        at.down_down = t[3] + t[3] + (at.right_down + t[4]) * kappa;
        return at;
    }

    /// To the next row, κ pixels to the right.
    void step_down() {
        if (order_ > 0) at_edge_.value += at_edge_.down;
        if (order_ > 1) {
            at_edge_.down += at_edge_.down_down;
            at_edge_.right += at_edge_.right_down;
        }
    }
    /// The edge carries: a pixel to the right.
    void step_right() {
        if (order_ > 0) at_edge_.value += at_edge_.right;
        if (order_ > 1) {
            at_edge_.right += second_;
            at_edge_.down += at_edge_.right_down;
        }
    }

    int order_;
    Value second_;
    std::vector<Registers> starts_;
    std::size_t next_start_ = 0;
    std::size_t rows_started_ = 0;
    Registers at_edge_;  ///< at the row's first pixel
    PixelRow row_;
    Value value_{0.0};  ///< at the next pixel
    Value step_{0.0};
};

}  // namespace sheen
