// SPDX-License-Identifier: MIT
// Contract 1: every pixel is an exact polynomial. Also the errata of paper `quadratic`: each test named Printed… fails
// when the printed formula replaces the corrected one.
#include "sheen/polynomial.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

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

/// Largest possible effect of rounding the six coefficients, X and Y pixels from the origin.
double rounding_bound(const Polynomial& p, int px, int py) {
    const double x = std::abs(px - p.origin_x);
    const double y = std::abs(py - p.origin_y);
    return 0.5 * (1 + x + y + x * x + x * y + y * y) / (1 << colour_bits);
}

struct ErrorClass {
    const char* name;
    int max_px;
    double min_slenderness;  ///< longest edge² / doubled area
};

double slenderness(const Triangle& t) {
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto dx = static_cast<double>(t[k].x - t[(k + 1) % 3].x);
        const auto dy = static_cast<double>(t[k].y - t[(k + 1) % 3].y);
        longest = std::max(longest, dx * dx + dy * dy);
    }
    return longest / std::abs(static_cast<double>(doubled_area(t[0], t[1], t[2])));
}

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

/// A triangle whose vertices and edge midpoints are pixel centres.
Triangle triangle_on_centres(Rng& rng) {
    Triangle t{};
    for (SnappedPoint& p : t) p = {256 * (2 * uniform(rng, 0, 60)) + 128, 256 * (2 * uniform(rng, 0, 60)) + 128};
    return t;
}

