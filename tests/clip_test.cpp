// SPDX-License-Identifier: MIT
// Clipping to the image: what is left is the triangle, in the image, in disjoint pieces, without cracks between
// neighbours. Coverage is judged by oracles that share no code with clipping or walking.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sheen/scene.hpp"
#include "support/coverage_oracle.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 7003;
constexpr int width = 14;
constexpr int height = 10;
constexpr std::int64_t right = 256 * width;
constexpr std::int64_t bottom = 256 * height;

class Points {
 public:
    /// A point in or around the image: anywhere, on the half-pixel grid (edges through centres), or on its border
    /// lines.
    SnappedPoint operator()(std::int64_t margin = 256 * 12) {
        const SnappedPoint p{within(-margin, right + margin), within(-margin, bottom + margin)};
        switch (within(0, 3)) {
            case 0:
                return {p.x / 128 * 128, p.y / 128 * 128};
            case 1:
                return within(0, 1) == 0 ? SnappedPoint{within(0, 1) * right, p.y}
                                         : SnappedPoint{p.x, within(0, 1) * bottom};
            default:
                return p;
        }
    }
    std::int64_t within(std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
    }
    Triangle triangle() { return {(*this)(), (*this)(), (*this)()}; }
    /// Long and at most a few units thin.
    Triangle sliver() {
        const SnappedPoint a = (*this)();
        const SnappedPoint b = (*this)();
        const std::int64_t t = within(0, 256);
        return {a, b, {a.x + (b.x - a.x) * t / 256 + within(-3, 3), a.y + (b.y - a.y) * t / 256 + within(-3, 3)}};
    }

 private:
    std::mt19937_64 random_{seed};
};

std::string text(const Triangle& t) {
    return fmt::format("seed {}: ({}, {}) ({}, {}) ({}, {})", seed, t[0].x, t[0].y, t[1].x, t[1].y, t[2].x, t[2].y);
}

int count_covering(const std::vector<std::array<SnappedPoint, 3>>& pieces, int x, int y) {
    int count = 0;
    for (const auto& piece : pieces) {
        count += moved_sample_covers(piece, x, y) ? 1 : 0;
    }
    return count;
}

/// True when the centre of pixel (x, y) is more than one unit (1/256 px) from the line a, b.
bool clear_of_line(const SnappedPoint& a, const SnappedPoint& b, int x, int y) {
    const double length = std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
    return std::abs(static_cast<double>(cross(a, b, pixel_centre(x, y)))) > length;
}

template <typename Body>
void for_each_pixel(Body body) {
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            body(x, y);
        }
    }
}

/// True when an edge of `a` has all of `b` on its outer side; both turn clockwise (`sign` 1) or both the other way.
bool separates(const Triangle& a, const Triangle& b, std::int64_t sign) {
    for (std::size_t k = 0; k < 3; ++k) {
        const auto outside = [&](const SnappedPoint& p) { return sign * cross(a[k], a[(k + 1) % 3], p) <= 0; };
        if (outside(b[0]) && outside(b[1]) && outside(b[2])) {
            return true;
        }
    }
    return false;
}

void expect_faithful(const Triangle& t) {
    const auto pieces = clip_to_image(t, width, height);
    const std::int64_t sign = doubled_area(t[0], t[1], t[2]) > 0 ? 1 : -1;
    for (const auto& piece : pieces) {
        for (const SnappedPoint& p : piece) {
            EXPECT_TRUE(p.x >= 0 && p.x <= right && p.y >= 0 && p.y <= bottom) << p.x << ", " << p.y << ", " << text(t);
        }
        EXPECT_TRUE(doubled_area(piece[0], piece[1], piece[2]) * sign > 0) << text(t);
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t k = i + 1; k < pieces.size(); ++k) {
            EXPECT_TRUE(separates(pieces[i], pieces[k], sign) || separates(pieces[k], pieces[i], sign))
                << "pieces " << i << " and " << k << " overlap, " << text(t);
        }
    }
    for_each_pixel([&](int x, int y) {
        const int count = count_covering(pieces, x, y);
        EXPECT_LE(count, 1) << "pixel " << x << ", " << y << " of " << text(t);
        if (clear_of_line(t[0], t[1], x, y) && clear_of_line(t[1], t[2], x, y) && clear_of_line(t[2], t[0], x, y)) {
            EXPECT_EQ(count, moved_sample_covers(t, x, y) ? 1 : 0) << "pixel " << x << ", " << y << " of " << text(t);
        }
    });
}

TEST(Clip, PiecesAreTheTriangleInTheImage) {
    Points points;
    for (int i = 0; i < 20000; ++i) {
        expect_faithful(points.triangle());
    }
}

TEST(Clip, SliversKeepTheirPiecesDisjoint) {
    Points points;
    for (int i = 0; i < 20000; ++i) {
        expect_faithful(points.sliver());
    }
}

