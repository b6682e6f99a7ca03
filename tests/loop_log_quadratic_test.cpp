// SPDX-License-Identifier: MIT
// The loop of log-quadratic against its shader, and what it costs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "sheen/log_quadratic.hpp"
#include "sheen/loop.hpp"
#include "support/coverage_oracle.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 7701;

double real(Rng& rng, double low, double high) { return std::uniform_real_distribution<double>(low, high)(rng); }

Scene scene_with(std::vector<Light> lights) {
    Scene scene;
    scene.width = scene.height = 80;
    scene.lights = std::move(lights);
    return scene;
}

ScreenTriangle random_triangle(Rng& rng, const Scene& scene) {
    ScreenTriangle t;
    t.material = scene.material;
    auto& v = t.vertices;
    do {
        for (ScreenVertex& vertex : v) {
            vertex.point = {uniform(rng, -2000, 22000), uniform(rng, -2000, 22000)};
            vertex.position = {real(rng, -1, 1), real(rng, -1, 1), real(rng, -5, -3)};
            vertex.normal = glm::normalize(glm::dvec3(real(rng, -0.7, 0.7), real(rng, -0.7, 0.7), 1.0));
        }
        t.walks = walk_in_image(v[0].point, v[1].point, v[2].point, scene.width, scene.height);
    } while (t.walks.empty() || std::abs(doubled_area(v[0].point, v[1].point, v[2].point)) < 200 * 256 * 256);
    return t;
}

glm::dvec3 weights_at(const ScreenTriangle& t, int x, int y) {
    const SnappedPoint p = pixel_centre(x, y);
    const auto& v = t.vertices;
    return glm::dvec3(static_cast<double>(doubled_area(p, v[1].point, v[2].point)),
                      static_cast<double>(doubled_area(v[0].point, p, v[2].point)),
                      static_cast<double>(doubled_area(v[0].point, v[1].point, p))) /
           static_cast<double>(doubled_area(v[0].point, v[1].point, v[2].point));
}

Light random_light(Rng& rng) {
    Light light;
    light.vector = glm::normalize(glm::dvec3(real(rng, -1, 1), real(rng, -1, 1), real(rng, -0.5, 1)));
    if (uniform(rng, 0, 1) == 0) light.colour = {real(rng, 0, 1), uniform(rng, 0, 3) == 0 ? 0.0 : 0.5, 1.0};
    if (uniform(rng, 0, 2) == 0) {
        light.kind = Light::Kind::positional;
        light.vector *= 4.0;
    }
    return light;
}

/// Half a bin of 64, and half a unit of an 8-bit entry that is at least 128.
constexpr double table_error = 0.0055 + 0.5 / 128;

TEST(loop_log_quadratic, colours_are_the_shaders_but_for_the_table) {
    Rng rng(seed);
    double greatest = 0.0;
    std::size_t pixels = 0;
    for (int run = 0; run < 300; ++run) {
        Scene scene = scene_with({});
        for (std::int64_t i = uniform(rng, 0, 4); i > 0; --i) scene.lights.push_back(random_light(rng));
        if (run % 3 == 0) scene.field_of_view = 40.0;
        scene.material.shininess = std::pow(10.0, real(rng, 0, 2.5));
        scene.material.brdf = run % 2 == 0 ? Brdf::blinn : Brdf::phong;
        MethodOptions options;
        options.log_channels = static_cast<std::size_t>(uniform(rng, 0, 3));
        const ScreenTriangle t = random_triangle(rng, scene);
        const LogNodes nodes = shade_log_nodes(options, scene, t);
        LogNodes without = nodes;
        without.highlights.clear();
        const auto loop = make_loop<double>(Method::log_quadratic, options, scene, t);
        for (const PixelRow& row : triangle_rows(t)) {
            loop->start_row(row);
            for (int x = row.x; x < row.x + row.length; ++x) {
                const glm::dvec3 weights = weights_at(t, x, row.y);
                const glm::dvec3 got = loop->next();
                const glm::dvec3 expected = nodes.colour_at(weights);
                const glm::dvec3 highlights = expected - without.colour_at(weights);
                for (int c = 0; c < 3; ++c) {
                    const double error = std::abs(got[c] - expected[c]);
                    ASSERT_LE(error, table_error * highlights[c] + 1e-5) << "run " << run << ": " << x << ", " << row.y;
                    greatest = std::max(greatest, error);
                }
                ++pixels;
            }
        }
    }
    fmt::print("{} pixels, at most {:.2f} steps apart\n", pixels, greatest);
    EXPECT_GT(pixels, 100000U);
}

/// A pixel of one white light: two additions for each of red, green, blue and z, three for ambient, three for the
/// highlight; a comparison for each clamp; one read. No multiplication.
TEST(loop_log_quadratic, a_pixel_has_no_multiplication) {
    Rng rng(seed + 1);
    Light white;
    white.vector = glm::normalize(white.vector);
    Light red = white;
    red.colour = {1.0, 0.5, 0.25};
    const auto pixel_cost = [&](const std::vector<Light>& lights) {
        const Scene scene = scene_with(lights);
        const ScreenTriangle t = random_triangle(rng, scene);
        const auto loop = make_loop<Counted>(Method::log_quadratic, {}, scene, t);
        EXPECT_GT(loop->node_counts().powers, 0U);
        loop->start_row(triangle_rows(t).front());
        const CountingScope scope;
        (void)loop->next();
        return scope.counts();
    };
    EXPECT_EQ(pixel_cost({white}), (OperationCounts{8 + 3 + 3, 0, 0, 0, 0, 4, 1}));
    EXPECT_EQ(pixel_cost({red}), (OperationCounts{8 + 3 + 6, 0, 0, 0, 0, 6, 3}));
    EXPECT_EQ(pixel_cost({white, white}), (OperationCounts{10 + 3 + 6, 0, 0, 0, 0, 5, 2}));
}

}  // namespace
}  // namespace sheen::test
