// SPDX-License-Identifier: MIT
/// \file
/// Which light's highlight goes where in `log-quadratic`.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sheen/lighting.hpp"
#include "sheen/method_options.hpp"

namespace sheen {

inline double brightest_component(const Light& light) {
    return std::max({light.colour.x, light.colour.y, light.colour.z});
}

/// A light's colour over its brightest component, which is not 0.
inline glm::dvec3 tint_of(const Light& light) { return light.colour / brightest_component(light); }

/// Who draws which light's highlight; indices into the scene's lights.
struct LogChannels {
    std::vector<std::vector<std::size_t>> logarithmic;  ///< a log channel each: lights of one tint
    std::vector<std::size_t> in_colour;
};

/// Where log_bell() turns into its tangent: G(θ) = line + slope·θ² from θ = start on, up to `farthest`; radians.
struct LogBellTangent {
    static constexpr double farthest = 2.6;
    double start;
    double line;
    double slope;
    explicit LogBellTangent(double shininess);
};

/// The assignment that shade_log_nodes() describes.
LogChannels assign_log_channels(const MethodOptions& options, const Material& material,
                                const std::vector<Light>& lights);

}  // namespace sheen
