// SPDX-License-Identifier: MIT
// Method recurrence: its steps against the cosine, its shader against explicit rotations, errata and quality.
#include "sheen/recurrence.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>

#include "sheen/error.hpp"
#include "support/spherical_cases.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 20031120;
const glm::dvec3 camera(0.0, 0.0, 1.0);

MethodOptions four_pixels() {
    MethodOptions options;
    options.recurrence_pixels = 4;
    return options;
}

/// Paper `recurrence`, eq. 7 and 9, and 10 and 11 corrected: U_k(cos φ)·f(t) − U_{k−1}(cos φ)·f(t − 1).
TEST(Recurrence, StepsAreTheCosineOneToFourPixelsAhead) {
    Rng rng(seed);
    for (int run = 0; run < 20000; ++run) {
        const double phi = real(rng, 0.0, 3.1415);
        const double alpha = real(rng, -3.0, 3.0);
        const RecurrenceStep<double> step(std::cos(phi), true, false);
        for (int k = 1; k <= 4; ++k) {
            ASSERT_NEAR(step.ahead(k, std::cos(alpha), std::cos(alpha - phi)), std::cos(alpha + k * phi), 1e-12)
                << "k = " << k << ", φ = " << phi << ", seed " << seed;
        }
    }
}

/// Errata: eq. 10 and 11 as printed are off, the third and the fourth pixel ahead.
TEST(Recurrence, EquationsTenAndElevenAsPrintedMissTheCosine) {
    Rng rng(seed + 1);
    std::array<double, 4> worst{};
    for (int run = 0; run < 2000; ++run) {
        const double phi = real(rng, 0.0, 0.1);
        const double alpha = real(rng, -1.0, 1.0);
        const double c = std::cos(phi);
        const double c2 = std::cos(2.0 * phi);
        const double now = std::cos(alpha);
        const double before = std::cos(alpha - phi);
        const RecurrenceStep<double> step(c, true, true);
        ASSERT_NEAR(step.ahead(3, now, before), c2 * (4.0 * now * c - before) - 3.0 * before, 1e-12) << "eq. 10";
        ASSERT_NEAR(step.ahead(4, now, before), 2.0 * now * c2 * (2.0 * c2 + 3.0) - 2.0 * before * c * (c2 + 4.0) + now,
                    1e-12)
            << "eq. 11";
        for (int k = 1; k <= 4; ++k) {
            double& largest = worst.at(static_cast<std::size_t>(k - 1));
            largest = std::max(largest, std::abs(step.ahead(k, now, before) - std::cos(alpha + k * phi)));
        }
    }
    EXPECT_LT(worst[0], 1e-12);
    EXPECT_LT(worst[1], 1e-12);
    EXPECT_GT(worst[2], 0.05) << "eq. 10";
    EXPECT_GT(worst[3], 0.05) << "eq. 11";
}

/// Every reflection model, one and four pixels a step, against the model of the rotated normal.
TEST(Recurrence, ShaderIsTheReflectionModelOfTheRotatedNormal) {
    Rng rng(seed + 2);
    std::size_t compared = 0;
    double worst = 0.0;
    for (int run = 0; run < 400; ++run) {
        Scene scene;
        scene.width = scene.height = 60;
        scene.material.shininess = real(rng, 1.0, 80.0);
        scene.material.brdf =
            std::array<Brdf, 3>{Brdf::blinn, Brdf::phong, Brdf::cook_torrance}.at(static_cast<std::size_t>(run % 3));
        for (int i = 0; i < run % 4; ++i) {
            Light light;
            light.vector = glm::normalize(random_unit(rng) + camera);
            light.colour = {real(rng, 0.0, 1.0), real(rng, 0.0, 1.0), 1.0};
            scene.lights.push_back(light);
        }
        const ScreenTriangle triangle = normal_triangle(rng, scene, plump_triangle(rng));
        const MethodOptions options = run % 2 == 0 ? MethodOptions{} : four_pixels();
        shade_pixels(Method::recurrence, options, scene, triangle, [&](int x, int y, const glm::dvec3& colour) {
            const SurfacePoint point{glm::dvec3(0.0), spherical_normal(triangle, x, y), camera};
            const double error = glm::length(colour - shade(scene.material, scene.lights, point));
            ASSERT_LT(error, 1e-6) << "run " << run << ", pixel " << x << ", " << y << ", seed " << seed;
            worst = std::max(worst, error);
            ++compared;
        });
        if (HasFatalFailure()) return;
    }
    std::cout << fmt::format("largest difference {:.1e} steps over {} pixels\n", worst, compared);
    EXPECT_GT(compared, 50000U);
}

/// Rounding grows with the square of the span: 4095 pixels, nearly equal normals.
TEST(Recurrence, LongSpansDontDrift) {
    Rng rng(seed + 3);
    Scene scene;
    scene.width = 4095;
    scene.height = 2;
    scene.lights = measured_lights()[0];
    for (int run = 0; run < 20; ++run) {
        const ScreenTriangle triangle = normal_triangle(
            rng, scene, {SnappedPoint{0, 0}, SnappedPoint{4095 * 256, 0}, SnappedPoint{2000 * 256, 60000}});
        for (const MethodOptions& options : {MethodOptions{}, four_pixels()}) {
            shade_pixels(Method::recurrence, options, scene, triangle, [&](int x, int y, const glm::dvec3& colour) {
                const SurfacePoint point{glm::dvec3(0.0), spherical_normal(triangle, x, y), camera};
                ASSERT_LT(glm::length(colour - shade(scene.material, scene.lights, point)), 1e-4) << x << ", " << y;
            });
            if (HasFatalFailure()) return;
        }
    }
}

