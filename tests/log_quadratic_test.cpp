// SPDX-License-Identifier: MIT
// log-quadratic: its formulas, its nodes for any lights and materials, and the quality that it is there for.
#include "sheen/log_quadratic.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sheen/shader.hpp"
#include "sheen/surface.hpp"
#include "support/quality.hpp"
#include "support/random_triangles.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 7501;
const double pi = std::acos(-1.0);

double real(Rng& rng, double low, double high) { return std::uniform_real_distribution<double>(low, high)(rng); }

glm::dvec3 random_unit(Rng& rng) {
    glm::dvec3 v(0.0);
    do {
        v = {real(rng, -1, 1), real(rng, -1, 1), real(rng, -1, 1)};
    } while (glm::length(v) < 0.1);
    return glm::normalize(v);
}

Light towards(double x, double y, double z, const glm::dvec3& colour = glm::dvec3(1.0)) {
    return {glm::normalize(glm::dvec3(x, y, z)), colour};
}

ScreenTriangle random_screen_triangle(Rng& rng, const Scene& scene) {
    ScreenTriangle triangle;
    triangle.material = scene.material;
    for (ScreenVertex& vertex : triangle.vertices) {
        vertex.position = {real(rng, -1, 1), real(rng, -1, 1), real(rng, -5, -3)};
        vertex.normal = random_unit(rng);
    }
    triangle.face_normal = random_unit(rng);
    return triangle;
}

glm::dvec3 random_weights(Rng& rng) {
    const double a = real(rng, 0, 1);
    const double b = real(rng, 0, 1 - a);
    return {a, b, 1 - a - b};
}

TEST(log_bell, is_the_logarithm_of_the_cosine_power_up_to_its_tangent) {
    for (const double n : {1.0, 5.0, 20.0, 50.0, 200.0, 1000.0}) {
        const double start = std::min(std::acos(std::exp2(-7.0 / n)), 72.0 * pi / 180.0);
        for (double angle = 0.0; angle <= start; angle += start / 64) {
            ASSERT_NEAR(std::exp2(-log_bell(angle, n)), std::pow(std::cos(angle), n), 1e-12) << n << " at " << angle;
        }
        // Beyond: the same value and the same slope in θ² on both sides, and straight in θ².
        const double step = 1e-5 * start * start;
        const auto bell = [n](double squared) { return log_bell(std::sqrt(squared), n); };
        const double at = start * start;
        const double before = (bell(at) - bell(at - step)) / step;
        const double behind = (bell(at + step) - bell(at)) / step;
        EXPECT_NEAR(before / behind, 1.0, 1e-3) << n;
        EXPECT_NEAR((bell(2.6 * 2.6) - bell(at)) / (2.6 * 2.6 - at) / behind, 1.0, 1e-5) << n;
    }
}

TEST(log_bell, is_finite_and_grows_for_every_shininess) {
    for (const double n : {0.0, 1e-300, 0.01, 1.0, 50.0, 1e3, 1e9, 1e18, 1e300}) {
        double last = 0.0;
        for (int k = 0; k <= 1000; ++k) {
            const double value = log_bell(pi * k / 1000, n);
            ASSERT_TRUE(std::isfinite(value)) << n << ", step " << k;
            ASSERT_GE(value, last) << n << ", step " << k;
            last = value;
        }
    }
}

TEST(log_quadratic, one_light_is_exact_at_the_nodes_it_reaches) {
    Rng rng(seed);
    int compared = 0;
    for (int k = 0; k < 3000; ++k) {
        Scene scene;
        scene.material.shininess = real(rng, 1, 200);
        scene.material.brdf = k % 2 == 0 ? Brdf::blinn : Brdf::phong;
        scene.lights = {{random_unit(rng), glm::dvec3(real(rng, 0, 1), real(rng, 0, 1), 1.0)}};
        const ScreenTriangle t = random_screen_triangle(rng, scene);
        const LogNodes nodes = shade_log_nodes({}, scene, t);
        for (int n = 0; n < 6; ++n) {
            glm::dvec3 weights(0.0);
            weights[n % 3] = n < 3 ? 1.0 : 0.5;
            if (n >= 3) weights[(n + 1) % 3] = 0.5;
            const SurfacePoint node = n < 3 ? vertex_node(scene, t.vertices[static_cast<std::size_t>(n)])
                                            : edge_node(scene, t.vertices[static_cast<std::size_t>(n % 3)],
                                                        t.vertices[static_cast<std::size_t>((n + 1) % 3)]);
            const double z = nodes.highlights[0].z[static_cast<std::size_t>(n)];
            const double peak = 8.0 - std::log2(255.0 * scene.material.specular);
            const double seven_or_72 = std::min(7.0, -scene.material.shininess * std::log2(std::cos(72.0 * pi / 180)));
            if (z > peak + seven_or_72) continue;  // its tangent instead
            const glm::dvec3 expected = shade(scene.material, scene.lights, node);
            ASSERT_LT(glm::length(nodes.colour_at(weights) - expected), 1e-9) << "triangle " << k << ", node " << n;
            ++compared;
        }
    }
    EXPECT_GT(compared, 500);
}

