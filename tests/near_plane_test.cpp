// SPDX-License-Identifier: MIT
// Flying into meshes: what the near plane cuts stays joined, to the pixel, and within the rasteriser's range.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "sheen/scene.hpp"
#include "support/coverage_oracle.hpp"
#include "support/scenes.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 7102;

/// The documented near plane, in radii.
double near_plane(const Scene& scene) {
    const double focal = 0.5 * scene.height / std::tan(*scene.field_of_view * std::acos(-1.0) / 360.0);
    return std::max(1.0 / 256.0, focal / (1024.0 * 1024.0));
}

/// A directed edge of the hole that the near plane leaves, on the screen.
struct Segment {
    SnappedPoint from, to;
};

/// The cut of every triangle by the near plane, directed as the outline of what remains: computed here from the
/// mesh, with rotation and projection of its own.
std::vector<Segment> cut_of(const Scene& scene) {
    const BoundingSphere sphere = bounding_sphere(scene.mesh);
    const double near = near_plane(scene);
    const double focal = 0.5 * scene.height / std::tan(*scene.field_of_view * std::acos(-1.0) / 360.0);
    const auto eye = [&](std::uint32_t index) {
        const glm::dvec3 p = (scene.mesh.positions[index] - sphere.centre) / sphere.radius;
        return rotate_xyz(scene.rotate_degrees, p) - glm::dvec3(0.0, 0.0, *scene.distance);
    };
    std::vector<Segment> cut;
    for (const auto& triangle : scene.mesh.triangles) {
        std::optional<SnappedPoint> leaves, comes_back;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 a = eye(triangle[k]);
            const glm::dvec3 b = eye(triangle[(k + 1) % 3]);
            if ((-a.z >= near) == (-b.z >= near)) continue;
            const double t = (-near - a.z) / (b.z - a.z);
            const glm::dvec3 p = a + t * (b - a);
            const SnappedPoint point{std::llround(256.0 * (0.5 * scene.width + focal * p.x / near)),
                                     std::llround(256.0 * (0.5 * scene.height - focal * p.y / near))};
            (-a.z >= near ? leaves : comes_back) = point;
        }
        if (leaves) cut.push_back({*leaves, *comes_back});
    }
    return cut;
}

/// How often the segments, closed loops together, wind clockwise around the pixel's centre, by those right of it.
int winding(const std::vector<Segment>& cut, int x, int y) {
    const SnappedPoint p = pixel_centre(x, y);
    int turns = 0;
    for (const Segment& segment : cut) {
        const bool down = segment.to.y > p.y;
        if ((segment.from.y > p.y) == down) continue;
        const SnappedPoint& top = down ? segment.from : segment.to;
        const SnappedPoint& bottom = down ? segment.to : segment.from;
        if (cross(top, bottom, p) > 0) turns += down ? 1 : -1;
    }
    return turns;
}

/// Per pixel, how often triangles that turn clockwise on the screen cover it less how often the others do.
std::vector<int> signed_coverage(const Scene& scene, std::size_t& covered) {
    std::vector<int> counts(static_cast<std::size_t>(scene.width * scene.height), 0);
    for (const ScreenTriangle& triangle : project(scene)) {
        const int sign = screen_area(triangle) > 0 ? 1 : -1;
        for (const TriangleWalk& walk : triangle.walks) {
            for_each_span(walk, [&](int x, int y, int length, int step) {
                for (int k = 0; k < length; ++k, x += step, ++covered) {
                    counts.at(static_cast<std::size_t>(y * scene.width + x)) += sign;
                }
            });
        }
    }
    return counts;
}

Scene flight(const std::string& mesh, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    Scene scene;
    scene.mesh = make_builtin_mesh(mesh);
    scene.rotate_degrees = {360.0 * uniform(random), 360.0 * uniform(random), 360.0 * uniform(random)};
    scene.two_sided = true;
    scene.width = 47;
    scene.height = 36;
    scene.field_of_view = 1.0 + 169.0 * uniform(random);
    scene.distance = 1.05 * uniform(random);
    return scene;
}

