// SPDX-License-Identifier: MIT
/// \file
/// Automatic differentiation to the second degree in two variables, in long double: the oracle of Taylor series.
#pragma once

#include <array>
#include <cmath>

namespace sheen::test {

/// A function's value and derivatives at (0, 0).
struct Jet {
    long double v = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

    /// g(this), from g's value and its first two derivatives.
    [[nodiscard]] Jet through(long double g, long double g1, long double g2) const {
        return {g, g1 * x, g1 * y, g1 * xx + g2 * x * x, g1 * xy + g2 * x * y, g1 * yy + g2 * y * y};
    }
    /// T0…T5 of 1, y, x, y², xy, x².
    [[nodiscard]] std::array<double, 6> series() const {
        return {static_cast<double>(v),      static_cast<double>(y),  static_cast<double>(x),
                static_cast<double>(yy / 2), static_cast<double>(xy), static_cast<double>(xx / 2)};
    }
};

/// a·x + b·y + c
inline Jet linear_jet(long double a, long double b, long double c) { return {c, a, b, 0, 0, 0}; }

inline Jet operator+(const Jet& a, const Jet& b) {
    return {a.v + b.v, a.x + b.x, a.y + b.y, a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}

inline Jet operator*(const Jet& a, const Jet& b) {
    return {a.v * b.v,
            a.x * b.v + a.v * b.x,
            a.y * b.v + a.v * b.y,
            a.xx * b.v + 2 * a.x * b.x + a.v * b.xx,
            a.xy * b.v + a.x * b.y + a.y * b.x + a.v * b.xy,
            a.yy * b.v + 2 * a.y * b.y + a.v * b.yy};
}

inline Jet inverse_root(const Jet& a) {
    const long double root = 1 / std::sqrt(a.v);
    return a.through(root, -root / (2 * a.v), 3 * root / (4 * a.v * a.v));
}

using JetVector = std::array<Jet, 3>;

inline Jet dot(const JetVector& a, const JetVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// a·b/(|a|·|b|)
inline Jet cosine(const JetVector& a, const JetVector& b) {
    return dot(a, b) * inverse_root(dot(a, a)) * inverse_root(dot(b, b));
}

}  // namespace sheen::test
