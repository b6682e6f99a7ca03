// SPDX-License-Identifier: MIT
/// \file
/// Reflected radiance in double precision; the formulas are in radiance.hpp.
#include "sheen/lighting.hpp"

#include <glm/geometric.hpp>

#include "radiance.hpp"

namespace sheen {

glm::dvec3 Light::direction_from(const glm::dvec3& position) const {
    if (kind == Kind::directional) return vector;
    const glm::dvec3 offset = vector - position;
    const double length = glm::length(offset);
    return length > 0.0 ? offset / length : glm::dvec3(0.0, 0.0, 1.0);
}

glm::dvec3 shade(const Material& material, const std::vector<Light>& lights, const SurfacePoint& point) {
    glm::dvec3 sum = full_scale * material.ambient;
    for (const Light& light : lights) {
        sum += reflected(material, light, incidence(light, point.position, point.to_eye), point.normal);
    }
    return sum;
}

}  // namespace sheen
