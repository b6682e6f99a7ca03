// SPDX-License-Identifier: MIT
/// \file
/// Picture comparison.
#include "sheen/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "sheen/error.hpp"

namespace sheen {
namespace {

constexpr int components = 3;
constexpr double peak = 255.0;

void require_same_size(std::size_t expected, std::size_t actual, std::size_t mask) {
    if (expected != actual || expected != mask) {
        throw Error("cannot compare pictures of " + std::to_string(expected) + " and " + std::to_string(actual) +
                    " pixels under a mask of " + std::to_string(mask) + "; all three must be of one size");
    }
}

/// Mean square and largest error of one run.
struct RunError {
    double mean_square = 0.0;
    double max = 0.0;
};

/// `difference(pixel, component)` is the signed error there.
template <typename Difference>
RunError measure(const std::vector<bool>& mask, Difference difference) {
    RunError result;
    std::size_t pixels = 0;
    for (std::size_t pixel = 0; pixel < mask.size(); ++pixel) {
        if (!mask[pixel]) {
            continue;
        }
        ++pixels;
        for (int component = 0; component < components; ++component) {
            const double error = difference(pixel, component);
            result.mean_square += error * error;
            result.max = std::max(result.max, std::abs(error));
        }
    }
    if (pixels > 0) {
        result.mean_square /= static_cast<double>(pixels) * components;
    }
    return result;
}

}  // namespace

void ErrorMeter::add(const std::vector<glm::dvec3>& expected, const std::vector<glm::dvec3>& actual,
                     const std::vector<bool>& mask) {
    require_same_size(expected.size(), actual.size(), mask.size());
    const RunError run = measure(
        mask, [&](std::size_t pixel, int component) { return actual[pixel][component] - expected[pixel][component]; });
    sum_of_means_ += run.mean_square;
    max_error_ = std::max(max_error_, run.max);
    ++runs_;
}

void ErrorMeter::add(const Image& expected, const Image& actual, const std::vector<bool>& mask) {
    require_same_size(expected.rgb.size() / components, actual.rgb.size() / components, mask.size());
    const RunError run = measure(mask, [&](std::size_t pixel, int component) {
        const std::size_t index = pixel * components + static_cast<std::size_t>(component);
        return static_cast<double>(actual.rgb[index]) - static_cast<double>(expected.rgb[index]);
    });
    sum_of_means_ += run.mean_square;
    max_error_ = std::max(max_error_, run.max);
    ++runs_;
}

double ErrorMeter::mean_square_error() const { return runs_ == 0 ? 0.0 : sum_of_means_ / static_cast<double>(runs_); }

double ErrorMeter::psnr() const {
    const double error = mean_square_error();
    return error == 0.0 ? std::numeric_limits<double>::infinity() : 10.0 * std::log10(peak * peak / error);
}

}  // namespace sheen
