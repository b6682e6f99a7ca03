// SPDX-License-Identifier: MIT
/// \file
/// Lights, materials and the reflected radiance of paper `spherical`, eq. 8 (Blinn and Lambert, any number of lights).
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace sheen {

/// A light in eye space; its colour is linear, 1 = white.
struct Light {
    enum class Kind { directional, positional };
    glm::dvec3 vector{-0.4, 0.5, 0.77};  ///< directional: towards the light, of length 1; positional: its place
    glm::dvec3 colour{1.0};
    Kind kind = Kind::directional;
    /// Unit vector from a surface point towards the light; (0, 0, 1) for a point in the light's own place.
    [[nodiscard]] glm::dvec3 direction_from(const glm::dvec3& position) const;
};

enum class Brdf { blinn };

/// Reflectances in 0…1, shininess n ≥ 0.
struct Material {
    glm::dvec3 ambient{0.05};
    glm::dvec3 diffuse{0.55, 0.20, 0.12};
    double specular = 0.40;
    double shininess = 50.0;
    Brdf brdf = Brdf::blinn;
};

/// A point of a surface as shading sees it, in eye space.
struct SurfacePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit
    glm::dvec3 to_eye{0.0, 0.0, 1.0};  ///< unit
};

/// Colour in 8-bit steps (255 = full), not clamped above, of a surface point. Diffuse is max(0, N·L); specular max(0,
/// N·H)^n, not suppressed where N·L < 0, as in the papers.
glm::dvec3 shade(const Material& material, const std::vector<Light>& lights, const SurfacePoint& point);

}  // namespace sheen
