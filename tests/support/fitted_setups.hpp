// SPDX-License-Identifier: MIT
/// \file
/// Random quadratics over random triangles: nodes, setups as the host would send them, and their true values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "random_triangles.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/method.hpp"
#include "sheen/polynomial.hpp"

namespace sheen::test {

/// Values at vertices 0, 1, 2 and at the midpoints of edges 01, 12, 20.
using Nodes = std::array<double, 6>;

/// Fits about the middle of the triangle's bounding box, as the host does for a triangle inside the image.
inline Polynomial fit_quadratic(const Triangle& t, const Nodes& nodes) {
    return sheen::fit_quadratic(t, nodes, centre_pixel(t));
}
inline Polynomial fit_linear(const Triangle& t, const std::array<double, 3>& values) {
    return sheen::fit_linear(t, values, centre_pixel(t));
}

/// Colours in 0…255 with fractions, often 0 or 255.
inline Nodes random_nodes(Rng& rng) {
    Nodes nodes{};
    for (double& node : nodes) {
        node = std::clamp(static_cast<double>(uniform(rng, -60000, 315000)) / 1000.0, 0.0, 255.0);
    }
    return nodes;
}

/// The quadratic through the nodes at the centre of pixel (x, y), from exact integer barycentric coordinates. Well
/// conditioned inside the triangle, whatever its shape: an error of about 1e-13 there.
inline double quadratic_value(const Triangle& t, const Nodes& nodes, std::int64_t x, std::int64_t y) {
    const SnappedPoint p{256 * x + 128, 256 * y + 128};
    const auto area = static_cast<double>(doubled_area(t[0], t[1], t[2]));
    const double a = static_cast<double>(doubled_area(t[1], t[2], p)) / area;
    const double b = static_cast<double>(doubled_area(t[2], t[0], p)) / area;
    const double c = static_cast<double>(doubled_area(t[0], t[1], p)) / area;
    return nodes[0] * a * (2 * a - 1) + nodes[1] * b * (2 * b - 1) + nodes[2] * c * (2 * c - 1) +
           4 * (nodes[3] * a * b + nodes[4] * b * c + nodes[5] * c * a);
}

/// The closed form at pixel (x, y), whether the walk reaches it or not.
inline std::uint32_t channel_at(const ChannelWords& channel, const TriangleWalk& walk, std::int64_t x, std::int64_t y) {
    const std::int64_t j = y - walk.y;
    const std::int64_t u = (walk.leftward ? -1 : 1) * (x - walk.x) - walk.kappa * j;
    return channel_value(channel, u, j);
}

/// A colour word as a number, in 8-bit steps.
inline double colour_of(std::uint32_t word) {
    return static_cast<double>(static_cast<std::int32_t>(word)) / (1 << hls::colour_fraction_bits);
}

/// A setup as the host sends it: random nodes fitted over the triangle, with depth. Nothing if no pixel is covered.
inline std::optional<TriangleSetup> fitted_setup(Rng& rng, const Triangle& t) {
    const auto walk = walk_triangle(t[0], t[1], t[2]);
    if (!walk) return std::nullopt;
    TriangleSetup setup;
    setup.walk = *walk;
    for (ChannelWords& channel : setup.colour) {
        channel = channel_words(fit_quadratic(t, random_nodes(rng)), *walk, hls::colour_fraction_bits, true);
    }
    const auto depth = [&] { return static_cast<double>(uniform(rng, 1, 65534)); };
    setup.depth = channel_words(fit_linear(t, {depth(), depth(), depth()}), *walk, hls::depth_fraction_bits, true);
    return setup;
}

}  // namespace sheen::test