TEST(NearPlane, WhatRemainsOfAClosedMeshIsJoinedExactlyAlongEveryEdgeButTheCut) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::size_t covered = 0;
    std::size_t cuts = 0;
    std::size_t open_pixels = 0;
    for (const std::string mesh : {"builtin:torus-knot", "builtin:sphere-168"}) {
        for (int run = 0; run < 150; ++run) {
            const Scene scene = flight(mesh, random);
            const std::vector<Segment> cut = cut_of(scene);
            const std::vector<int> counts = signed_coverage(scene, covered);
            cuts += cut.size();
            for (int y = 0; y < scene.height; ++y) {
                for (int x = 0; x < scene.width; ++x) {
                    const int turns = winding(cut, x, y);
                    ASSERT_EQ(counts[static_cast<std::size_t>(y * scene.width + x)], turns)
                        << mesh << ", run " << run << ", pixel " << x << ", " << y << ", field " << *scene.field_of_view
                        << ", distance " << *scene.distance;
                    open_pixels += turns != 0 ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(covered, 100000U);
    EXPECT_GT(cuts, 1000U);
    EXPECT_GT(open_pixels, 10000U) << "the eye never was inside";
}

TEST(NearPlane, FromInsideASphereEveryPixelIsCoveredOnceAndFrontFacesAreCulled) {
    SCOPED_TRACE("seed " + std::to_string(seed + 1));
    std::mt19937 random(seed + 1);
    std::uniform_real_distribution<double> distance(0.0, 0.85);
    for (int run = 0; run < 100; ++run) {
        Scene scene = flight("builtin:sphere-374", random);
        scene.distance = distance(random);
        std::size_t covered = 0;
        for (const int count : signed_coverage(scene, covered)) ASSERT_EQ(count, 1) << "run " << run;
        ASSERT_EQ(covered, static_cast<std::size_t>(scene.width * scene.height)) << "run " << run;
        scene.two_sided = false;
        ASSERT_TRUE(project(scene).empty()) << "run " << run;
    }
}

TEST(NearPlane, PiecesEndOnThePlaneWithUnitNormalsAndTheNearestDepth) {
    SCOPED_TRACE("seed " + std::to_string(seed + 2));
    std::mt19937 random(seed + 2);
    std::size_t on_plane = 0;
    for (int run = 0; run < 100; ++run) {
        Scene scene = flight("builtin:torus-knot", random);
        if (run % 3 == 0) {
            // Opposite normals along edges: nothing to normalise half-way.
            for (std::size_t k = 0; k < scene.mesh.normals.size(); k += 2) scene.mesh.normals[k] *= -1.0;
        }
        const double radius = bounding_sphere(scene.mesh).radius;
        const double near = near_plane(scene);
        for (const ScreenTriangle& triangle : project(scene)) {
            EXPECT_NEAR(glm::length(triangle.face_normal), 1.0, 1e-9);
            EXPECT_GE(glm::dot(triangle.face_normal, -triangle.vertices[0].position), -1e-9 * radius);
            for (const ScreenVertex& vertex : triangle.vertices) {
                ASSERT_GE(-vertex.position.z / radius, near * (1.0 - 1e-12));
                ASSERT_NEAR(glm::length(vertex.normal), 1.0, 1e-9);
                ASSERT_GE(vertex.depth, 1.0 - 1e-6);
                ASSERT_LE(vertex.depth, 65534.0 + 1e-6);
                if (-vertex.position.z / radius > near * (1.0 + 1e-12)) continue;
                EXPECT_NEAR(vertex.depth, 1.0, 1e-6);
                ++on_plane;
            }
        }
    }
    EXPECT_GT(on_plane, 300U);
}

/// walk_in_image() takes ±2^29: no lens and no image size brings a vertex past half of that.
TEST(NearPlane, KeepsEveryVertexWithinTheRasterisersRange) {
    SCOPED_TRACE("seed " + std::to_string(seed + 3));
    std::mt19937 random(seed + 3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    constexpr std::int64_t limit = (std::int64_t{1} << 28) + 256 * 2048;
    std::int64_t farthest = 0;
    for (int run = 0; run < 400; ++run) {
        Scene scene;
        scene.mesh = random_mesh(random, 60);
        scene.two_sided = true;
        scene.width = 4095;
        scene.height = run % 2 == 0 ? 4095 : 16;
        scene.field_of_view = run % 3 == 0 ? 1.0 : 1.0 + 169.0 * uniform(random);
        scene.distance = uniform(random);
        for (const ScreenTriangle& triangle : project(scene)) {
            for (const ScreenVertex& vertex : triangle.vertices) {
                farthest = std::max({farthest, std::abs(vertex.point.x), std::abs(vertex.point.y)});
            }
        }
    }
    EXPECT_LE(farthest, limit);
    EXPECT_GT(farthest, limit / 4) << "the extreme was never tried";
}

/// The end of a cut edge is the same to the bit whichever triangle asks, so that neighbours also agree in colour.
TEST(NearPlane, NeighboursHaveEqualVerticesOnThePlane) {
    SCOPED_TRACE("seed " + std::to_string(seed + 4));
    std::mt19937 random(seed + 4);
    std::size_t on_plane = 0;
    std::size_t shared = 0;
    for (int run = 0; run < 60; ++run) {
        const Scene scene = flight("builtin:torus-knot", random);
        const double near = near_plane(scene) * bounding_sphere(scene.mesh).radius;
        std::map<std::pair<double, double>, glm::dvec3> normal_at;
        for (const ScreenTriangle& triangle : project(scene)) {
            const double side = screen_area(triangle) > 0 ? -1.0 : 1.0;  // back faces carry flipped normals
            for (const ScreenVertex& vertex : triangle.vertices) {
                if (-vertex.position.z > near * (1.0 + 1e-12)) continue;
                const std::pair<double, double> place{vertex.position.x, vertex.position.y};
                const auto [known, added] = normal_at.try_emplace(place, side * vertex.normal);
                EXPECT_EQ(known->second, side * vertex.normal);
                shared += added ? 0 : 1;
                ++on_plane;
            }
        }
    }
    // A cut edge ends in one place for the two triangles on its sides, but those that cover no pixel are left out.
    EXPECT_GT(on_plane, 300U);
    EXPECT_GT(3 * shared, on_plane);
}

}  // namespace
}  // namespace sheen::test
