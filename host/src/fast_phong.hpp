// SPDX-License-Identifier: MIT
/// \file
/// What the methods of paper `fast-phong` share: a triangle's vectors as linear functions, and its series per light.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "real_vector.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/method.hpp"
#include "sheen/scene.hpp"
#include "sheen/shader.hpp"
#include "sheen/taylor.hpp"

namespace sheen {

/// Coordinates with their origin at the triangle's centre: how the screen weights of vertices 1 and 2 grow along x and
/// y. By default x and y are these weights less a third.
template <typename Real>
struct TriangleAxes {
    glm::vec<2, Real> weight_1{Real(1.0), Real(0.0)};
    glm::vec<2, Real> weight_2{Real(0.0), Real(1.0)};
};

template <typename Real>
using VertexVectors = std::array<Vec3<Real>, 3>;

/// The linear function through the vertices' vectors.
template <typename Real>
LinearVector<Real> linear_vector(const VertexVectors<Real>& v, const TriangleAxes<Real>& axes) {
    const Vec3<Real> edge_1 = v[1] - v[0];
    const Vec3<Real> edge_2 = v[2] - v[0];
    return {edge_1 * axes.weight_1.x + edge_2 * axes.weight_2.x, edge_1 * axes.weight_1.y + edge_2 * axes.weight_2.y,
            (v[0] + v[1] + v[2]) * Real(1.0 / 3.0)};
}

/// False where the vectors all but cancel at the centre, so that no series about it is of use. A guard: free.
template <typename Real>
bool has_direction(const LinearVector<Real>& v) {
    constexpr double vanishing = 1e-6;  // relative length below which the direction is rounding noise
    double squared = 0.0;
    double centre = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double x = value_of(v.x[k]), y = value_of(v.y[k]), c = value_of(v.constant[k]);
        centre += c * c;
        squared += x * x + y * y + c * c;
    }
    return centre > vanishing * vanishing * squared;
}

/// Where the triangle's axes have their origin: its centroid on the screen, in pixels.
inline glm::dvec2 centre_of(const ScreenTriangle& triangle) {
    const auto& [a, b, c] = triangle.vertices;
    return glm::dvec2(a.point.x + b.point.x + c.point.x, a.point.y + b.point.y + c.point.y) /
           (3.0 * (1 << hls::subpixel_bits));
}

/// `duff`: squared length of the interpolated normal up to which it is rounding noise, and the face's takes its place.
inline constexpr double vanishing_squared_length = 1e-12;

/// numerator/√squared, Duff's form of a cosine, by the inverse root. As printed, an L within the bars of the
/// denominator, it is numerator/|numerator|.
template <typename Real>
Real duff_cosine(const Real& numerator, const Real& inverse_root, bool as_printed) {
    using std::abs;
    return as_printed ? numerator / abs(numerator) : numerator * inverse_root;
}

/// N·L and N·H of one light.
template <typename Real>
struct LightSeries {
    TaylorSeries<Real> diffuse{};
    TaylorSeries<Real> specular{};
};

/// The half vector of a directional light and an eye at infinity, unit; 0 where they are opposite.
glm::dvec3 infinite_half(const Light& light);

/// `taylor`: series of every light of the scene, in the triangle's axes.
template <typename Real>
std::vector<LightSeries<Real>> infinite_series(const MethodOptions& options, const Scene& scene,
                                               const ScreenTriangle& triangle, const TriangleAxes<Real>& axes);
/// `taylor-finite`: the same with eye and lights at a finite distance where they are.
template <typename Real>
std::vector<LightSeries<Real>> finite_series(const MethodOptions& options, const Scene& scene,
                                             const ScreenTriangle& triangle, const TriangleAxes<Real>& axes);

/// `taylor` or `taylor-finite` over one triangle, at its vertices' weights: as precise in slivers as anywhere. What is
/// misprinted depends on the axes, and is shown in the paper's, pixels.
class TriangleSeries {
 public:
    TriangleSeries(Method method, const MethodOptions& options, const Scene& scene, const ScreenTriangle& triangle);

    /// The series of N·L and of N·H, not clamped.
    struct Cosines {
        double diffuse = 0.0;
        double specular = 0.0;
    };
    /// Those of one of the scene's lights where the vertices have these weights.
    [[nodiscard]] Cosines at(std::size_t light, const glm::dvec3& weights) const;
    [[nodiscard]] std::size_t lights() const { return series_.size(); }

 private:
    std::vector<LightSeries<double>> series_;
    glm::dvec2 edge_1_{1.0, 0.0};  ///< from vertex 0, in the axes
    glm::dvec2 edge_2_{0.0, 1.0};
};

/// Why `duff` and `taylor` (eye and lights at infinity) can't express the scene.
std::optional<std::string> why_not_infinite(Method method, const Scene& scene);
/// Why no method of the paper can: another reflection model than Blinn's.
std::optional<std::string> why_not_blinn(Method method, const Scene& scene);

std::unique_ptr<Shader> make_duff_shader(const MethodOptions& options, const Scene& scene,
                                         const ScreenTriangle& triangle);
/// `taylor` or `taylor-finite`.
std::unique_ptr<Shader> make_taylor_shader(Method method, const MethodOptions& options, const Scene& scene,
                                           const ScreenTriangle& triangle);

}  // namespace sheen
