// SPDX-License-Identifier: MIT
/// \file
/// What a method costs on a scene: operations counted while its Loop shades every pixel of every triangle.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "sheen/loop.hpp"

namespace sheen {

/// A mean of OperationCounts.
struct MeanCounts {
    double additions = 0.0;
    double multiplications = 0.0;
    double divisions = 0.0;
    double roots = 0.0;
    double powers = 0.0;
    double comparisons = 0.0;
    double table_reads = 0.0;
    /// Each with its name, in this order.
    [[nodiscard]] std::array<std::pair<const char*, double>, 7> named() const;
};

/// Hidden pixels count like seen ones: the pixel is shaded before its depth is known.
struct MethodCost {
    MeanCounts nodes;     ///< per triangle, for radiance at nodes: the reflection model's share of the setup
    MeanCounts triangle;  ///< per triangle, the rest of the setup
    MeanCounts span;      ///< per row of a triangle's pixels
    MeanCounts pixel;     ///< per pixel
    /// Each with its name, in this order.
    [[nodiscard]] std::array<std::pair<const char*, MeanCounts>, 4> named() const;
};

/// Sums over the triangles that cover a pixel, their spans and pixels in the image, divided by how many there are:
/// large triangles weigh more in `span` and `pixel`, as they do in the work. All 0 where no triangle covers a pixel.
/// \throws Error where why_inexpressible().
MethodCost method_cost(Method method, const Scene& scene, const std::vector<ScreenTriangle>& triangles,
                       const MethodOptions& options = {});

}  // namespace sheen
