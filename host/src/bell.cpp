// SPDX-License-Identifier: MIT
#include "sheen/bell.hpp"

#include <algorithm>
#include <cmath>

namespace sheen {
namespace {

constexpr double half_pi = 1.57079632679489661923;

/// Where the bell ends.
double reach(double scale) { return scale > 1.0 ? half_pi / scale : half_pi; }

/// The zero of a falling function, to a relative `tolerance`, from a guess > 0: an octave around it, then false
/// position that halves the value of an end which stays twice (Illinois).
template <typename Function>
double falling_root(const Function& function, double guess, double tolerance) {
    constexpr int most_steps = 100;
    double low = guess;
    double at_low = function(low);
    double high = low;
    double at_high = at_low;
    while (at_low < 0.0) {
        high = low;
        at_high = at_low;
        low *= 0.5;
        at_low = function(low);
    }
    while (at_high > 0.0) {
        low = high;
        at_low = at_high;
        high *= 2.0;
        at_high = function(high);
    }
    double root = low;
    int replaced = 0;  // the end that the last step moved: −1 the low one, +1 the high one
    for (int step = 0; step < most_steps && at_low > at_high; ++step) {
        const double last = root;
        root = (high * at_low - low * at_high) / (at_low - at_high);
        const double value = function(root);
        if (value == 0.0 || std::abs(root - last) <= tolerance * root) break;
        const int side = value > 0.0 ? -1 : 1;
        double& at_other = side < 0 ? at_high : at_low;
        if (side == replaced) at_other *= 0.5;
        (side < 0 ? low : high) = root;
        (side < 0 ? at_low : at_high) = value;
        replaced = side;
    }
    return root;
}

/// The right side of eq. 20, cut off at π/2 where a < 1: ∫ cosᵏ(a·x)·sin x dx, by the double exponential rule, which a
/// fractional power's end at 0 does not disturb (error below 1e-12).
double weighted_integral(double base, double scale) {
    constexpr double step = 0.125;
    constexpr int count = 25;  // weights beyond are below 1e-14
    const double half = 0.5 * reach(scale);
    double sum = 0.0;
    for (int k = -count; k <= count; ++k) {
        const double u = half_pi * std::sinh(step * k);
        const double x = half * (1.0 + std::tanh(u));
        const double weight = std::cosh(step * k) / (std::cosh(u) * std::cosh(u));
        sum += weight * bell(x, base, scale) * std::sin(x);
    }
    return half * half_pi * step * sum;
}

/// Bells of equal curvature at the top: where a search for a starts.
double equal_curvature_scale(double shininess, double base) { return std::sqrt(shininess / base); }

/// The largest and least cosⁿ x − bell.
struct Extremes {
    double most = 0.0;
    double least = 0.0;
};

/// The largest value of `function` near x ± width, by golden section.
template <typename Function>
double refined_maximum(const Function& function, double x, double width) {
    constexpr double golden = 0.61803398874989484820;
    constexpr int steps = 24;
    double low = std::max(0.0, x - width);
    double high = x + width;
    double p = high - golden * (high - low);
    double q = low + golden * (high - low);
    double at_p = function(p);
    double at_q = function(q);
    for (int k = 0; k < steps; ++k) {
        if (at_p > at_q) {
            high = q;
            q = p;
            at_q = at_p;
            p = high - golden * (high - low);
            at_p = function(p);
        } else {
            low = p;
            p = q;
            at_p = at_q;
            q = low + golden * (high - low);
            at_q = function(q);
        }
    }
    return std::max(at_p, at_q);
}

/// Beyond its reach the bell is 0 and cosⁿ falls: no extreme lies there.
Extremes extremes(double shininess, double base, double scale) {
    constexpr int samples = 64;
    const auto difference = [&](double x) { return cosine_power(x, shininess) - bell(x, base, scale); };
    const double width = reach(scale) / samples;
    double most_at = 0.0;
    double least_at = 0.0;
    Extremes result;
    for (int k = 1; k <= samples; ++k) {
        const double value = difference(k * width);
        if (value > result.most) most_at = k * width;
        if (value < result.least) least_at = k * width;
        result = {std::max(result.most, value), std::min(result.least, value)};
    }
    if (result.most > 0.0) result.most = std::max(result.most, refined_maximum(difference, most_at, width));
    if (result.least < 0.0) {
        const auto negative = [&](double x) { return -difference(x); };
        result.least = std::min(result.least, -refined_maximum(negative, least_at, width));
    }
    return result;
}

}  // namespace

double bell(double x, double base, double scale) {
    return std::abs(x) < reach(scale) ? std::pow(std::max(0.0, std::cos(scale * x)), base) : 0.0;
}

double cosine_power(double x, double shininess) {
    if (shininess == 0.0) return 1.0;
    return std::abs(x) < half_pi ? std::pow(std::cos(x), shininess) : 0.0;
}

double equal_integral_scale(double shininess, double base) {
    if (shininess == base) return 1.0;
    const double left_side = 1.0 / (shininess + 1.0);
    const auto excess = [&](double scale) { return weighted_integral(base, scale) - left_side; };
    return shininess == 0.0 ? 0.0 : falling_root(excess, equal_curvature_scale(shininess, base), 1e-10);
}

/// A larger a lowers the bell everywhere, so both extremes of cosⁿ − bell rise with it, and the larger of the two in
/// magnitude is least where they are opposite.
double minimax_scale(double shininess, double base) {
    if (shininess == base) return 1.0;
    const auto imbalance = [&](double scale) {
        const Extremes found = extremes(shininess, base, scale);
        return -found.most - found.least;
    };
    return shininess == 0.0 ? 0.0 : falling_root(imbalance, equal_curvature_scale(shininess, base), 1e-8);
}

double bell_error(double shininess, double base, double scale) {
    const Extremes found = extremes(shininess, base, scale);
    return std::max(found.most, -found.least);
}

Bell::Bell(double shininess, double base, bool minimax) : base_(base == 0.0 ? shininess : base), scale_(1.0) {
    scale_ = minimax ? minimax_scale(shininess, base_) : equal_integral_scale(shininess, base_);
}

double Bell::operator()(double angle) const { return scale_ == 0.0 ? 1.0 : bell(angle, base_, scale_); }

}  // namespace sheen
