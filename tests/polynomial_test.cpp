// SPDX-License-Identifier: MIT
// Contract 1: every pixel is an exact polynomial. (Errata of paper `quadratic`: quadratic_errata_test.cpp.)
#include "sheen/polynomial.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/fits.hpp"
#include "support/fitted_setups.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 19861030;
constexpr int colour_bits = hls::colour_fraction_bits;

/// Start-edge and span registers of paper `quadratic`, figure 6, modulo 2^32 ("form A").
struct Registers {
    explicit Registers(const ChannelWords& channel)
        : i(channel.words[0]), d(channel.words[1]), e(channel.words[2]), constants(channel) {}
    void next_row(bool carry) {
        i += e;
        e += constants.words[5];
        d += constants.words[4];
        if (carry) {
            i += d;
            d += constants.words[3];
            e += constants.words[4];
        }
    }
    std::uint32_t i, d, e;
    ChannelWords constants;
};

TEST(Polynomial, SteppingEqualsTheClosedFormForArbitraryWords) {
    Rng rng(seed);
    for (int k = 0; k < 2000; ++k) {
        const ChannelWords channel = random_channel(rng, k % 5 == 0);
        Registers edge(channel);
        std::int64_t carries = 0;
        for (std::int64_t j = 0; j < 60; ++j) {
            std::uint32_t value = edge.i;
            std::uint32_t step = edge.d;
            for (std::int64_t pixel = 0; pixel < 20; ++pixel) {
                ASSERT_EQ(value, channel_value(channel, carries + pixel, j)) << "channel " << k << ", row " << j;
                value += step;
                step += channel.words[3];
            }
            const bool carry = uniform(rng, 0, 2) == 0;
            edge.next_row(carry);
            carries += carry;
        }
    }
}

/// The rounded coefficients, from their definition: round(T·2^22), for |T| below 2^104.
__int128 rounded(Coefficient t) {
    const Coefficient scaled = t * static_cast<Coefficient>(1 << colour_bits) + Coefficient{0.5};
    const auto whole = static_cast<__int128>(scaled);
    return static_cast<Coefficient>(whole) > scaled ? whole - 1 : whole;
}

/// Σ round(T·2^22)·monomial + ½ in plain integers, modulo 2^32 at the end.
std::uint32_t exact_word(const Polynomial& p, std::int64_t px, std::int64_t py) {
    using Wide = unsigned __int128;
    const auto x = static_cast<Wide>(static_cast<__int128>(px - p.origin_x));
    const auto y = static_cast<Wide>(static_cast<__int128>(py - p.origin_y));
    const std::array<Wide, 6> monomials{1, y, x, y * y, x * y, x * x};
    Wide sum = Wide{1} << (colour_bits - 1);
    for (std::size_t k = 0; k < 6; ++k) sum += static_cast<Wide>(rounded(p.t[k])) * monomials[k];
    return static_cast<std::uint32_t>(sum);
}

