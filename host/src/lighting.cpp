// SPDX-License-Identifier: MIT
/// \file
/// Reflected radiance, paper `spherical`, eq. 8: ambient + Σ lights (Lambert + Blinn's half vector).
#include "sheen/lighting.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sheen {
namespace {

/// Radiance of full intensity in 8-bit steps.
constexpr double full_scale = 255.0;

/// max(0, N·H)^n with H = (L + V)/|L + V|; 0 where L and V are opposite and H has no direction.
double blinn_factor(const glm::dvec3& normal, const glm::dvec3& to_light, const glm::dvec3& to_eye, double shininess) {
    const glm::dvec3 half = to_light + to_eye;
    const double length = glm::length(half);
    if (length == 0.0) {
        return 0.0;
    }
    return std::pow(std::max(0.0, glm::dot(normal, half) / length), shininess);
}

}  // namespace

glm::dvec3 Light::direction_from(const glm::dvec3& position) const {
    if (kind == Kind::directional) return vector;
    const glm::dvec3 offset = vector - position;
    const double length = glm::length(offset);
    return length > 0.0 ? offset / length : glm::dvec3(0.0, 0.0, 1.0);
}

glm::dvec3 shade(const Material& material, const std::vector<Light>& lights, const SurfacePoint& point) {
    glm::dvec3 radiance = material.ambient;
    for (const Light& light : lights) {
        const glm::dvec3 to_light = light.direction_from(point.position);
        const double lambert = std::max(0.0, glm::dot(point.normal, to_light));
        const double highlight = blinn_factor(point.normal, to_light, point.to_eye, material.shininess);
        radiance += light.colour * (material.diffuse * lambert + material.specular * highlight);
    }
    return full_scale * radiance;
}

}  // namespace sheen
