// SPDX-License-Identifier: MIT
// The surface under the screen, against rays through the eye: interpolation, edge nodes, Phong per pixel.
#include "sheen/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "sheen/method.hpp"
#include "sheen/reference.hpp"
#include "support/random_triangles.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 7104;

double real(Rng& rng, double low, double high) { return std::uniform_real_distribution<double>(low, high)(rng); }

glm::dvec3 random_unit(Rng& rng) {
    return glm::normalize(glm::dvec3(real(rng, -1, 1), real(rng, -1, 1), real(rng, 0.01, 1)));
}

Scene scene_with(std::optional<double> field_of_view) {
    Scene scene;
    scene.width = 40;
    scene.height = 30;
    scene.field_of_view = field_of_view;
    scene.lights = {{glm::normalize(glm::dvec3(-0.4, 0.5, 0.77)), glm::dvec3(0.7)}};
    Light lamp;
    lamp.kind = Light::Kind::positional;
    lamp.vector = {1.0, 2.0, -1.0};
    scene.lights.push_back(lamp);
    return scene;
}

/// From screen to a ray: where it starts and where it goes, in eye space.
struct Ray {
    glm::dvec3 from, to;
};

/// Through (x, y) pixels right of and above the image's middle. `focal` is the pixels that a unit takes at distance 1,
/// or anywhere without perspective.
Ray ray_through(const Scene& scene, double focal, double x, double y) {
    if (!scene.field_of_view) return {{x / focal, y / focal, 0.0}, {0.0, 0.0, -1.0}};
    return {glm::dvec3(0.0), {x / focal, y / focal, -1.0}};
}

double focal_of(const Scene& scene) {
    if (!scene.field_of_view) return 0.45 * scene.height;
    return 0.5 * scene.height / std::tan(*scene.field_of_view * std::acos(-1.0) / 360.0);
}

/// A triangle whose snapped vertices are exactly where its positions are seen: the points come first.
ScreenTriangle random_triangle(Rng& rng, const Scene& scene) {
    const double focal = focal_of(scene);
    ScreenTriangle triangle;
    for (ScreenVertex& vertex : triangle.vertices) {
        vertex.point = {uniform(rng, -2000, 256 * scene.width + 2000), uniform(rng, -2000, 256 * scene.height + 2000)};
        const double x = static_cast<double>(vertex.point.x) / 256.0 - 0.5 * scene.width;
        const double y = 0.5 * scene.height - static_cast<double>(vertex.point.y) / 256.0;
        const Ray ray = ray_through(scene, focal, x, y);
        vertex.position = ray.from + real(rng, 0.2, 9.0) * ray.to;
        vertex.normal = random_unit(rng);
        vertex.depth = 100.0;
    }
    const auto& v = triangle.vertices;
    triangle.face_normal = random_unit(rng);
    triangle.walks = walk_in_image(v[0].point, v[1].point, v[2].point, scene.width, scene.height);
    return triangle;
}

/// Where the ray meets the triangle's plane, and the weights of its vertices there by areas in space.
std::pair<glm::dvec3, glm::dvec3> meet(const ScreenTriangle& triangle, const Ray& ray) {
    const glm::dvec3 a = triangle.vertices[0].position;
    const glm::dvec3 b = triangle.vertices[1].position;
    const glm::dvec3 c = triangle.vertices[2].position;
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const glm::dvec3 p = ray.from + glm::dot(a - ray.from, area) / glm::dot(ray.to, area) * ray.to;
    const double whole = glm::dot(area, area);
    return {p,
            {glm::dot(glm::cross(c - b, p - b), area) / whole, glm::dot(glm::cross(a - c, p - c), area) / whole,
             glm::dot(glm::cross(b - a, p - a), area) / whole}};
}

bool is_wide(const ScreenTriangle& t) {
    return std::abs(doubled_area(t.vertices[0].point, t.vertices[1].point, t.vertices[2].point)) > 400000;
}

void expect_near(const glm::dvec3& got, const glm::dvec3& expected, double tolerance, const std::string& what) {
    EXPECT_LE(glm::length(got - expected), tolerance)
        << what << ": got " << got.x << " " << got.y << " " << got.z << ", expected " << expected.x << " " << expected.y
        << " " << expected.z;
}

