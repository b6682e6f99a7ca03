// SPDX-License-Identifier: MIT
// The camera's conventions, visibility of faces, and what projecting never does.
#include "sheen/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "sheen/error.hpp"
#include "support/scenes.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 7005;

Scene scene_of(Mesh mesh, const glm::dvec3& rotate_degrees = glm::dvec3(0.0)) {
    Scene scene;
    scene.mesh = std::move(mesh);
    scene.rotate_degrees = rotate_degrees;
    return scene;
}

TEST(Scene, VerticesAreWhereTheConventionsPutThem) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> angle(-200.0, 200.0);
    for (int run = 0; run < 40; ++run) {
        Scene scene = scene_of(random_mesh(random, 1), {angle(random), angle(random), angle(random)});
        scene.two_sided = true;
        scene.width = 300 + 17 * run;
        scene.height = 200 + 11 * run;
        const BoundingSphere sphere = bounding_sphere(scene.mesh);
        const auto projected = project(scene);
        ASSERT_EQ(projected.size(), 1U);
        const bool flipped = screen_area(projected[0]) > 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const ScreenVertex& vertex = projected[0].vertices[k];
            const glm::dvec3 turned = rotate_xyz(scene.rotate_degrees, scene.mesh.positions[k] - sphere.centre);
            const glm::dvec3 eye = turned - glm::dvec3(0.0, 0.0, 4.0 * sphere.radius);
            const double scale = 0.45 * scene.height / sphere.radius;
            EXPECT_NEAR(static_cast<double>(vertex.point.x), 256.0 * (0.5 * scene.width + scale * eye.x), 0.5001);
            EXPECT_NEAR(static_cast<double>(vertex.point.y), 256.0 * (0.5 * scene.height - scale * eye.y), 0.5001);
            EXPECT_NEAR(vertex.depth, 1.0 + 65533.0 * (-eye.z / sphere.radius - 3.0) / 2.0, 1e-6);
            EXPECT_NEAR(glm::distance(vertex.position, eye), 0.0, 1e-9);
            const glm::dvec3 normal = rotate_xyz(scene.rotate_degrees, scene.mesh.normals[k]);
            EXPECT_NEAR(glm::distance(vertex.normal, flipped ? -normal : normal), 0.0, 1e-9);
        }
    }
}

TEST(Scene, TheBoundingSphereIsCentredAndFillsNineTenthsOfTheHeight) {
    for (const glm::dvec3& turn : {glm::dvec3(0.0), glm::dvec3(23, 0, 11), glm::dvec3(-70, 130, 5)}) {
        Scene scene = scene_of(make_builtin_mesh("builtin:sphere-690"), turn);
        scene.height = 400;
        double lowest = 1e9;
        double highest = -1e9;
        for (const ScreenTriangle& triangle : project(scene)) {
            for (const ScreenVertex& vertex : triangle.vertices) {
                lowest = std::min(lowest, static_cast<double>(vertex.point.y) / 256.0);
                highest = std::max(highest, static_cast<double>(vertex.point.y) / 256.0);
            }
        }
        EXPECT_NEAR(lowest, 20.0, 3.0);
        EXPECT_NEAR(highest, 380.0, 3.0);
        EXPECT_GE(lowest, 20.0 - 1e-9);
        EXPECT_LE(highest, 380.0 + 1e-9);
    }
}

TEST(Scene, FrontFacesAreKeptInOrderAndBackFacesOnlyWhenTwoSided) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Scene scene = scene_of(random_mesh(random, 800));
    const auto front = project(scene);
    scene.two_sided = true;
    const auto both = project(scene);
    std::size_t next = 0;
    for (const ScreenTriangle& triangle : both) {
        ASSERT_NE(screen_area(triangle), 0);
        EXPECT_GE(triangle.face_normal.z, 0.0) << "faces away from the eye";
        EXPECT_NEAR(glm::length(triangle.face_normal), 1.0, 1e-12);
        const glm::dvec3 u = triangle.vertices[1].position - triangle.vertices[0].position;
        EXPECT_NEAR(glm::dot(triangle.face_normal, glm::normalize(u)), 0.0, 1e-9);
        if (screen_area(triangle) < 0) {
            ASSERT_LT(next, front.size());
            EXPECT_EQ(triangle.vertices[0].point, front[next].vertices[0].point);
            EXPECT_EQ(triangle.vertices[0].normal, front[next].vertices[0].normal);
            ++next;
        }
    }
    EXPECT_EQ(next, front.size());
    EXPECT_GT(both.size(), front.size() + 200);
    EXPECT_EQ(both.size(), 700U) << "one in eight has no area";
}

