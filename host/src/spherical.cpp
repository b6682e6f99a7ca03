// SPDX-License-Identifier: MIT
/// \file
/// Shaders of method `spherical`.
#include "sheen/spherical.hpp"

#include <algorithm>
#include <cmath>

#include "spherical_span.hpp"

namespace sheen {
namespace {

/// Radiance from each light's diffuse and highlight term.
class Sum {
 public:
    explicit Sum(const Material& material) : material_(material), radiance_(material.ambient) {}
    void add(const Light& light, double diffuse, double highlight) {
        radiance_ += light.colour * (material_.diffuse * std::max(0.0, diffuse) + material_.specular * highlight);
    }
    [[nodiscard]] glm::dvec3 steps() const { return full_scale * radiance_; }

 private:
    const Material& material_;
    glm::dvec3 radiance_;
};

/// One vector turned against the other: an angle that is linear along the span, and a bell of it.
class SphericalShader : public Shader {
 public:
    SphericalShader(const MethodOptions& options, const Scene& scene, const ScreenTriangle& triangle)
        : scene_(scene),
          material_(triangle.material),
          bell_(make_bell(options, triangle.material)),
          spans_(scene, triangle, options.as_printed) {}

    void start_row(const PixelRow& row) override {
        span_ = spans_.frame().span(row.y);
        lights_ = spans_.start(span_);
    }

    [[nodiscard]] glm::dvec3 colour(int x, const glm::dvec3& /*weights*/) const override {
        const double t = span_.position(x);
        Sum sum(material_);
        for (std::size_t i = 0; i < lights_.size(); ++i) {
            const SphericalLight<double>& light = lights_[i];
            sum.add(scene_.lights[i], light.diffuse.amplitude * std::cos(light.diffuse.angle(t)),
                    light.power * bell_(light.highlight.angle(t)));
        }
        return sum.steps();
    }

 private:
    const Scene& scene_;
    const Material& material_;
    Bell bell_;
    SphericalSpan<double> spans_;
    SpanFrame::Span span_;
    std::vector<SphericalLight<double>> lights_;
};

/// Both vectors interpolated, and a bell of the angle between them.
class SeparateShader : public Shader {
 public:
    SeparateShader(const MethodOptions& options, const Scene& scene, const ScreenTriangle& triangle)
        : scene_(scene),
          material_(triangle.material),
          bell_(make_bell(options, triangle.material)),
          spans_(scene, triangle) {}

    void start_row(const PixelRow& row) override {
        span_ = spans_.frame().span(row.y);
        spans_.start(span_);
    }

    [[nodiscard]] glm::dvec3 colour(int x, const glm::dvec3& /*weights*/) const override {
        const auto cosines = spans_.at(span_.position(x));
        Sum sum(material_);
        for (std::size_t i = 0; i < cosines.size(); ++i) {
            const double angle = std::acos(std::clamp(cosines[i].highlight, -1.0, 1.0));
            sum.add(scene_.lights[i], cosines[i].diffuse, bell_(angle));
        }
        return sum.steps();
    }

 private:
    const Scene& scene_;
    const Material& material_;
    Bell bell_;
    SeparateSpan<double> spans_;
    SpanFrame::Span span_;
};

}  // namespace

std::optional<std::string> why_not_spherical(const Scene& scene) {
    const auto expressible = [](const Material& material) { return material.brdf != Brdf::cook_torrance; };
    if (expressible(scene.material) &&
        std::all_of(scene.mesh.materials.begin(), scene.mesh.materials.end(), expressible)) {
        return std::nullopt;
    }
    return "method 'spherical' makes a highlight of one angle: it can't draw Cook and Torrance's reflection model, "
           "which "
           "depends on four; use blinn or phong, or method 'recurrence'";
}

std::unique_ptr<Shader> make_spherical_shader(const MethodOptions& options, const Scene& scene,
                                              const ScreenTriangle& triangle) {
    if (options.spherical_separate) return std::make_unique<SeparateShader>(options, scene, triangle);
    return std::make_unique<SphericalShader>(options, scene, triangle);
}

}  // namespace sheen
