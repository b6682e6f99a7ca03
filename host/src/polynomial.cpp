// SPDX-License-Identifier: MIT
#include "sheen/polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

#include "sheen/hls/formats.hpp"

namespace sheen {
namespace {

constexpr std::int64_t pixel = std::int64_t{1} << hls::subpixel_bits;

/// Greatest L²/(2·area) for which double is precise enough (see fit_quadratic).
constexpr std::int64_t greatest_double_slenderness = 64;

bool double_suffices(const std::array<SnappedPoint, 3>& v, std::int64_t area) {
    std::int64_t longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t dx = v[k].x - v[(k + 1) % 3].x;
        const std::int64_t dy = v[k].y - v[(k + 1) % 3].y;
        longest = std::max(longest, dx * dx + dy * dy);
    }
    return longest / greatest_double_slenderness < std::abs(area);
}

/// A barycentric coordinate as a linear function of the pixel, about an origin: x·X + y·Y + one.
template <typename Real>
struct Barycentric {
    Real x, y, one;
};

/// λ of each vertex: the edge function of the opposite edge over the doubled area, at pixel centres about `origin`.
template <typename Real>
std::array<Barycentric<Real>, 3> barycentrics(const std::array<SnappedPoint, 3>& v, std::int64_t area,
                                              const PixelIndex& origin) {
    const SnappedPoint sample{pixel * origin.x + pixel / 2, pixel * origin.y + pixel / 2};
    const Real inverse = Real{1} / static_cast<Real>(area);
    std::array<Barycentric<Real>, 3> lambda{};
    for (std::size_t k = 0; k < 3; ++k) {
        const SnappedPoint& from = v[(k + 1) % 3];
        const SnappedPoint& to = v[(k + 2) % 3];
        lambda[k] = {static_cast<Real>(pixel * (from.y - to.y)) * inverse,
                     static_cast<Real>(pixel * (to.x - from.x)) * inverse,
                     static_cast<Real>(doubled_area(from, to, sample)) * inverse};
    }
    return lambda;
}

template <typename Real>
using Terms = std::array<Real, 6>;  ///< T₀…T₅

template <typename Real>
void add_linear(Terms<Real>& t, Real weight, const Barycentric<Real>& a) {
    t[0] += weight * a.one;
    t[1] += weight * a.y;
    t[2] += weight * a.x;
}

template <typename Real>
void add_product(Terms<Real>& t, Real weight, const Barycentric<Real>& a, const Barycentric<Real>& b) {
    t[0] += weight * (a.one * b.one);
    t[1] += weight * (a.one * b.y + a.y * b.one);
    t[2] += weight * (a.one * b.x + a.x * b.one);
    t[3] += weight * (a.y * b.y);
    t[4] += weight * (a.x * b.y + a.y * b.x);
    t[5] += weight * (a.x * b.x);
}

/// Σ vₖ·λₖ
template <typename Real>
Terms<Real> linear_terms(const std::array<Barycentric<Real>, 3>& lambda, const std::array<double, 3>& values) {
    Terms<Real> t{};
    for (std::size_t k = 0; k < 3; ++k) add_linear<Real>(t, values[k], lambda[k]);
    return t;
}

/// Σ vₖ·λₖ(2λₖ − 1) + Σ 4·vₖₗ·λₖλₗ
template <typename Real>
Terms<Real> quadratic_terms(const std::array<Barycentric<Real>, 3>& lambda, const std::array<double, 6>& values) {
    Terms<Real> t{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Real vertex = values[k];
        const Real midpoint = values[3 + k];
        add_product<Real>(t, Real{2} * vertex, lambda[k], lambda[k]);
        add_linear<Real>(t, -vertex, lambda[k]);
        add_product<Real>(t, Real{4} * midpoint, lambda[k], lambda[(k + 1) % 3]);
    }
    return t;
}

/// `terms(lambda)` in the precision that the triangle needs.
template <std::size_t count, typename TermsOf>
Polynomial fit(const std::array<SnappedPoint, 3>& triangle, const std::array<double, count>& values,
               const PixelIndex& origin, TermsOf terms_of) {
    Polynomial p{{}, origin.x, origin.y};
    const std::int64_t area = doubled_area(triangle[0], triangle[1], triangle[2]);
    if (area == 0) {
        p.t[0] = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(count);
    } else if (double_suffices(triangle, area)) {
        const Terms<double> terms = terms_of(barycentrics<double>(triangle, area, origin));
        std::copy(terms.begin(), terms.end(), p.t.begin());
    } else {
        p.t = terms_of(barycentrics<Coefficient>(triangle, area, origin));
    }
    return p;
}

/// round(value·2^fraction_bits) modulo 2^32, to nearest, halves up. Reduces before converting: a sliver's coefficient
/// exceeds every integer type.
std::uint32_t rounded_word(Coefficient value, int fraction_bits) {
    // Most coefficients are doubles, and small enough for a double's sum.
    const double scaled = std::ldexp(static_cast<double>(value), fraction_bits);
    constexpr double halves_are_exact = 1LL << 51;
    if (std::abs(scaled) < halves_are_exact && static_cast<Coefficient>(static_cast<double>(value)) == value) {
        return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(scaled + 0.5)));
    }
    constexpr Coefficient modulus = static_cast<Coefficient>(std::uint64_t{1} << hls::word_bits);
    constexpr Coefficient all_integers = static_cast<Coefficient>(static_cast<__int128>(1) << 120);
    const Coefficient turns =
        (value * static_cast<Coefficient>(std::uint64_t{1} << fraction_bits) + Coefficient{0.5}) / modulus;
    if (turns >= all_integers || turns <= -all_integers) return 0;  // a multiple of 2^32: no bit is left below
    const Coefficient fraction = turns - static_cast<Coefficient>(static_cast<__int128>(turns));  // in (−1, 1), exact
    const Coefficient word = fraction * modulus;
    std::int64_t whole = static_cast<std::int64_t>(word);
    if (static_cast<Coefficient>(whole) > word) --whole;
    return static_cast<std::uint32_t>(whole);
}

}  // namespace