TEST(Recurrence, ColoursAreFiniteOnSliversAndForOppositeAndEqualNormals) {
    Rng rng(seed + 4);
    for (int run = 0; run < 3000; ++run) {
        Scene scene;
        scene.width = scene.height = 40;
        scene.material.shininess = run % 7 == 0 ? 0.0 : std::exp(real(rng, 0.0, std::log(1000.0)));
        scene.lights.resize(1);
        scene.lights[0].vector = run % 11 == 0 ? -camera : random_unit(rng);
        ScreenTriangle triangle = normal_triangle(rng, scene, random_triangle(rng, 40));
        if (run % 4 == 0) triangle.vertices[1].normal = -triangle.vertices[0].normal;
        if (run % 6 == 0) triangle.vertices[2].normal = triangle.vertices[0].normal;
        if (triangle.walks.empty()) continue;
        MethodOptions options = run % 2 == 0 ? MethodOptions{} : four_pixels();
        options.recurrence_integer_index = run % 5 == 0;
        shade_pixels(Method::recurrence, options, scene, triangle, [&](int x, int y, const glm::dvec3& colour) {
            const glm::dvec3 most = 255.0 * (scene.material.ambient + scene.material.diffuse + scene.material.specular);
            for (int c = 0; c < 3; ++c) {
                ASSERT_GE(colour[c], 255.0 * scene.material.ambient[c] - 1e-9) << "run " << run << ", seed " << seed;
                ASSERT_LE(colour[c], most[c] + 1e-6) << "run " << run << ", pixel " << x << ", " << y;
            }
        });
        if (HasFatalFailure()) return;
    }
}

/// A row that begins at the image's border has the colours of the whole row, by angles and by the paper's index.
TEST(Recurrence, ABorderChangesNoColour) {
    Rng rng(seed + 5);
    Scene whole;
    whole.lights = measured_lights()[0];
    whole.width = whole.height = 60;
    std::size_t compared = 0;
    for (int run = 0; run < 300; ++run) {
        const Triangle points = run % 2 == 0 ? random_triangle(rng, 60) : plump_triangle(rng);
        const ScreenTriangle triangle = normal_triangle(rng, whole, points);
        MethodOptions options = run % 2 == 0 ? MethodOptions{} : four_pixels();
        options.recurrence_integer_index = run % 4 < 2;
        const ReferenceImage expected = render_reference(Method::recurrence, whole, {triangle}, options);
        ScreenTriangle moved = triangle;
        for (ScreenVertex& vertex : moved.vertices) vertex.point.x -= 256 * 23;
        const auto& v = moved.vertices;
        moved.walks = walk_in_image(v[0].point, v[1].point, v[2].point, whole.width, whole.height);
        shade_pixels(Method::recurrence, options, whole, moved, [&](int x, int y, const glm::dvec3& colour) {
            const auto pixel = static_cast<std::size_t>(y * whole.width + x + 23);
            ASSERT_LT(glm::length(expected.colour[pixel] - glm::min(colour, glm::dvec3(255.0))), 1e-7)
                << x << ", " << y;
            ++compared;
        });
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(compared, 10000U);
}

TEST(Recurrence, QualityOnTheSphereOf168TrianglesAndThePriceOfThePapersIndex) {
    const Scene scene = measured_sphere(50.0);
    const ErrorMeter centres = measured_error(Method::recurrence, {}, scene);
    const ErrorMeter four = measured_error(Method::recurrence, four_pixels(), scene);
    MethodOptions integer;
    integer.recurrence_integer_index = true;
    const ErrorMeter index = measured_error(Method::recurrence, integer, scene);
    std::cout << fmt::format("recurrence, n = 50: {:.2f} dB, max {:.2f}; by integer index {:.2f} dB, max {:.2f}\n",
                             centres.psnr(), centres.max_error(), index.psnr(), index.max_error());
    EXPECT_GE(centres.psnr(), 60.0);
    EXPECT_LE(centres.max_error(), 2.0);
    EXPECT_NEAR(four.psnr(), centres.psnr(), 1e-6) << "four pixels a step are the same colours";
    EXPECT_LE(index.psnr(), 58.0);
    EXPECT_GE(index.max_error(), 30.0);
}

TEST(Recurrence, RefusesNearLightsTheNearEyeAndOtherPixelCounts) {
    Scene scene = measured_sphere(50.0);
    scene.lights = measured_lights()[0];
    for (const Brdf brdf : {Brdf::blinn, Brdf::phong, Brdf::cook_torrance}) {
        scene.material.brdf = brdf;
        EXPECT_EQ(why_inexpressible(Method::recurrence, scene), std::nullopt);
    }
    const std::vector<ScreenTriangle> triangles = project(scene);
    for (const int pixels : {0, 2, 3, 5, -1}) {
        MethodOptions options;
        options.recurrence_pixels = pixels;
        EXPECT_THROW(render_reference(Method::recurrence, scene, triangles, options), UsageError) << pixels;
    }
    Scene perspective = scene;
    perspective.field_of_view = 40.0;
    ASSERT_TRUE(why_inexpressible(Method::recurrence, perspective));
    EXPECT_NE(why_inexpressible(Method::recurrence, perspective)->find("perspective"), std::string::npos);
    scene.lights[0].kind = Light::Kind::positional;
    ASSERT_TRUE(why_inexpressible(Method::recurrence, scene));
    EXPECT_NE(why_inexpressible(Method::recurrence, scene)->find("positional"), std::string::npos);
    EXPECT_THROW(render_reference(Method::recurrence, scene, triangles), Error);
}

}  // namespace
}  // namespace sheen::test
