// SPDX-License-Identifier: MIT
// Loops: the colours of the shaders by incremental means, and what each costs a pixel, a span, a triangle.
#include "sheen/loop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>

#include "support/coverage_oracle.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 5150;
constexpr std::array<Method, 4> methods{Method::flat, Method::gouraud, Method::quadratic, Method::phong};

/// Lights, camera and reflection model at random, of every kind.
Scene random_scene(Rng& random) {
    const auto between = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Scene scene;
    scene.width = static_cast<int>(uniform(random, 20, 200));
    scene.height = static_cast<int>(uniform(random, 20, 200));
    if (uniform(random, 0, 1) == 1) scene.field_of_view = 40.0;
    const std::int64_t lights = uniform(random, 0, 3);
    for (std::int64_t i = 0; i < lights; ++i) {
        Light light;
        light.vector = glm::normalize(glm::dvec3(between(-1.0, 1.0), between(-1.0, 1.0), between(0.1, 1.0)));
        light.colour = {between(0.0, 1.0), between(0.0, 1.0), between(0.0, 1.0)};
        if (uniform(random, 0, 1) == 1) {
            light.kind = Light::Kind::positional;
            light.vector *= 3.0;
        }
        scene.lights.push_back(light);
    }
    return scene;
}

/// A triangle in or around the image, some pixels wide everywhere, with normals that face the eye.
ScreenTriangle random_triangle(Rng& random, const Scene& scene) {
    constexpr std::int64_t pixel = 256;
    const auto between = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    ScreenTriangle triangle;
    triangle.material.shininess = between(1.0, 100.0);
    triangle.material.brdf = std::array<Brdf, 3>{Brdf::blinn, Brdf::phong, Brdf::cook_torrance}.at(
        static_cast<std::size_t>(uniform(random, 0, 2)));
    triangle.face_normal = glm::normalize(glm::dvec3(between(-0.5, 0.5), between(-0.5, 0.5), 1.0));
    auto& v = triangle.vertices;
    do {
        for (ScreenVertex& vertex : v) {
            vertex.point = {uniform(random, -10 * pixel, (scene.width + 10) * pixel),
                            uniform(random, -10 * pixel, (scene.height + 10) * pixel)};
            vertex.position = {between(-1.0, 1.0), between(-1.0, 1.0), between(-5.0, -3.0)};
            vertex.normal = glm::normalize(glm::dvec3(between(-0.7, 0.7), between(-0.7, 0.7), 1.0));
        }
        triangle.walks = walk_in_image(v[0].point, v[1].point, v[2].point, scene.width, scene.height);
    } while (std::abs(doubled_area(v[0].point, v[1].point, v[2].point)) < 200 * pixel * pixel ||
             triangle.walks.empty());
    return triangle;
}

glm::dvec3 weights_at(const ScreenTriangle& triangle, int x, int y) {
    const SnappedPoint p = pixel_centre(x, y);
    const auto& v = triangle.vertices;
    const glm::dvec3 parts(static_cast<double>(doubled_area(p, v[1].point, v[2].point)),
                           static_cast<double>(doubled_area(v[0].point, p, v[2].point)),
                           static_cast<double>(doubled_area(v[0].point, v[1].point, p)));
    return parts / static_cast<double>(doubled_area(v[0].point, v[1].point, v[2].point));
}

std::size_t pixels_of(const ScreenTriangle& triangle) {
    std::size_t pixels = 0;
    for (const PixelRow& row : triangle_rows(triangle)) pixels += static_cast<std::size_t>(row.length);
    return pixels;
}

/// What the method does on the triangle, by part.
struct Cost {
    OperationCounts setup, nodes, spans, pixels;
};

Cost cost_of(Method method, const Scene& scene, const ScreenTriangle& triangle) {
    Cost cost;
    std::unique_ptr<Loop<Counted>> loop;
    {
        const CountingScope scope;
        loop = make_loop<Counted>(method, {}, scene, triangle);
        cost.setup = scope.counts();
        cost.nodes = loop->node_counts();
    }
    for (const PixelRow& row : triangle_rows(triangle)) {
        {
            const CountingScope scope;
            loop->start_row(row);
            cost.spans += scope.counts();
        }
        const CountingScope scope;
        for (int i = 0; i < row.length; ++i) (void)loop->next();
        cost.pixels += scope.counts();
    }
    return cost;
}

