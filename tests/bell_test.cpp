// SPDX-License-Identifier: MIT
// Bells that stand for cos^n: the paper's a against its table and against independent integrals, the minimax a, and how
// well each base does.
#include "sheen/bell.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "support/random_triangles.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 20000411;
const double pi = std::acos(-1.0);

double real(Rng& rng, double low, double high) {
    return low + (high - low) * static_cast<double>(uniform(rng, 0, 1 << 20)) / (1 << 20);
}

/// max(0, cos x)^k for x in 0…π.
long double power_of_cosine(long double x, double k) {
    const long double c = std::cos(x);
    return c > 0.0L ? std::pow(c, static_cast<long double>(k)) : 0.0L;
}

/// ∫ cos^k(a·x)·sin x dx from 0 to where the bell or the hemisphere ends, by the midpoint rule.
double integral(double k, double a) {
    constexpr int parts = 20000;
    const double end = std::min(0.5 * pi, 0.5 * pi / a);
    long double sum = 0.0L;
    for (int i = 0; i < parts; ++i) {
        const long double x = end * (i + 0.5L) / parts;
        sum += power_of_cosine(a * x, k) * std::sin(x);
    }
    return static_cast<double>(sum * end / parts);
}

/// The largest |cos^n x − cos^k(a·x)| over a dense grid.
double largest_difference(double n, double k, double a) {
    constexpr int parts = 20000;
    double largest = 0.0;
    for (int i = 0; i <= parts; ++i) {
        const double x = 0.5 * pi * i / parts;
        const double value = a * x < 0.5 * pi && i < parts ? std::pow(std::cos(a * x), k) : 0.0;
        largest = std::max(largest, std::abs(std::pow(std::cos(x), n) - value));
    }
    return largest;
}

/// Paper `spherical`, table 1.
TEST(Bell, ScalesAreThoseOfThePapersTable) {
    struct Entry {
        double n, a;
    };
    for (const Entry& entry : {Entry{2, 1.0000}, Entry{5, 1.4502}, Entry{10, 1.9845}, Entry{20, 2.7582},
                               Entry{50, 4.3143}, Entry{100, 6.0791}, Entry{500, 13.5535}}) {
        EXPECT_NEAR(equal_integral_scale(entry.n, 2.0), entry.a, 5.1e-5) << "n = " << entry.n;
    }
}

/// Erratum: figure 10 prints a = 1.9745 for n = 10, and the integrals differ there.
TEST(Bell, FigureTensPrintedScaleMissesTheIntegral) {
    EXPECT_NEAR(integral(2.0, 1.9845), 1.0 / 11.0, 1e-5);
    EXPECT_GT(std::abs(integral(2.0, 1.9745) - 1.0 / 11.0), 5e-4);
}

/// The closed form that follows eq. 20.
TEST(Bell, ScalesOfTheSquaredCosineSolveThePapersClosedForm) {
    Rng rng(seed);
    for (int run = 0; run < 500; ++run) {
        const double n = std::exp(real(rng, std::log(2.01), std::log(1000.0)));
        const double a = equal_integral_scale(n, 2.0);
        const double right_side = (2.0 * a * a * (1.0 - std::cos(0.5 * pi / a)) - 1.0) / (4.0 * a * a - 1.0);
        ASSERT_NEAR(right_side * (n + 1.0), 1.0, 1e-8) << "n = " << n << ", seed " << seed;
    }
}

TEST(Bell, ScalesOfAnyBaseMakeTheIntegralsEqual) {
    Rng rng(seed + 1);
    for (int run = 0; run < 60; ++run) {
        const double n = std::exp(real(rng, std::log(0.2), std::log(1000.0)));
        const double k = std::exp(real(rng, std::log(0.5), std::log(50.0)));
        const double a = equal_integral_scale(n, k);
        ASSERT_NEAR(integral(k, a) * (n + 1.0), 1.0, 1e-4) << "n = " << n << ", k = " << k << ", a = " << a;
    }
}

TEST(Bell, MinimaxScalesLeaveTheLeastLargestError) {
    Rng rng(seed + 2);
    for (int run = 0; run < 40; ++run) {
        const double n = std::exp(real(rng, std::log(2.0), std::log(1000.0)));
        const double k = std::exp(real(rng, std::log(1.5), std::log(20.0)));
        const double a = minimax_scale(n, k);
        const double least = largest_difference(n, k, a);
        ASSERT_NEAR(bell_error(n, k, a), least, 2e-5) << "n = " << n << ", k = " << k;
        for (const double factor : {0.9, 0.99, 0.999, 1.001, 1.01, 1.1}) {
            ASSERT_GE(largest_difference(n, k, factor * a), least - 2e-5) << "n = " << n << ", k = " << k;
        }
        ASSERT_LE(least, largest_difference(n, k, equal_integral_scale(n, k)) + 2e-5);
    }
}

