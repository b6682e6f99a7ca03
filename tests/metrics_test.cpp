// SPDX-License-Identifier: MIT
// Picture comparison: closed forms of PSNR, masks, and the mean over runs.
#include "sheen/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sheen/error.hpp"

namespace sheen {
namespace {

constexpr unsigned seed = 7001;
constexpr std::size_t pixels = 64;
using Colours = std::vector<glm::dvec3>;

Colours offset(Colours colours, double amount) {
    for (glm::dvec3& colour : colours) {
        colour += amount;
    }
    return colours;
}

TEST(Metrics, AConstantErrorHasTheClosedFormPsnr) {
    const std::vector<bool> mask(pixels, true);
    for (const double error : {0.25, 1.0, -3.5, 100.0, -255.0}) {
        ErrorMeter meter;
        meter.add(Colours(pixels, glm::dvec3(10.0)), offset(Colours(pixels, glm::dvec3(10.0)), error), mask);
        EXPECT_NEAR(meter.psnr(), 20.0 * std::log10(255.0 / std::abs(error)), 1e-9) << "error " << error;
        EXPECT_DOUBLE_EQ(meter.max_error(), std::abs(error));
        EXPECT_DOUBLE_EQ(meter.mean_square_error(), error * error);
    }
}

TEST(Metrics, EqualPicturesHaveInfinitePsnr) {
    ErrorMeter meter;
    meter.add(Colours(pixels, glm::dvec3(3.0)), Colours(pixels, glm::dvec3(3.0)), std::vector<bool>(pixels, true));
    EXPECT_TRUE(std::isinf(meter.psnr()));
    EXPECT_GT(meter.psnr(), 0.0);
    EXPECT_EQ(meter.max_error(), 0.0);
}

TEST(Metrics, PixelsOutsideTheMaskDoNotCount) {
    std::vector<bool> mask(pixels, true);
    mask[5] = false;
    Colours actual(pixels, glm::dvec3(1.0));
    actual[5] = glm::dvec3(200.0);
    ErrorMeter meter;
    meter.add(Colours(pixels, glm::dvec3(0.0)), actual, mask);
    EXPECT_DOUBLE_EQ(meter.mean_square_error(), 1.0);
    EXPECT_DOUBLE_EQ(meter.max_error(), 1.0);
}

TEST(Metrics, RunsAreAveragedInSquareErrorWhateverTheirSize) {
    ErrorMeter meter;
    meter.add(Colours(8, glm::dvec3(0.0)), Colours(8, glm::dvec3(2.0)), std::vector<bool>(8, true));
    meter.add(Colours(800, glm::dvec3(0.0)), Colours(800, glm::dvec3(4.0)), std::vector<bool>(800, true));
    EXPECT_DOUBLE_EQ(meter.mean_square_error(), (4.0 + 16.0) / 2.0);
    EXPECT_DOUBLE_EQ(meter.max_error(), 4.0);
}

TEST(Metrics, EightBitAndDoubleAgreeOnWholeSteps) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> component(0, 255);
    std::bernoulli_distribution chosen(0.7);
    Image expected(8, 8);
    Image actual(8, 8);
    Colours expected_colours(pixels);
    Colours actual_colours(pixels);
    std::vector<bool> mask(pixels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        mask[pixel] = chosen(random);
        for (int c = 0; c < 3; ++c) {
            const std::size_t index = 3 * pixel + static_cast<std::size_t>(c);
            expected_colours[pixel][c] = expected.rgb[index] = static_cast<std::uint8_t>(component(random));
            actual_colours[pixel][c] = actual.rgb[index] = static_cast<std::uint8_t>(component(random));
        }
    }
    ErrorMeter bytes;
    ErrorMeter doubles;
    bytes.add(expected, actual, mask);
    doubles.add(expected_colours, actual_colours, mask);
    EXPECT_DOUBLE_EQ(bytes.mean_square_error(), doubles.mean_square_error());
    EXPECT_DOUBLE_EQ(bytes.max_error(), doubles.max_error());
    EXPECT_GT(bytes.max_error(), 0.0);
}

TEST(Metrics, PicturesOfDifferentSizesAreRefused) {
    ErrorMeter meter;
    EXPECT_THROW(meter.add(Colours(4), Colours(5), std::vector<bool>(4)), Error);
    EXPECT_THROW(meter.add(Colours(4), Colours(4), std::vector<bool>(3)), Error);
    EXPECT_THROW(meter.add(Image(2, 2), Image(2, 3), std::vector<bool>(4)), Error);
}

}  // namespace
}  // namespace sheen
