// SPDX-License-Identifier: MIT
#include "sheen/great_arc.hpp"

namespace sheen {

glm::dvec3 perpendicular(const glm::dvec3& from, const glm::dvec3& towards) {
    constexpr double vanishing = 1e-6;  // length below which a difference's direction is rounding noise
    const glm::dvec3 rest = towards - glm::dot(towards, from) * from;
    if (glm::length(rest) > vanishing) return glm::normalize(rest);
    const glm::dvec3 axis = std::abs(from.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::normalize(axis - glm::dot(axis, from) * from);
}

}  // namespace sheen
