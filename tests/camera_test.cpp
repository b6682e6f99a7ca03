// SPDX-License-Identifier: MIT
// The perspective camera against formulas of its own: where vertices fall, how depth runs, what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "sheen/error.hpp"
#include "sheen/scene.hpp"
#include "support/scenes.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 7101;

/// The distance at which a sphere of radius 1 fills `fill` of the height: its tangent from the eye has that slope.
long double filling_distance(double field_of_view, long double fill) {
    const long double half = std::atan(fill * std::tan(field_of_view * std::acos(-1.0L) / 360.0L));
    return 1.0L / std::sin(half);
}

TEST(Camera, PerspectiveDividesByTheDistanceBeforeTheEye) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> angle(-200.0, 200.0);
    std::uniform_real_distribution<double> field(1.0, 170.0);
    for (int run = 0; run < 200; ++run) {
        Scene scene;
        scene.mesh = random_mesh(random, 1);
        scene.rotate_degrees = {angle(random), angle(random), angle(random)};
        scene.two_sided = true;
        scene.width = 300 + 7 * run;
        scene.height = 200 + 5 * run;
        scene.field_of_view = field(random);
        double distance = static_cast<double>(filling_distance(*scene.field_of_view, 0.9L));
        if (run % 2 == 0) distance = 1.5 + 0.1 * run;
        if (run % 2 == 0) scene.distance = distance;
        const auto projected = project(scene);
        if (projected.empty()) continue;  // thinner than a pixel
        const BoundingSphere sphere = bounding_sphere(scene.mesh);
        const bool flipped = screen_area(projected[0]) > 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const ScreenVertex& vertex = projected[0].vertices[k];
            const glm::dvec3 turned = rotate_xyz(scene.rotate_degrees, scene.mesh.positions[k] - sphere.centre);
            const glm::dvec3 eye = turned - glm::dvec3(0.0, 0.0, distance * sphere.radius);
            const double slope = std::tan(*scene.field_of_view * std::acos(-1.0) / 360.0);  // of the image's upper edge
            const double half = 0.5 * scene.height;
            EXPECT_NEAR(static_cast<double>(vertex.point.x) / 256.0, 0.5 * scene.width + half * eye.x / -eye.z / slope,
                        0.0021);
            EXPECT_NEAR(static_cast<double>(vertex.point.y) / 256.0, half - half * eye.y / -eye.z / slope, 0.0021);
            EXPECT_NEAR(glm::distance(vertex.position, eye) / sphere.radius, 0.0, 1e-9);
            const double nearest = (distance - 1.0) * sphere.radius;
            const double farthest = (distance + 1.0) * sphere.radius;
            EXPECT_NEAR(vertex.depth, 1.0 + 65533.0 * (1.0 / nearest - 1.0 / -eye.z) / (1.0 / nearest - 1.0 / farthest),
                        1e-5);
            const glm::dvec3 normal = rotate_xyz(scene.rotate_degrees, scene.mesh.normals[k]);
            EXPECT_NEAR(glm::distance(vertex.normal, flipped ? -normal : normal), 0.0, 1e-9);
        }
        const glm::dvec3 towards_eye = -projected[0].vertices[0].position;
        EXPECT_GE(glm::dot(projected[0].face_normal, towards_eye), 0.0) << "faces away from the eye";
        if (HasFailure()) FAIL() << "run " << run;
    }
}

TEST(Camera, ByDefaultTheSphereFillsNineTenthsOfTheHeight) {
    for (const double field : {1.0, 20.0, 60.0, 110.0}) {
        Scene scene;
        scene.mesh = make_builtin_mesh("builtin:sphere-690");
        scene.field_of_view = field;
        scene.height = 400;
        double lowest = 1e9;
        double highest = -1e9;
        for (const ScreenTriangle& triangle : project(scene)) {
            for (const ScreenVertex& vertex : triangle.vertices) {
                lowest = std::min(lowest, static_cast<double>(vertex.point.y) / 256.0);
                highest = std::max(highest, static_cast<double>(vertex.point.y) / 256.0);
            }
        }
        EXPECT_NEAR(lowest, 20.0, 6.0) << field;  // the outline runs between vertices
        EXPECT_NEAR(highest, 380.0, 6.0) << field;
        EXPECT_GE(lowest, 20.0 - 1.0 / 256) << field;
        EXPECT_LE(highest, 380.0 + 1.0 / 256) << field;
    }
}

