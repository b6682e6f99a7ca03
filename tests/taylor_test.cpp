// SPDX-License-Identifier: MIT
// taylor (paper fast-phong, eye at infinity): its coefficients against automatic differentiation, the printed one's
// error, what it shades, its quality, its limits and its cost.
#include "sheen/taylor.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <map>
#include <tuple>

#include "sheen/error.hpp"
#include "sheen/exponent_table.hpp"
#include "support/jet.hpp"
#include "support/shaded_triangles.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 19860803;

LinearVector<double> random_linear(Rng& rng) {
    const auto vector = [&rng](double size) {
        return glm::dvec3(between(rng, -size, size), between(rng, -size, size), between(rng, -size, size));
    };
    return {vector(0.7), vector(0.7), random_direction(rng, -1.0) * between(rng, 0.5, 1.0)};
}

JetVector jet_of(const LinearVector<double>& v) {
    return {linear_jet(v.x.x, v.y.x, v.constant.x), linear_jet(v.x.y, v.y.y, v.constant.y),
            linear_jet(v.x.z, v.y.z, v.constant.z)};
}

JetVector jet_of(const glm::dvec3& v) { return {linear_jet(0, 0, v.x), linear_jet(0, 0, v.y), linear_jet(0, 0, v.z)}; }

TEST(Taylor, CoefficientsAreThoseOfAutomaticDifferentiation) {
    Rng rng(seed);
    for (int run = 0; run < 5000; ++run) {
        const LinearVector<double> normal = random_linear(rng);
        const glm::dvec3 light = random_direction(rng, -1.0);
        const TaylorSeries<double> got =
            taylor_series(dot_product(normal, light), inverse_length(squared_length(normal)));
        const std::array<double, 6> expected = cosine(jet_of(normal), jet_of(light)).series();
        for (std::size_t t = 0; t < got.size(); ++t) {
            ASSERT_NEAR(got[t], expected[t], 1e-10 * (1.0 + std::abs(expected[t])))
                << "T" << t << ", run " << run << ", seed " << seed;
        }
    }
}

/// Erratum: T5 is printed with 3ig² for 3cg².
TEST(TaylorErrata, PrintedT5IsWrongAndTheOthersRight) {
    Rng rng(seed + 1);
    double worst = 0.0;
    for (int run = 0; run < 1000; ++run) {
        const LinearVector<double> normal = random_linear(rng);
        const glm::dvec3 light = random_direction(rng, -1.0);
        const TaylorSeries<double> printed = printed_taylor_series(normal, light);
        const std::array<double, 6> expected = cosine(jet_of(normal), jet_of(light)).series();
        for (std::size_t t = 0; t < 5; ++t) {
            ASSERT_NEAR(printed[t], expected[t], 1e-10 * (1.0 + std::abs(expected[t]))) << "T" << t << ", run " << run;
        }
        worst = std::max(worst, std::abs(printed[5] - expected[5]));
    }
    fmt::print("printed T5: up to {:.2f} off\n", worst);
    EXPECT_GT(worst, 1.0);
}

/// The colour by jets in pixels about the centroid on the screen: other axes than the shader's, no formula shared.
glm::dvec3 expected_colour(const Scene& scene, const ScreenTriangle& triangle, const MethodOptions& options, int x,
                           int y) {
    const auto& v = triangle.vertices;
    const glm::dvec3 here = weights_at(triangle, 100, 100);
    const glm::dvec3 along_x = weights_at(triangle, 101, 100) - here;
    const glm::dvec3 along_y = weights_at(triangle, 100, 101) - here;
    const auto interpolate = [&](const glm::dvec3& w) {
        return w[0] * v[0].normal + w[1] * v[1].normal + w[2] * v[2].normal;
    };
    const JetVector normal =
        jet_of(LinearVector<double>{interpolate(along_x), interpolate(along_y), interpolate(glm::dvec3(1.0 / 3.0))});
    const double dx = x + 0.5 - static_cast<double>(v[0].point.x + v[1].point.x + v[2].point.x) / 768.0;
    const double dy = y + 0.5 - static_cast<double>(v[0].point.y + v[1].point.y + v[2].point.y) / 768.0;
    const ExponentTable table(triangle.material.shininess, options.taylor_table_bytes);
    glm::dvec3 sum = triangle.material.ambient;
    for (const Light& light : scene.lights) {
        const auto value = [&](const glm::dvec3& direction) {
            const std::array<double, 6> t = cosine(normal, jet_of(direction)).series();
            return t[0] + t[1] * dy + t[2] * dx + t[3] * dy * dy + t[4] * dx * dy + t[5] * dx * dx;
        };
        const glm::dvec3 half = light.vector + glm::dvec3(0.0, 0.0, 1.0);
        sum += light.colour * (triangle.material.diffuse * std::max(0.0, value(light.vector)) +
                               triangle.material.specular * table.read(value(half)));
    }
    return 255.0 * sum;
}

