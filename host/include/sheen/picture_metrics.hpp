// SPDX-License-Identifier: MIT
/// \file
/// How alike pictures look: SSIM and FLIP, by the Python packages scikit-image and flip-evaluator, which a program of
/// the project's own (scripts/metrics/picture_metrics.py) asks in a process of its own.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sheen/image.hpp"

namespace sheen {

/// Means over the masked pixels; nothing where they have no meaning: no pixel is masked or, for SSIM, a side of the
/// picture is shorter than its window of 11 pixels.
struct PictureMetrics {
    std::optional<double> ssim;  ///< structural similarity, −1…1, 1 for equal pictures
    std::optional<double> flip;  ///< difference seen when a display flips between the pictures, 0…1, 0 for equal ones
};

/// Collects pairs of pictures, and measures them all at once, since the packages take seconds to load.
class PictureMeter {
 public:
    PictureMeter();
    PictureMeter(const PictureMeter&) = delete;
    PictureMeter& operator=(const PictureMeter&) = delete;
    ~PictureMeter();
    /// From now on pictures are held against this one, over the pixels where `mask` is true.
    void expect(const Image& expected, const std::vector<bool>& mask);
    /// Adds a pair; its number is how many came before it. \throws Error when nothing is expected or the sizes differ.
    std::size_t add(const Image& actual);

    struct Result {
        std::vector<PictureMetrics> pairs;  ///< one a pair, or none
        std::string unavailable;            ///< why there are none, and what to install; empty where there are
    };
    /// The interpreter is $SHEEN_PYTHON; else the source folder's build/venv, else python3. `progress` is told before
    /// each pair. \throws Error when the program fails for another reason than a missing interpreter or package.
    [[nodiscard]] Result measure(const std::function<void(std::size_t done, std::size_t total)>& progress = {}) const;

 private:
    struct Files;
    std::unique_ptr<Files> files_;
};

}  // namespace sheen
