// SPDX-License-Identifier: MIT
/// \file
/// The double-precision reference: any method evaluated at every covered pixel, with the devices' coverage and depth
/// rule.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "sheen/image.hpp"
#include "sheen/method.hpp"

namespace sheen {

/// A picture in double precision.
struct ReferenceImage {
    int width = 0;
    int height = 0;
    std::vector<glm::dvec3> colour;  ///< 8-bit steps, saturated to 0…255, not rounded; row 0 at the top
    std::vector<bool> covered;
    std::size_t triangles = 0;  ///< walks: triangles that covered a pixel, or what the image leaves of them
    std::size_t pixels = 0;     ///< pixels drawn, hidden ones included
    /// Rounded to 8 bits.
    [[nodiscard]] Image image() const;
};

/// Renders `method` per pixel with its Shader. Coverage and depth are the devices', to the bit, so that a pixel shows
/// the same triangle. \throws Error where the method can't express the scene.
ReferenceImage render_reference(Method method, const Scene& scene, const std::vector<ScreenTriangle>& triangles,
                                const MethodOptions& options = {});

}  // namespace sheen