TEST(log_quadratic, no_light_puts_out_another) {
    Rng rng(seed + 1);
    for (int k = 0; k < 20000; ++k) {
        Material material;
        const Light a{random_unit(rng), {real(rng, 0, 2), real(rng, 0, 2), 0.0}};
        const Light b{random_unit(rng), {real(rng, 0, 2), 0.0, real(rng, 0, 2)}};
        const SurfacePoint point{glm::dvec3(0.0), random_unit(rng), {0, 0, 1}};
        const glm::dvec3 both = unclamped_diffuse(material, {a, b}, point);
        const glm::dvec3 of_a = unclamped_diffuse(material, {a}, point);
        const glm::dvec3 of_b = unclamped_diffuse(material, {b}, point);
        for (int c = 0; c < 3; ++c) {
            // A light that doesn't reach a component leaves it alone.
            const bool reached_by_a = a.colour[c] > 0.0;
            const bool reached_by_b = b.colour[c] > 0.0;
            ASSERT_TRUE(!reached_by_a || both[c] >= of_a[c]) << k;
            ASSERT_TRUE(!reached_by_b || both[c] >= of_b[c]) << k;
            ASSERT_TRUE(reached_by_b || both[c] == of_a[c]) << k;
            const double truth = std::max(0.0, of_a[c]) + std::max(0.0, of_b[c]);
            ASSERT_NEAR(std::max(0.0, both[c]), truth, 1e-12) << k;
        }
    }
}

TEST(log_quadratic, neighbours_agree_along_their_shared_edge) {
    Rng rng(seed + 2);
    for (int k = 0; k < 2000; ++k) {
        Scene scene;
        if (k % 2 == 0) scene.field_of_view = 50.0;
        scene.lights = {{random_unit(rng), glm::dvec3(1.0)}, towards(0.2, 0.1, 1.0, {0.3, 0.8, 0.5})};
        scene.lights.push_back({random_unit(rng) * 4.0, glm::dvec3(0.7), Light::Kind::positional});
        scene.material.shininess = std::pow(10.0, real(rng, 0, 3));
        ScreenTriangle left = random_screen_triangle(rng, scene);
        if (k % 3 == 0) left.vertices[1].normal = -left.vertices[0].normal;
        ScreenTriangle right = random_screen_triangle(rng, scene);
        right.vertices[0] = left.vertices[1];
        right.vertices[1] = left.vertices[0];
        MethodOptions options;
        options.log_channels = static_cast<std::size_t>(uniform(rng, 0, 3));
        const LogNodes a = shade_log_nodes(options, scene, left);
        const LogNodes b = shade_log_nodes(options, scene, right);
        for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
            const glm::dvec3 jump = a.colour_at({1 - t, t, 0}) - b.colour_at({t, 1 - t, 0});
            ASSERT_LT(glm::length(jump), 1e-6) << "pair " << k << " at " << t;
        }
    }
}

TEST(log_quadratic, any_material_and_light_gives_finite_colours) {
    Rng rng(seed + 3);
    for (int k = 0; k < 20000; ++k) {
        Scene scene;
        scene.material.shininess = k % 9 == 0 ? 0.0 : std::pow(10.0, real(rng, 0, k % 7 == 0 ? 300 : 3));
        scene.material.specular = k % 5 == 0 ? 0.0 : real(rng, 0, 1);
        scene.material.brdf = k % 2 == 0 ? Brdf::blinn : Brdf::phong;
        if (k % 4 == 0) scene.field_of_view = 90.0;
        ScreenTriangle t = random_screen_triangle(rng, scene);
        if (k % 6 == 0) t.vertices[1].normal = -t.vertices[0].normal;
        scene.lights = {{{0, 0, -1}, glm::dvec3(1.0)},  // opposite to the eye: no half vector
                        {random_unit(rng), glm::dvec3(0.0)},
                        {random_unit(rng), {real(rng, 0, 100), 0.0, 0.0}},
                        {t.vertices[2].position, glm::dvec3(1.0), Light::Kind::positional}};
        MethodOptions options;
        options.log_channels = static_cast<std::size_t>(uniform(rng, 0, 4));
        const LogNodes nodes = shade_log_nodes(options, scene, t);
        ASSERT_EQ(nodes.highlights.empty(), scene.material.specular == 0.0 || options.log_channels == 0);
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 colour = nodes.colour_at(random_weights(rng));
            for (int c = 0; c < 3; ++c) {
                ASSERT_GE(colour[c], 0.0) << "triangle " << k;
                ASSERT_LT(colour[c], 5000.0) << "triangle " << k;
            }
        }
    }
}

