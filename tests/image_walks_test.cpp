// SPDX-License-Identifier: MIT
// What the image leaves of a triangle: exactly the pixels that the whole triangle covers, however its edges leave the
// image, and so each pixel once along every shared edge. The oracle judges the unclipped triangle and shares no code
// with the walks.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "support/coverage_oracle.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 7003;
constexpr int width = 14;
constexpr int height = 10;
constexpr std::int64_t right = 256 * width;
constexpr std::int64_t bottom = 256 * height;
constexpr std::int64_t margin = 256 * 12;

using Coverage = std::map<std::pair<int, int>, int>;  ///< pixel → how often

/// A point in or around the image: anywhere, on the half-pixel grid (edges through centres), or on its border lines.
SnappedPoint any_point(Rng& rng) {
    const SnappedPoint p{uniform(rng, -margin, right + margin), uniform(rng, -margin, bottom + margin)};
    switch (uniform(rng, 0, 3)) {
        case 0:
            return {p.x / 128 * 128, p.y / 128 * 128};
        case 1:
            return uniform(rng, 0, 1) == 0 ? SnappedPoint{uniform(rng, 0, 1) * right, p.y}
                                           : SnappedPoint{p.x, uniform(rng, 0, 1) * bottom};
        default:
            return p;
    }
}

/// Long and at most a few units thin, often through a pixel's centre.
Triangle any_sliver(Rng& rng) {
    const SnappedPoint centre = pixel_centre(uniform(rng, 0, width - 1), uniform(rng, 0, height - 1));
    const SnappedPoint step{uniform(rng, -700, 700), uniform(rng, -700, 700)};
    const auto along = [&](std::int64_t steps, std::int64_t off) {
        return SnappedPoint{centre.x + steps * step.x + uniform(rng, -off, off),
                            centre.y + steps * step.y + uniform(rng, -off, off)};
    };
    const std::int64_t off = uniform(rng, 0, 2);
    return {along(uniform(rng, -9, -1), off), along(uniform(rng, 1, 9), off), along(uniform(rng, -9, 9), 1)};
}

std::string text(const Triangle& t) {
    return fmt::format("seed {}: ({}, {}) ({}, {}) ({}, {})", seed, t[0].x, t[0].y, t[1].x, t[1].y, t[2].x, t[2].y);
}

/// Adds the pixels of the triangle's walks; those outside the image fail.
void add_coverage(Coverage& coverage, const Triangle& t, int image_width = width, int image_height = height) {
    for (const TriangleWalk& walk : walk_in_image(t[0], t[1], t[2], image_width, image_height)) {
        for_each_span(walk, [&](int x, int y, int length, int step) {
            for (int k = 0; k < length; ++k, x += step) {
                ASSERT_TRUE(x >= 0 && x < image_width && y >= 0 && y < image_height)
                    << x << ", " << y << ", " << text(t);
                ++coverage[{x, y}];
            }
        });
    }
}

/// The pixels are the whole triangle's, each once.
void expect_exact(const Triangle& t) {
    Coverage coverage;
    add_coverage(coverage, t);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            ASSERT_EQ((coverage[{x, y}]), moved_sample_covers(t, x, y) ? 1 : 0)
                << "pixel " << x << ", " << y << " of " << text(t);
        }
    }
}

TEST(ImageWalks, CoverWhatTheWholeTriangleCoversInTheImage) {
    Rng rng(seed);
    for (int i = 0; i < 30000 && !testing::Test::HasFatalFailure(); ++i) {
        expect_exact({any_point(rng), any_point(rng), any_point(rng)});
    }
}

TEST(ImageWalks, CoverWhatAWholeSliverCoversInTheImage) {
    Rng rng(seed + 1);
    for (int i = 0; i < 60000 && !testing::Test::HasFatalFailure(); ++i) expect_exact(any_sliver(rng));
}

/// Three triangles around a sliver: whatever the border cuts off, nothing beside it is drawn twice or left out.
TEST(ImageWalks, NeighboursOfSliversAcrossTheBorderCoverEachPixelOnce) {
    Rng rng(seed + 2);
    int meshes = 0;
    int covered = 0;
    while (meshes < 20000) {
        Triangle sliver = any_sliver(rng);
        const std::int64_t area = cross(sliver[0], sliver[1], sliver[2]);
        if (area == 0) continue;
        if (area < 0) std::swap(sliver[1], sliver[2]);
        std::vector<Triangle> mesh{sliver};
        for (std::size_t k = 0; k < 3; ++k) {
            const Triangle neighbour{sliver[(k + 1) % 3], sliver[k], any_point(rng)};
            // Neighbours on the same side of their edges as the mesh asks: they don't overlap along them.
            if (cross(neighbour[0], neighbour[1], neighbour[2]) > 0) mesh.push_back(neighbour);
        }
        ++meshes;
        Coverage coverage;
        for (const Triangle& t : mesh) add_coverage(coverage, t);
        for (const auto& [pixel, count] : coverage) {
            int expected = 0;
            for (const Triangle& t : mesh) expected += moved_sample_covers(t, pixel.first, pixel.second) ? 1 : 0;
            ASSERT_EQ(count, expected) << "pixel " << pixel.first << ", " << pixel.second << " by " << text(sliver);
            covered += count;
        }
    }
    EXPECT_GT(covered, 100000);
}