TEST(Taylor, ShadesTheSeriesAboutTheCentroidWithTheTablesPowerForAnyLights) {
    Rng rng(seed + 2);
    std::size_t compared = 0;
    for (int run = 0; run < 60; ++run) {
        Scene scene = small_scene();
        for (std::int64_t k = uniform(rng, 0, 3); k > 0; --k) scene.lights.push_back(directional_light(rng, -0.5));
        scene.material.shininess = between(rng, 1.0, 100.0);
        MethodOptions options;
        options.taylor_table_bytes = static_cast<std::size_t>(uniform(rng, 16, 9000));
        const ScreenTriangle triangle = benign_triangle(rng, scene);
        for_each_pixel(Method::taylor, options, scene, triangle, [&](int x, int y, const glm::dvec3& got) {
            if ((x + y) % 3 != 0) return;
            ASSERT_LT(glm::length(got - expected_colour(scene, triangle, options, x, y)), 1e-7)
                << "pixel " << x << ", " << y << ", run " << run << ", seed " << seed + 2;
            ++compared;
        });
    }
    EXPECT_GT(compared, 3000U);
}

/// A remainder of the third degree: halving every normal's distance from the middle one divides the error by eight.
TEST(Taylor, ErrorFallsWithTheThirdPowerOfTheTriangle) {
    Rng rng(seed + 3);
    double coarse = 0.0;
    double fine = 0.0;
    for (int run = 0; run < 300; ++run) {
        const LinearVector<double> normal = random_linear(rng);
        const glm::dvec3 light = random_direction(rng, -1.0);
        const TaylorSeries<double> t =
            taylor_series(dot_product(normal, light), inverse_length(squared_length(normal)));
        const glm::dvec2 at(between(rng, -1.0, 1.0), between(rng, -1.0, 1.0));
        const auto error = [&](double scale) {
            const glm::dvec3 n = normal.x * (scale * at.x) + normal.y * (scale * at.y) + normal.constant;
            return std::abs(value_at(t, scale * at.x, scale * at.y) - glm::dot(glm::normalize(n), light));
        };
        coarse += error(0.02);
        fine += error(0.01);
    }
    EXPECT_NEAR(coarse / fine, 8.0, 0.8);
}

/// The paper: beyond about 60 degrees of curvature the shading differs noticeably. Three normals on a cone about the
/// eye's direction, `degrees` from each other, under lights all round; the error of a white surface's diffuse colour.
ErrorMeter curvature_error(double degrees) {
    // Neighbours on a cone of half angle c have a chord of √3·sin c.
    const double tilt = std::asin(2.0 / std::sqrt(3.0) * std::sin(glm::radians(degrees) / 2.0));
    Scene scene = small_scene();
    scene.material.ambient = glm::dvec3(0.0);
    scene.material.diffuse = glm::dvec3(1.0);
    scene.material.specular = 0.0;
    ScreenTriangle triangle;
    triangle.material = scene.material;
    triangle.face_normal = {0.0, 0.0, 1.0};
    for (std::size_t k = 0; k < 3; ++k) {
        const double turn = glm::two_pi<double>() * static_cast<double>(k) / 3.0;
        const glm::dvec2 around(std::cos(turn), std::sin(turn));
        triangle.vertices[k].normal = glm::dvec3(std::sin(tilt) * around, std::cos(tilt));
        triangle.vertices[k].point = {7680 + static_cast<std::int64_t>(7000.0 * around.x),
                                      7680 - static_cast<std::int64_t>(7000.0 * around.y)};
    }
    walk_in(triangle, scene);
    ErrorMeter meter;
    for (int light = 0; light < 60; ++light) {
        const int ring = light / 4;
        const double height = glm::radians(6.0 * ring + 3.0);
        const double turn = glm::two_pi<double>() * light / 24.0;
        scene.lights = {Light()};
        scene.lights[0].vector = {std::cos(turn) * std::cos(height), std::sin(turn) * std::cos(height),
                                  std::sin(height)};
        const auto phong = make_shader(Method::phong, {}, scene, triangle);
        for_each_pixel(Method::taylor, {}, scene, triangle, [&](int x, int y, const glm::dvec3& got) {
            meter.add({phong->colour(x, weights_at(triangle, x, y))}, {got}, {true});
        });
    }
    return meter;
}

