// SPDX-License-Identifier: MIT
/// \file
/// The shader of method `recurrence`.
#include "sheen/recurrence.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "recurrence_span.hpp"
#include "sheen/error.hpp"

namespace sheen {
namespace {

/// Makes a row's pixels one after the other when it starts. A row that the image's border cuts begins at its first
/// pixel there, with the same angles: its colours are the whole row's to double precision.
class RecurrenceShader : public Shader {
 public:
    RecurrenceShader(const MethodOptions& options, const Scene& scene, const ScreenTriangle& triangle)
        : frame_(triangle.vertices),
          normal_(frame_, vertex_normals<double>(triangle)),
          radiance_(scene, triangle),
          dots_(radiance_.directions(), options) {}

    void start_row(const PixelRow& row) override {
        const SpanFrame::Span span = frame_.span(row.y);
        dots_.start(frame_, span, normal_.ends(span), row);
        first_ = row.x;
        colours_.clear();
        for (int i = 0; i < row.length; ++i) colours_.push_back(radiance_.colour(dots_.next()));
    }

    [[nodiscard]] glm::dvec3 colour(int x, const glm::dvec3& /*weights*/) const override {
        return colours_[static_cast<std::size_t>(x - first_)];
    }

 private:
    SpanFrame frame_;
    EdgeVector<double> normal_;
    RecurrentRadiance<double> radiance_;
    RecurrentDots<double> dots_;
    int first_ = 0;
    std::vector<glm::dvec3> colours_;  ///< of the row's pixels, from the first one on
};

}  // namespace

std::optional<std::string> why_not_recurrent(const Scene& scene) {
    const char* why = nullptr;
    if (scene.field_of_view) {
        why = "a perspective camera, which sees each pixel from another side; use the orthographic one";
    } else if (std::any_of(scene.lights.begin(), scene.lights.end(),
                           [](const Light& light) { return light.kind == Light::Kind::positional; })) {
        why = "a positional light, whose direction changes from pixel to pixel; use directional lights";
    }
    if (why == nullptr) return std::nullopt;
    return fmt::format("method 'recurrence' needs light and eye far away: it can't draw {}, or method 'spherical'",
                       why);
}

std::unique_ptr<Shader> make_recurrence_shader(const MethodOptions& options, const Scene& scene,
                                               const ScreenTriangle& triangle) {
    return std::make_unique<RecurrenceShader>(options, scene, triangle);
}

}  // namespace sheen