TEST(Polynomial, SixWordsReproduceTheRoundedPolynomialExactly) {
    Rng rng(seed + 1);
    int walks = 0;
    for (int k = 0; k < 6000; ++k) {
        const Triangle t = random_triangle(rng, k % 10 == 0 ? 4095 : 100);
        const auto walk = walk_triangle(t[0], t[1], t[2]);
        if (!walk) continue;
        ++walks;
        const Polynomial p = fit_quadratic(t, random_nodes(rng));
        const ChannelWords channel = channel_words(p, *walk, colour_bits, true);
        for_each_row(*walk, [&](const WalkRow& row) {
            for (const int pixel : {0, row.length / 2, row.length - 1}) {
                const int x = row.x + (walk->leftward ? -pixel : pixel);
                ASSERT_EQ(channel_value(channel, row.carries + pixel, row.row), exact_word(p, x, row.y))
                    << "triangle " << k << " pixel " << x << ", " << row.y;
            }
        });
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(walks, 2000);
}

struct ErrorClass {
    const char* name;
    int max_px;
    double min_slenderness;  ///< longest edge² / doubled area
};

TEST(Polynomial, PixelsStayWithinTheRoundingBoundOfTheTrueQuadratic) {
    Rng rng(seed + 2);
    constexpr double slack = 1e-6;  // of the oracle and of 113-bit coefficients, far below 2^−22·bound at any size
    for (const ErrorClass& c :
         {ErrorClass{"all shapes, 512 px", 512, 0}, ErrorClass{"all shapes, 1024 px", 1024, 0},
          ErrorClass{"slivers beyond 1e6, 1024 px", 1024, 1e6}, ErrorClass{"slivers beyond 1e6, 4095 px", 4095, 1e6}}) {
        double worst = 0.0;
        double worst_share = 0.0;
        std::size_t pixels = 0;
        int triangles = 0;
        for (int k = 0; triangles < 1000 && k < 1000000; ++k) {
            const Triangle any = random_triangle(rng, c.max_px);
            const Triangle t = c.min_slenderness > 0 ? sliver_through_centre(rng, any[0], c.max_px) : any;
            if (doubled_area(t[0], t[1], t[2]) == 0 || slenderness(t) < c.min_slenderness) continue;
            const auto walk = walk_triangle(t[0], t[1], t[2]);
            if (!walk) continue;
            ++triangles;
            const Nodes nodes = random_nodes(rng);
            const Polynomial p = fit_quadratic(t, nodes);
            const ChannelWords channel = channel_words(p, *walk, colour_bits, true);
            for_each_row(*walk, [&](const WalkRow& row) {
                for (const int eighth : {0, 1, 2, 3, 4, 5, 6, 7, 8}) {
                    if (row.length == 0) continue;
                    const int pixel = (row.length - 1) * eighth / 8;
                    const int x = row.x + (walk->leftward ? -pixel : pixel);
                    const double got = colour_of(channel_value(channel, row.carries + pixel, row.row)) - 0.5;
                    const double error = std::abs(got - quadratic_value(t, nodes, x, row.y));
                    const double bound = rounding_bound(p, x, row.y) + slack;
                    worst = std::max(worst, error);
                    worst_share = std::max(worst_share, error / bound);
                    ++pixels;
                }
            });
        }
        fmt::print("{:28}: {} triangles, {} pixels: max error {:.4f} steps of 8 bits, {:.3f} of the bound\n", c.name,
                   triangles, pixels, worst, worst_share);
        EXPECT_EQ(triangles, 1000) << c.name;
        EXPECT_LE(worst_share, 1.0) << c.name;
    }
}

/// Two triangles over one edge, its ends and the pixels tested on pixel centres.
TEST(Polynomial, NeighboursAgreeAlongTheirSharedEdge) {
    Rng rng(seed + 3);
    double worst = 0.0;
    std::size_t pixels = 0;
    for (int k = 0; k < 3000; ++k) {
        const std::int64_t parts = uniform(rng, 1, 500);
        const std::int64_t step_x = uniform(rng, -511 / parts, 511 / parts);
        const std::int64_t step_y = uniform(rng, -511 / parts, 511 / parts);
        const SnappedPoint a{256 * 512 + 128, 256 * 512 + 128};
        const SnappedPoint b{a.x + 256 * parts * step_x, a.y + 256 * parts * step_y};
        const auto third = [&] { return SnappedPoint{uniform(rng, 0, 256 * 1024), uniform(rng, 0, 256 * 1024)}; };
        const Triangle left{a, b, third()};
        const Triangle right{b, a, third()};
        const auto walk = walk_triangle(left[0], left[1], left[2]);
        const auto other_walk = walk_triangle(right[0], right[1], right[2]);
        if (!walk || !other_walk) continue;
        const Nodes nodes = random_nodes(rng);
        Nodes others = random_nodes(rng);
        others[0] = nodes[1];
        others[1] = nodes[0];
        others[3] = nodes[3];
        const Polynomial p = fit_quadratic(left, nodes);
        const Polynomial q = fit_quadratic(right, others);
        const ChannelWords channel = channel_words(p, *walk, colour_bits, true);
        const ChannelWords other = channel_words(q, *other_walk, colour_bits, true);
        for (std::int64_t n = 0; n <= parts; ++n) {
            const auto x = static_cast<int>(512 + n * step_x);
            const auto y = static_cast<int>(512 + n * step_y);
            const double jump =
                std::abs(colour_of(channel_at(channel, *walk, x, y)) - colour_of(channel_at(other, *other_walk, x, y)));
            ASSERT_LE(jump, rounding_bound(p, x, y) + rounding_bound(q, x, y) + 1e-6) << "pair " << k;
            worst = std::max(worst, jump);
            ++pixels;
        }
    }
    EXPECT_GT(pixels, 100000U);
    fmt::print("triangles in 1024 px: neighbours at most {:.4f} steps of 8 bits apart on {} pixels\n", worst, pixels);
}

TEST(Polynomial, AllSixNodesAreInterpolated) {
    Rng rng(seed + 4);
    for (int k = 0; k < 3000; ++k) {
        const Triangle t = triangle_on_centres(rng);
        if (doubled_area(t[0], t[1], t[2]) == 0) continue;
        const Nodes nodes = random_nodes(rng);
        expect_interpolates(fit_quadratic(t, nodes), t, nodes);
        const Polynomial linear = fit_linear(t, {nodes[0], nodes[1], nodes[2]});
        expect_interpolates(linear, t,
                            {nodes[0], nodes[1], nodes[2], (nodes[0] + nodes[1]) / 2, (nodes[1] + nodes[2]) / 2,
                             (nodes[2] + nodes[0]) / 2});
        if (HasFatalFailure()) return;
    }
}

TEST(Polynomial, AnyOriginInTheBoxGivesTheSameFunction) {
    Rng rng(seed + 7);
    for (int k = 0; k < 3000; ++k) {
        const Triangle t = random_triangle(rng, 4095);
        const auto walk = walk_triangle(t[0], t[1], t[2]);
        if (!walk) continue;
        const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
        const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
        const PixelIndex origin{static_cast<int>(uniform(rng, left / 256, right / 256)),
                                static_cast<int>(uniform(rng, top / 256, bottom / 256))};
        const Nodes nodes = random_nodes(rng);
        const Polynomial p = fit_quadratic(t, nodes, origin);
        EXPECT_EQ(p.origin_x, origin.x);
        EXPECT_EQ(p.origin_y, origin.y);
        for_each_span(*walk, [&](int x, int y, int length, int step) {
            for (const int px : {x, x + step * (length - 1)}) {
                ASSERT_NEAR(p.at(px, y), quadratic_value(t, nodes, px, y), 1.0 / (1 << 21)) << "triangle " << k;
            }
        });
        if (HasFatalFailure()) return;
    }
}

TEST(Polynomial, HugeCoefficientsAreReducedBeforeTheyBecomeIntegers) {
    const TriangleWalk walk;
    for (const double sign : {1.0, -1.0}) {
        for (const int power : {9, 10, 41, 42, 60, 80}) {  // 2^power·2^22 is a multiple of 2^32 from power 10 on
            Polynomial p;
            p.t[0] = static_cast<Coefficient>(sign * std::ldexp(1.0, power)) + Coefficient{0.25};
            const std::uint32_t fraction = 1U << (colour_bits - 2);
            const std::uint32_t whole = power == 9 ? 1U << 31 : 0;
            EXPECT_EQ(channel_words(p, walk, colour_bits, false).words[0], whole + fraction) << power;
            EXPECT_EQ(channel_words(p, walk, colour_bits, true).words[0], whole + 3 * fraction) << power;
        }
        Polynomial p;
        p.t[0] = static_cast<Coefficient>(sign * std::ldexp(1.0, 300));
        EXPECT_EQ(channel_words(p, walk, colour_bits, false).words[0], 0U);
    }
}

TEST(Polynomial, RoundingIsToNearest) {
    const TriangleWalk walk;
    const double lsb = std::ldexp(1.0, -colour_bits);
    for (const auto& [units, word] :
         {std::pair{0.49, 0}, {0.5, 1}, {1.49, 1}, {-0.49, 0}, {-0.51, -1}, {-1.49, -1}, {-1.51, -2}}) {
        Polynomial p;
        p.t[0] = units * lsb;
        EXPECT_EQ(static_cast<std::int32_t>(channel_words(p, walk, colour_bits, false).words[0]), word) << units;
    }
}

TEST(Polynomial, TheOriginIsTheMiddleOfTheBoundingBox) {
    const PixelIndex inside = centre_pixel({SnappedPoint{0, 0}, SnappedPoint{2560, 256}, SnappedPoint{100, 1024}});
    EXPECT_EQ(inside.x, 5);
    EXPECT_EQ(inside.y, 2);
    const PixelIndex outside = centre_pixel({SnappedPoint{-10, -300}, SnappedPoint{-1, -1}, SnappedPoint{-5, -700}});
    EXPECT_EQ(outside.x, -1);
    EXPECT_EQ(outside.y, -2);
}

TEST(Polynomial, TrianglesWithoutAreaAreConstant) {
    const Triangle t{SnappedPoint{0, 0}, SnappedPoint{256, 256}, SnappedPoint{512, 512}};
    EXPECT_DOUBLE_EQ(fit_quadratic(t, {1, 2, 3, 4, 5, 6}).at(100, 7), 3.5);
    EXPECT_DOUBLE_EQ(fit_linear(t, {1, 2, 6}).at(100, 7), 3.0);
}

}  // namespace
}  // namespace sheen::test