TEST(Scene, AClosedMeshWithoutCullingCoversEachPixelAsOftenFromTheFrontAsFromTheBack) {
    Scene scene = scene_of(make_builtin_mesh("builtin:torus-knot"), {20, 30, 40});
    scene.two_sided = true;
    scene.width = 40;  // narrower than the knot: clipping takes part
    scene.height = 60;
    std::vector<int> winding(static_cast<std::size_t>(scene.width * scene.height), 0);
    int covered = 0;
    for (const ScreenTriangle& triangle : project(scene)) {
        for (const TriangleWalk& walk : triangle.walks) {
            for_each_span(walk, [&](int x, int y, int length, int step) {
                for (int k = 0; k < length; ++k, x += step, ++covered) {
                    winding.at(static_cast<std::size_t>(y * scene.width + x)) += screen_area(triangle) > 0 ? 1 : -1;
                }
            });
        }
    }
    for (std::size_t pixel = 0; pixel < winding.size(); ++pixel) {
        ASSERT_EQ(winding[pixel], 0) << "pixel " << pixel % 40 << ", " << pixel / 40;
    }
    EXPECT_GT(covered, 1000);
}

TEST(Scene, EveryTriangleLeftCoversPixelsInTheImage) {
    Scene scene = scene_of(make_builtin_mesh("builtin:sphere-690"));
    const std::size_t whole = project(scene).size();
    scene.width = 64;
    const auto triangles = project(scene);
    EXPECT_LT(triangles.size(), whole / 2);
    for (const ScreenTriangle& triangle : triangles) {
        int covered = 0;
        for (const TriangleWalk& walk : triangle.walks) {
            for_each_span(walk, [&](int x, int y, int length, int step) {
                const int end = x + step * (length - 1);
                EXPECT_TRUE(std::min(x, end) >= 0 && std::max(x, end) < scene.width && y >= 0 && y < scene.height);
                covered += length;
            });
        }
        EXPECT_GT(covered, 0);
    }
}

TEST(Scene, ThePictureDoesNotDependOnTheMeshsUnitOrPlace) {
    const auto reference = project(scene_of(make_builtin_mesh("builtin:sphere-168"), {10, 20, 30}));
    for (const double scale : {1e-30, 1e-3, 1e30}) {
        Mesh mesh = make_builtin_mesh("builtin:sphere-168");
        for (glm::dvec3& p : mesh.positions) {
            p = scale * (p + glm::dvec3(2.0, -3.0, 1.0));
        }
        const auto triangles = project(scene_of(mesh, {10, 20, 30}));
        ASSERT_EQ(triangles.size(), reference.size()) << scale;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const SnappedPoint& a = triangles[t].vertices[k].point;
                const SnappedPoint& b = reference[t].vertices[k].point;
                EXPECT_LE(std::abs(a.x - b.x) + std::abs(a.y - b.y), 1) << scale;
            }
            EXPECT_NEAR(glm::distance(triangles[t].face_normal, reference[t].face_normal), 0.0, 1e-9) << scale;
        }
    }
}

TEST(Scene, ImpossibleSizesAndMeshesAreRefused) {
    for (const auto& [width, height] : {std::pair{0, 10}, {10, 0}, {-1, 10}, {4096, 10}, {10, 4096}}) {
        Scene scene = scene_of(make_builtin_mesh("builtin:sphere-168"));
        scene.width = width;
        scene.height = height;
        EXPECT_THROW(project(scene), UsageError) << width << "x" << height;
    }
    Mesh point = make_builtin_mesh("builtin:sphere-168");
    for (glm::dvec3& p : point.positions) {
        p = glm::dvec3(1.0, 2.0, 3.0);
    }
    EXPECT_THROW(project(scene_of(point)), Error);
    EXPECT_THROW(project(scene_of(Mesh{})), Error);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Mesh mesh = make_builtin_mesh("builtin:sphere-168");
        mesh.positions[7].y = bad;
        EXPECT_THROW(project(scene_of(mesh)), Error) << bad;
    }
}

TEST(Scene, TheLargestAndSmallestImagesWork) {
    for (const auto& [width, height] : {std::pair{4095, 4095}, {1, 1}, {4095, 1}, {1, 4095}}) {
        Scene scene = scene_of(make_builtin_mesh("builtin:sphere-168"));
        scene.width = width;
        scene.height = height;
        for (const ScreenTriangle& triangle : project(scene)) {
            for (const ScreenVertex& vertex : triangle.vertices) {
                EXPECT_GE(vertex.depth, 1.0);
                EXPECT_LE(vertex.depth, 65534.0);
            }
        }
    }
}

}  // namespace
}  // namespace sheen::test
