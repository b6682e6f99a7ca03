// SPDX-License-Identifier: MIT
/// \file
/// Highlights over any Real, from the cosines between the normal N, the light L, the eye V and H = (L + V)/|L + V|:
/// Blinn's half vector, Phong's mirror vector, and the facets of Cook and Torrance (1982, "A reflectance model for
/// computer graphics"). Each is what a material's `specular` and the light's colour are multiplied with; all are
/// finite.
#pragma once

#include <algorithm>
#include <cmath>

#include "sheen/counted.hpp"
#include "sheen/lighting.hpp"

namespace sheen {

/// cosine^n, 0 for a negative cosine. One that rounding left above 1 counts as 1, or a large n would make it infinite.
template <typename Real>
Real highlight_power(const Real& cosine, double n) {
    using std::pow;
    return value_of(cosine) < 1.0 ? pow(std::max(Real(0.0), cosine), Real(n)) : Real(1.0);
}

/// max(0, N·H)^n (paper `spherical`, eq. 6); not suppressed where N·L < 0.
template <typename Real>
Real blinn_highlight(const Material& material, const Real& n_dot_h) {
    return highlight_power(n_dot_h, material.shininess);
}

/// max(0, R·V)^n, R = 2(N·L)N − L the mirror image of L; not suppressed where N·L < 0.
template <typename Real>
Real phong_highlight(const Material& material, const Real& n_dot_l, const Real& n_dot_v, const Real& l_dot_v) {
    return highlight_power(Real(2.0) * n_dot_l * n_dot_v - l_dot_v, material.shininess);
}

/// Fresnel's reflectance of unpolarised light where V·H = c > 0, for the index of refraction whose reflectance at c = 1
/// is given.
template <typename Real>
Real fresnel(double normal_reflectance, const Real& c) {
    using std::sqrt;
    const double root = std::sqrt(normal_reflectance);
    if (root == 0.0 || root == 1.0) return normal_reflectance;
    const double index = (1.0 + root) / (1.0 - root);
    const Real one(1.0);
    const Real g = sqrt(Real((index - 1.0) * (index + 1.0)) + c * c);
    const Real across = (g - c) / (g + c);
    const Real along = (c * (g + c) - one) / (c * (g - c) + one);
    return Real(0.5) * across * across * (one + along * along);
}

/// Beckmann's distribution of slopes, exp(−tan²α/m²)/(m²·cos⁴α) with cos α = N·H > 0, m > 0. Weighted by cos α, its
/// integral over the hemisphere is π.
template <typename Real>
Real beckmann(double roughness, const Real& n_dot_h) {
    using std::exp;
    constexpr double vanishing = 700.0;  // exponent whose power is 0 to double precision, before cos⁴α underflows
    const Real square = n_dot_h * n_dot_h;
    const Real slope = Real(roughness * roughness) * square;
    const Real exponent = (Real(1.0) - square) / slope;
    return exponent < Real(vanishing) ? exp(-exponent) / (slope * square) : Real(0.0);
}

/// F·D·G/(4 N·V): the reflectance F·D·G/((N·L)(N·V)) with the factor 1/4 that keeps D's energy (the paper prints 1/π),
/// times N·L. G = min(1, 2(N·H)(N·V)/(V·H), 2(N·H)(N·L)/(V·H)), 0 where N·L ≤ 0. Where N·V ≤ 0 (interpolated normals
/// past the silhouette) G/(N·V) keeps its limit, so that no edge appears there.
template <typename Real>
Real cook_torrance_highlight(const Material& material, const Real& n_dot_h, const Real& n_dot_l, const Real& n_dot_v,
                             const Real& v_dot_h) {
    const Real zero(0.0);
    if (n_dot_h <= zero || n_dot_l <= zero || v_dot_h <= zero) return zero;
    const Real slopes = beckmann(material.roughness, std::min(Real(1.0), n_dot_h));
    const Real masked = Real(2.0) * n_dot_h / v_dot_h;  // facets hide the light that leaves: N·V cancels
    const Real unmasked = std::min(Real(1.0), masked * n_dot_l);
    const Real visible = n_dot_v > zero ? std::min(masked, unmasked / n_dot_v) : masked;
    return Real(0.25) * fresnel(material.normal_reflectance, v_dot_h) * slopes * visible;
}

}  // namespace sheen
