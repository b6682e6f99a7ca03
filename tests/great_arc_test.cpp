// SPDX-License-Identifier: MIT
// Great arcs against explicit rotations, and the rows of a triangle against exact intersections.
#include "sheen/great_arc.hpp"

#include <gtest/gtest.h>

#include "sheen/span_frame.hpp"
#include "support/spherical_cases.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 19850722;
const glm::dvec3 camera(0.0, 0.0, 1.0);
const double pi = std::acos(-1.0);

/// Paper `spherical`, eq. 11 and 12.
TEST(GreatArc, IsTheRotationAndThePapersFormula) {
    Rng rng(seed);
    for (int run = 0; run < 5000; ++run) {
        const glm::dvec3 a = random_unit(rng);
        const glm::dvec3 b = random_unit(rng);
        const double gamma = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
        if (gamma < 1e-3 || gamma > pi - 1e-3) continue;
        const GreatArc<double> arc(a, b, camera);
        const double t = real(rng, 0.0, 1.0);
        const glm::dvec3 u = arc.at(t);
        ASSERT_LT(glm::length(u - between(a, b, t)), 1e-11) << "run " << run << ", seed " << seed;
        const glm::dvec3 printed = (std::sin((1.0 - t) * gamma) * a + std::sin(t * gamma) * b) / std::sin(gamma);
        ASSERT_LT(glm::length(u - printed), 1e-10);
        ASSERT_NEAR(glm::length(u), 1.0, 1e-12);
        ASSERT_NEAR(glm::dot(a, u), std::cos(t * gamma), 1e-12);
        ASSERT_NEAR(glm::dot(b, u), std::cos((1.0 - t) * gamma), 1e-12);
    }
}

TEST(GreatArc, IsUnitAndFiniteWhereVectorsAreEqualOrOppositeOrNearlySo) {
    Rng rng(seed + 1);
    for (int run = 0; run < 20000; ++run) {
        const glm::dvec3 a = run % 5 == 0 ? camera * (run % 2 == 0 ? 1.0 : -1.0) : random_unit(rng);
        const double distance = run % 3 == 0 ? 0.0 : std::pow(10.0, real(rng, -17.0, -3.0));
        const glm::dvec3 b = glm::normalize((run % 2 == 0 ? a : -a) + distance * random_unit(rng));
        const GreatArc<double> arc(a, b, camera);
        for (const double t : {0.0, 0.3, 1.0}) {
            ASSERT_NEAR(glm::length(arc.at(t)), 1.0, 1e-6) << "run " << run << ", distance " << distance;
        }
        ASSERT_LT(glm::length(arc.at(0.0) - a), 1e-15);
        ASSERT_LT(glm::length(arc.at(1.0) - b), 3e-9) << "run " << run << ", distance " << distance;
        ASSERT_NEAR(glm::length(arc.turned_back(random_unit(rng))), 1.0, 1e-6);
    }
}

TEST(GreatArc, BetweenOppositeVectorsPassesNearestToTheCamera) {
    Rng rng(seed + 2);
    for (int run = 0; run < 1000; ++run) {
        const glm::dvec3 a = random_unit(rng);
        const glm::dvec3 middle = GreatArc<double>(a, -a, camera).at(0.5);
        ASSERT_NEAR(glm::dot(middle, a), 0.0, 1e-12);
        ASSERT_NEAR(glm::dot(middle, camera), std::sqrt(1.0 - a.z * a.z), 1e-9);
    }
}

/// Section 3.2: the inverse rotation as the paper writes it, q⁻¹·u·q worked out.
TEST(GreatArc, TurnsBackAsThePapersQuaternionDoes) {
    Rng rng(seed + 3);
    for (int run = 0; run < 5000; ++run) {
        const glm::dvec3 from = random_unit(rng);
        const glm::dvec3 to = random_unit(rng);
        const glm::dvec3 u = random_unit(rng);
        const glm::dvec3 k = glm::cross(from, to);
        const double cosine = glm::dot(from, to);
        if (cosine < -0.99 || cosine > 1.0 - 1e-9) continue;
        const glm::dvec3 expected = u - glm::cross(k, u) + glm::cross(k, glm::cross(k, u)) / (1.0 + cosine);
        const GreatArc<double> arc(from, to, camera);
        ASSERT_LT(glm::length(arc.turned_back(u) - expected), 1e-10) << "run " << run << ", seed " << seed;
        const double angle = std::atan2(glm::length(k), cosine);
        ASSERT_LT(glm::length(arc.turned_back(u) - rotated(u, glm::normalize(k), -angle)), 1e-10);
        ASSERT_LT(glm::length(arc.turned_back(to) - from), 1e-12);
    }
}

/// Where a row's centre line meets the edges, in long double, and how pixels lie between.
TEST(SpanFrame, PositionsAreThoseOfTheRowsIntersections) {
    Rng rng(seed + 4);
    std::size_t compared = 0;
    for (int run = 0; run < 3000; ++run) {
        const Triangle t = random_triangle(rng, 60);
        std::array<ScreenVertex, 3> vertices;
        for (std::size_t k = 0; k < 3; ++k) vertices[k].point = t[k];
        if (cross(t[0], t[1], t[2]) == 0) continue;
        const SpanFrame frame(vertices);
        for (int y = 0; y < 60; ++y) {
            int first = 60;
            int end = 0;
            for (int x = 0; x < 60; ++x) {
                if (!edge_functions_cover(t, x, y)) continue;
                first = std::min(first, x);
                end = x + 1;
            }
            if (end == 0) continue;
            const SpanFrame::Pixels pixels = frame.pixels(y);
            ASSERT_EQ(pixels.first, first) << "run " << run << ", row " << y << ", seed " << seed;
            ASSERT_EQ(pixels.end, end) << "run " << run << ", row " << y << ", seed " << seed;
            const SpanFrame::Span span = frame.span(y);
            const auto meets = [&](const SpanFrame::EdgePoint& point) {
                const auto ends = frame.ends(point.side);
                const auto top = static_cast<long double>(t[ends[0]].x);
                const auto bottom = static_cast<long double>(t[ends[1]].x);
                return top + (bottom - top) * static_cast<long double>(point.t);
            };
            const long double left = meets(span.left);
            const long double width = meets(span.right) - left;
            if (width < 16.0L) continue;  // the intersections' own rounding
            for (int x = first; x < end; ++x) {
                const auto expected = static_cast<double>((256.0L * x + 128.0L - left) / width);
                ASSERT_NEAR(span.position(x), expected, 1e-10) << "run " << run << ", pixel " << x << ", " << y;
                ++compared;
            }
            ASSERT_NEAR(span.position_step() * static_cast<double>(width), 256.0, 1e-7);
        }
    }
    EXPECT_GT(compared, 40000U);
}

}  // namespace
}  // namespace sheen::test
