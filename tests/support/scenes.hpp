// SPDX-License-Identifier: MIT
/// \file
/// Random meshes, and the scene's conventions once more, independent of the library.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <random>

#include "sheen/scene.hpp"

namespace sheen::test {

/// Rodrigues' rotation of `p` about a unit axis, independent of the library's matrices.
inline glm::dvec3 rotate_about(const glm::dvec3& axis, double degrees, const glm::dvec3& p) {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    return p * std::cos(angle) + glm::cross(axis, p) * std::sin(angle) +
           axis * (glm::dot(axis, p) * (1.0 - std::cos(angle)));
}

inline glm::dvec3 rotate_xyz(const glm::dvec3& degrees, glm::dvec3 p) {
    p = rotate_about({1, 0, 0}, degrees.x, p);
    p = rotate_about({0, 1, 0}, degrees.y, p);
    return rotate_about({0, 0, 1}, degrees.z, p);
}

/// Triangles of random corners; every eighth one is without area.
inline Mesh random_mesh(std::mt19937& random, std::size_t triangles) {
    std::uniform_real_distribution<double> coordinate(-3.0, 5.0);
    Mesh mesh;
    mesh.name = "random";
    for (std::size_t t = 0; t < triangles; ++t) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int corner = 0; corner < 3; ++corner) {
            mesh.positions.emplace_back(coordinate(random), coordinate(random), coordinate(random));
            mesh.normals.push_back(
                glm::normalize(glm::dvec3(coordinate(random), coordinate(random), coordinate(random))));
        }
        const std::uint32_t last = t % 8 == 7 ? first : first + 2;
        mesh.triangles.push_back({first, first + 1, last});
    }
    return mesh;
}

inline std::int64_t screen_area(const ScreenTriangle& t) {
    return doubled_area(t.vertices[0].point, t.vertices[1].point, t.vertices[2].point);
}

}  // namespace sheen::test
