// SPDX-License-Identifier: MIT
// taylor-finite (paper fast-phong, "Going Further"): its coefficients against automatic differentiation, the printed
// ones' errors, perspective and positional lights, its quality and its cost.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sheen/error.hpp"
#include "sheen/taylor.hpp"
#include "support/jet.hpp"
#include "support/shaded_triangles.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 19860804;

LinearVector<double> random_linear(Rng& rng) {
    const auto vector = [&rng](double size) {
        return glm::dvec3(between(rng, -size, size), between(rng, -size, size), between(rng, -size, size));
    };
    return {vector(0.7), vector(0.7), random_direction(rng, -1.0) * between(rng, 0.5, 1.5)};
}

JetVector jet_of(const LinearVector<double>& v) {
    return {linear_jet(v.x.x, v.y.x, v.constant.x), linear_jet(v.x.y, v.y.y, v.constant.y),
            linear_jet(v.x.z, v.y.z, v.constant.z)};
}

TEST(TaylorFinite, CoefficientsAreThoseOfAutomaticDifferentiation) {
    Rng rng(seed);
    for (int run = 0; run < 5000; ++run) {
        const LinearVector<double> normal = random_linear(rng);
        const LinearVector<double> half = random_linear(rng);
        const TaylorSeries<double> got = taylor_series(
            dot_product(normal, half), inverse_length(squared_length(normal)), inverse_length(squared_length(half)));
        const std::array<double, 6> expected = cosine(jet_of(normal), jet_of(half)).series();
        for (std::size_t t = 0; t < got.size(); ++t) {
            ASSERT_NEAR(got[t], expected[t], 1e-10 * (1.0 + std::abs(expected[t])))
                << "T" << t << ", run " << run << ", seed " << seed;
        }
    }
}

TEST(TaylorFinite, AConstantVectorGivesTheSeriesOfTheInfiniteEye) {
    Rng rng(seed + 1);
    for (int run = 0; run < 500; ++run) {
        const LinearVector<double> normal = random_linear(rng);
        const LinearVector<double> constant{glm::dvec3(0.0), glm::dvec3(0.0), random_direction(rng, -1.0)};
        const InverseLength<double> length = inverse_length(squared_length(normal));
        const TaylorSeries<double> finite =
            taylor_series(dot_product(normal, constant), length, inverse_length(squared_length(constant)));
        const TaylorSeries<double> infinite = taylor_series(dot_product(normal, constant.constant), length);
        for (std::size_t t = 0; t < 6; ++t) ASSERT_NEAR(finite[t], infinite[t], 1e-10 * (1.0 + std::abs(infinite[t])));
    }
}

/// How far the printed coefficients are off, relative to 1 + |T|.
std::array<double, 6> printed_errors(const LinearVector<double>& normal, const LinearVector<double>& half) {
    const TaylorSeries<double> printed = printed_taylor_series(normal, half);
    const std::array<double, 6> exact = cosine(jet_of(normal), jet_of(half)).series();
    std::array<double, 6> errors{};
    for (std::size_t t = 0; t < 6; ++t) errors[t] = std::abs(printed[t] - exact[t]) / (1.0 + std::abs(exact[t]));
    return errors;
}

