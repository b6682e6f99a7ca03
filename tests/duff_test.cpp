// SPDX-License-Identifier: MIT
// duff (Duff's formulation in paper fast-phong): Phong to rounding, its misprint, and its cost.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sheen/error.hpp"
#include "support/shaded_triangles.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 19790801;

Scene lit_scene(Rng& rng) {
    Scene scene = small_scene();
    for (std::int64_t k = uniform(rng, 0, 3); k > 0; --k) scene.lights.push_back(directional_light(rng, -0.5));
    scene.material.shininess = between(rng, 0.0, 200.0);
    return scene;
}

TEST(Duff, IsPhongToRounding) {
    Rng rng(seed);
    std::size_t compared = 0;
    double greatest = 0.0;
    for (int run = 0; run < 200; ++run) {
        const Scene scene = lit_scene(rng);
        const ScreenTriangle triangle = benign_triangle(rng, scene);
        const auto phong = make_shader(Method::phong, {}, scene, triangle);
        for_each_pixel(Method::duff, {}, scene, triangle, [&](int x, int y, const glm::dvec3& got) {
            greatest = std::max(greatest, glm::length(got - phong->colour(x, weights_at(triangle, x, y))));
            ASSERT_LT(greatest, 1e-9) << "pixel " << x << ", " << y << ", run " << run << ", seed " << seed;
            ++compared;
        });
    }
    fmt::print("{} pixels, at most {:.1e} steps apart\n", compared, greatest);
    EXPECT_GT(compared, 30000U);
}

TEST(Duff, IsPhongOnTheSphere) { EXPECT_GT(measure(Method::duff, {}, measured_sphere()).psnr(), 200.0); }

/// Erratum: with an L in the denominator the cosine is 1 wherever the light is before the surface.
TEST(DuffErrata, ThePrintedDenominatorShadesNothing) {
    Rng rng(seed + 1);
    MethodOptions printed;
    printed.as_printed = true;
    Scene scene = small_scene();
    scene.lights = {directional_light(rng, 0.8)};
    const glm::dvec3 flooded =
        255.0 * (scene.material.ambient + scene.lights[0].colour * (scene.material.diffuse + scene.material.specular));
    double closest = 1e9;
    for (int run = 0; run < 50; ++run) {
        const ScreenTriangle triangle = benign_triangle(rng, scene);
        const auto phong = make_shader(Method::phong, {}, scene, triangle);
        double difference = 0.0;
        for_each_pixel(Method::duff, printed, scene, triangle, [&](int x, int y, const glm::dvec3& got) {
            ASSERT_LT(glm::length(got - flooded), 1e-9);
            difference = std::max(difference, glm::length(got - phong->colour(x, weights_at(triangle, x, y))));
        });
        closest = std::min(closest, difference);
    }
    EXPECT_GT(closest, 1.0) << "8-bit steps off Phong";
}

TEST(Duff, IsFiniteAndWithinThePicturesRangeForAnyNormalsShapesAndPowers) {
    Rng rng(seed + 2);
    std::size_t pixels = 0;
    for (int run = 0; run < 3000; ++run) {
        Scene scene = lit_scene(rng);
        if (run % 5 == 0) scene.material.shininess = 1000.0;
        const double most = 255.0 * (1.0 + 2.0 * static_cast<double>(scene.lights.size()));
        MethodOptions options;
        options.as_printed = run % 4 == 0;
        for_each_pixel(Method::duff, options, scene, hostile_triangle(rng, scene),
                       [&](int x, int y, const glm::dvec3& colour) {
                           ASSERT_TRUE(is_finite(colour)) << x << ", " << y << ", run " << run << ", seed " << seed + 2;
                           ASSERT_LE(std::max({colour.x, colour.y, colour.z}), most);
                           ++pixels;
                       });
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(pixels, 30000U);
}

TEST(Duff, WhatItCannotExpressIsSaid) {
    Rng rng(seed + 3);
    Scene scene = measured_sphere();
    scene.lights = {positional_light(rng)};
    EXPECT_EQ(why_inexpressible(Method::duff, scene).value_or(""),
              "duff has its lights at infinity: light 1 is positional; give directions, or take taylor-finite");
    EXPECT_THROW((void)make_shader(Method::duff, {}, scene, ScreenTriangle()), Error);
    scene.lights = {directional_light(rng)};
    EXPECT_EQ(why_inexpressible(Method::duff, scene), std::nullopt);
    scene.field_of_view = 40.0;
    EXPECT_NE(why_inexpressible(Method::duff, scene), std::nullopt);
}

TEST(DuffLoop, ColoursAreTheShadersAndAPixelIsADivisionARootAndAPower) {
    Rng rng(seed + 4);
    for (int run = 0; run < 80; ++run) {
        const Scene scene = lit_scene(rng);
        MethodOptions options;
        options.as_printed = run % 5 == 0;
        expect_loop_equals_shader(Method::duff, options, scene, benign_triangle(rng, scene),
                                  fmt::format("run {}, seed {}", run, seed + 4));
        if (HasFatalFailure()) return;
    }
    Scene scene = small_scene();
    scene.lights = {directional_light(rng)};
    const ScreenTriangle triangle = benign_triangle(rng, scene);
    // Squared length 2 +, N·L and N·H 1 + each, and two colours summed 6 +; two cosines 2 ×, two colours 6 ×.
    const OperationCounts both = cost_of_pixel(Method::duff, scene, triangle);
    EXPECT_EQ(both, (OperationCounts{2 + 2 + 6, 2 + 6, 1, 1, 1, 2, 0}));
    ScreenTriangle matt = triangle;
    matt.material.specular = 0.0;
    const OperationCounts diffuse = cost_of_pixel(Method::duff, scene, matt);
    EXPECT_EQ(diffuse, (OperationCounts{3 + 3, 1 + 3, 1, 1, 0, 1, 0})) << "the paper's three additions, and the colour";
}

}  // namespace
}  // namespace sheen::test
