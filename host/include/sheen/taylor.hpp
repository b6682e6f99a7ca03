// SPDX-License-Identifier: MIT
/// \file
/// Shading as a polynomial, paper `fast-phong`: dot products of vectors that are linear over a triangle, Duff's form of
/// them, and their Taylor series to the second degree about the triangle's centre.
///
/// Coordinates (x, y) may be any that are affine on the screen and 0 at the centre: pixels, or barycentric ones. The
/// series doesn't depend on the choice, since an affine map keeps a polynomial's degree; only its coefficients do.
#pragma once

#include <array>
#include <cmath>
#include <glm/vec3.hpp>

namespace sheen {

/// Ax + By + C: a vector interpolated linearly.
template <typename Real>
struct LinearVector {
    glm::vec<3, Real> x{}, y{}, constant{};
};

/// a·b for any Real: glm's own is for its floating-point types only.
template <typename Real>
Real scalar_product(const glm::vec<3, Real>& a, const glm::vec<3, Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// xx·x² + xy·xy + yy·y² + x·x + y·y + constant.
template <typename Real>
struct Quadratic {
    Real xx{}, xy{}, yy{}, x{}, y{}, constant{};
};

/// Duff's a, b, c: the dot product with a constant vector. The second degree is 0.
template <typename Real>
Quadratic<Real> dot_product(const LinearVector<Real>& n, const glm::vec<3, Real>& v) {
    return {
        Real(0.0), Real(0.0), Real(0.0), scalar_product(n.x, v), scalar_product(n.y, v), scalar_product(n.constant, v)};
}

/// The finite eye's a…f.
template <typename Real>
Quadratic<Real> dot_product(const LinearVector<Real>& n, const LinearVector<Real>& v) {
    return {scalar_product(n.x, v.x),
            scalar_product(n.x, v.y) + scalar_product(n.y, v.x),
            scalar_product(n.y, v.y),
            scalar_product(n.x, v.constant) + scalar_product(n.constant, v.x),
            scalar_product(n.y, v.constant) + scalar_product(n.constant, v.y),
            scalar_product(n.constant, v.constant)};
}

/// |v|²: Duff's d…i, the finite eye's g…l and m…r. The paper prints the finite eye's m, n, o in another order.
template <typename Real>
Quadratic<Real> squared_length(const LinearVector<Real>& v) {
    const Real xy = scalar_product(v.x, v.y);
    const Real x = scalar_product(v.x, v.constant);
    const Real y = scalar_product(v.y, v.constant);
    return {scalar_product(v.x, v.x),
            xy + xy,
            scalar_product(v.y, v.y),
            x + x,
            y + y,
            scalar_product(v.constant, v.constant)};
}

/// What a series needs of a length: 1/√constant, and the other coefficients of its square over twice the constant.
/// Shared by all dot products with the vector.
template <typename Real>
struct InverseLength {
    Real scale{}, xx{}, xy{}, yy{}, x{}, y{};
};

/// `squared.constant` > 0. One division, one root.
template <typename Real>
InverseLength<Real> inverse_length(const Quadratic<Real>& squared) {
    using std::sqrt;
    const Real inverse = Real(1.0) / squared.constant;
    const Real half = Real(0.5) * inverse;
    return {sqrt(inverse), half * squared.xx, half * squared.xy, half * squared.yy, half * squared.x, half * squared.y};
}

/// T0…T5: T5·x² + T4·xy + T3·y² + T2·x + T1·y + T0.
template <typename Real>
using TaylorSeries = std::array<Real, 6>;

template <typename Real>
Real value_at(const TaylorSeries<Real>& t, const Real& x, const Real& y) {
    return (t[5] * x + t[4] * y + t[2]) * x + (t[3] * y + t[1]) * y + t[0];
}

/// Series of n·v/|n| for a constant v, eye and light at infinity; `product` is dot_product(n, v). With Duff's letters
/// T5 = (3cg² − 4cdi − 4agi)/(8i²√i), where the paper prints 3ig²; T0 to T4 are as printed.
template <typename Real>
TaylorSeries<Real> taylor_series(const Quadratic<Real>& product, const InverseLength<Real>& n) {
    const Real& a = product.x;
    const Real& b = product.y;
    const Real& c = product.constant;
    const Real cx = c * n.x;
    const Real cy = c * n.y;
    const Real three_halves(1.5);
    return {n.scale * c,
            n.scale * (b - cy),
            n.scale * (a - cx),
            n.scale * ((three_halves * cy - b) * n.y - c * n.yy),
            n.scale * ((Real(3.0) * cx - a) * n.y - b * n.x - c * n.xy),
            n.scale * ((three_halves * cx - a) * n.x - c * n.xx)};
}

/// Series of n·v/(|n|·|v|) for a linear v, eye or light at a finite distance. T4 is that of the errata at the paper's
/// end: +fjlqr and −2fl²nr, where the text prints −fjlqr and −2f²nr.
template <typename Real>
TaylorSeries<Real> taylor_series(const Quadratic<Real>& product, const InverseLength<Real>& n,
                                 const InverseLength<Real>& v) {
    const Real& f = product.constant;
    const Real scale = n.scale * v.scale;
    const Real x = n.x + v.x;
    const Real y = n.y + v.y;
    // (1/|n||v|) to the second degree: 3/2·(j² + p²) + jp = 3/2·(j + p)² − 2jp, with j = n.x, p = v.x.
    const Real three_halves(1.5);
    const Real two(2.0);
    const Real xx = three_halves * x * x - two * n.x * v.x - n.xx - v.xx;
    const Real yy = three_halves * y * y - two * n.y * v.y - n.yy - v.yy;
    const Real xy = Real(3.0) * x * y - two * (n.x * v.y + n.y * v.x) - n.xy - v.xy;
    return {scale * f,
            scale * (product.y - f * y),
            scale * (product.x - f * x),
            scale * (product.yy - product.y * y + f * yy),
            scale * (product.xy - product.x * y - product.y * x + f * xy),
            scale * (product.xx - product.x * x + f * xx)};
}

/// The series with an infinite eye letter by letter as printed: its T5 is wrong.
template <typename Real>
TaylorSeries<Real> printed_taylor_series(const LinearVector<Real>& normal, const glm::vec<3, Real>& v) {
    using std::sqrt;
    const auto [none_xx, none_xy, none_yy, a, b, c] = dot_product(normal, v);
    const auto [d, e, f, g, h, i] = squared_length(normal);
    const Real root = sqrt(i);
    return {c / root,
            (2.0 * b * i - c * h) / (2.0 * i * root),
            (2.0 * a * i - c * g) / (2.0 * i * root),
            (3.0 * c * h * h - 4.0 * c * f * i - 4.0 * b * h * i) / (8.0 * i * i * root),
            (3.0 * c * g * h - 2.0 * c * e * i - 2.0 * b * g * i - 2.0 * a * h * i) / (4.0 * i * i * root),
            (3.0 * i * g * g - 4.0 * c * d * i - 4.0 * a * g * i) / (8.0 * i * i * root)};
}

/// The series with a finite eye letter by letter as printed: m = E·E, n = D·D, o = 2D·E, and the T4 of the text.
template <typename Real>
TaylorSeries<Real> printed_taylor_series(const LinearVector<Real>& normal, const LinearVector<Real>& v) {
    using std::sqrt;
    const auto [a, b, c, d, e, f] = dot_product(normal, v);
    const auto [g, h, i, j, k, l] = squared_length(normal);
    const auto [n, o, m, p, q, r] = squared_length(v);
    const Real ll = l * l;
    const Real rr = r * r;
    const Real root = sqrt(l * r);
    return {f / root,
            (2.0 * e * l * r - f * k * r - f * l * q) / (2.0 * l * r * root),
            (2.0 * d * l * r - f * j * r - f * l * p) / (2.0 * l * r * root),
            (8.0 * c * ll * rr - 4.0 * e * k * l * rr - 4.0 * f * i * l * rr + 3.0 * f * k * k * rr -
             4.0 * e * ll * q * r + 2.0 * f * k * l * q * r - 4.0 * f * ll * o * r + 3.0 * f * ll * q * q) /
                (8.0 * ll * rr * root),
            (4.0 * b * ll * rr - 2.0 * d * k * l * rr - 2.0 * e * j * l * rr - 2.0 * f * h * l * rr +
             3.0 * f * j * k * rr - 2.0 * d * ll * q * r - f * j * l * q * r - 2.0 * e * ll * p * r +
             f * k * l * p * r - 2.0 * f * f * n * r + 3.0 * f * ll * p * q) /
                (4.0 * ll * rr * root),
            (8.0 * a * ll * rr - 4.0 * d * j * l * rr - 4.0 * f * g * l * rr + 3.0 * f * j * j * rr -
             4.0 * d * ll * p * r + 2.0 * f * j * l * p * r - 4.0 * f * ll * m * r + 3.0 * f * ll * p * p) /
                (8.0 * ll * rr * root)};
}

}  // namespace sheen
