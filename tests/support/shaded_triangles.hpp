// SPDX-License-Identifier: MIT
/// \file
/// Triangles with normals and positions, benign and hostile, and what every method's shader and loop are held to.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <string>

#include "coverage_oracle.hpp"
#include "sheen/loop.hpp"
#include "sheen/metrics.hpp"
#include "sheen/reference.hpp"
#include "sheen/shader.hpp"

namespace sheen::test {

inline double between(Rng& rng, double low, double high) {
    return low + (high - low) * static_cast<double>(uniform(rng, 0, 1 << 30)) / (1 << 30);
}

inline glm::dvec3 random_direction(Rng& rng, double least_z) {
    return glm::normalize(glm::dvec3(between(rng, -1.0, 1.0), between(rng, -1.0, 1.0), between(rng, least_z, 1.0)));
}

inline Light directional_light(Rng& rng, double least_z = 0.1) {
    Light light;
    light.vector = random_direction(rng, least_z);
    light.colour = {between(rng, 0.2, 1.0), between(rng, 0.2, 1.0), between(rng, 0.2, 1.0)};
    return light;
}

/// A light in a place before or beside what random_triangle() makes.
inline Light positional_light(Rng& rng) {
    Light light = directional_light(rng);
    light.kind = Light::Kind::positional;
    light.vector = {between(rng, -2.0, 2.0), between(rng, -2.0, 2.0), between(rng, -1.5, 0.0)};
    return light;
}

inline Scene small_scene() {
    Scene scene;
    scene.width = scene.height = 60;
    return scene;
}

inline void walk_in(ScreenTriangle& triangle, const Scene& scene) {
    const auto& v = triangle.vertices;
    triangle.walks = walk_in_image(v[0].point, v[1].point, v[2].point, scene.width, scene.height);
}

/// Twenty square pixels or more, its normals at most about 20 degrees off the eye's direction each way.
inline ScreenTriangle benign_triangle(Rng& rng, const Scene& scene) {
    ScreenTriangle triangle;
    triangle.material = scene.material;
    const auto& v = triangle.vertices;
    do {
        for (ScreenVertex& vertex : triangle.vertices) {
            vertex.point = {uniform(rng, 0, 256 * scene.width), uniform(rng, 0, 256 * scene.height)};
            vertex.position = {between(rng, -1.0, 1.0), between(rng, -1.0, 1.0), between(rng, -5.0, -3.0)};
            vertex.normal = glm::normalize(glm::dvec3(between(rng, -0.35, 0.35), between(rng, -0.35, 0.35), 1.0));
        }
        walk_in(triangle, scene);
    } while (std::abs(doubled_area(v[0].point, v[1].point, v[2].point)) < 40 * 256 * 256 || triangle.walks.empty());
    triangle.face_normal = {0.0, 0.0, 1.0};
    return triangle;
}

/// Slivers, needles and plain shapes; normals anywhere, equal, opposite, or all but cancelling in the centre.
inline ScreenTriangle hostile_triangle(Rng& rng, const Scene& scene) {
    ScreenTriangle triangle = benign_triangle(rng, scene);
    auto& v = triangle.vertices;
    do {
        const Triangle shape = random_triangle(rng, scene.width);
        for (std::size_t k = 0; k < 3; ++k) v[k].point = shape[k];
        walk_in(triangle, scene);
    } while (triangle.walks.empty());
    for (ScreenVertex& vertex : v) vertex.normal = random_direction(rng, -1.0);
    switch (uniform(rng, 0, 4)) {
        case 0:
            v[1].normal = -v[0].normal;
            break;
        case 1:
            v[1].normal = v[2].normal = v[0].normal;
            break;
        case 2:  // a third of a turn apart: their sum is rounding noise
            v[0].normal = {1.0, 0.0, 0.0};
            v[1].normal = {-0.5, std::sqrt(0.75), 0.0};
            v[2].normal = {-0.5, -std::sqrt(0.75), 0.0};
            break;
        case 3:
            v[1].normal = glm::normalize(-v[0].normal + 1e-5 * v[1].normal);
            v[2].normal = v[0].normal;
            break;
        default:
            break;
    }
    return triangle;
}

/// The vertices' weights at a pixel's centre, from exact areas.
inline glm::dvec3 weights_at(const ScreenTriangle& triangle, int x, int y) {
    const SnappedPoint p = pixel_centre(x, y);
    const auto& v = triangle.vertices;
    return glm::dvec3(static_cast<double>(cross(v[1].point, v[2].point, p)),
                      static_cast<double>(cross(v[2].point, v[0].point, p)),
                      static_cast<double>(cross(v[0].point, v[1].point, p))) /
           static_cast<double>(cross(v[0].point, v[1].point, v[2].point));
}

/// visit(x, y, colour) at every pixel of the triangle.
template <typename Visit>
void for_each_pixel(Method method, const MethodOptions& options, const Scene& scene, const ScreenTriangle& triangle,
                    Visit visit) {
    const std::unique_ptr<Shader> shader = make_shader(method, options, scene, triangle);
    for (const PixelRow& row : triangle_rows(triangle)) {
        shader->start_row(row);
        for (int x = row.x; x < row.x + row.length; ++x) {
            visit(x, row.y, shader->colour(x, weights_at(triangle, x, row.y)));
        }
    }
}

inline bool is_finite(const glm::dvec3& colour) {
    return std::isfinite(colour.x) && std::isfinite(colour.y) && std::isfinite(colour.z);
}

/// The loop's colours are the shader's.
inline void expect_loop_equals_shader(Method method, const MethodOptions& options, const Scene& scene,
                                      const ScreenTriangle& triangle, const std::string& where) {
    const auto loop = make_loop<double>(method, options, scene, triangle);
    int row = -1;
    for_each_pixel(method, options, scene, triangle, [&](int x, int y, const glm::dvec3& expected) {
        if (y != row) {
            for (const PixelRow& started : triangle_rows(triangle)) {
                if (started.y == y) loop->start_row(started);
            }
            row = y;
        }
        ASSERT_LT(glm::length(loop->next() - expected), 1e-6)
            << to_string(method) << " at " << x << ", " << y << ", " << where;
    });
}

/// What the loop does at the triangle's pixels, over their number.
inline OperationCounts cost_of_pixel(Method method, const Scene& scene, const ScreenTriangle& triangle) {
    const auto loop = make_loop<Counted>(method, {}, scene, triangle);
    loop->start_row(triangle_rows(triangle).front());
    const CountingScope scope;
    (void)loop->next();
    return scope.counts();
}

/// Error against Phong over the four measured lights, each alone.
inline ErrorMeter measure(Method method, const MethodOptions& options, Scene scene) {
    ErrorMeter meter;
    for (const glm::dvec3& direction :
         {glm::dvec3(-0.4, 0.5, 0.77), {0.6, 0.3, 0.74}, {0.2, -0.55, 0.8}, {0.85, 0.45, 0.15}}) {
        Light light;
        light.vector = glm::normalize(direction);
        scene.lights = {light};
        const auto triangles = project(scene);
        const ReferenceImage phong = render_reference(Method::phong, scene, triangles);
        meter.add(phong.colour, render_reference(method, scene, triangles, options).colour, phong.covered);
    }
    return meter;
}

inline Scene measured_sphere(const std::string& name = "builtin:sphere-168") {
    Scene scene;
    scene.mesh = make_builtin_mesh(name);
    scene.rotate_degrees = {23.0, 0.0, 11.0};
    return scene;
}

}  // namespace sheen::test