double Polynomial::at(int x, int y) const {
    const Coefficient dx = x - origin_x;
    const Coefficient dy = y - origin_y;
    return static_cast<double>((t[5] * dx + t[4] * dy + t[2]) * dx + (t[3] * dy + t[1]) * dy + t[0]);
}

PixelIndex centre_pixel(const std::array<SnappedPoint, 3>& triangle) {
    const auto [left, right] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    const auto [top, bottom] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    // Arithmetic shift: floor, for vertices left of or above the image too.
    return {static_cast<int>((left + right) >> (hls::subpixel_bits + 1)),
            static_cast<int>((top + bottom) >> (hls::subpixel_bits + 1))};
}

PixelIndex centre_pixel(const TriangleWalk& walk) {
    int left = std::numeric_limits<int>::max();
    int right = 0;
    for_each_span(walk, [&](int x, int /*y*/, int length, int step) {
        left = std::min({left, x, x + step * (length - 1)});
        right = std::max({right, x, x + step * (length - 1)});
    });
    return {left + (right - left) / 2, walk.y + (walk.rows_above + walk.rows_below) / 2};
}

Polynomial fit_linear(const std::array<SnappedPoint, 3>& triangle, const std::array<double, 3>& values,
                      const PixelIndex& origin) {
    return fit(triangle, values, origin, [&](const auto& lambda) { return linear_terms(lambda, values); });
}

Polynomial fit_quadratic(const std::array<SnappedPoint, 3>& triangle, const std::array<double, 6>& values,
                         const PixelIndex& origin) {
    return fit(triangle, values, origin, [&](const auto& lambda) { return quadratic_terms(lambda, values); });
}

std::uint32_t channel_value(const ChannelWords& channel, std::int64_t u, std::int64_t j) {
    const auto& [i_word, d, e, h, d_row, e_row] = channel.words;
    const auto mod = [](std::int64_t value) { return static_cast<std::uint32_t>(value); };
    return i_word + mod(u) * d + mod(j) * e + mod(u * (u - 1) / 2) * h + mod(u * j) * d_row +
           mod(j * (j - 1) / 2) * e_row;
}

ChannelWords channel_words(const Polynomial& polynomial, const TriangleWalk& walk, int fraction_bits, bool round_half) {
    // The only rounding; everything after it is exact modulo 2^32.
    std::array<std::uint32_t, 6> t{};
    for (std::size_t k = 0; k < t.size(); ++k) t[k] = rounded_word(polynomial.t[k], fraction_bits);
    if (round_half) t[0] += std::uint32_t{1} << (fraction_bits - 1);

    const auto value = [&t](std::uint32_t x, std::uint32_t y) {
        return (t[5] * x + t[4] * y + t[2]) * x + (t[3] * y + t[1]) * y + t[0];
    };
    const auto x = static_cast<std::uint32_t>(walk.x - polynomial.origin_x);
    const auto y = static_cast<std::uint32_t>(walk.y - polynomial.origin_y);
    const auto s = static_cast<std::uint32_t>(walk.leftward ? -1 : 1);
    const auto kappa = static_cast<std::uint32_t>(walk.kappa);

    const std::uint32_t start = value(x, y);
    return {{start, value(x + s, y) - start, value(x + s * kappa, y + 1) - start, 2 * t[5], 2 * t[5] * kappa + s * t[4],
             2 * t[5] * kappa * kappa + 2 * s * t[4] * kappa + 2 * t[3]}};
}

}  // namespace sheen
