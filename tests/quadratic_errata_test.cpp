// SPDX-License-Identifier: MIT
// Errata of paper `quadratic`: each test fails when the printed formula replaces the corrected one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/fits.hpp"
#include "support/fitted_setups.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 20030601;

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

TEST(QuadraticErrata, PrintedCoefficientsAreRightButSingularOnHorizontalEdges) {
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
TEST(QuadraticErrata, PrintedRealStepsMissPixelCentresWholeStepsDoNot) {
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
        const ChannelWords channel = channel_words(p, *walk, hls::colour_fraction_bits, true);
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
TEST(QuadraticErrata, PrintedFractionBitsAreTooFewForSecondDifferences) {
    constexpr int span = 512;
    constexpr int printed_bits = 10;  // > log₂ 512
    TriangleWalk walk;
    Polynomial p;
    const double t5 = 0.43 / (1 << printed_bits);
    p.t[2] = -0.215;
    p.t[5] = t5;
    const ChannelWords coarse = channel_words(p, walk, printed_bits, false);
    const ChannelWords fine = channel_words(p, walk, hls::colour_fraction_bits, false);
    const auto value = [](const ChannelWords& c, int bits) {
        return static_cast<double>(static_cast<std::int32_t>(channel_value(c, span, 0))) / (1 << bits);
    };
    EXPECT_GT(std::abs(value(coarse, printed_bits) - p.at(span, 0)), 50.0);
    EXPECT_LE(std::abs(value(fine, hls::colour_fraction_bits) - p.at(span, 0)), rounding_bound(p, span, 0));
}

}  // namespace
}  // namespace sheen::test
