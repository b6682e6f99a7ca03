// SPDX-License-Identifier: MIT
/// \file
/// How far one picture is from another: peak signal-to-noise ratio and largest error, in 8-bit steps.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "sheen/image.hpp"

namespace sheen {

/// Collects the difference of pairs of pictures, a run each. The square error is the mean over the masked pixels' three
/// components, averaged over the runs.
class ErrorMeter {
 public:
    /// Adds one run, double against double (8-bit steps). `mask` is true at the pixels that count; all three have one
    /// entry a pixel. \throws Error when their sizes differ.
    void add(const std::vector<glm::dvec3>& expected, const std::vector<glm::dvec3>& actual,
             const std::vector<bool>& mask);
    /// Adds one run, 8-bit against 8-bit. \throws Error when the sizes differ.
    void add(const Image& expected, const Image& actual, const std::vector<bool>& mask);

    /// Mean square error, averaged over the runs; 0 before the first one. A run whose mask is empty counts as 0.
    [[nodiscard]] double mean_square_error() const;
    /// 10·log₁₀(255²/mean_square_error()) in dB; infinite when the pictures are equal.
    [[nodiscard]] double psnr() const;
    /// Largest difference of one component over all runs.
    [[nodiscard]] double max_error() const { return max_error_; }

 private:
    double sum_of_means_ = 0.0;
    double max_error_ = 0.0;
    std::size_t runs_ = 0;
};

}  // namespace sheen
