// SPDX-License-Identifier: MIT
#include "sheen/polynomial.hpp"

#include <algorithm>

#include "sheen/hls/formats.hpp"

namespace sheen {
namespace {

constexpr std::int64_t pixel = std::int64_t{1} << hls::subpixel_bits;

/// A barycentric coordinate as a linear function of the pixel, about an origin: x·X + y·Y + one.
struct Barycentric {
    Coefficient x, y, one;
};

/// λ of the vertex opposite to edge from→to: its edge function over the doubled area, at pixel centres about `origin`.
Barycentric barycentric(const SnappedPoint& from, const SnappedPoint& to, std::int64_t area, const PixelIndex& origin) {
    const SnappedPoint sample{pixel * origin.x + pixel / 2, pixel * origin.y + pixel / 2};
    const Coefficient inverse = Coefficient{1} / static_cast<Coefficient>(area);
    return {static_cast<Coefficient>(pixel * (from.y - to.y)) * inverse,
            static_cast<Coefficient>(pixel * (to.x - from.x)) * inverse,
            static_cast<Coefficient>(doubled_area(from, to, sample)) * inverse};
}

std::array<Barycentric, 3> barycentrics(const std::array<SnappedPoint, 3>& v, std::int64_t area,
                                        const PixelIndex& origin) {
    return {barycentric(v[1], v[2], area, origin), barycentric(v[2], v[0], area, origin),
            barycentric(v[0], v[1], area, origin)};
}

void add_linear(Polynomial& p, Coefficient weight, const Barycentric& a) {
    p.t[0] += weight * a.one;
    p.t[1] += weight * a.y;
    p.t[2] += weight * a.x;
}

void add_product(Polynomial& p, Coefficient weight, const Barycentric& a, const Barycentric& b) {
    p.t[0] += weight * (a.one * b.one);
    p.t[1] += weight * (a.one * b.y + a.y * b.one);
    p.t[2] += weight * (a.one * b.x + a.x * b.one);
    p.t[3] += weight * (a.y * b.y);
    p.t[4] += weight * (a.x * b.y + a.y * b.x);
    p.t[5] += weight * (a.x * b.x);
}

template <std::size_t count>
Coefficient mean(const std::array<double, count>& values) {
    Coefficient sum{0};
    for (const double value : values) sum += value;
    return sum / static_cast<Coefficient>(count);
}

/// round(value·2^fraction_bits) modulo 2^32, to nearest, halves up. Reduces before converting: a sliver's coefficient
/// exceeds every integer type.
std::uint32_t rounded_word(Coefficient value, int fraction_bits) {
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

Coefficient Polynomial::value(Coefficient x, Coefficient y) const {
    const Coefficient dx = x - static_cast<Coefficient>(origin_x);
    const Coefficient dy = y - static_cast<Coefficient>(origin_y);
    return (t[5] * dx + t[4] * dy + t[2]) * dx + (t[3] * dy + t[1]) * dy + t[0];
}

Polynomial Polynomial::recentred(int x, int y) const {
    const Coefficient dx = x - origin_x;
    const Coefficient dy = y - origin_y;
    Polynomial moved = *this;
    moved.origin_x = x;
    moved.origin_y = y;
    moved.t[0] = value(x, y);
    moved.t[1] = t[1] + t[4] * dx + Coefficient{2} * t[3] * dy;
    moved.t[2] = t[2] + t[4] * dy + Coefficient{2} * t[5] * dx;
    return moved;
}

PixelIndex centre_pixel(const std::array<SnappedPoint, 3>& triangle) {
    const auto [left, right] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    const auto [top, bottom] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    // Arithmetic shift: floor, for vertices left of or above the image too.
    return {static_cast<int>((left + right) >> (hls::subpixel_bits + 1)),
            static_cast<int>((top + bottom) >> (hls::subpixel_bits + 1))};
}

std::array<Coefficient, 3> barycentric_coordinates(const std::array<SnappedPoint, 3>& triangle,
                                                   const SnappedPoint& point) {
    const auto area = static_cast<Coefficient>(doubled_area(triangle[0], triangle[1], triangle[2]));
    return {static_cast<Coefficient>(doubled_area(triangle[1], triangle[2], point)) / area,
            static_cast<Coefficient>(doubled_area(triangle[2], triangle[0], point)) / area,
            static_cast<Coefficient>(doubled_area(triangle[0], triangle[1], point)) / area};
}

Polynomial fit_linear(const std::array<SnappedPoint, 3>& triangle, const std::array<double, 3>& values) {
    const PixelIndex origin = centre_pixel(triangle);
    Polynomial p{{}, origin.x, origin.y};
    const std::int64_t area = doubled_area(triangle[0], triangle[1], triangle[2]);
    if (area == 0) {
        p.t[0] = mean(values);
        return p;
    }
    const auto lambda = barycentrics(triangle, area, origin);
    for (std::size_t k = 0; k < 3; ++k) add_linear(p, values[k], lambda[k]);
    return p;
}

Polynomial fit_quadratic(const std::array<SnappedPoint, 3>& triangle, const std::array<double, 6>& values) {
    const PixelIndex origin = centre_pixel(triangle);
    Polynomial p{{}, origin.x, origin.y};
    const std::int64_t area = doubled_area(triangle[0], triangle[1], triangle[2]);
    if (area == 0) {
        p.t[0] = mean(values);
        return p;
    }
    // Σ vₖ·λₖ(2λₖ − 1) + Σ 4·vₖₗ·λₖλₗ
    const auto lambda = barycentrics(triangle, area, origin);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const Coefficient vertex = values[k];
        const Coefficient midpoint = values[3 + k];
        add_product(p, Coefficient{2} * vertex, lambda[k], lambda[k]);
        add_linear(p, -vertex, lambda[k]);
        add_product(p, Coefficient{4} * midpoint, lambda[k], lambda[next]);
    }
    return p;
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
