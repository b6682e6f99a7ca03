// SPDX-License-Identifier: MIT
/// \file
/// With weights λ of the vertices, the long edge has λ_middle = 0, and along a row λ_middle grows linearly to what it
/// is on the other edge, (Y − Y_top)/(Y_middle − Y_top) above the middle vertex. Their quotient is the share of the
/// way.
#include "sheen/span_frame.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "edge.hpp"

namespace sheen {
namespace {

double share(std::int64_t part, std::int64_t whole) { return static_cast<double>(part) / static_cast<double>(whole); }

std::int64_t row_centre(int y) { return subpixels * y + half_pixel; }

}  // namespace

double SpanFrame::Span::position(int x) const {
    const double from_long = std::clamp(static_cast<double>(offset_ + step_ * x) * scale_, 0.0, 1.0);
    return long_edge_is_left_ ? from_long : 1.0 - from_long;
}

double SpanFrame::Span::position_step() const { return std::abs(static_cast<double>(step_) * scale_); }

SpanFrame::SpanFrame(const std::array<ScreenVertex, 3>& vertices) : order_{0, 1, 2} {
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
        const SnappedPoint& p = vertices[a].point;
        const SnappedPoint& q = vertices[b].point;
        return std::tie(p.y, p.x) < std::tie(q.y, q.x);
    });
    std::transform(order_.begin(), order_.end(), points_.begin(), [&](std::size_t k) { return vertices[k].point; });
    area_ = doubled_area(points_[0], points_[2], points_[1]);
}

std::array<std::size_t, 2> SpanFrame::ends(Side side) const {
    return {order_[side == Side::lower ? 1 : 0], order_[side == Side::upper ? 1 : 2]};
}

SpanFrame::Span SpanFrame::span(int y) const {
    const auto& [top, middle, bottom] = points_;
    const std::int64_t centre = row_centre(y);
    const bool above = centre < middle.y;
    const EdgePoint whole{Side::whole, share(centre - top.y, bottom.y - top.y)};
    const EdgePoint other = above ? EdgePoint{Side::upper, share(centre - top.y, middle.y - top.y)}
                                  : EdgePoint{Side::lower, share(centre - middle.y, bottom.y - middle.y)};
    Span span;
    span.long_edge_is_left_ = area_ < 0;
    span.left = span.long_edge_is_left_ ? whole : other;
    span.right = span.long_edge_is_left_ ? other : whole;
    span.offset_ = doubled_area(top, bottom, {half_pixel, centre});
    span.step_ = -subpixels * (bottom.y - top.y);
    const double widest = above ? other.t : share(bottom.y - centre, bottom.y - middle.y);
    span.scale_ = 1.0 / (static_cast<double>(area_) * widest);
    return span;
}

SpanFrame::Pixels SpanFrame::pixels(int y) const {
    const auto& [top, middle, bottom] = points_;
    const std::int64_t whole = Edge(top, bottom).boundary(y);
    const bool above = row_centre(y) < middle.y;
    const std::int64_t other = above ? Edge(top, middle).boundary(y) : Edge(middle, bottom).boundary(y);
    return {std::min(whole, other), std::max(whole, other)};
}

}  // namespace sheen