TEST(Surface, LiesWhereTheRayThroughTheScreenMeetsTheTriangle) {
    Rng rng(seed);
    for (int k = 0; k < 3000; ++k) {
        const Scene scene = scene_with(k % 3 == 0 ? std::nullopt : std::optional(real(rng, 1.0, 170.0)));
        const ScreenTriangle triangle = random_triangle(rng, scene);
        if (!is_wide(triangle)) continue;
        const double u = real(rng, 0, 1);
        const double v = real(rng, 0, 1);
        const glm::dvec3 weights = u + v < 1 ? glm::dvec3(u, v, 1 - u - v) : glm::dvec3(1 - u, 1 - v, u + v - 1);
        glm::dvec3 screen(0.0);
        for (int i = 0; i < 3; ++i) {
            const SnappedPoint& p = triangle.vertices[static_cast<std::size_t>(i)].point;
            screen += weights[i] * glm::dvec3(static_cast<double>(p.x), static_cast<double>(p.y), 0.0) / 256.0;
        }
        const Ray ray =
            ray_through(scene, focal_of(scene), screen.x - 0.5 * scene.width, 0.5 * scene.height - screen.y);
        const auto [position, shares] = meet(triangle, ray);
        glm::dvec3 normal(0.0);
        for (int i = 0; i < 3; ++i) normal += shares[i] * triangle.vertices[static_cast<std::size_t>(i)].normal;
        const SurfacePoint point = surface_point(scene, triangle, weights);
        expect_near(point.position, position, 1e-8 * (1.0 + glm::length(position)), "position");
        expect_near(point.normal, glm::normalize(normal), 1e-7, "normal");
        expect_near(point.to_eye, -glm::normalize(ray.to), 1e-9, "to the eye");
        expect_near(surface_weights(scene, triangle, weights), shares, 1e-7, "weights");
        if (HasFailure()) FAIL() << "case " << k << ", seed " << seed;
    }
}

TEST(Surface, AnEdgesNodeIsUnderItsMiddleOnTheScreenWhicheverEndComesFirst) {
    Rng rng(seed + 1);
    for (int k = 0; k < 5000; ++k) {
        const Scene scene = scene_with(k % 3 == 0 ? std::nullopt : std::optional(60.0));
        ScreenTriangle triangle = random_triangle(rng, scene);
        auto& [a, b, c] = triangle.vertices;
        if (k % 5 == 0) b.normal = -a.normal;
        if (k % 10 == 0) b.position.z = a.position.z;
        const SurfacePoint node = edge_node(scene, a, b);
        const SurfacePoint other = edge_node(scene, b, a);
        ASSERT_EQ(node.position, other.position) << k;
        ASSERT_EQ(node.normal, other.normal) << k;
        ASSERT_EQ(node.to_eye, other.to_eye) << k;
        ASSERT_NEAR(glm::length(node.normal), 1.0, 1e-9) << k;
        const SurfacePoint middle = surface_point(scene, triangle, {0.5, 0.5, 0.0});
        expect_near(node.position, middle.position, 1e-12 * glm::length(middle.position), "position");
        if (k % 5 != 0) expect_near(node.normal, middle.normal, 1e-9, "normal");
        if (HasFailure()) FAIL() << "case " << k << ", seed " << seed + 1;
    }
}

TEST(Surface, AQuadraticsMidpointShowsWhatPhongShowsThere) {
    Rng rng(seed + 2);
    for (int k = 0; k < 1000; ++k) {
        const Scene scene = scene_with(k % 3 == 0 ? std::nullopt : std::optional(75.0));
        const ScreenTriangle triangle = random_triangle(rng, scene);
        const TriangleNodes nodes = shade_nodes(Method::quadratic, scene, triangle);
        for (const glm::dvec3& weights :
             {glm::dvec3(0.5, 0.5, 0.0), {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5}, {0.0, 1.0, 0.0}}) {
            const SurfacePoint point = surface_point(scene, triangle, weights);
            const glm::dvec3 colour = shade(triangle.material, scene.lights, point);
            expect_near(nodes.colour_at(weights), glm::min(colour, 306.0), 1e-6, "colour");
        }
        if (HasFailure()) FAIL() << "triangle " << k << ", seed " << seed + 2;
    }
}

TEST(Surface, PhongShadesThePointWhereThePixelsRayMeetsTheTriangle) {
    Rng rng(seed + 3);
    std::size_t pixels = 0;
    for (int k = 0; k < 60; ++k) {
        const Scene scene = scene_with(k % 3 == 0 ? std::nullopt : std::optional(real(rng, 5.0, 140.0)));
        const ScreenTriangle triangle = random_triangle(rng, scene);
        if (!is_wide(triangle)) continue;
        const ReferenceImage image = render_reference(Method::phong, scene, {triangle});
        for (int y = 0; y < scene.height; ++y) {
            for (int x = 0; x < scene.width; ++x) {
                const auto index = static_cast<std::size_t>(y * scene.width + x);
                if (!image.covered[index]) continue;
                const Ray ray =
                    ray_through(scene, focal_of(scene), x + 0.5 - 0.5 * scene.width, 0.5 * scene.height - y - 0.5);
                const auto [position, shares] = meet(triangle, ray);
                glm::dvec3 normal(0.0);
                for (int i = 0; i < 3; ++i) normal += shares[i] * triangle.vertices[static_cast<std::size_t>(i)].normal;
                const SurfacePoint point{position, glm::normalize(normal), -glm::normalize(ray.to)};
                const glm::dvec3 colour = shade(triangle.material, scene.lights, point);
                expect_near(image.colour[index], glm::clamp(colour, 0.0, 255.0), 1e-4, "pixel");
                ++pixels;
            }
        }
        if (HasFailure()) FAIL() << "triangle " << k << ", seed " << seed + 3;
    }
    EXPECT_GT(pixels, 3000U);
}

}  // namespace
}  // namespace sheen::test