TEST(log_quadratic, brightest_lights_get_channels_of_their_own_and_the_rest_its_tint_or_colour) {
    Rng rng(seed + 4);
    const glm::dvec3 white(1.0);
    const glm::dvec3 red(1.0, 0.25, 0.25);
    Scene scene;
    scene.lights = {towards(-0.4, 0.5, 0.8, 0.5 * red), towards(0.6, 0.3, 0.7, 0.5 * white), towards(0, 0, 1, white),
                    towards(0, 1, 1, 0.25 * white), towards(1, 0, 1, {0.125, 0.0, 0.0})};
    const ScreenTriangle t = random_screen_triangle(rng, scene);
    MethodOptions options;
    const auto tints = [&](std::size_t channels) {
        options.log_channels = channels;
        std::vector<glm::dvec3> result;
        for (const LogHighlight& h : shade_log_nodes(options, scene, t).highlights) result.push_back(h.tint);
        return result;
    };
    EXPECT_EQ(tints(0), (std::vector<glm::dvec3>{}));
    EXPECT_EQ(tints(1), (std::vector<glm::dvec3>{white}));
    EXPECT_EQ(tints(2), (std::vector<glm::dvec3>{white, red}));
    EXPECT_EQ(tints(5), (std::vector<glm::dvec3>{white, red, white, white, {1, 0, 0}}));

    // With two channels the white one holds three lights, and the fifth light is left to the colour nodes.
    options.log_channels = 2;
    const LogNodes nodes = shade_log_nodes(options, scene, t);
    const auto z_of = [&](std::size_t light, std::size_t node) {
        Scene one = scene;
        one.lights = {scene.lights[light]};
        return shade_log_nodes({}, one, t).highlights[0].z[node];
    };
    Material mirror = scene.material;
    mirror.ambient = mirror.diffuse = glm::dvec3(0.0);
    for (std::size_t n = 0; n < 3; ++n) {
        const double sum = std::exp2(-z_of(1, n)) + std::exp2(-z_of(2, n)) + std::exp2(-z_of(3, n));
        EXPECT_NEAR(nodes.highlights[0].z[n], -std::log2(sum), 1e-9) << n;
        EXPECT_NEAR(nodes.highlights[1].z[n], z_of(0, n), 1e-12) << n;
        const SurfacePoint node = vertex_node(scene, t.vertices[n]);
        const glm::dvec3 fifth = shade(mirror, {scene.lights[4]}, node);
        const glm::dvec3 expected = unclamped_diffuse(scene.material, scene.lights, node) + fifth;
        EXPECT_LT(glm::length(nodes.diffuse.colour[n] - expected), 1e-9) << n;
    }
}

TEST(log_quadratic, coloured_highlights_keep_their_tint_and_stop_at_256_each) {
    const LogHighlight highlight{{}, {1.0, 0.5, 0.0}};
    EXPECT_EQ(highlight.colour(1.0), glm::dvec3(128.0, 64.0, 0.0));
    EXPECT_EQ(highlight.colour(0.0), glm::dvec3(256.0, 128.0, 0.0));
    EXPECT_EQ(highlight.colour(-2.0), glm::dvec3(256.0, 256.0, 0.0));
}

TEST(log_quadratic, nodes_obey_the_limit_of_a_narrow_channel) {
    Rng rng(seed + 5);
    Scene scene;
    scene.material.shininess = 1000.0;
    scene.lights = {towards(0, 0, 1)};
    MethodOptions options;
    options.log_node_limit = 94.0;
    bool limited = false;
    for (int k = 0; k < 100; ++k) {
        const ScreenTriangle t = random_screen_triangle(rng, scene);
        const LogNodes free = shade_log_nodes({}, scene, t);
        const LogNodes narrow = shade_log_nodes(options, scene, t);
        for (std::size_t n = 0; n < 6; ++n) {
            ASSERT_EQ(narrow.highlights[0].z[n], std::min(94.0, free.highlights[0].z[n]));
            limited = limited || free.highlights[0].z[n] > 94.0;
        }
    }
    EXPECT_TRUE(limited);
}