TEST(Taylor, DiffuseErrorGrowsSteeplyAround60DegreesOfCurvature) {
    fmt::print("degrees between the vertices' normals: diffuse error, 8-bit steps, greatest and root mean square\n");
    double previous = 0.0;
    for (const double degrees : {10.0, 20.0, 30.0, 45.0, 60.0, 75.0, 90.0, 110.0}) {
        const ErrorMeter meter = curvature_error(degrees);
        const double error = meter.max_error();
        fmt::print("{:5.0f} {:8.2f} {:8.2f}\n", degrees, error, std::sqrt(meter.mean_square_error()));
        EXPECT_GT(error, previous);
        previous = error;
    }
    EXPECT_LT(curvature_error(20.0).max_error(), 1.0);
    EXPECT_GT(curvature_error(60.0).max_error(), 8.0);
}

TEST(Taylor, HasItsMeasuredQualityOnTheSphereAndMisprintedLess) {
    Scene scene = measured_sphere();
    const std::array<std::array<double, 2>, 3> measured{{{5.0, 57.0}, {20.0, 55.8}, {50.0, 53.0}}};
    double psnr = 0.0;
    for (const auto& [shininess, least] : measured) {
        scene.material.shininess = shininess;
        const ErrorMeter meter = measure(Method::taylor, {}, scene);
        fmt::print("n = {}: {:.2f} dB, largest error {:.1f}\n", shininess, meter.psnr(), meter.max_error());
        psnr = meter.psnr();
        EXPECT_GE(psnr, least) << "n = " << shininess;
    }
    MethodOptions printed;
    printed.as_printed = true;
    const ErrorMeter misprinted = measure(Method::taylor, printed, scene);
    fmt::print("as printed: {:.2f} dB, largest error {:.1f}\n", misprinted.psnr(), misprinted.max_error());
    EXPECT_LT(misprinted.psnr(), psnr - 3.0);
    EXPECT_GT(misprinted.max_error(), 100.0);
}

/// Every edge of the mesh that two drawn triangles share, sampled at 33 points: how far apart their colours are.
double greatest_jump(Method method, const Scene& scene) {
    struct Side {
        std::size_t triangle;
        int from, to;  ///< corners, in the order of the edge's key
    };
    const std::vector<ScreenTriangle> triangles = project(scene);
    std::map<std::array<std::int64_t, 4>, std::vector<Side>> edges;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int next = (k + 1) % 3;
            const SnappedPoint a = triangles[t].vertices[static_cast<std::size_t>(k)].point;
            const SnappedPoint b = triangles[t].vertices[static_cast<std::size_t>(next)].point;
            const bool ordered = std::tie(a.x, a.y) < std::tie(b.x, b.y);
            if (ordered) edges[{a.x, a.y, b.x, b.y}].push_back({t, k, next});
            if (!ordered) edges[{b.x, b.y, a.x, a.y}].push_back({t, next, k});
        }
    }
    double greatest = 0.0;
    for (const auto& [key, sides] : edges) {
        if (sides.size() != 2) continue;
        for (int step = 0; step <= 32; ++step) {
            std::array<glm::dvec3, 2> colours;
            for (std::size_t s = 0; s < 2; ++s) {
                glm::dvec3 weights(0.0);
                weights[sides[s].from] = 1.0 - step / 32.0;
                weights[sides[s].to] = step / 32.0;
                colours[s] = make_shader(method, {}, scene, triangles[sides[s].triangle])->colour(0, weights);
            }
            for (int c = 0; c < 3; ++c) greatest = std::max(greatest, std::abs(colours[0][c] - colours[1][c]));
        }
    }
    return greatest;
}

TEST(Taylor, NeighboursMeetOnlyRoughlyAlongTheirEdge) {
    double greatest = 0.0;
    for (const glm::dvec3& direction :
         {glm::dvec3(-0.4, 0.5, 0.77), {0.6, 0.3, 0.74}, {0.2, -0.55, 0.8}, {0.85, 0.45, 0.15}}) {
        Scene scene = measured_sphere();
        scene.lights = {Light()};
        scene.lights[0].vector = glm::normalize(direction);
        greatest = std::max(greatest, greatest_jump(Method::taylor, scene));
        EXPECT_LT(greatest_jump(Method::duff, scene), 1e-6);
    }
    fmt::print("greatest jump across a shared edge: {:.1f} steps\n", greatest);
    EXPECT_GT(greatest, 1.0);
    EXPECT_LT(greatest, 45.0);
}

