// SPDX-License-Identifier: MIT
/// \file
/// The functions that tables are computed from, for the compiler alone: std::cos and its like are not constexpr.
#pragma once

namespace sheen::hls::table_math {

inline constexpr double half_pi = 1.57079632679489661923;

/// cos x for 0 ≤ x ≤ π/2 by its series (error below 1e-15).
constexpr double cosine(double x) {
    double sum = 1.0;
    double term = 1.0;
    for (int k = 1; k <= 12; ++k) {
        term *= -x * x / ((2 * k - 1) * (2 * k));
        sum += term;
    }
    return sum;
}

/// ln x for 0 < x ≤ 1: x = m / 2^e with m near 1, then the series of the inverse hyperbolic tangent.
constexpr double logarithm(double x) {
    constexpr double ln_2 = 0.69314718055994530942;
    int doublings = 0;
    while (x < 0.75) {
        x *= 2.0;
        ++doublings;
    }
    const double u = (x - 1.0) / (x + 1.0);
    double power = u;
    double sum = u;
    for (int k = 3; k <= 21; k += 2) {
        power *= u * u;
        sum += power / k;
    }
    return 2.0 * sum - doublings * ln_2;
}

/// e^y for y ≤ 0: the series of y / 2^k, squared k times.
constexpr double exponential(double y) {
    int halvings = 0;
    while (y < -0.5) {
        y *= 0.5;
        ++halvings;
    }
    double sum = 1.0;
    double term = 1.0;
    for (int k = 1; k <= 14; ++k) {
        term *= y / k;
        sum += term;
    }
    for (; halvings > 0; --halvings) {
        sum *= sum;
    }
    return sum;
}

}  // namespace sheen::hls::table_math