/// docs/papers.md: the errors of the paper's scale and of the best one.
TEST(Bell, LargestErrorsAreTheDocumentedOnes) {
    struct Entry {
        double n, paper, best_scale, best;
    };
    for (const Entry& e :
         {Entry{5, 0.040, 1.4614, 0.035}, Entry{10, 0.055, 2.0182, 0.044}, Entry{20, 0.0635, 2.8215, 0.0485},
          Entry{50, 0.069, 4.4310, 0.051}, Entry{100, 0.070, 6.2524, 0.052}, Entry{500, 0.072, 13.9560, 0.0525}}) {
        EXPECT_NEAR(bell_error(e.n, 2.0, equal_integral_scale(e.n, 2.0)), e.paper, 5e-4) << "n = " << e.n;
        EXPECT_NEAR(minimax_scale(e.n, 2.0), e.best_scale, 1e-4) << "n = " << e.n;
        EXPECT_NEAR(bell_error(e.n, 2.0, minimax_scale(e.n, 2.0)), e.best, 5e-4) << "n = " << e.n;
    }
}

/// Over n = 5…500 no base does better than cos^9.5, over 2…500 none better than cos^3.5, to half an exponent.
TEST(Bell, BestBasesForOneTable) {
    const auto worst = [](double lowest, double base) {
        double largest = 0.0;
        for (int i = 0; i <= 40; ++i) {
            const double n = lowest * std::pow(500.0 / lowest, i / 40.0);
            largest = std::max(largest, bell_error(n, base, minimax_scale(n, base)));
        }
        return largest;
    };
    for (const auto& [lowest, best] : {std::pair{5.0, 9.5}, std::pair{2.0, 3.5}}) {
        const double least = worst(lowest, best);
        std::cout << fmt::format("n = {}…500: cos² {:.4f}, cos^{} {:.4f}\n", lowest, worst(lowest, 2.0), best, least);
        for (double base = 1.5; base <= 16.0; base += 0.5) {
            EXPECT_GE(worst(lowest, base), least) << "base " << base << ", n from " << lowest;
        }
    }
    EXPECT_LE(worst(5.0, 9.5), 0.0095);
    EXPECT_LE(worst(2.0, 3.5), 0.0275);
}

TEST(Bell, IsTheCosinesPowerWhereTheBaseIsTheShininess) {
    Rng rng(seed + 3);
    for (int run = 0; run < 2000; ++run) {
        const double n = real(rng, 0.0, 200.0);
        const double x = real(rng, -pi, pi);
        const double expected = n == 0.0 ? 1.0 : static_cast<double>(power_of_cosine(std::abs(x), n));
        ASSERT_NEAR(Bell(n, 0.0, false)(x), expected, 1e-12) << "n = " << n << ", x = " << x;
        ASSERT_NEAR(Bell(n, n, true)(x), expected, 1e-12) << "n = " << n << ", x = " << x;
    }
}

/// One at the top, even, and 0 from its end on: nothing comes round again.
TEST(Bell, HasOneTopAndNoSecondOne) {
    Rng rng(seed + 4);
    for (int run = 0; run < 300; ++run) {
        const double n = std::exp(real(rng, std::log(0.5), std::log(1000.0)));
        const Bell shape(n, real(rng, 1.0, 20.0), run % 2 == 1);
        EXPECT_EQ(shape(0.0), 1.0);
        double last = 1.0;
        for (int i = 1; i <= 200; ++i) {
            const double x = pi * i / 200;
            const double value = shape(x);
            ASSERT_LE(value, last) << "n = " << n << ", x = " << x;
            ASSERT_EQ(value, shape(-x));
            const bool ended = x >= 0.5 * pi || x * shape.scale() >= 0.5 * pi;
            ASSERT_EQ(value > 0.0 && ended, false) << "n = " << n << ", x = " << x;
            last = value;
        }
    }
    for (int i = -10; i <= 10; ++i) EXPECT_EQ(Bell(0.0, 2.0, false)(0.3 * i), 1.0) << "cos^0 is 1 everywhere";
}

}  // namespace
}  // namespace sheen::test