/// Errata: m, n, o in another order spoil T3, T4 and T5; T4 has two misprints more. T0, T1, T2 are right.
TEST(TaylorFiniteErrata, PrintedSecondOrderIsWrongAndTheFirstRight) {
    Rng rng(seed + 2);
    std::array<double, 6> worst{};
    double worst_of_fjlqr = 0.0;
    double worst_of_ffnr = 0.0;
    for (int run = 0; run < 1000; ++run) {
        LinearVector<double> normal = random_linear(rng);
        const LinearVector<double> half = random_linear(rng);
        const std::array<double, 6> errors = printed_errors(normal, half);
        for (std::size_t t = 0; t < 6; ++t) worst[t] = std::max(worst[t], errors[t]);

        // D = 0: n is 0 in either order, and of T4's misprints fjlqr alone is left.
        worst_of_fjlqr = std::max(worst_of_fjlqr, printed_errors(normal, {glm::dvec3(0.0), half.y, half.constant})[4]);

        // E at 60 degrees to D and as long: D·D = 2D·E = E·E hides the order. A at right angles to C: j = 0.
        const glm::dvec3 across = glm::normalize(glm::cross(half.x, half.y));
        const glm::dvec3 y = 0.5 * half.x + std::sqrt(0.75) * glm::length(half.x) * across;
        normal.x = glm::cross(normal.x, normal.constant);
        const std::array<double, 6> ordered = printed_errors(normal, {half.x, y, half.constant});
        ASSERT_LT(ordered[3] + ordered[5], 1e-9) << "run " << run << ", seed " << seed + 2;
        worst_of_ffnr = std::max(worst_of_ffnr, ordered[4]);
    }
    for (std::size_t t = 0; t < 3; ++t) EXPECT_LT(worst[t], 1e-10) << "T" << t;
    for (std::size_t t = 3; t < 6; ++t) EXPECT_GT(worst[t], 0.1) << "T" << t;
    EXPECT_GT(worst_of_fjlqr, 0.1) << "-fjlqr";
    EXPECT_GT(worst_of_ffnr, 0.1) << "-2f²nr";
    fmt::print("printed T3, T4, T5: up to {:.2f}, {:.2f}, {:.2f} off, relative\n", worst[3], worst[4], worst[5]);
}

TEST(TaylorFinite, IsTaylorWhereEyeAndLightsAreAtInfinity) {
    Rng rng(seed + 3);
    for (int run = 0; run < 100; ++run) {
        Scene scene = small_scene();
        scene.lights = {directional_light(rng, -0.5), directional_light(rng)};
        MethodOptions options;
        options.as_printed = run % 4 == 0;
        const ScreenTriangle triangle = hostile_triangle(rng, scene);
        const auto taylor = make_shader(Method::taylor, options, scene, triangle);
        for_each_pixel(Method::taylor_finite, options, scene, triangle, [&](int x, int y, const glm::dvec3& got) {
            ASSERT_EQ(got, taylor->colour(x, weights_at(triangle, x, y))) << "run " << run << ", seed " << seed + 3;
        });
    }
}

/// At its centre the series is exact; H is interpolated between the vertices, so the diffuse part shows it.
TEST(TaylorFinite, DiffuseAtTheCentreIsPhongsInPerspectiveAndUnderPositionalLights) {
    Rng rng(seed + 4);
    for (int run = 0; run < 500; ++run) {
        Scene scene = small_scene();
        if (run % 2 == 0) scene.field_of_view = 50.0;
        scene.lights = {directional_light(rng), positional_light(rng)};
        scene.material.specular = 0.0;
        const ScreenTriangle triangle = benign_triangle(rng, scene);
        const glm::dvec3 centre(1.0 / 3.0);
        const glm::dvec3 got = make_shader(Method::taylor_finite, {}, scene, triangle)->colour(0, centre);
        const glm::dvec3 phong = make_shader(Method::phong, {}, scene, triangle)->colour(0, centre);
        ASSERT_LT(glm::length(got - phong), 1e-9) << "run " << run << ", seed " << seed + 4;
    }
}

Scene finite_sphere(const std::string& mesh) {
    Scene scene = measured_sphere(mesh);
    scene.width = scene.height = 256;
    scene.field_of_view = 40.0;
    scene.material.shininess = 20.0;
    Light light;
    light.kind = Light::Kind::positional;
    // In eye space the sphere, of radius 1, is before the camera: a light off its upper left.
    light.vector = {-2.0, 2.0, 0.0};
    scene.lights = {light};
    return scene;
}

double psnr_of(const Scene& scene, const MethodOptions& options) {
    const auto triangles = project(scene);
    const ReferenceImage phong = render_reference(Method::phong, scene, triangles);
    ErrorMeter meter;
    meter.add(phong.colour, render_reference(Method::taylor_finite, scene, triangles, options).colour, phong.covered);
    return meter.psnr();
}