TEST(Taylor, IsFiniteForAnyNormalsShapesAndPowers) {
    Rng rng(seed + 4);
    std::size_t pixels = 0;
    for (int run = 0; run < 3000; ++run) {
        Scene scene = small_scene();
        scene.material.shininess = run % 5 == 0 ? 1000.0 : between(rng, 0.0, 300.0);
        scene.lights = {directional_light(rng, -1.0), directional_light(rng, -1.0)};
        if (run % 7 == 0) scene.lights[0].vector = {0.0, 0.0, -1.0};
        const ScreenTriangle triangle = hostile_triangle(rng, scene);
        MethodOptions options;
        options.as_printed = run % 4 == 0;
        for_each_pixel(Method::taylor, options, scene, triangle, [&](int x, int y, const glm::dvec3& colour) {
            ASSERT_TRUE(is_finite(colour)) << x << ", " << y << ", run " << run << ", seed " << seed + 4;
            ++pixels;
        });
    }
    EXPECT_GT(pixels, 30000U);
}

TEST(Taylor, EqualNormalsShadeEvenlyAsPhong) {
    Rng rng(seed + 5);
    Scene scene = small_scene();
    scene.material.specular = 0.0;
    scene.lights = {directional_light(rng)};
    ScreenTriangle triangle = benign_triangle(rng, scene);
    for (ScreenVertex& vertex : triangle.vertices) vertex.normal = triangle.vertices[0].normal;
    const glm::dvec3 phong = make_shader(Method::phong, {}, scene, triangle)->colour(0, glm::dvec3(1.0 / 3.0));
    for_each_pixel(Method::taylor, {}, scene, triangle,
                   [&](int, int, const glm::dvec3& got) { EXPECT_LT(glm::length(got - phong), 1e-9); });
}

TEST(Taylor, WhatItCannotExpressIsSaid) {
    Scene scene = measured_sphere();
    scene.lights = {Light(), Light()};
    EXPECT_EQ(why_inexpressible(Method::taylor, scene), std::nullopt);
    scene.lights[1].kind = Light::Kind::positional;
    EXPECT_EQ(why_inexpressible(Method::taylor, scene).value_or(""),
              "taylor has its lights at infinity: light 2 is positional; give directions, or take taylor-finite");
    EXPECT_THROW((void)make_shader(Method::taylor, {}, scene, ScreenTriangle()), Error);
    scene.lights.pop_back();
    scene.field_of_view = 40.0;
    EXPECT_EQ(why_inexpressible(Method::taylor, scene).value_or(""),
              "taylor has its eye at infinity: give the orthographic camera, or take taylor-finite");
    scene.field_of_view.reset();
    scene.material.brdf = Brdf::cook_torrance;
    EXPECT_EQ(why_inexpressible(Method::taylor, scene).value_or(""),
              "taylor expresses Blinn's reflection model only: give every material the model blinn");
    scene.mesh.materials = {Material()};
    scene.mesh.triangle_materials.assign(scene.mesh.triangles.size(), 0);
    EXPECT_EQ(why_inexpressible(Method::taylor, scene), std::nullopt) << "no triangle has the scene's material";
    scene.mesh.materials[0].brdf = Brdf::phong;
    EXPECT_NE(why_inexpressible(Method::taylor, scene), std::nullopt);
}

TEST(TaylorLoop, ColoursAreTheShadersAndAPixelIsTwoAdditionsASeriesAndOneTableRead) {
    Rng rng(seed + 6);
    for (int run = 0; run < 60; ++run) {
        Scene scene = small_scene();
        for (std::int64_t k = uniform(rng, 0, 2); k > 0; --k) scene.lights.push_back(directional_light(rng, -0.5));
        scene.material.shininess = between(rng, 1.0, 100.0);
        MethodOptions options;
        options.as_printed = run % 3 == 0;
        expect_loop_equals_shader(Method::taylor, options, scene, benign_triangle(rng, scene),
                                  fmt::format("run {}, seed {}", run, seed + 6));
        if (HasFatalFailure()) return;
    }
    Scene scene = small_scene();
    scene.lights = {directional_light(rng)};
    // Three diffuse series and one of addresses, and the highlight added to three colours: 5 for a single colour.
    const OperationCounts both = cost_of_pixel(Method::taylor, scene, benign_triangle(rng, scene));
    EXPECT_EQ(both, (OperationCounts{3 * 2 + 2 + 3, 0, 0, 0, 0, both.comparisons, 1}));
    scene.material.specular = 0.0;
    const OperationCounts diffuse = cost_of_pixel(Method::taylor, scene, benign_triangle(rng, scene));
    EXPECT_EQ(diffuse, (OperationCounts{3 * 2, 0, 0, 0, 0, diffuse.comparisons, 0}));
}

}  // namespace
}  // namespace sheen::test
