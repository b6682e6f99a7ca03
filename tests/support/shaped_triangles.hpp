// SPDX-License-Identifier: MIT
/// \file
/// Triangles of one shape and area, randomly rotated and placed, as packets: what throughput is measured on.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "random_triangles.hpp"
#include "sheen/packet.hpp"

namespace sheen::test {

/// equilateral; right: equal legs; random: three points in a square, none flatter than 1:10; sliver: length to height
/// 10…1000, log-uniform.
enum class Shape { equilateral, right, random, sliver };

inline std::string to_string(Shape shape) {
    constexpr std::array<const char*, 4> names{"equilateral", "right", "random", "sliver"};
    return names[static_cast<std::size_t>(shape)];
}

/// In 0…1, with 30 bits.
inline double uniform_real(Rng& rng) { return static_cast<double>(uniform(rng, 0, (1 << 30) - 1)) / (1 << 30); }

struct PlanePoint {
    double x = 0;
    double y = 0;
};
using PlaneTriangle = std::array<PlanePoint, 3>;

inline double plane_area(const PlaneTriangle& t) {
    return std::abs((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y)) / 2;
}

/// A triangle of the shape, of any size, where it happens to be.
inline PlaneTriangle shaped_triangle(Rng& rng, Shape shape) {
    switch (shape) {
        case Shape::equilateral:
            return {{{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}}};
        case Shape::right:
            return {{{0, 0}, {1, 0}, {0, 1}}};
        case Shape::sliver:
            return {{{0, 0}, {std::pow(10.0, 1 + 2 * uniform_real(rng)), 0}, {10 * uniform_real(rng), 1}}};
        case Shape::random:
            break;
    }
    for (;;) {
        PlaneTriangle t;
        double longest = 0;
        for (PlanePoint& p : t) p = {uniform_real(rng), uniform_real(rng)};
        for (std::size_t k = 0; k < 3; ++k) {
            const PlanePoint& a = t[k];
            const PlanePoint& b = t[(k + 1) % 3];
            longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
        }
        if (20 * plane_area(t) > longest * longest) return t;
    }
}

/// A triangle of the shape and area (in pixels), randomly rotated and placed within [0, image]², in 1/256 pixel.
inline Triangle placed_triangle(Rng& rng, Shape shape, double area, int image) {
    PlaneTriangle plane = shaped_triangle(rng, shape);
    const double scale = std::sqrt(area / plane_area(plane));
    const double angle = 2 * std::acos(-1.0) * uniform_real(rng);
    constexpr double far = 1e9;
    PlanePoint low{far, far};
    PlanePoint high{-far, -far};
    for (PlanePoint& p : plane) {
        p = {scale * (p.x * std::cos(angle) - p.y * std::sin(angle)),
             scale * (p.x * std::sin(angle) + p.y * std::cos(angle))};
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double x = uniform_real(rng) * (image - (high.x - low.x)) - low.x;
    const double y = uniform_real(rng) * (image - (high.y - low.y)) - low.y;
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) {
        t[k] = {std::llround(256 * (plane[k].x + x)), std::llround(256 * (plane[k].y + y))};
    }
    return t;
}

/// How much of a packet a triangle fills.
struct PacketForm {
    bool linear = false;
    bool depth = true;
};

/// Packets of `count` triangles that cover a pixel. The channels' words are random: no clock depends on them.
inline std::vector<std::uint32_t> shaped_packets(Rng& rng, Shape shape, double area, int count,
                                                 const PacketForm& form) {
    constexpr int image = 1024;
    std::vector<std::uint32_t> packets;
    for (int drawn = 0; drawn < count;) {
        const Triangle t = placed_triangle(rng, shape, area, image);
        const auto walk = walk_triangle(t[0], t[1], t[2]);
        if (!walk) continue;
        TriangleSetup setup;
        setup.walk = *walk;
        setup.linear = form.linear;
        for (ChannelWords& channel : setup.colour) channel = random_channel(rng, form.linear);
        if (form.depth) setup.depth = random_channel(rng, true);
        append_triangle(packets, setup);
        ++drawn;
    }
    return packets;
}

}  // namespace sheen::test
