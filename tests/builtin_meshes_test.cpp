// SPDX-License-Identifier: MIT
// Built-in meshes: counts, closedness, orientation, normals and sizes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "sheen/error.hpp"
#include "sheen/mesh.hpp"

namespace sheen {
namespace {

/// How often each directed edge occurs, between places: vertices that differ in normal only are one place.
std::map<std::pair<std::size_t, std::size_t>, int> directed_edges(const Mesh& mesh) {
    std::map<std::array<double, 3>, std::size_t> places;
    const auto place = [&](std::uint32_t index) {
        const glm::dvec3& p = mesh.positions[index];
        return places.try_emplace({p.x, p.y, p.z}, places.size()).first->second;
    };
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++edges[{place(triangle[k]), place(triangle[(k + 1) % 3])}];
        }
    }
    return edges;
}

double signed_volume(const Mesh& mesh) {
    double volume = 0.0;
    for (const auto& t : mesh.triangles) {
        volume += glm::dot(mesh.positions[t[0]], glm::cross(mesh.positions[t[1]], mesh.positions[t[2]])) / 6.0;
    }
    return volume;
}

glm::dvec3 area_vector(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
    return glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
}

std::size_t open_edges(const Mesh& mesh) {
    const auto edges = directed_edges(mesh);
    std::size_t open = 0;
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1) << mesh.name << ": an edge is used twice in one direction";
        open += edges.count({edge.second, edge.first}) == 0 ? 1 : 0;
    }
    return open;
}

TEST(BuiltinMeshes, TriangleCountsAreThoseOfTheirNames) {
    EXPECT_EQ(make_builtin_mesh("builtin:sphere-168").triangles.size(), 168U);
    EXPECT_EQ(make_builtin_mesh("builtin:sphere-374").triangles.size(), 374U);
    EXPECT_EQ(make_builtin_mesh("builtin:sphere-690").triangles.size(), 690U);
    EXPECT_EQ(make_builtin_mesh("builtin:torus-knot").triangles.size(), 2640U);
}

TEST(BuiltinMeshes, EveryMeshIsSoundAndFacesOutwards) {
    for (const std::string& name : builtin_mesh_names()) {
        const Mesh mesh = make_builtin_mesh(name);
        EXPECT_EQ(mesh.name, name);
        ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
        EXPECT_GT(signed_volume(mesh), 0.0) << name << " is inside out";
        for (const glm::dvec3& normal : mesh.normals) {
            EXPECT_NEAR(glm::length(normal), 1.0, 1e-12) << name;
        }
        for (const auto& triangle : mesh.triangles) {
            for (const std::uint32_t index : triangle) {
                ASSERT_LT(index, mesh.positions.size());
                EXPECT_GT(glm::dot(area_vector(mesh, triangle), mesh.normals[index]), 0.0)
                    << name << ": a normal points to the back of its triangle";
            }
        }
    }
}

TEST(BuiltinMeshes, SpheresAndKnotAreClosedManifoldsOfTheRightGenus) {
    const std::map<std::string, int> euler_characteristic{
        {"builtin:sphere-168", 2}, {"builtin:sphere-374", 2}, {"builtin:sphere-690", 2}, {"builtin:torus-knot", 0}};
    for (const auto& [name, expected] : euler_characteristic) {
        const Mesh mesh = make_builtin_mesh(name);
        EXPECT_EQ(open_edges(mesh), 0U) << name;
        const auto edges = static_cast<int>(directed_edges(mesh).size() / 2);
        EXPECT_EQ(static_cast<int>(mesh.positions.size()) - edges + static_cast<int>(mesh.triangles.size()), expected)
            << name;
    }
}

TEST(BuiltinMeshes, SpheresLieOnTheUnitSphereWithPolesOnY) {
    for (const char* name : {"builtin:sphere-168", "builtin:sphere-374", "builtin:sphere-690"}) {
        const Mesh mesh = make_builtin_mesh(name);
        double highest = -1.0;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            EXPECT_NEAR(glm::length(mesh.positions[i]), 1.0, 1e-12);
            EXPECT_EQ(mesh.positions[i], mesh.normals[i]);
            highest = std::max(highest, mesh.positions[i].y);
        }
        EXPECT_EQ(highest, 1.0) << name;
    }
}

TEST(BuiltinMeshes, TheKnotIsATubeOfRadiusAFifth) {
    // Each ring of 12 vertices lies around its mean at 0.2·(1 ± 0.12).
    const Mesh mesh = make_builtin_mesh("builtin:torus-knot");
    for (std::size_t ring = 0; ring < 110; ++ring) {
        glm::dvec3 centre(0.0);
        for (std::size_t k = 0; k < 12; ++k) {
            centre += mesh.positions[12 * ring + k] / 12.0;
        }
        for (std::size_t k = 0; k < 12; ++k) {
            const double radius = glm::distance(centre, mesh.positions[12 * ring + k]);
            EXPECT_GE(radius, 0.2 * 0.88 - 1e-9);
            EXPECT_LE(radius, 0.2 * 1.12 + 1e-9);
        }
    }
}

TEST(BuiltinMeshes, TheTeapotHasNewellsSizeStandsUprightAndPointsItsSpoutToPlusX) {
    const Mesh mesh = make_builtin_mesh("builtin:teapot");
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-low);
    for (const glm::dvec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    EXPECT_EQ(low, glm::dvec3(-3.0, 0.0, -2.0)) << "handle, base, belly";
    EXPECT_NEAR(high.y, 3.15, 1e-6) << "knob";
    EXPECT_EQ(high.z, 2.0);
    EXPECT_NEAR(high.x, 3.434, 1e-3) << "spout";
}

TEST(BuiltinMeshes, TheTeapotIsOpenOnlyWhereHandleAndSpoutEnterTheBody) {
    const Mesh mesh = make_builtin_mesh("builtin:teapot");
    // Two ends of the handle and one of the spout, each two patches of ten cells around.
    EXPECT_EQ(open_edges(mesh), 3U * 2U * 10U);
}

TEST(BuiltinMeshes, TheTeapotMirrorsInItsPlaneOfSymmetry) {
    const Mesh mesh = make_builtin_mesh("builtin:teapot");
    constexpr double grid = 1e6;
    const auto key = [](const glm::dvec3& p) {
        return std::array<long, 3>{std::lround(p.x * grid), std::lround(p.y * grid), std::lround(std::abs(p.z) * grid)};
    };
    std::map<std::array<long, 3>, int> balance;
    for (const glm::dvec3& p : mesh.positions) {
        balance[key(p)] += (p.z > 1e-9) - (p.z < -1e-9);
    }
    for (const auto& [place, difference] : balance) {
        EXPECT_EQ(difference, 0) << place[0] << ", " << place[1] << ", " << place[2] << " (micro-units)";
    }
}

TEST(BuiltinMeshes, AnUnknownNameIsAUsageErrorThatListsTheKnownOnes) {
    try {
        make_builtin_mesh("builtin:cube");
        FAIL() << "accepted";
    } catch (const UsageError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("'builtin:cube'"), std::string::npos) << message;
        for (const std::string& name : builtin_mesh_names()) {
            EXPECT_NE(message.find(name), std::string::npos) << message;
        }
    }
}

}  // namespace
}  // namespace sheen
