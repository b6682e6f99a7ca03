// SPDX-License-Identifier: MIT
/// \file
/// What every mesh needs, wherever it comes from.
#include "sheen/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace sheen {

BoundingSphere bounding_sphere(const Mesh& mesh) {
    if (mesh.triangles.empty()) {
        return {};
    }
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t index : triangle) {
            low = glm::min(low, mesh.positions[index]);
            high = glm::max(high, mesh.positions[index]);
        }
    }
    BoundingSphere sphere;
    sphere.centre = 0.5 * low + 0.5 * high;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t index : triangle) {
            const double distance = glm::distance(sphere.centre, mesh.positions[index]);
            if (!std::isfinite(distance)) {
                return {glm::dvec3(0.0), std::numeric_limits<double>::infinity()};
            }
            sphere.radius = std::max(sphere.radius, distance);
        }
    }
    return sphere;
}

std::vector<glm::dvec3> smooth_normals(const std::vector<glm::dvec3>& positions,
                                       const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::vector<glm::dvec3> normals(positions.size(), glm::dvec3(0.0));
    for (const auto& triangle : triangles) {
        const glm::dvec3& origin = positions[triangle[0]];
        const glm::dvec3 area = glm::cross(positions[triangle[1]] - origin, positions[triangle[2]] - origin);
        for (const std::uint32_t index : triangle) {
            normals[index] += area;
        }
    }
    for (glm::dvec3& normal : normals) {
        const double length = glm::length(normal);
        normal = length > 0.0 && std::isfinite(length) ? normal / length : glm::dvec3(0.0, 0.0, 1.0);
    }
    return normals;
}

}  // namespace sheen
