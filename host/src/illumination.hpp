// SPDX-License-Identifier: MIT
/// \file
/// Radiance at nodes and pixels as loops price it.
#pragma once

#include <algorithm>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "radiance.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/scene.hpp"
#include "sheen/surface.hpp"

namespace sheen {

/// A point of a surface: position where it is needed, unit normal.
template <typename Real>
struct NodePoint {
    Vec3<Real> position;
    Vec3<Real> normal;
};

/// A scene's lights and eye. Where a light is directional and the eye at infinity its Incidence is the scene's, made
/// once and free; otherwise it is made at each point.
template <typename Real>
class Illumination {
 public:
    /// Scene and material must outlive it.
    Illumination(const Scene& scene, const Material& material) : scene_(scene), material_(material) {
        for (const Light& light : scene.lights) {
            fixed_.emplace_back();
            if (light.kind == Light::Kind::directional && !perspective()) {
                const Incidence<double> at = incidence(light, glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 1.0));
                fixed_.back() = {Vec3<Real>(at.to_light), Vec3<Real>(at.to_eye), Vec3<Real>(at.half)};
            } else {
                needs_position_ = true;
            }
        }
    }
    /// Whether radiance depends on the position, and not on the normal alone.
    [[nodiscard]] bool needs_position() const { return needs_position_; }
    [[nodiscard]] bool perspective() const { return scene_.field_of_view.has_value(); }

    /// Each light as a point sees it; `position` is looked at where needs_position().
    [[nodiscard]] std::vector<Incidence<Real>> incidences(const Vec3<Real>& position) const {
        const Vec3<Real> eye = perspective() && needs_position_ ? -normalised(position) : Vec3<Real>(0.0, 0.0, 1.0);
        std::vector<Incidence<Real>> result;
        for (std::size_t i = 0; i < fixed_.size(); ++i) {
            result.push_back(fixed_[i] ? *fixed_[i] : incidence(scene_.lights[i], position, eye));
        }
        return result;
    }
    /// In 8-bit steps, not clamped; `normal` is unit, `position` is looked at where needs_position().
    [[nodiscard]] Vec3<Real> radiance(const Vec3<Real>& position, const Vec3<Real>& normal) const {
        const std::vector<Incidence<Real>> at = incidences(position);
        Vec3<Real> sum(full_scale * material_.ambient);
        for (std::size_t i = 0; i < at.size(); ++i) sum += reflected(material_, scene_.lights[i], at[i], normal);
        return sum;
    }
    /// radiance() within the limits of a colour node.
    [[nodiscard]] Vec3<Real> node(const Vec3<Real>& position, const Vec3<Real>& normal) const {
        Vec3<Real> colour = radiance(position, normal);
        const Real limit(hls::colour_node_limit);
        for (int c = 0; c < 3; ++c) colour[c] = std::min(std::max(colour[c], -limit), limit);
        return colour;
    }
    /// node() in the middle of an edge.
    [[nodiscard]] Vec3<Real> edge_node(const ScreenVertex& a, const ScreenVertex& b) const {
        const NodePoint<Real> middle = edge_point(a, b);
        return node(middle.position, middle.normal);
    }
    /// The middle of an edge, as edge_node() of sheen/surface.hpp has it.
    [[nodiscard]] NodePoint<Real> edge_point(const ScreenVertex& a, const ScreenVertex& b) const {
        const Vec3<Real> normal_a(a.normal);
        const Vec3<Real> normal_b(b.normal);
        const Vec3<Real> position_a(a.position);
        const Vec3<Real> position_b(b.position);
        Vec3<Real> normal = normal_a + normal_b;
        Vec3<Real> position(0.0);
        if (needs_position_) position = position_a + position_b;
        if (perspective()) {
            const Real lean = (position_b.z - position_a.z) / (position_a.z + position_b.z);
            normal += (normal_a - normal_b) * lean;
            if (needs_position_) position += (position_a - position_b) * lean;
        }
        const SurfacePoint exact = sheen::edge_node(scene_, a, b);  // for normals that cancel
        constexpr double vanishing = 1e-6;
        const bool cancels =
            std::abs(value_of(normal.x)) + std::abs(value_of(normal.y)) + std::abs(value_of(normal.z)) < vanishing;
        return {position * Real(0.5), cancels ? Vec3<Real>(exact.normal) : normalised(normal)};
    }

 private:
    const Scene& scene_;
    const Material& material_;
    std::vector<std::optional<Incidence<Real>>> fixed_;
    bool needs_position_ = false;
};

}  // namespace sheen
