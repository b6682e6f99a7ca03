// SPDX-License-Identifier: MIT
/// \file
/// `taylor`, paper `fast-phong`, "A New Approach": eye and lights at infinity. The shader also draws `taylor-finite`.
#include "sheen/taylor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "fast_phong.hpp"
#include "screen_terms.hpp"
#include "sheen/exponent_table.hpp"

namespace sheen {
namespace {

/// From vertex 0 to vertex k, in pixels.
glm::dvec2 edge_to(const ScreenTriangle& triangle, std::size_t k) {
    const SnappedPoint& from = triangle.vertices[0].point;
    const SnappedPoint& to = triangle.vertices[k].point;
    return glm::dvec2(to.x - from.x, to.y - from.y) / static_cast<double>(1 << hls::subpixel_bits);
}

/// Evaluates the series of all lights; a negative N·L is dark, the table does the power.
class TaylorShader : public Shader {
 public:
    TaylorShader(Method method, const MethodOptions& options, const Scene& scene, const ScreenTriangle& triangle)
        : scene_(scene),
          material_(triangle.material),
          series_(method, options, scene, triangle),
          table_(material_.shininess, options.taylor_table_bytes) {}

    [[nodiscard]] glm::dvec3 colour(int /*x*/, const glm::dvec3& weights) const override {
        glm::dvec3 sum = material_.ambient;
        for (std::size_t k = 0; k < series_.lights(); ++k) {
            const TriangleSeries::Cosines cosines = series_.at(k, weights);
            const double lambert = std::max(0.0, cosines.diffuse);
            const double highlight = table_.read(cosines.specular);
            sum += scene_.lights[k].colour * (material_.diffuse * lambert + material_.specular * highlight);
        }
        return 255.0 * sum;
    }

 private:
    const Scene& scene_;
    const Material& material_;
    TriangleSeries series_;
    ExponentTable table_;
};

bool is_blinn(const Material& material) { return material.brdf == Brdf::blinn; }

}  // namespace

TriangleSeries::TriangleSeries(Method method, const MethodOptions& options, const Scene& scene,
                               const ScreenTriangle& triangle) {
    TriangleAxes<double> axes;
    if (options.as_printed) {
        const Barycentrics<double> on_screen(triangle);
        axes = {{on_screen.p_x, on_screen.p_y}, {on_screen.q_x, on_screen.q_y}};
        edge_1_ = edge_to(triangle, 1);
        edge_2_ = edge_to(triangle, 2);
    }
    series_ = method == Method::taylor ? infinite_series(options, scene, triangle, axes)
                                       : finite_series(options, scene, triangle, axes);
}

TriangleSeries::Cosines TriangleSeries::at(std::size_t light, const glm::dvec3& weights) const {
    const glm::dvec2 place = (weights[1] - 1.0 / 3.0) * edge_1_ + (weights[2] - 1.0 / 3.0) * edge_2_;
    const LightSeries<double>& series = series_[light];
    return {value_at(series.diffuse, place.x, place.y), value_at(series.specular, place.x, place.y)};
}

glm::dvec3 infinite_half(const Light& light) {
    const glm::dvec3 half = light.vector + glm::dvec3(0.0, 0.0, 1.0);
    const double length = glm::length(half);
    return length > 0.0 ? half / length : half;
}

template <typename Real>
std::vector<LightSeries<Real>> infinite_series(const MethodOptions& options, const Scene& scene,
                                               const ScreenTriangle& triangle, const TriangleAxes<Real>& axes) {
    const auto& v = triangle.vertices;
    const LinearVector<Real> normal =
        linear_vector<Real>({Vec3<Real>(v[0].normal), Vec3<Real>(v[1].normal), Vec3<Real>(v[2].normal)}, axes);
    std::vector<LightSeries<Real>> series(scene.lights.size());
    const bool directed = has_direction(normal);
    const InverseLength<Real> length = directed ? inverse_length(squared_length(normal)) : InverseLength<Real>{};
    const auto expand = [&](const glm::dvec3& direction) {
        const Vec3<Real> to(direction);
        if (!directed) return TaylorSeries<Real>{scalar_product(Vec3<Real>(triangle.face_normal), to)};
        return options.as_printed ? printed_taylor_series(normal, to) : taylor_series(dot_product(normal, to), length);
    };
    for (std::size_t k = 0; k < series.size(); ++k) {
        series[k].diffuse = expand(scene.lights[k].vector);
        series[k].specular = expand(infinite_half(scene.lights[k]));
    }
    return series;
}

template std::vector<LightSeries<double>> infinite_series(const MethodOptions&, const Scene&, const ScreenTriangle&,
                                                          const TriangleAxes<double>&);
template std::vector<LightSeries<Counted>> infinite_series(const MethodOptions&, const Scene&, const ScreenTriangle&,
                                                           const TriangleAxes<Counted>&);

std::optional<std::string> why_not_blinn(Method method, const Scene& scene) {
    const std::vector<Material>& materials = scene.mesh.materials;
    const bool expressible = scene.mesh.triangle_materials.empty()
                                 ? is_blinn(scene.material)
                                 : std::all_of(materials.begin(), materials.end(), is_blinn);
    if (expressible) return std::nullopt;
    return fmt::format("{} expresses Blinn's reflection model only: give every material the model blinn",
                       to_string(method));
}

std::optional<std::string> why_not_infinite(Method method, const Scene& scene) {
    if (scene.field_of_view) {
        return fmt::format("{} has its eye at infinity: give the orthographic camera, or take taylor-finite",
                           to_string(method));
    }
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        if (scene.lights[k].kind == Light::Kind::directional) continue;
        return fmt::format(
            "{} has its lights at infinity: light {} is positional; give directions, or take "
            "taylor-finite",
            to_string(method), k + 1);
    }
    return why_not_blinn(method, scene);
}

std::unique_ptr<Shader> make_taylor_shader(Method method, const MethodOptions& options, const Scene& scene,
                                           const ScreenTriangle& triangle) {
    return std::make_unique<TaylorShader>(method, options, scene, triangle);
}

}  // namespace sheen