TEST(ImageWalks, PairsSharingAnEdgeAcrossTheBorderCoverEachPixelOnce) {
    Rng rng(seed + 3);
    int pairs = 0;
    while (pairs < 100000) {
        const Triangle thin = any_sliver(rng);
        const bool slim = uniform(rng, 0, 1) == 1;
        const SnappedPoint a = slim ? thin[0] : any_point(rng);
        const SnappedPoint b = slim ? thin[1] : any_point(rng);
        const SnappedPoint c = slim ? thin[2] : any_point(rng);
        const SnappedPoint d = any_point(rng);
        if (cross(a, b, c) * cross(a, b, d) >= 0) continue;
        ++pairs;
        Coverage coverage;
        add_coverage(coverage, {a, b, c});
        add_coverage(coverage, {a, d, b});
        const std::vector<SnappedPoint> outline{a, c, b, d};
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                ASSERT_EQ((coverage[{x, y}]), polygon_covers(outline, x, y) ? 1 : 0)
                    << "pixel " << x << ", " << y << " of " << text({a, b, c}) << " and " << text({a, d, b});
            }
        }
    }
}

TEST(ImageWalks, AFanAroundAnyPointCoversTheWholeImageOnce) {
    Rng rng(seed + 4);
    for (int i = 0; i < 3000; ++i) {
        // The rim is a circle well outside the image; the hub lies in or around the image.
        const SnappedPoint hub{uniform(rng, -1024, right + 1024), uniform(rng, -1024, bottom + 1024)};
        constexpr int spokes = 9;
        std::array<SnappedPoint, spokes> rim{};
        const double turn = static_cast<double>(uniform(rng, 0, 1000)) / 1000.0;
        for (int s = 0; s < spokes; ++s) {
            const double angle = 2.0 * std::acos(-1.0) * (s + turn) / spokes;
            rim[static_cast<std::size_t>(s)] = {right / 2 + std::llround(256 * 40 * std::cos(angle)),
                                                bottom / 2 + std::llround(256 * 40 * std::sin(angle))};
        }
        Coverage coverage;
        for (std::size_t s = 0; s < spokes; ++s) add_coverage(coverage, {hub, rim[s], rim[(s + 1) % spokes]});
        ASSERT_EQ(coverage.size(), static_cast<std::size_t>(width * height)) << "hub " << hub.x << ", " << hub.y;
        for (const auto& [pixel, count] : coverage) {
            ASSERT_EQ(count, 1) << "pixel " << pixel.first << ", " << pixel.second << ", hub " << hub.x << ", "
                                << hub.y;
        }
    }
}

TEST(ImageWalks, ATriangleInsideIsOneWalkAndOneOutsideOrWithoutAreaNone) {
    Rng rng(seed + 5);
    for (int i = 0; i < 20000; ++i) {
        const Triangle t = random_triangle(rng, 100);
        const std::size_t expected = walk_triangle(t[0], t[1], t[2]) ? 1 : 0;
        ASSERT_EQ(walk_in_image(t[0], t[1], t[2], 100, 100).size(), expected) << text(t);
    }
    EXPECT_TRUE(walk_in_image({-900, 10}, {-1, 2000}, {-1, 10}, width, height).empty());
    EXPECT_TRUE(walk_in_image({right, 0}, {right + 9000, 0}, {right, bottom}, width, height).empty()) << "touches";
    EXPECT_TRUE(walk_in_image({-512, -512}, {256, 256}, {1024, 1024}, width, height).empty()) << "no area";
}

/// Edges so high that a phase accumulator can't follow them over the whole image, through a pixel centre every few
/// rows.
TEST(ImageWalks, TheGreatestCoordinatesStayExactDownTheHighestImage) {
    Rng rng(seed + 6);
    constexpr std::int64_t far = std::int64_t{1} << 29;
    constexpr int narrow = 12;
    constexpr int tall = 4095;
    for (int i = 0; i < 20; ++i) {
        const SnappedPoint centre = pixel_centre(uniform(rng, 0, narrow - 1), uniform(rng, 0, 40));
        const SnappedPoint step{256 * (2 * uniform(rng, 0, 1) - 1), 256 * uniform(rng, 300, 900)};
        const std::int64_t steps = (far - (1 << 20)) / step.y;
        const Triangle t{SnappedPoint{centre.x - steps * step.x, centre.y - steps * step.y},
                         SnappedPoint{centre.x + steps * step.x, centre.y + steps * step.y},
                         SnappedPoint{uniform(rng, 0, 1) == 0 ? -far : far, uniform(rng, -far, far)}};
        Coverage coverage;
        add_coverage(coverage, t, narrow, tall);
        for (int y = 0; y < tall; ++y) {
            for (int x = 0; x < narrow; ++x) {
                ASSERT_EQ((coverage[{x, y}]), moved_sample_covers(t, x, y) ? 1 : 0)
                    << x << ", " << y << ", " << text(t);
            }
        }
    }
}

}  // namespace
}  // namespace sheen::test
