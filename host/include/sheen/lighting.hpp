// SPDX-License-Identifier: MIT
/// \file
/// Lights, materials and the reflected radiance of paper `spherical`, eq. 8 (Blinn and Lambert, any number of lights).
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace sheen {

/// A directional light in eye space; `direction` points towards the light and has length 1; colour is linear, 1 =
/// white.
struct DirectionalLight {
    glm::dvec3 direction{-0.4, 0.5, 0.77};
    glm::dvec3 colour{1.0};
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

/// Colour in 8-bit steps (255 = full), not clamped above, of a surface point with unit normal `normal` seen from unit
/// direction `to_eye`. Diffuse is max(0, N·L); specular max(0, N·H)^n, not suppressed where N·L < 0, as in the papers.
glm::dvec3 shade(const Material& material, const std::vector<DirectionalLight>& lights, const glm::dvec3& normal,
                 const glm::dvec3& to_eye);

}  // namespace sheen
