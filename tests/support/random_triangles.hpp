// SPDX-License-Identifier: MIT
/// \file
/// Random triangles of many shapes, and random setups, for tests. The same seed gives the same sequence everywhere.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "sheen/method.hpp"
#include "sheen/raster.hpp"

namespace sheen::test {

using Rng = std::mt19937_64;
using Triangle = std::array<SnappedPoint, 3>;

/// Uniform in low…high. (std::uniform_int_distribution is not the same in every library.)
inline std::int64_t uniform(Rng& rng, std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(rng() % static_cast<std::uint64_t>(high - low + 1));
}

/// A square of side 1…max_px pixels (log-uniform) inside [0, max_px]², in 1/256 px.
struct Window {
    std::int64_t left, top, side;
};

inline Window random_window(Rng& rng, int max_px) {
    const double exponent = static_cast<double>(uniform(rng, 0, 1000)) / 1000.0;
    const std::int64_t limit = std::int64_t{256} * max_px;
    const auto side = std::clamp(static_cast<std::int64_t>(256.0 * std::pow(max_px, exponent)), std::int64_t{2}, limit);
    return {uniform(rng, 0, limit - side), uniform(rng, 0, limit - side), side};
}

inline SnappedPoint random_point(Rng& rng, const Window& w) {
    return {w.left + uniform(rng, 0, w.side), w.top + uniform(rng, 0, w.side)};
}

/// The point moved to a multiple of 256 plus `offset`, inside the window's image.
inline SnappedPoint on_grid(const SnappedPoint& p, std::int64_t offset, int max_px) {
    const auto snap = [&](std::int64_t v) { return std::min(v / 256, std::int64_t{max_px} - 1) * 256 + offset; };
    return {snap(p.x), snap(p.y)};
}

/// A point within three subpixels of segment a–b, inside [0, max_px]².
inline SnappedPoint near_segment(Rng& rng, const SnappedPoint& a, const SnappedPoint& b, int max_px) {
    const std::int64_t t = uniform(rng, 0, 1 << 20);
    const auto blend = [&](std::int64_t from, std::int64_t to) {
        return std::clamp(from + (to - from) * t / (1 << 20) + uniform(rng, -3, 3), std::int64_t{0},
                          std::int64_t{256} * max_px);
    };
    return {blend(a.x, b.x), blend(a.y, b.y)};
}

/// A sliver whose longest edge, or a line next to it, runs through the pixel centre nearest to `through`: the most
/// extreme shapes that still cover pixels. Its doubled area is a few units of (1/256 px)² per lattice point on the
/// edge.
inline Triangle sliver_through_centre(Rng& rng, const SnappedPoint& through, int max_px) {
    const SnappedPoint centre = on_grid(through, 128, max_px);
    SnappedPoint step{uniform(rng, -40, 40), uniform(rng, -40, 40)};
    if (step == SnappedPoint{0, 0}) step = {1, 2};
    // As far along ±step as the image allows.
    const auto reach = [&](std::int64_t sign) {
        const auto along = [&](std::int64_t from, std::int64_t by) {
            const std::int64_t limit = std::int64_t{256} * max_px;
            return by > 0 ? (limit - from) / by : by < 0 ? from / -by : limit;
        };
        return std::min(along(centre.x, sign * step.x), along(centre.y, sign * step.y));
    };
    const std::int64_t back = uniform(rng, 0, reach(-1));
    const std::int64_t ahead = uniform(rng, 1, std::max(reach(1), std::int64_t{1}));
    const SnappedPoint a{centre.x - back * step.x, centre.y - back * step.y};
    const SnappedPoint b{centre.x + ahead * step.x, centre.y + ahead * step.y};
    return {a, b, {centre.x + uniform(rng, -1, 1), centre.y + uniform(rng, -1, 1)}};
}

/// A triangle in [0, 256·max_px]², max_px ≤ 4095, in any winding: general, with vertices on pixel centres, corners or
/// edges, slivers along their longest edge, needles, with horizontal or vertical edges. It may cover no pixel and
/// may have no area.
inline Triangle random_triangle(Rng& rng, int max_px) {
    const Window window = random_window(rng, max_px);
    Triangle t{random_point(rng, window), random_point(rng, window), random_point(rng, window)};
    switch (uniform(rng, 0, 9)) {
        case 0:
            for (SnappedPoint& p : t) p = on_grid(p, 128, max_px);  // pixel centres
            break;
        case 1:
            for (SnappedPoint& p : t) p = on_grid(p, 0, max_px);  // pixel corners
            break;
        case 2:
            for (SnappedPoint& p : t) p.y = on_grid(p, 128, max_px).y;  // on the rows' centre lines
            break;
        case 3:
            for (SnappedPoint& p : t) p.x = on_grid(p, 0, max_px).x;  // on pixel edges
            break;
        case 4:
            t[2] = near_segment(rng, t[0], t[1], max_px);
            break;
        case 5:
            t = sliver_through_centre(rng, t[0], max_px);
            break;
        case 6:
            t[2] = near_segment(rng, t[0], t[0], max_px);  // needle
            break;
        case 7:
            t[1].y = t[0].y;
            break;
        case 8:
            t[1].x = t[0].x;
            break;
        default:
            break;
    }
    std::shuffle(t.begin(), t.end(), rng);
    return t;
}

/// Any 32 bits, with runs of zeros and ones more likely than by chance.
inline std::uint32_t random_word(Rng& rng) {
    const auto word = static_cast<std::uint32_t>(rng());
    switch (uniform(rng, 0, 5)) {
        case 0:
            return word & static_cast<std::uint32_t>(rng() & rng());
        case 1:
            return static_cast<std::uint32_t>(static_cast<std::int32_t>(word) >> uniform(rng, 0, 31));
        default:
            return word;
    }
}

/// A walk of arbitrary words: fields anywhere in 0…4095, phases anywhere; at most max_rows rows a part.
inline TriangleWalk random_walk(Rng& rng, int max_rows) {
    const auto field = [&] { return static_cast<int>(uniform(rng, 0, 4095)); };
    const auto small = [&] { return static_cast<int>(uniform(rng, 0, 1) == 0 ? uniform(rng, -3, 3) : field()); };
    TriangleWalk walk;
    walk.x = field();
    walk.y = field();
    walk.rows_above = static_cast<int>(uniform(rng, 0, max_rows));
    walk.rows_below = static_cast<int>(uniform(rng, 0, max_rows));
    walk.kappa = small();
    walk.length = small() & 4095;
    walk.m = small();
    walk.length_reload = small() & 4095;
    walk.m_below = small();
    walk.leftward = uniform(rng, 0, 1) == 1;
    for (EdgePhase* edge : {&walk.long_edge, &walk.upper, &walk.lower}) *edge = {random_word(rng), random_word(rng)};
    return walk;
}

/// Six arbitrary words; three when `linear` (the rest 0).
inline ChannelWords random_channel(Rng& rng, bool linear) {
    ChannelWords channel;
    for (std::size_t k = 0; k < (linear ? 3U : 6U); ++k) channel.words[k] = random_word(rng);
    return channel;
}

/// Arbitrary channels over the given walk, without log channels; linear and depth at random.
inline TriangleSetup random_channels(Rng& rng, const TriangleWalk& walk) {
    TriangleSetup setup;
    setup.walk = walk;
    setup.linear = uniform(rng, 0, 1) == 1;
    for (ChannelWords& channel : setup.colour) channel = random_channel(rng, setup.linear);
    if (uniform(rng, 0, 1) == 1) setup.depth = random_channel(rng, true);
    return setup;
}

/// A setup of arbitrary words: what a device must draw though no host would send it.
inline TriangleSetup random_setup(Rng& rng, int max_rows) { return random_channels(rng, random_walk(rng, max_rows)); }

}  // namespace sheen::test
