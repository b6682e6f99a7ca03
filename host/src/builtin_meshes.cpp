// SPDX-License-Identifier: MIT
/// \file
/// Meshes that Sheen makes itself: the papers' spheres, a bumpy torus knot, the teapot.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "sheen/error.hpp"
#include "sheen/mesh.hpp"
#include "teapot.hpp"

namespace sheen {
namespace {

double turn_fraction(std::uint32_t step, std::uint32_t steps) {
    return glm::two_pi<double>() * static_cast<double>(step) / static_cast<double>(steps);
}

/// Unit sphere with its poles on y: `segments` meridian segments, `rings` bands between the poles, 2·segments·(rings −
/// 1) triangles. The normals are the positions.
Mesh make_sphere(const std::string& name, std::uint32_t segments, std::uint32_t rings) {
    Mesh mesh;
    mesh.name = name;
    mesh.positions.emplace_back(0.0, 1.0, 0.0);
    for (std::uint32_t ring = 1; ring < rings; ++ring) {
        const double polar = glm::pi<double>() * ring / rings;
        for (std::uint32_t segment = 0; segment < segments; ++segment) {
            const double azimuth = turn_fraction(segment, segments);
            mesh.positions.emplace_back(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                        -std::sin(polar) * std::sin(azimuth));
        }
    }
    mesh.positions.emplace_back(0.0, -1.0, 0.0);
    mesh.normals = mesh.positions;

    const auto south = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    const auto at = [segments](std::uint32_t ring, std::uint32_t segment) {
        return 1 + (ring - 1) * segments + segment % segments;
    };
    for (std::uint32_t segment = 0; segment < segments; ++segment) {
        mesh.triangles.push_back({0, at(1, segment), at(1, segment + 1)});
        for (std::uint32_t ring = 1; ring + 1 < rings; ++ring) {
            mesh.triangles.push_back({at(ring, segment), at(ring + 1, segment), at(ring, segment + 1)});
            mesh.triangles.push_back({at(ring, segment + 1), at(ring + 1, segment), at(ring + 1, segment + 1)});
        }
        mesh.triangles.push_back({at(rings - 1, segment), south, at(rings - 1, segment + 1)});
    }
    return mesh;
}

/// The knot's axis C(u) = (ρ cos 2u, ρ sin 2u, 0.35 sin 3u), ρ = 0.62(1 + 0.38 cos 3u), and its derivative.
struct KnotAxis {
    glm::dvec3 point{0.0};
    glm::dvec3 tangent{0.0};
};

KnotAxis knot_axis(double u) {
    const double radius = 0.62 * (1.0 + 0.38 * std::cos(3.0 * u));
    const double radius_slope = -0.62 * 0.38 * 3.0 * std::sin(3.0 * u);
    const double cosine = std::cos(2.0 * u);
    const double sine = std::sin(2.0 * u);
    return {{radius * cosine, radius * sine, 0.35 * std::sin(3.0 * u)},
            {radius_slope * cosine - 2.0 * radius * sine, radius_slope * sine + 2.0 * radius * cosine,
             0.35 * 3.0 * std::cos(3.0 * u)}};
}

/// A tube about the knot's axis in 110×12 cells, its radius 0.2·(1 + 0.12 sin 7u cos 3w); smooth normals by area.
Mesh make_torus_knot(const std::string& name) {
    constexpr std::uint32_t lengthwise = 110;
    constexpr std::uint32_t around = 12;
    Mesh mesh;
    mesh.name = name;
    for (std::uint32_t i = 0; i < lengthwise; ++i) {
        const double u = turn_fraction(i, lengthwise);
        const KnotAxis axis = knot_axis(u);
        const glm::dvec3 tangent = glm::normalize(axis.tangent);
        const glm::dvec3 binormal = glm::normalize(glm::cross(tangent, glm::dvec3(0.0, 0.0, 1.0)));
        const glm::dvec3 normal = glm::cross(binormal, tangent);
        for (std::uint32_t j = 0; j < around; ++j) {
            const double w = turn_fraction(j, around);
            const double radius = 0.2 * (1.0 + 0.12 * std::sin(7.0 * u) * std::cos(3.0 * w));
            mesh.positions.push_back(axis.point + radius * (std::cos(w) * binormal + std::sin(w) * normal));
        }
    }
    const auto at = [](std::uint32_t i, std::uint32_t j) { return (i % lengthwise) * around + j % around; };
    for (std::uint32_t i = 0; i < lengthwise; ++i) {
        for (std::uint32_t j = 0; j < around; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        }
    }
    mesh.normals = smooth_normals(mesh.positions, mesh.triangles);
    return mesh;
}

}  // namespace

std::vector<std::string> builtin_mesh_names() {
    return {"builtin:sphere-168", "builtin:sphere-374", "builtin:sphere-690", "builtin:torus-knot", "builtin:teapot"};
}

Mesh make_builtin_mesh(const std::string& name) {
    if (name == "builtin:sphere-168") {
        return make_sphere(name, 12, 8);
    }
    if (name == "builtin:sphere-374") {
        return make_sphere(name, 17, 12);
    }
    if (name == "builtin:sphere-690") {
        return make_sphere(name, 23, 16);
    }
    if (name == "builtin:torus-knot") {
        return make_torus_knot(name);
    }
    if (name == "builtin:teapot") {
        return make_teapot();
    }
    std::string known;
    for (const std::string& candidate : builtin_mesh_names()) {
        known += (known.empty() ? "" : ", ") + candidate;
    }
    throw UsageError("unknown mesh '" + name + "'; the built-in ones are " + known);
}

}  // namespace sheen