SnappedPoint middle(const SnappedPoint& a, const SnappedPoint& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

void expect_interpolates(const Polynomial& p, const Triangle& t, const Nodes& nodes) {
    const std::array<SnappedPoint, 6> points{
        t[0], t[1], t[2], middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
    for (std::size_t k = 0; k < 6; ++k) {
        const auto x = static_cast<int>(points[k].x / 256);
        const auto y = static_cast<int>(points[k].y / 256);
        ASSERT_NEAR(p.at(x, y), nodes[k], 1e-9) << "node " << k;
    }
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

/// T₃, T₄, T₅ as printed in paper `quadratic`, section 3, vertex 0 at the coordinate origin.
std::array<double, 3> printed_second_order(const Triangle& t, const Nodes& nodes) {
    const auto px = [&](std::size_t k) { return static_cast<double>(t[k].x - t[0].x) / 256; };
    const auto py = [&](std::size_t k) { return static_cast<double>(t[k].y - t[0].y) / 256; };
    const double x2 = px(1), y2 = py(1), x3 = px(2), y3 = py(2);
    const double i1 = nodes[0], i2 = nodes[1], i12 = nodes[3], i23 = nodes[4], i13 = nodes[5], i3 = nodes[2];
    const double c12 = i1 + i2 - 2 * i12, c13 = i1 + i3 - 2 * i13, c23 = 4 * i1 - 4 * i12 - 4 * i13 + 4 * i23;
    const double p = 2 * x2 * x2 * y3 - 2 * x2 * y2 * x3, q = 2 * y2 * x3 * x3 - 2 * x2 * x3 * y3;
    const double r = y2 * x3 * y3 - x2 * y3 * y3, s = x2 * y2 * y3 - y2 * y2 * x3;
    const double first = 4 * c13 * y2 - c23 * y3, second = 4 * c12 * y3 - c23 * y2;
    const double t4 = (first * p - second * q) / (p * r - s * q);
    const double t5 = (second * r - first * s) / (p * r - s * q);
    return {(2 * c12 - t5 * x2 * x2 - t4 * x2 * y2) / (y2 * y2), t4, t5};
}

TEST(Polynomial, PrintedCoefficientsAreRightButSingularOnHorizontalEdges) {
    Rng rng(seed + 5);
    int agreeing = 0;
    for (int k = 0; k < 3000; ++k) {
        Triangle t = triangle_on_centres(rng);
        const bool horizontal = k % 2 == 0;
        if (horizontal) t[1].y = t[0].y;
        if (doubled_area(t[0], t[1], t[2]) == 0) continue;
        const Nodes nodes = random_nodes(rng);
        const Polynomial p = fit_quadratic(t, nodes);
        const auto printed = printed_second_order(t, nodes);
        if (horizontal) {
            ASSERT_FALSE(std::isfinite(printed[0])) << "the printed T3 divides by Y2²";
            expect_interpolates(p, t, nodes);
            if (HasFatalFailure()) return;
        } else if (std::isfinite(printed[1]) && t[1].y != t[0].y) {
            const double scale = 255 * slenderness(t) * slenderness(t);
            for (std::size_t c = 0; c < 3; ++c) {
                ASSERT_NEAR(static_cast<double>(p.t[3 + c]), printed[c], 1e-9 * scale) << "T" << 3 + c;
            }
            ++agreeing;
        }
    }
    EXPECT_GT(agreeing, 1000);
}

/// Erratum: the printed start edge steps A = dx/dy pixels a row and so samples the colour at a fractional X.
TEST(Polynomial, PrintedRealStepsMissPixelCentresWholeStepsDoNot) {
    Rng rng(seed + 6);
    double printed_worst = 0.0;
    double worst = 0.0;
    for (int k = 0; k < 300; ++k) {
        const Triangle t = random_triangle(rng, 100);
        if (doubled_area(t[0], t[1], t[2]) == 0 || slenderness(t) > 20) continue;
        const auto walk = walk_triangle(t[0], t[1], t[2]);
        if (!walk) continue;
        const Nodes nodes = random_nodes(rng);
        const Polynomial p = fit_quadratic(t, nodes);
        const ChannelWords channel = channel_words(p, *walk, colour_bits, true);
        Triangle sorted = t;
        std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
        const double slope =
            static_cast<double>(sorted[2].x - sorted[0].x) / static_cast<double>(sorted[2].y - sorted[0].y);
        for_each_row(*walk, [&](const WalkRow& row) {
            if (row.length == 0) return;
            const double truth = quadratic_value(t, nodes, row.x, row.y);
            // What the printed algorithm writes at this row's first pixel: the value at x₀ + A·j, not at its centre.
            const double real_x = walk->x + slope * row.row - p.origin_x;
            const double y = row.y - p.origin_y;
            std::array<double, 6> c{};
            std::transform(p.t.begin(), p.t.end(), c.begin(), [](Coefficient v) { return static_cast<double>(v); });
            const double printed = (c[5] * real_x + c[4] * y + c[2]) * real_x + (c[3] * y + c[1]) * y + c[0];
            printed_worst = std::max(printed_worst, std::abs(printed - truth));
            worst = std::max(worst, std::abs(colour_of(channel_value(channel, row.carries, row.row)) - 0.5 - truth));
        });
    }
    fmt::print("start edge: whole steps {:.4f}, printed real steps {:.1f} steps of 8 bits off\n", worst, printed_worst);
    EXPECT_LE(worst, 0.01);
    EXPECT_GT(printed_worst, 10.0);
}

/// Erratum: b > log₂M fraction bits bound one chain of M additions; rounded second differences add up twice.
TEST(Polynomial, PrintedFractionBitsAreTooFewForSecondDifferences) {
    constexpr int span = 512;
    constexpr int printed_bits = 10;  // > log₂ 512
    TriangleWalk walk;
    Polynomial p;
    const double t5 = 0.43 / (1 << printed_bits);
    p.t[2] = -0.215;
    p.t[5] = t5;
    const ChannelWords coarse = channel_words(p, walk, printed_bits, false);
    const ChannelWords fine = channel_words(p, walk, colour_bits, false);
    const auto value = [](const ChannelWords& c, int bits) {
        return static_cast<double>(static_cast<std::int32_t>(channel_value(c, span, 0))) / (1 << bits);
    };
    EXPECT_GT(std::abs(value(coarse, printed_bits) - p.at(span, 0)), 50.0);
    EXPECT_LE(std::abs(value(fine, colour_bits) - p.at(span, 0)), rounding_bound(p, span, 0));
}

TEST(Polynomial, MovingTheOriginKeepsTheFunction) {
    Rng rng(seed + 7);
    for (int k = 0; k < 3000; ++k) {
        const Triangle t = random_triangle(rng, 4095);
        if (doubled_area(t[0], t[1], t[2]) == 0) continue;
        const Nodes nodes = random_nodes(rng);
        const auto x = static_cast<int>(uniform(rng, -5000, 5000));
        const auto y = static_cast<int>(uniform(rng, -5000, 5000));
        const Polynomial p = fit_quadratic(t, nodes);
        const Polynomial moved = p.recentred(x, y);
        EXPECT_EQ(moved.origin_x, x);
        EXPECT_EQ(moved.origin_y, y);
        const auto walk = walk_triangle(t[0], t[1], t[2]);
        if (walk) {
            ASSERT_NEAR(moved.at(walk->x, walk->y), p.at(walk->x, walk->y), 1e-6);
        }
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
