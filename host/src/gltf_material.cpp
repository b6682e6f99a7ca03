// SPDX-License-Identifier: MIT
#include "gltf_material.hpp"

#include <algorithm>
#include <cmath>

namespace sheen {
namespace {

Material from_factors(const glm::dvec3& base_colour, double roughness) {
    constexpr double most_shiny = 1000.0;
    constexpr double dielectric = 0.04;
    Material material;
    material.diffuse = base_colour;
    material.shininess = most_shiny;
    if (const double slope = roughness * roughness; slope * slope * (most_shiny + 2.0) > 2.0) {
        material.shininess = 2.0 / (slope * slope) - 2.0;
    }
    material.specular = std::min(1.0, dielectric * (material.shininess + 8.0) / 8.0);
    return material;
}

double fraction(const GltfField& field) {
    const double value = field.number();
    if (value < 0.0 || value > 1.0) {
        field.fail("must be within 0 to 1");
    }
    return value;
}

}  // namespace

Material gltf_material(const GltfField& material) {
    glm::dvec3 base_colour(1.0);
    double roughness = 1.0;
    if (material.has("pbrMetallicRoughness")) {
        const GltfField factors = material["pbrMetallicRoughness"];
        if (factors.has("baseColorFactor")) {
            for (std::size_t i = 0; i < 3; ++i) {
                base_colour[static_cast<int>(i)] = fraction(factors["baseColorFactor"][i]);
            }
        }
        if (factors.has("roughnessFactor")) {
            roughness = fraction(factors["roughnessFactor"]);
        }
    }
    return from_factors(base_colour, roughness);
}

Material gltf_default_material() { return from_factors(glm::dvec3(1.0), 1.0); }

}  // namespace sheen