/// One white directional light, orthographic: what the papers count.
Scene plain_scene() {
    Scene scene;
    scene.width = scene.height = 100;
    scene.lights.emplace_back();
    scene.lights.back().vector = glm::normalize(scene.lights.back().vector);
    return scene;
}

/// A triangle in the plain scene whose middle vertex is on the right, so that it has one left edge.
ScreenTriangle plain_triangle(const Scene& scene) {
    ScreenTriangle triangle;
    triangle.vertices[0].point = {256 * 10, 256 * 5};
    triangle.vertices[1].point = {256 * 25, 256 * 90};
    triangle.vertices[2].point = {256 * 80, 256 * 40};
    const auto& v = triangle.vertices;
    for (std::size_t k = 0; k < 3; ++k) {
        triangle.vertices[k].normal = glm::normalize(glm::dvec3(0.2 * static_cast<double>(k), 0.3, 1.0));
    }
    triangle.face_normal = {0.0, 0.0, 1.0};
    triangle.walks = walk_in_image(v[0].point, v[1].point, v[2].point, scene.width, scene.height);
    return triangle;
}

TEST(Loop, ColoursAreTheShadersOnRandomTrianglesUnderAnyLightsCameraAndReflection) {
    Rng random(seed);
    std::size_t compared = 0;
    double greatest = 0.0;
    for (int run = 0; run < 300; ++run) {
        const Scene scene = random_scene(random);
        const ScreenTriangle triangle = random_triangle(random, scene);
        for (const Method method : methods) {
            const auto loop = make_loop<double>(method, {}, scene, triangle);
            const auto shader = make_shader(method, {}, scene, triangle);
            ASSERT_NE(loop, nullptr);
            for (const PixelRow& row : triangle_rows(triangle)) {
                loop->start_row(row);
                shader->start_row(row);
                for (int x = row.x; x < row.x + row.length; ++x) {
                    const glm::dvec3 got = loop->next();
                    const glm::dvec3 expected = shader->colour(x, weights_at(triangle, x, row.y));
                    const double error = glm::length(got - expected);
                    ASSERT_LT(error, 1e-6)
                        << to_string(method) << " at " << x << ", " << row.y << ", run " << run << ", seed " << seed;
                    greatest = std::max(greatest, error);
                    ++compared;
                }
            }
        }
    }
    EXPECT_GT(compared, 1000000U);
    std::cout << compared << " pixels, at most " << greatest << " steps apart\n";
}

TEST(Loop, EveryMethodHasOneInBothNumberTypes) {
    const Scene scene = plain_scene();
    const ScreenTriangle triangle = plain_triangle(scene);
    for (const Method method : all_methods()) {
        EXPECT_NE(make_loop<double>(method, {}, scene, triangle), nullptr) << to_string(method);
        EXPECT_NE(make_loop<Counted>(method, {}, scene, triangle), nullptr) << to_string(method);
    }
}

TEST(Loop, CountingChangesNoColour) {
    Rng random(seed);
    for (int run = 0; run < 20; ++run) {
        const Scene scene = random_scene(random);
        const ScreenTriangle triangle = random_triangle(random, scene);
        for (const Method method : methods) {
            const auto drawn = make_loop<double>(method, {}, scene, triangle);
            const auto counted = make_loop<Counted>(method, {}, scene, triangle);
            for (const PixelRow& row : triangle_rows(triangle)) {
                drawn->start_row(row);
                counted->start_row(row);
                for (int i = 0; i < row.length; ++i) {
                    const glm::dvec3 expected = drawn->next();
                    const glm::vec<3, Counted> got = counted->next();
                    ASSERT_EQ(glm::dvec3(got.x.value(), got.y.value(), got.z.value()), expected) << to_string(method);
                }
            }
        }
    }
}

