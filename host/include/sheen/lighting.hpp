// SPDX-License-Identifier: MIT
/// \file
/// Lights, materials and the reflected radiance of paper `spherical`, eq. 8: Lambert, and a highlight of Blinn, Phong
/// or Cook and Torrance, of any number of lights.
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

/// How a surface reflects its highlight, H = (L + V)/|L + V| and R = 2(N·L)N − L:
/// - `blinn`: max(0, N·H)^n, and `phong`: max(0, R·V)^n, not suppressed where N·L < 0, as in the papers;
/// - `cook_torrance`: F·D·G/(4 N·V) with Beckmann's D, 0 where N·L ≤ 0. Where N·V ≤ 0 (interpolated normals past the
///   silhouette) G/(N·V) keeps its limit.
enum class Brdf { blinn, phong, cook_torrance };

/// Reflectances in 0…1.
struct Material {
    glm::dvec3 ambient{0.05};
    glm::dvec3 diffuse{0.55, 0.20, 0.12};
    double specular = 0.40;
    double shininess = 50.0;  ///< `blinn`, `phong`: exponent n ≥ 0
    Brdf brdf = Brdf::blinn;
    double roughness = 0.2;           ///< `cook_torrance`: root mean square slope m of the facets, 0.01…1
    double normal_reflectance = 0.1;  ///< `cook_torrance`: Fresnel reflectance at normal incidence, 0…1
};

/// A point of a surface as shading sees it, in eye space.
struct SurfacePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit
    glm::dvec3 to_eye{0.0, 0.0, 1.0};  ///< unit
};

/// Colour in 8-bit steps (255 = full), not clamped above, of a surface point: 255·(ambient + Σ lights
/// colour·(diffuse·max(0, N·L) + specular·highlight)). A light's distance doesn't matter. Where L and V are opposite H
/// has no direction, and there is no highlight. Finite for any unit vectors.
glm::dvec3 shade(const Material& material, const std::vector<Light>& lights, const SurfacePoint& point);

}  // namespace sheen
