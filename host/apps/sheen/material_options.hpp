// SPDX-License-Identifier: MIT
/// \file
/// The options that describe the surface. What the user gives holds for all materials of the mesh; what isn't given is
/// the mesh's own, or the default.
#pragma once

#include <CLI/CLI.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "sheen/lighting.hpp"
#include "sheen/scene.hpp"

namespace sheen::command {

/// What the user says of the material.
class MaterialOptions {
 public:
    MaterialOptions() = default;
    MaterialOptions(const MaterialOptions&) = delete;
    MaterialOptions& operator=(const MaterialOptions&) = delete;

    /// Adds the options to a subcommand, whose parsing this must outlive.
    void add_to(CLI::App& command);
    /// \throws UsageError for a parameter that the reflection model doesn't have.
    void check() const;
    /// Overrides what was given, in the scene's material and in those of its mesh.
    void apply(Scene& scene) const;

 private:
    std::optional<glm::dvec3> ambient_, diffuse_;
    std::optional<double> specular_, shininess_, roughness_, normal_reflectance_;
    std::optional<Brdf> brdf_;
};

}  // namespace sheen::command
