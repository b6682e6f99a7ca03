// SPDX-License-Identifier: MIT
/// \file
/// Random vectors, triangles and pictures for the methods that interpolate normals on the sphere, and an oracle of
/// theirs: Rodrigues' rotation along the edges and along the span.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "coverage_oracle.hpp"
#include "sheen/compare.hpp"
#include "sheen/mesh.hpp"
#include "sheen/metrics.hpp"
#include "sheen/reference.hpp"
#include "sheen/shader.hpp"

namespace sheen::test {

inline double real(Rng& rng, double low, double high) {
    return low + (high - low) * static_cast<double>(uniform(rng, 0, 1 << 20)) / (1 << 20);
}

inline glm::dvec3 random_unit(Rng& rng) {
    glm::dvec3 v(0.0);
    do {
        v = {real(rng, -1.0, 1.0), real(rng, -1.0, 1.0), real(rng, -1.0, 1.0)};
    } while (glm::length(v) < 0.1);
    return glm::normalize(v);
}

/// v turned about a unit axis.
inline glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& axis, double radians) {
    return v * std::cos(radians) + glm::cross(axis, v) * std::sin(radians) +
           axis * (glm::dot(axis, v) * (1.0 - std::cos(radians)));
}

/// The unit vector at the share t of the way from a to b, which must not be equal or opposite.
inline glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double t) {
    const glm::dvec3 axis = glm::cross(a, b);
    return rotated(a, glm::normalize(axis), t * std::atan2(glm::length(axis), glm::dot(a, b)));
}

/// A triangle of at least 50 square pixels in [0, 60]² pixels.
inline Triangle plump_triangle(Rng& rng) {
    Triangle t{};
    do {
        for (SnappedPoint& p : t) p = {uniform(rng, 0, 60 * 256), uniform(rng, 0, 60 * 256)};
    } while (std::abs(cross(t[0], t[1], t[2])) < 100 * 65536);
    return t;
}

/// A triangle with random normals that mostly face the eye, clipped to the scene's image; it may cover nothing.
inline ScreenTriangle normal_triangle(Rng& rng, const Scene& scene, const Triangle& points) {
    ScreenTriangle triangle;
    triangle.material = scene.material;
    triangle.face_normal = {0.0, 0.0, 1.0};
    for (std::size_t k = 0; k < 3; ++k) {
        ScreenVertex& vertex = triangle.vertices[k];
        vertex.point = points[k];
        vertex.depth = 1000.0;
        vertex.position = {real(rng, -1.0, 1.0), real(rng, -1.0, 1.0), real(rng, -5.0, -3.0)};
        vertex.normal = glm::normalize(glm::dvec3(real(rng, -1.0, 1.0), real(rng, -1.0, 1.0), real(rng, 0.3, 1.0)));
    }
    triangle.walks = walk_in_image(points[0], points[1], points[2], scene.width, scene.height);
    return triangle;
}

/// What papers `spherical` and `recurrence` interpolate at the centre of a covered pixel: from edge to edge along the
/// row, by rotation.
inline glm::dvec3 spherical_normal(const ScreenTriangle& triangle, int x, int y) {
    std::array<ScreenVertex, 3> v = triangle.vertices;
    std::sort(v.begin(), v.end(), [](const auto& a, const auto& b) {
        return a.point.y != b.point.y ? a.point.y < b.point.y : a.point.x < b.point.x;
    });
    const long double row = 256.0L * y + 128.0L;
    struct Crossing {
        long double x;
        glm::dvec3 normal;
    };
    const auto crossing = [row](const ScreenVertex& a, const ScreenVertex& b) {
        const long double t =
            (row - static_cast<long double>(a.point.y)) / static_cast<long double>(b.point.y - a.point.y);
        return Crossing{static_cast<long double>(a.point.x) + t * static_cast<long double>(b.point.x - a.point.x),
                        between(a.normal, b.normal, static_cast<double>(t))};
    };
    const Crossing one = crossing(v[0], v[2]);
    const Crossing other = row < static_cast<long double>(v[1].point.y) ? crossing(v[0], v[1]) : crossing(v[1], v[2]);
    const long double t = (256.0L * x + 128.0L - one.x) / (other.x - one.x);
    return between(one.normal, other.normal, static_cast<double>(t));
}

/// Calls visit(x, y, colour) for each pixel of the triangle in the image.
template <typename Visit>
void shade_pixels(Method method, const MethodOptions& options, const Scene& scene, const ScreenTriangle& triangle,
                  Visit visit) {
    const auto shader = make_shader(method, options, scene, triangle);
    for (const TriangleWalk& walk : triangle.walks) {
        for_each_span(walk, [&](int x, int y, int length, int step) {
            const int first = step < 0 ? x - length + 1 : x;
            shader->start_row({first, y, length});
            for (int i = 0; i < length; ++i) visit(first + i, y, shader->colour(first + i, glm::dvec3(1.0 / 3.0)));
        });
    }
}

/// The picture of issue and documents: the sphere of 168 triangles, 512×512.
inline Scene measured_sphere(double shininess) {
    Scene scene;
    scene.mesh = load_mesh("builtin:sphere-168");
    scene.rotate_degrees = {23.0, 0.0, 11.0};
    scene.material.shininess = shininess;
    return scene;
}

/// Against Phong per pixel, over the four measured lights.
inline ErrorMeter measured_error(Method method, const MethodOptions& options, Scene scene) {
    ErrorMeter meter;
    const std::vector<ScreenTriangle> triangles = project(scene);
    for (const std::vector<Light>& lights : measured_lights()) {
        scene.lights = lights;
        const ReferenceImage phong = render_reference(Method::phong, scene, triangles);
        meter.add(phong.colour, render_reference(method, scene, triangles, options).colour, phong.covered);
    }
    return meter;
}

}  // namespace sheen::test