TEST(Loop, RowsAreTheTrianglesPixelsInItsWalksOrder) {
    Rng random(seed);
    for (int run = 0; run < 100; ++run) {
        const Scene scene = random_scene(random);
        const ScreenTriangle triangle = random_triangle(random, scene);
        const auto& v = triangle.vertices;
        std::size_t covered = 0;
        for (int y = 0; y < scene.height; ++y) {
            for (int x = 0; x < scene.width; ++x) {
                covered += edge_functions_cover({v[0].point, v[1].point, v[2].point}, x, y) ? 1U : 0U;
            }
        }
        EXPECT_EQ(pixels_of(triangle), covered) << "run " << run << ", seed " << seed;
        int last = -1;
        for (const PixelRow& row : triangle_rows(triangle)) {
            EXPECT_GT(row.y, last);
            last = row.y;
            EXPECT_GT(row.length, 0);
            for (const int x : {row.x, row.x + row.length - 1}) {
                EXPECT_TRUE(edge_functions_cover({v[0].point, v[1].point, v[2].point}, x, row.y));
            }
        }
    }
}

TEST(LoopCost, APixelIsNoneThreeSixAdditionsForFlatGouraudQuadratic) {
    Rng random(seed);
    for (int run = 0; run < 50; ++run) {
        const Scene scene = random_scene(random);
        const ScreenTriangle triangle = random_triangle(random, scene);
        const std::size_t pixels = pixels_of(triangle);
        EXPECT_EQ(cost_of(Method::flat, scene, triangle).pixels, OperationCounts{});
        EXPECT_EQ(cost_of(Method::gouraud, scene, triangle).pixels, (OperationCounts{3 * pixels, 0, 0, 0, 0, 0, 0}));
        EXPECT_EQ(cost_of(Method::quadratic, scene, triangle).pixels, (OperationCounts{6 * pixels, 0, 0, 0, 0, 0, 0}));
    }
}

TEST(LoopCost, ARowIsOneOrThreeAdditionsAChannelAndAsManyWhereTheEdgeCarries) {
    const Scene scene = plain_scene();
    const ScreenTriangle triangle = plain_triangle(scene);
    const std::vector<PixelRow> rows = triangle_rows(triangle);
    // The left edge moves 15 pixels in 85 rows: it carries where it moves at all.
    const auto carries = static_cast<std::size_t>(rows.back().x - rows.front().x);
    const std::size_t steps = rows.size() - 1 + carries;
    EXPECT_GT(carries, 10U);
    EXPECT_EQ(cost_of(Method::flat, scene, triangle).spans, OperationCounts{});
    EXPECT_EQ(cost_of(Method::gouraud, scene, triangle).spans, (OperationCounts{3 * steps, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(cost_of(Method::quadratic, scene, triangle).spans, (OperationCounts{9 * steps, 0, 0, 0, 0, 0, 0}));
}

TEST(LoopCost, SetupDividesOnceAndNodesArePricedApart) {
    const Scene scene = plain_scene();
    const ScreenTriangle triangle = plain_triangle(scene);
    for (const Method method : {Method::gouraud, Method::quadratic}) {
        const Cost cost = cost_of(method, scene, triangle);
        EXPECT_EQ(cost.setup.divisions - cost.nodes.divisions, 1U) << to_string(method);
        EXPECT_EQ(cost.setup.powers, cost.nodes.powers);
        EXPECT_EQ(cost.setup.roots, cost.nodes.roots);
        EXPECT_EQ(cost.nodes.powers, method == Method::gouraud ? 3U : 6U) << "a power a node";
        EXPECT_EQ(cost.nodes.roots, method == Method::gouraud ? 0U : 3U) << "a root for each midpoint's normal";
    }
    EXPECT_EQ(cost_of(Method::flat, scene, triangle).setup, cost_of(Method::flat, scene, triangle).nodes);
}

TEST(LoopCost, PhongNormalisesAndRaisesToAPowerAtEveryPixel) {
    const Scene scene = plain_scene();
    const ScreenTriangle triangle = plain_triangle(scene);
    const std::size_t pixels = pixels_of(triangle);
    // The normal 3 + and its square 2 +, 3 ×; its inverse length; 3 ×; N·L and N·H 4 +, 6 ×; two colours 6 ×, summed 6
    // +.
    EXPECT_EQ(cost_of(Method::phong, scene, triangle).pixels,
              (OperationCounts{15 * pixels, 18 * pixels, pixels, pixels, pixels, 2 * pixels, 0}));
}

}  // namespace
}  // namespace sheen::test