TEST(TaylorFinite, DrawsPerspectiveAndPositionalLightsAndMoreTrianglesMakeItBetter) {
    MethodOptions large_table;
    large_table.taylor_table_bytes = 8192;
    MethodOptions printed = large_table;
    printed.as_printed = true;
    const double coarse = psnr_of(finite_sphere("builtin:sphere-168"), large_table);
    const double fine = psnr_of(finite_sphere("builtin:sphere-690"), large_table);
    const double misprinted = psnr_of(finite_sphere("builtin:sphere-168"), printed);
    fmt::print("168 triangles {:.1f} dB, 690 {:.1f} dB; 168 as printed {:.1f} dB\n", coarse, fine, misprinted);
    EXPECT_GT(coarse, 50.0);
    EXPECT_GT(fine, coarse + 3.0);
    EXPECT_LT(misprinted, coarse - 5.0);
}

TEST(TaylorFinite, HasTaylorsMeasuredQualityOnTheSphere) {
    const ErrorMeter meter = measure(Method::taylor_finite, {}, measured_sphere());
    EXPECT_GE(meter.psnr(), 53.0);
}

TEST(TaylorFinite, IsFiniteForAnyNormalsShapesLightsAndPowers) {
    Rng rng(seed + 5);
    std::size_t pixels = 0;
    for (int run = 0; run < 3000; ++run) {
        Scene scene = small_scene();
        scene.material.shininess = run % 5 == 0 ? 1000.0 : between(rng, 0.0, 300.0);
        if (run % 2 == 0) scene.field_of_view = 60.0;
        const ScreenTriangle triangle = hostile_triangle(rng, scene);
        const auto& v = triangle.vertices;
        scene.lights = {directional_light(rng, -1.0), positional_light(rng), positional_light(rng)};
        if (run % 3 == 0) scene.lights[1].vector = v[0].position;
        if (run % 3 == 1) scene.lights[1].vector = (v[0].position + v[1].position + v[2].position) / 3.0;
        if (run % 3 == 2) scene.lights[0].vector = {0.0, 0.0, -1.0};
        MethodOptions options;
        options.as_printed = run % 4 == 1;
        for_each_pixel(Method::taylor_finite, options, scene, triangle, [&](int x, int y, const glm::dvec3& colour) {
            ASSERT_TRUE(is_finite(colour)) << x << ", " << y << ", run " << run << ", seed " << seed + 5;
            ++pixels;
        });
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(pixels, 30000U);
}

TEST(TaylorFinite, ExpressesAnyLightAndCameraButBlinnsModelOnly) {
    Rng rng(seed + 6);
    Scene scene = measured_sphere();
    scene.field_of_view = 30.0;
    scene.lights = {directional_light(rng), positional_light(rng)};
    EXPECT_EQ(why_inexpressible(Method::taylor_finite, scene), std::nullopt);
    scene.material.brdf = Brdf::phong;
    EXPECT_EQ(why_inexpressible(Method::taylor_finite, scene).value_or(""),
              "taylor-finite expresses Blinn's reflection model only: give every material the model blinn");
    EXPECT_THROW((void)make_shader(Method::taylor_finite, {}, scene, ScreenTriangle()), Error);
}

TEST(TaylorFiniteLoop, ColoursAreTheShadersAndAPixelCostsWhatTaylorsDoes) {
    Rng rng(seed + 7);
    for (int run = 0; run < 80; ++run) {
        Scene scene = small_scene();
        if (run % 2 == 0) scene.field_of_view = 50.0;
        scene.lights = {directional_light(rng), positional_light(rng)};
        MethodOptions options;
        options.as_printed = run % 5 == 0;
        expect_loop_equals_shader(Method::taylor_finite, options, scene, benign_triangle(rng, scene),
                                  fmt::format("run {}, seed {}", run, seed + 7));
        if (HasFatalFailure()) return;
    }
    Scene scene = small_scene();
    scene.field_of_view = 50.0;
    scene.lights = {positional_light(rng)};
    const OperationCounts pixel = cost_of_pixel(Method::taylor_finite, scene, benign_triangle(rng, scene));
    EXPECT_EQ(pixel, (OperationCounts{3 * 2 + 2 + 3, 0, 0, 0, 0, pixel.comparisons, 1}));
}

}  // namespace
}  // namespace sheen::test
