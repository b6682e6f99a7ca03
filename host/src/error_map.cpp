// SPDX-License-Identifier: MIT
#include "error_map.hpp"

#include <algorithm>
#include <cmath>

#include "sheen/compare.hpp"

namespace sheen {
namespace {

/// error_map_gain times the absolute error, `error(pixel, component)` in 8-bit steps.
template <typename Error>
Image make_error_map(int width, int height, Error error) {
    Image map(width, height);
    for (std::size_t i = 0; i < map.rgb.size(); ++i) {
        const double scaled = error_map_gain * std::abs(error(i / 3, i % 3));
        map.rgb[i] = static_cast<std::uint8_t>(std::lround(std::min(scaled, 255.0)));
    }
    return map;
}

}  // namespace

Image error_map(const ReferenceImage& expected, const ReferenceImage& actual) {
    return make_error_map(actual.width, actual.height, [&](std::size_t pixel, std::size_t component) {
        const auto c = static_cast<int>(component);
        return actual.colour[pixel][c] - expected.colour[pixel][c];
    });
}

Image error_map(const Image& expected, const Image& actual) {
    return make_error_map(actual.width, actual.height, [&](std::size_t pixel, std::size_t component) {
        const std::size_t i = 3 * pixel + component;
        return static_cast<double>(actual.rgb[i]) - static_cast<double>(expected.rgb[i]);
    });
}

}  // namespace sheen