TEST(log_quadratic, refuses_highlights_that_are_no_power_of_a_cosine) {
    Scene scene = measured_scene("sphere-168");
    scene.lights = measured_lights().front();
    EXPECT_FALSE(why_inexpressible(Method::log_quadratic, scene));
    scene.material.brdf = Brdf::phong;
    EXPECT_FALSE(why_inexpressible(Method::log_quadratic, scene));
    scene.material.brdf = Brdf::cook_torrance;
    EXPECT_NE(why_inexpressible(Method::log_quadratic, scene).value().find("blinn or phong"), std::string::npos);
    scene.mesh.materials = {Material{}};
    scene.mesh.triangle_materials.assign(scene.mesh.triangles.size(), 0);
    EXPECT_FALSE(why_inexpressible(Method::log_quadratic, scene)) << "the mesh brings its own material";
    scene.mesh.materials[0].brdf = Brdf::cook_torrance;
    EXPECT_TRUE(why_inexpressible(Method::log_quadratic, scene));
}

struct Quality {
    std::string mesh;
    double shininess;
    double least_psnr;
    double greatest_error;
};

class LogQuadraticQuality : public testing::TestWithParam<Quality> {};

TEST_P(LogQuadraticQuality, over_the_measured_lights) {
    Scene scene = measured_scene(GetParam().mesh);
    scene.material.shininess = GetParam().shininess;
    const ErrorMeter meter = measure(Method::log_quadratic, {}, scene, measured_lights());
    fmt::print("log-quadratic, {}, n = {}: {:.2f} dB, max {:.2f}\n", GetParam().mesh, GetParam().shininess,
               meter.psnr(), meter.max_error());
    EXPECT_GE(meter.psnr(), GetParam().least_psnr);
    EXPECT_LE(meter.max_error(), GetParam().greatest_error);
}

INSTANTIATE_TEST_SUITE_P(
    figures, LogQuadraticQuality,
    testing::Values(Quality{"sphere-168", 1.0, 40.5, 12.0}, Quality{"sphere-168", 5.0, 66.0, 1.5},
                    Quality{"sphere-168", 50.0, 62.0, 3.5}, Quality{"sphere-168", 200.0, 58.0, 7.5},
                    Quality{"sphere-168", 1000.0, 51.0, 34.0}, Quality{"sphere-374", 50.0, 74.0, 1.0},
                    Quality{"sphere-374", 1000.0, 64.0, 9.0}, Quality{"torus-knot", 50.0, 59.0, 5.5}));

TEST(log_quadratic, two_lights_one_from_behind) {
    const Scene scene = measured_scene("sphere-168");
    for (const Light& behind : {towards(0.4, -0.5, -0.77), towards(0.8, 0.1, -0.6)}) {
        const ErrorMeter meter = measure(Method::log_quadratic, {}, scene, {{towards(-0.4, 0.5, 0.77), behind}});
        fmt::print("log-quadratic, two lights: {:.2f} dB, max {:.2f}\n", meter.psnr(), meter.max_error());
        EXPECT_GE(meter.psnr(), 46.0);
        EXPECT_LE(meter.max_error(), 10.0);
    }
}

TEST(log_quadratic, a_shared_channel_is_better_than_colour_nodes) {
    const Scene scene = measured_scene("sphere-168");
    const std::vector<std::vector<Light>> runs{{towards(-0.4, 0.5, 0.77), towards(0.8, 0.1, -0.6)},
                                               {towards(0.85, 0.45, 0.15), towards(-0.9, 0.1, 0.1)}};
    MethodOptions options;
    options.log_channels = 2;
    const double own = measure(Method::log_quadratic, options, scene, runs).psnr();
    options.log_channels = 1;
    const double shared = measure(Method::log_quadratic, options, scene, runs).psnr();
    options.log_channels = 0;
    const double in_colour = measure(Method::log_quadratic, options, scene, runs).psnr();
    fmt::print("two lights, a channel each {:.2f}, one for both {:.2f}, none {:.2f} dB\n", own, shared, in_colour);
    EXPECT_GE(shared, own - 1.0);
    EXPECT_GE(shared, in_colour + 10.0);
}

}  // namespace
}  // namespace sheen::test