TEST(Camera, TheNearPlaneReachesNoVertexAtTheDefaultDistance) {
    for (double field = 1.0; field <= 170.0; field += 0.5) {
        Scene scene;
        scene.mesh = make_builtin_mesh("builtin:sphere-168");
        scene.field_of_view = field;
        scene.width = scene.height = 4095;
        scene.two_sided = true;
        ASSERT_EQ(project(scene).size(), scene.mesh.triangles.size()) << field << " degrees";
    }
}

TEST(Camera, DepthGrowsWithDistanceAndStaysInSixteenBits) {
    SCOPED_TRACE("seed " + std::to_string(seed + 1));
    std::mt19937 random(seed + 1);
    for (const double distance : {0.0, 0.3, 0.9, 1.0, 1.1, 4.0, 1000.0}) {
        Scene scene;
        scene.mesh = random_mesh(random, 300);
        scene.two_sided = true;
        scene.field_of_view = distance > 100.0 ? 1.0 : 70.0;
        scene.distance = distance;
        std::vector<std::pair<double, double>> seen;
        for (const ScreenTriangle& triangle : project(scene)) {
            for (const ScreenVertex& vertex : triangle.vertices) seen.emplace_back(-vertex.position.z, vertex.depth);
        }
        ASSERT_GT(seen.size(), 10U) << distance;
        std::sort(seen.begin(), seen.end());
        for (std::size_t k = 0; k < seen.size(); ++k) {
            ASSERT_GE(seen[k].second, 1.0 - 1e-6);
            ASSERT_LE(seen[k].second, 65534.0 + 1e-6);
            ASSERT_GE(seen[k].second, seen[k == 0 ? 0 : k - 1].second);
        }
        EXPECT_GT(seen.back().second, seen.front().second + 1.0) << distance;
    }
}

TEST(Camera, ThePerspectivePictureDoesNotDependOnTheMeshsUnit) {
    Scene scene;
    scene.mesh = make_builtin_mesh("builtin:sphere-168");
    scene.field_of_view = 50.0;
    scene.distance = 1.3;
    const auto reference = project(scene);
    for (const double scale : {1e-30, 1e30}) {
        Scene scaled = scene;
        for (glm::dvec3& p : scaled.mesh.positions) p *= scale;
        const auto triangles = project(scaled);
        ASSERT_EQ(triangles.size(), reference.size()) << scale;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const SnappedPoint& a = triangles[t].vertices[k].point;
                const SnappedPoint& b = reference[t].vertices[k].point;
                EXPECT_LE(std::abs(a.x - b.x) + std::abs(a.y - b.y), 1) << scale;
                EXPECT_NEAR(triangles[t].vertices[k].depth, reference[t].vertices[k].depth, 1e-6) << scale;
            }
        }
    }
}

TEST(Camera, ImpossibleFieldsOfViewAndDistancesAreRefused) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double field : {0.0, 0.99, 170.01, 180.0, -30.0, nan}) {
        Scene scene;
        scene.mesh = make_builtin_mesh("builtin:sphere-168");
        scene.field_of_view = field;
        EXPECT_THROW(project(scene), UsageError) << field;
    }
    for (const double distance : {-0.1, 1000.5, nan, std::numeric_limits<double>::infinity()}) {
        Scene scene;
        scene.mesh = make_builtin_mesh("builtin:sphere-168");
        scene.field_of_view = 30.0;
        scene.distance = distance;
        EXPECT_THROW(project(scene), UsageError) << distance;
    }
    Scene orthographic;
    orthographic.mesh = make_builtin_mesh("builtin:sphere-168");
    orthographic.distance = 3.0;
    EXPECT_THROW(project(orthographic), UsageError);
}

}  // namespace
}  // namespace sheen::test