TEST(Clip, TwoTrianglesSharingAnEdgeCoverEachPixelOnce) {
    Points points;
    int pairs = 0;
    while (pairs < 20000) {
        const SnappedPoint a = points();
        const SnappedPoint b = points();
        const SnappedPoint c = points();
        const SnappedPoint d = points();
        if (cross(a, b, c) <= 0 || cross(a, b, d) >= 0) {
            continue;
        }
        ++pairs;
        const auto left = clip_to_image({a, b, c}, width, height);
        const auto other = clip_to_image({a, d, b}, width, height);
        for_each_pixel([&](int x, int y) {
            const int count = count_covering(left, x, y) + count_covering(other, x, y);
            ASSERT_LE(count, 1) << "pixel " << x << ", " << y << " of " << text({a, b, c}) << " and "
                                << text({a, d, b});
            const bool clear_of_outline = clear_of_line(a, c, x, y) && clear_of_line(c, b, x, y) &&
                                          clear_of_line(a, d, x, y) && clear_of_line(d, b, x, y);
            if (clear_of_outline) {
                const bool inside = moved_sample_covers({a, b, c}, x, y) || moved_sample_covers({a, d, b}, x, y);
                ASSERT_EQ(count, inside ? 1 : 0)
                    << "pixel " << x << ", " << y << " of " << text({a, b, c}) << " and " << text({a, d, b});
            }
        });
    }
}

TEST(Clip, AFanAroundAnyPointCoversTheWholeImageOnce) {
    Points points;
    for (int i = 0; i < 5000; ++i) {
        // The rim is a circle well outside the image; the hub lies in or around the image.
        const SnappedPoint hub = points(256 * 4);
        constexpr int spokes = 9;
        std::array<SnappedPoint, spokes> rim{};
        const double turn = static_cast<double>(points.within(0, 1000)) / 1000.0;
        for (int s = 0; s < spokes; ++s) {
            const double angle = 2.0 * std::acos(-1.0) * (s + turn) / spokes;
            rim[static_cast<std::size_t>(s)] = {right / 2 + std::llround(256 * 40 * std::cos(angle)),
                                                bottom / 2 + std::llround(256 * 40 * std::sin(angle))};
        }
        std::vector<std::array<SnappedPoint, 3>> pieces;
        for (std::size_t s = 0; s < spokes; ++s) {
            const auto clipped = clip_to_image({hub, rim[s], rim[(s + 1) % spokes]}, width, height);
            pieces.insert(pieces.end(), clipped.begin(), clipped.end());
        }
        for_each_pixel([&](int x, int y) {
            ASSERT_EQ(count_covering(pieces, x, y), 1)
                << "pixel " << x << ", " << y << ", hub " << hub.x << ", " << hub.y << ", seed " << seed;
        });
    }
}

TEST(Clip, ACrossingIsRoundedToNearestWhicheverWayTheEdgeRuns) {
    Points points;
    int crossings = 0;
    for (int i = 0; i < 20000; ++i) {
        // An edge that leaves through the left side only, in both directions.
        const SnappedPoint inside{points.within(1, right), points.within(1, bottom - 1)};
        const SnappedPoint outside{-points.within(1, 4000), points.within(1, bottom - 1)};
        const SnappedPoint third{inside.x, points.within(0, 1) * bottom};
        const double expected =
            static_cast<double>(outside.y) +
            static_cast<double>((inside.y - outside.y) * -outside.x) / static_cast<double>(inside.x - outside.x);
        for (const Triangle& t : {Triangle{inside, outside, third}, Triangle{outside, inside, third}}) {
            double nearest = 1e9;
            for (const auto& piece : clip_to_image(t, width, height)) {
                for (const SnappedPoint& p : piece) {
                    if (p.x == 0) {
                        nearest = std::min(nearest, std::abs(static_cast<double>(p.y) - expected));
                    }
                }
            }
            if (nearest < 1e9) {
                EXPECT_LE(nearest, 0.5 + 1e-9) << text(t);
                ++crossings;
            }
        }
    }
    EXPECT_GT(crossings, 30000);
}

TEST(Clip, ATriangleInsideIsItsOwnPieceAndOneOutsideOrWithoutAreaLeavesNone) {
    const Triangle inside{{{0, 0}, {right, 0}, {0, bottom}}};
    EXPECT_EQ(clip_to_image(inside, width, height), std::vector<Triangle>{inside});
    EXPECT_TRUE(clip_to_image({{{-900, 10}, {-1, 2000}, {-1, 10}}}, width, height).empty());
    EXPECT_TRUE(clip_to_image({{{right, 0}, {right + 9, 0}, {right, bottom}}}, width, height).empty()) << "touches";
    EXPECT_TRUE(clip_to_image({{{-512, -512}, {256, 256}, {1024, 1024}}}, width, height).empty()) << "no area";
}

TEST(Clip, TheGreatestCoordinatesDoNotOverflow) {
    constexpr std::int64_t far = std::int64_t{1} << 29;
    const Triangle t{{{-far, -far + 1}, {far, -far}, {1, far}}};
    const auto pieces = clip_to_image(t, width, height);
    for_each_pixel([&](int x, int y) { EXPECT_EQ(count_covering(pieces, x, y), 1) << "pixel " << x << ", " << y; });
}

}  // namespace
}  // namespace sheen::test
