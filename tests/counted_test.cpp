// SPDX-License-Identifier: MIT
// A number that counts its operations: each under its own name, values as a double's, scopes that nest.
#include "sheen/counted.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <random>
#include <thread>

namespace sheen::test {
namespace {

constexpr unsigned seed = 4201;

template <typename Body>
OperationCounts counted(Body body) {
    const CountingScope scope;
    body();
    return scope.counts();
}

/// A formula that holds every operation.
template <typename Real>
Real everything(const Real& a, const Real& b) {
    using std::abs, std::acos, std::atan2, std::cos, std::exp, std::exp2, std::log, std::log2, std::pow, std::sin,
        std::sqrt, std::tan;
    Real sum = a + b - a * b / (Real(2.0) + abs(a));
    sum += sqrt(abs(b)) + pow(abs(a), b) + exp2(a) + exp(b) + log2(Real(1.5) + abs(a)) + log(Real(1.5) + abs(b));
    sum -= sin(a) * cos(b) + tan(a / Real(4.0)) + acos(a / Real(9.0)) + atan2(a, b);
    sum *= Real(0.5);
    sum /= Real(3.0);
    return std::max(sum, -sum) + (a < b ? a : b);
}

TEST(Counted, ValuesAreThoseOfADouble) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-3.0, 3.0);
    for (int run = 0; run < 1000; ++run) {
        const double a = number(random);
        const double b = number(random);
        EXPECT_EQ(everything(Counted(a), Counted(b)).value(), everything(a, b)) << a << ", " << b << ", seed " << seed;
    }
}

TEST(Counted, EachOperationIsCountedOnceUnderItsName) {
    const Counted a = 3.0;
    const Counted b = 0.5;
    const auto additions = counted([&] { (void)(a + b), (void)(a - b); });
    EXPECT_EQ(additions, (OperationCounts{2, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(counted([&] { (void)(a * b); }), (OperationCounts{0, 1, 0, 0, 0, 0, 0}));
    EXPECT_EQ(counted([&] { (void)(a / b); }), (OperationCounts{0, 0, 1, 0, 0, 0, 0}));
    EXPECT_EQ(counted([&] { (void)sqrt(a); }), (OperationCounts{0, 0, 0, 1, 0, 0, 0}));
    EXPECT_EQ(counted([&] {
                  (void)pow(a, b), (void)exp2(a), (void)exp(a), (void)log2(a), (void)log(a), (void)sin(a), (void)cos(a),
                      (void)tan(a), (void)acos(b), (void)atan2(a, b);
              }),
              (OperationCounts{0, 0, 0, 0, 10, 0, 0}));
    EXPECT_EQ(counted([&] {
                  (void)(a < b), (void)(a > b), (void)(a <= b), (void)(a >= b), (void)(a == b), (void)(a != b),
                      (void)std::max(a, b);
              }),
              (OperationCounts{0, 0, 0, 0, 0, 7, 0}));
    const std::array<double, 3> table{1.0, 2.0, 4.0};
    EXPECT_EQ(counted([&] { EXPECT_EQ(read_table<Counted>(table, 2).value(), 4.0); }),
              (OperationCounts{0, 0, 0, 0, 0, 0, 1}));
    EXPECT_EQ(counted([&] { EXPECT_EQ(read_table<double>(table, 1), 2.0); }), OperationCounts{});
}

TEST(Counted, ConstantsSignsAndCopiesAreFree) {
    EXPECT_EQ(counted([] {
                  const Counted a = -Counted(2.0);
                  Counted b = abs(a);
                  b = a;
                  EXPECT_EQ(value_of(b), -2.0);
              }),
              OperationCounts{});
}

TEST(Counted, GlmVectorsCountByComponent) {
    const glm::vec<3, Counted> a(1.0, 2.0, 3.0);
    EXPECT_EQ(counted([&] { (void)(a + a); }), (OperationCounts{3, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(counted([&] { (void)(a * Counted(2.0)); }), (OperationCounts{0, 3, 0, 0, 0, 0, 0}));
}

TEST(CountingScope, CountsWhatInnerScopesCountAndNothingAfterItsEnd) {
    const Counted a = 2.0;
    const CountingScope outer;
    EXPECT_EQ(counted([&] { (void)(a + a); }).additions, 1U);
    (void)(a * a);
    EXPECT_EQ(outer.counts(), (OperationCounts{1, 1, 0, 0, 0, 0, 0}));
}

TEST(CountingScope, AnotherThreadsOperationsAreItsOwn) {
    const CountingScope scope;
    std::thread([] { (void)(Counted(1.0) + Counted(2.0)); }).join();
    EXPECT_EQ(scope.counts(), OperationCounts{});
}

}  // namespace
}  // namespace sheen::test
