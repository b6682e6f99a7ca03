// SPDX-License-Identifier: MIT
/// \file
/// A method at work on one triangle, in double precision: what the reference asks at every covered pixel.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>

#include "sheen/method.hpp"
#include "sheen/scene.hpp"

namespace sheen {

/// One row of the pixels that a triangle covers in the image.
struct PixelRow {
    int x = 0;  ///< leftmost pixel
    int y = 0;
    int length = 0;  ///< pixels, at least 1
};

/// Shades one triangle.
class Shader {
 public:
    Shader() = default;
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    virtual ~Shader() = default;
    /// Rows may come in any order, and a row in several parts where the image's border cuts it. What a method does per
    /// span depends on the triangle and on `y` alone, so that the border changes no colour.
    virtual void start_row(const PixelRow& /*row*/) {}
    /// Colour in 8-bit steps, not clamped, at the centre of pixel x of the row. `weights` are the vertices' there
    /// (barycentric coordinates on the screen), exact to double precision however thin the triangle.
    [[nodiscard]] virtual glm::dvec3 colour(int x, const glm::dvec3& weights) const = 0;
};

/// Why `method` can't express this scene (its camera, a light, a material's reflection model), in words that say what
/// would be right; nothing where it can.
std::optional<std::string> why_inexpressible(Method method, const Scene& scene);

/// The method's shader for a triangle of the scene, which must outlive it. \throws Error where why_inexpressible().
std::unique_ptr<Shader> make_shader(Method method, const MethodOptions& options, const Scene& scene,
                                    const ScreenTriangle& triangle);

}  // namespace sheen
