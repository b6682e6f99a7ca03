// SPDX-License-Identifier: MIT
// The loops of spherical and recurrence: the shaders' colours by stepped angles and recurrences, and what they cost.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>

#include "sheen/loop.hpp"
#include "support/spherical_cases.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 19890907;

Scene lit_scene() {
    Scene scene;
    scene.width = scene.height = 60;
    scene.lights = measured_lights()[0];
    return scene;
}

MethodOptions options_of(Method method, int run) {
    MethodOptions options;
    options.recurrence_pixels = method == Method::recurrence && run % 2 == 1 ? 4 : 1;
    options.recurrence_integer_index = run % 5 == 0;
    options.spherical_base = run % 3 == 0 ? 9.5 : 2.0;
    options.spherical_separate = run % 4 == 3;
    options.as_printed = method == Method::spherical && run % 7 == 0;
    return options;
}

TEST(SphericalLoops, ColoursAreTheShaders) {
    Rng rng(seed);
    std::size_t compared = 0;
    double greatest = 0.0;
    for (const Method method : {Method::spherical, Method::recurrence}) {
        for (int run = 0; run < 200; ++run) {
            Scene scene = lit_scene();
            scene.material.brdf = run % 3 == 1 ? Brdf::phong : Brdf::blinn;
            scene.lights.push_back({random_unit(rng), {0.5, 0.3, 0.2}, Light::Kind::directional});
            if (method == Method::spherical && run % 2 == 1) {
                scene.lights.push_back({{0.0, 0.5, -2.0}, {0.2, 0.2, 0.2}, Light::Kind::positional});
                if (run % 6 == 1) scene.field_of_view = 40.0;
            }
            const MethodOptions options = options_of(method, run);
            const ScreenTriangle triangle = normal_triangle(rng, scene, plump_triangle(rng));
            const auto shader = make_shader(method, options, scene, triangle);
            const auto loop = make_loop<double>(method, options, scene, triangle);
            for (const PixelRow& row : triangle_rows(triangle)) {
                shader->start_row(row);
                loop->start_row(row);
                for (int i = 0; i < row.length; ++i) {
                    const double difference = glm::length(loop->next() - shader->colour(row.x + i, {}));
                    ASSERT_LT(difference, 1e-6) << to_string(method) << ", run " << run << ", pixel " << row.x + i
                                                << ", " << row.y << ", seed " << seed;
                    greatest = std::max(greatest, difference);
                    ++compared;
                }
            }
        }
    }
    std::cout << fmt::format("largest difference {:.1e} steps over {} pixels\n", greatest, compared);
    EXPECT_GT(compared, 100000U);
}

struct Cost {
    OperationCounts span, pixel;
};

/// Of the first span of a triangle, and of one of its pixels.
Cost cost_of(Method method, const MethodOptions& options, int pixels) {
    Rng rng(seed + 1);
    const Scene scene = lit_scene();
    const ScreenTriangle triangle = normal_triangle(rng, scene, {SnappedPoint{0, 0}, {15000, 0}, {7000, 15000}});
    const auto loop = make_loop<Counted>(method, options, scene, triangle);
    Cost cost;
    {
        const CountingScope scope;
        loop->start_row(triangle_rows(triangle).front());
        cost.span = scope.counts();
    }
    const CountingScope scope;
    for (int i = 0; i < pixels; ++i) (void)loop->next();
    cost.pixel = scope.counts();
    return cost;
}

/// One white far light: two angles stepped, two tables read, three products of the diffuse colour and one of the
/// highlight (figure 12), and their sums.
TEST(SphericalLoops, APixelOfSphericalIsTwoTableReadsAndFourProducts) {
    const OperationCounts pixel = cost_of(Method::spherical, {}, 1).pixel;
    EXPECT_EQ(pixel.table_reads, 2U);
    EXPECT_EQ(pixel.multiplications, 4U);
    EXPECT_EQ(pixel.additions, 2U + 6U);
    EXPECT_EQ(pixel.divisions + pixel.roots + pixel.powers + pixel.comparisons, 0U);
}

/// Eq. 14: one multiplication and one subtraction a dot product; the rest is the reflection model.
TEST(SphericalLoops, ADotProductOfTheRecurrenceIsOneMultiplicationAndOneSubtraction) {
    const OperationCounts one = cost_of(Method::recurrence, {}, 1).pixel;
    MethodOptions options;
    options.recurrence_pixels = 4;
    const OperationCounts four = cost_of(Method::recurrence, options, 4).pixel;
    const std::uint64_t model_multiplications = 6;  // three components of two terms
    const std::uint64_t model_additions = 6;
    EXPECT_EQ(one.multiplications, 2U + model_multiplications);
    EXPECT_EQ(one.additions, 2U + model_additions);
    EXPECT_EQ(one.powers, 1U);
    EXPECT_EQ(one.divisions + one.roots, 0U);
    EXPECT_EQ(four.multiplications, 2U * (1U + 3U * 2U) + 4U * model_multiplications);
    EXPECT_EQ(four.additions, 2U * 4U + 4U * model_additions);
}

TEST(SphericalLoops, ASpanStartsWithDivisionsRootsAndAngles) {
    for (const Method method : {Method::spherical, Method::recurrence}) {
        const OperationCounts span = cost_of(method, {}, 0).span;
        std::cout << fmt::format("{} a span: {} additions, {} multiplications, {} divisions, {} roots, {} powers\n",
                                 to_string(method), span.additions, span.multiplications, span.divisions, span.roots,
                                 span.powers);
        EXPECT_GE(span.divisions, 1U);
        EXPECT_GE(span.roots, 1U);
        EXPECT_GE(span.powers, 5U);
    }
}

}  // namespace
}  // namespace sheen::test
