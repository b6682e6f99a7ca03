// SPDX-License-Identifier: MIT
/// \file
/// What paper `quadratic` draws where its formulas are taken as printed.
#pragma once

#include <algorithm>
#include <numeric>

#include "printed_quadratic.hpp"
#include "sheen/shader.hpp"
#include "sheen/span_frame.hpp"

namespace sheen::paper {

/// The printed T0…T5 about the bottom vertex. Of two bottom vertices the left one is vertex 1, the right one vertex 2.
class PrintedTermsShader : public Shader {
 public:
    PrintedTermsShader(const Scene& scene, const ScreenTriangle& triangle) {
        const auto& v = triangle.vertices;
        std::array<std::size_t, 3> order{0, 1, 2};
        std::sort(order.begin(), order.end(), [&v](std::size_t a, std::size_t b) {
            if (v[a].point.y != v[b].point.y) return v[a].point.y > v[b].point.y;
            return v[a].point.x < v[b].point.x;
        });
        const auto pixels = [](std::int64_t subpixels) { return static_cast<double>(subpixels) / 256.0; };
        const auto [one, two, three] = order;
        origin_x_ = pixels(v[one].point.x);
        origin_y_ = pixels(v[one].point.y);
        const PrintedGeometry<double> at{pixels(v[two].point.x) - origin_x_, pixels(v[two].point.y) - origin_y_,
                                         pixels(v[three].point.x) - origin_x_, pixels(v[three].point.y) - origin_y_};
        const TriangleNodes nodes = shade_nodes(Method::quadratic, scene, triangle);
        const auto middle = [&nodes](std::size_t a, std::size_t b) {  // midpoints come in the order 01, 12, 20
            return nodes.colour[a + b == 1 ? 3 : a + b == 3 ? 4 : 5];
        };
        for (int c = 0; c < 3; ++c) {
            terms_[static_cast<std::size_t>(c)] =
                printed_terms<double>(at, {nodes.colour[one][c], nodes.colour[two][c], nodes.colour[three][c],
                                           middle(one, two)[c], middle(one, three)[c], middle(two, three)[c]});
        }
    }
    void start_row(const PixelRow& row) override { y_ = row.y + 0.5 - origin_y_; }
    [[nodiscard]] glm::dvec3 colour(int pixel, const glm::dvec3& /*weights*/) const override {
        const double x = pixel + 0.5 - origin_x_;
        glm::dvec3 colour(0.0);
        for (int c = 0; c < 3; ++c) {
            const auto& t = terms_[static_cast<std::size_t>(c)];
            colour[c] = (t[5] * x + t[4] * y_ + t[2]) * x + (t[3] * y_ + t[1]) * y_ + t[0];
        }
        return colour;
    }

 private:
    double origin_x_ = 0.0, origin_y_ = 0.0, y_ = 0.0;
    std::array<std::array<double, 6>, 3> terms_{};
};

/// The printed walk: each row starts where the edge crosses it, X_start real, and its k-th pixel gets I(X_start + k).
class RealStepShader : public Shader {
 public:
    RealStepShader(const Scene& scene, const ScreenTriangle& triangle) : frame_(triangle.vertices) {
        const PixelIndex origin =
            centre_pixel({triangle.vertices[0].point, triangle.vertices[1].point, triangle.vertices[2].point});
        const auto fitted = fit_colour(shade_nodes(Method::quadratic, scene, triangle), triangle, origin);
        for (std::size_t c = 0; c < 3; ++c) {
            std::transform(fitted[c].t.begin(), fitted[c].t.end(), terms_[c].begin(),
                           [](Coefficient t) { return static_cast<double>(t); });
        }
        origin_ = origin;
    }
    void start_row(const PixelRow& row) override {
        const int first = static_cast<int>(frame_.pixels(row.y).first);
        const SpanFrame::Span span = frame_.span(row.y);
        miss_ = span.position(first) / span.position_step();
        y_ = row.y - origin_.y;
    }
    [[nodiscard]] glm::dvec3 colour(int pixel, const glm::dvec3& /*weights*/) const override {
        const double x = pixel - miss_ - origin_.x;
        glm::dvec3 colour(0.0);
        for (int c = 0; c < 3; ++c) {
            const auto& t = terms_[static_cast<std::size_t>(c)];
            colour[c] = (t[5] * x + t[4] * y_ + t[2]) * x + (t[3] * y_ + t[1]) * y_ + t[0];
        }
        return colour;
    }

 private:
    SpanFrame frame_;
    PixelIndex origin_;
    std::array<std::array<double, 6>, 3> terms_{};
    double miss_ = 0.0;  ///< from X_start to the centre of the row's first pixel, 0…1
    double y_ = 0.0;
};

}  // namespace sheen::paper
