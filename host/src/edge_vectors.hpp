// SPDX-License-Identifier: MIT
/// \file
/// The vectors of a triangle's shading, interpolated spherically along its edges (paper `spherical`, section 5): what a
/// span starts from. Real is double or Counted.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "radiance.hpp"
#include "sheen/great_arc.hpp"
#include "sheen/scene.hpp"
#include "sheen/span_frame.hpp"

namespace sheen {

/// Which way arcs between opposite vectors take: by the camera. The same for all triangles, so that neighbours agree.
inline const glm::dvec3& towards_camera() {
    static const glm::dvec3 direction(0.0, 0.0, 1.0);
    return direction;
}

/// A vector at both ends of a span.
template <typename Real>
struct SpanEnds {
    Vec3<Real> left, right;
    bool fixed = false;  ///< the same at both ends of every span
    [[nodiscard]] GreatArc<Real> arc() const { return {left, right, towards_camera()}; }
};

/// A unit vector along the triangle's three edges.
template <typename Real>
class EdgeVector {
 public:
    /// One that is the same everywhere.
    explicit EdgeVector(const Vec3<Real>& fixed) : fixed_(fixed) {}
    /// One given at the vertices.
    EdgeVector(const SpanFrame& frame, const std::array<Vec3<Real>, 3>& at_vertices) : fixed_(at_vertices[0]) {
        for (const SpanFrame::Side side : {SpanFrame::Side::whole, SpanFrame::Side::upper, SpanFrame::Side::lower}) {
            const auto [upper, lower] = frame.ends(side);
            arcs_.emplace_back(at_vertices[upper], at_vertices[lower], towards_camera());
        }
    }
    [[nodiscard]] SpanEnds<Real> ends(const SpanFrame::Span& span) const {
        if (arcs_.empty()) return {fixed_, fixed_, true};
        return {at(span.left), at(span.right), false};
    }

 private:
    [[nodiscard]] Vec3<Real> at(const SpanFrame::EdgePoint& point) const {
        return arcs_[static_cast<std::size_t>(point.side)].at(Real(point.t));
    }

    Vec3<Real> fixed_;
    std::vector<GreatArc<Real>> arcs_;  ///< by SpanFrame::Side; empty: fixed
};

template <typename Real>
std::array<Vec3<Real>, 3> vertex_normals(const ScreenTriangle& triangle) {
    const auto& v = triangle.vertices;
    return {Vec3<Real>(v[0].normal), Vec3<Real>(v[1].normal), Vec3<Real>(v[2].normal)};
}

/// What one light's terms are made of: diffuse of N and `to_light`, the highlight of N and H (Blinn), or of the
/// mirrored light R and V (Phong).
template <typename Real>
struct LightVectors {
    EdgeVector<Real> to_light;
    std::optional<EdgeVector<Real>> mirrored;  ///< R, which takes N's place
    EdgeVector<Real> against;                  ///< H, or V
    bool has_highlight = true;                 ///< false where H has no direction at a vertex
};

/// A triangle's normals and the vectors of its lights.
template <typename Real>
class TriangleVectors {
 public:
    TriangleVectors(const Scene& scene, const ScreenTriangle& triangle)
        : frame_(triangle.vertices), normal_(frame_, vertex_normals<Real>(triangle)) {
        for (const Light& light : scene.lights) lights_.push_back(light_vectors(scene, triangle, light));
    }
    [[nodiscard]] const SpanFrame& frame() const { return frame_; }
    [[nodiscard]] const EdgeVector<Real>& normal() const { return normal_; }
    [[nodiscard]] const std::vector<LightVectors<Real>>& lights() const { return lights_; }

 private:
    using Corners = std::array<Vec3<Real>, 3>;

    /// A light as a vertex sees it. Where that is the same everywhere it is made once for the scene, and so is free.
    static Incidence<Real> incidence_at(const Scene& scene, const Light& light, const ScreenVertex& vertex) {
        if (light.kind == Light::Kind::directional && !scene.field_of_view) {
            const Incidence<double> at = incidence(light, glm::dvec3(0.0), towards_camera());
            return {Vec3<Real>(at.to_light), Vec3<Real>(at.to_eye), Vec3<Real>(at.half)};
        }
        const Vec3<Real> position(vertex.position);
        return incidence(light, position, scene.field_of_view ? -normalised(position) : Vec3<Real>(towards_camera()));
    }

    LightVectors<Real> light_vectors(const Scene& scene, const ScreenTriangle& triangle, const Light& light) const {
        const bool phong = triangle.material.brdf == Brdf::phong;
        const Corners normal = vertex_normals<Real>(triangle);
        Corners to_light, mirrored, against;
        bool has_highlight = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const Incidence<Real> at = incidence_at(scene, light, triangle.vertices[k]);
            to_light[k] = at.to_light;
            against[k] = phong ? at.to_eye : at.half;
            if (phong) mirrored[k] = normal[k] * (Real(2.0) * dot(normal[k], at.to_light)) - at.to_light;
            has_highlight = has_highlight && !is_zero(at.half);
        }
        const bool far_light = light.kind == Light::Kind::directional;
        const bool far_eye = !scene.field_of_view;
        const auto along_edges = [&](const Corners& corners, bool fixed) {
            return fixed ? EdgeVector<Real>(corners[0]) : EdgeVector<Real>(frame_, corners);
        };
        LightVectors<Real> result{along_edges(to_light, far_light), std::nullopt,
                                  along_edges(against, far_eye && (phong || far_light)), has_highlight};
        if (phong) result.mirrored = EdgeVector<Real>(frame_, mirrored);
        return result;
    }

    SpanFrame frame_;
    EdgeVector<Real> normal_;
    std::vector<LightVectors<Real>> lights_;
};

}  // namespace sheen
