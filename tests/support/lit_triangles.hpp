// SPDX-License-Identifier: MIT
/// \file
/// Random lit triangles for the methods with log channels, each with a light and a material of its own, and how far a
/// device's pixel may lie from the method in double precision.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "fits.hpp"
#include "shaped_triangles.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/lit_setup.hpp"
#include "sheen/log_quadratic.hpp"

namespace sheen::test {

/// A triangle in a scene without a mesh: only its camera, lights and material are used.
struct LitSubject {
    Method method = Method::log_quadratic;
    Scene scene;
    ScreenTriangle triangle;
};

inline glm::dvec3 random_direction(Rng& rng, double spread) {
    const auto side = [&] { return spread * (2.0 * uniform_real(rng) - 1.0); };
    return glm::normalize(glm::dvec3(side(), side(), 1.0));
}

/// A surface whose normals turn by up to about 40 degrees from vertex to vertex.
inline ScreenTriangle lit_triangle(Rng& rng, const Scene& scene, const Triangle& points) {
    ScreenTriangle triangle;
    const glm::dvec3 middle = random_direction(rng, 0.7);
    const double bend = 0.35 * uniform_real(rng);
    for (std::size_t k = 0; k < 3; ++k) {
        ScreenVertex& vertex = triangle.vertices[k];
        vertex.point = points[k];
        vertex.depth = static_cast<double>(uniform(rng, 1, 65534));
        vertex.position = {static_cast<double>(points[k].x) / 1e5, static_cast<double>(points[k].y) / -1e5, -4.0};
        vertex.normal = glm::normalize(middle + bend * random_direction(rng, 2.0));
    }
    triangle.face_normal = middle;
    triangle.material = scene.material;
    triangle.walks = walk_in_image(points[0], points[1], points[2], scene.width, scene.height);
    return triangle;
}

/// Lights: one, for `log-quadratic` up to three, white or grey, sometimes a lamp for `taylor-finite`.
inline LitSubject random_subject(Rng& rng, Method method, const Triangle& points) {
    LitSubject subject;
    subject.method = method;
    Scene& scene = subject.scene;
    scene.width = scene.height = 1024;
    const std::int64_t lights = method == Method::log_quadratic ? uniform(rng, 1, 3) : 1;
    for (std::int64_t k = 0; k < lights; ++k) {
        scene.lights.push_back({random_direction(rng, 1.5), glm::dvec3(0.2 + uniform_real(rng))});
    }
    if (method == Method::taylor_finite && uniform(rng, 0, 1) == 0) {
        scene.lights[0].kind = Light::Kind::positional;
        scene.lights[0].vector *= 8.0;
    }
    Material& material = scene.material;
    material.ambient = {0.2 * uniform_real(rng), 0.2 * uniform_real(rng), 0.05};
    material.diffuse = {uniform_real(rng), uniform_real(rng), uniform_real(rng)};
    material.specular = uniform(rng, 0, 9) == 0 ? 0.0 : uniform_real(rng);
    material.shininess = std::pow(200.0, uniform_real(rng)) + 2.0;
    subject.triangle = lit_triangle(rng, scene, points);
    return subject;
}

/// The vertices' weights at the centre of a pixel, from exact integers.
inline glm::dvec3 weights_at(const ScreenTriangle& triangle, int x, int y) {
    const auto& [a, b, c] = triangle.vertices;
    const SnappedPoint p{256 * std::int64_t{x} + 128, 256 * std::int64_t{y} + 128};
    const auto area = static_cast<double>(doubled_area(a.point, b.point, c.point));
    return {static_cast<double>(doubled_area(b.point, c.point, p)) / area,
            static_cast<double>(doubled_area(c.point, a.point, p)) / area,
            static_cast<double>(doubled_area(a.point, b.point, p)) / area};
}

/// Largest effect on a channel of rounding its six coefficients about the middle of the walk, and of the fit.
inline double channel_error(const TriangleWalk& walk, int px, int py, int fraction_bits) {
    const PixelIndex origin = centre_pixel(walk);
    const double x = std::abs(px - origin.x);
    const double y = std::abs(py - origin.y);
    return std::ldexp(0.5 * (1 + x + y + x * x + x * y + y * y), -fraction_bits) + std::ldexp(1.0, -20);
}

/// What exp2_rom makes of a z within `error` of this one, against 2^(8 − z), at most 2^8.
inline double exp2_error(double z, double error) {
    const double exact = std::min(256.0, std::exp2(8.0 - z));
    const double octave = std::floor(std::max(0.0, z - error));
    const double unit = std::ldexp(1.0, hls::component_bits - hls::exp2_data_bits);
    const double bin = 256.0 * (1.0 - std::exp2(-0.5 / (1 << hls::exp2_address_bits)));
    const double shift = std::ldexp(1.0, -hls::colour_sum_fraction_bits);
    return (std::exp2(error) - 1.0) * exact + (0.5 * unit + bin) * std::exp2(-octave) + shift;
}

/// The same of a power table of this strength, against strength·round(255·cos^n)/255, for 16·cos within `error`.
inline double power_error(const PowerEntries& entries, double strength, double cosine, double error) {
    const auto entry = [&](double address) {
        return entries[static_cast<std::size_t>(std::clamp(std::floor(address), 0.0, 1023.0))];
    };
    const double address = 1023.0 * cosine + 0.5;
    const int middle = entry(address);
    const double moved =
        std::max(std::abs(entry(address + 64.0 * error) - middle), std::abs(entry(address - 64.0 * error) - middle));
    return moved + 0.5 + 0.5 * strength / 255.0;
}

/// ½ of the pixel's rounding, and half a step of ambient; diffuse is cut where all else is whole, which cuts nothing
/// more from the sum.
inline double pixel_error() { return 0.5 + std::ldexp(0.5, -hls::colour_sum_fraction_bits); }

}  // namespace sheen::test
