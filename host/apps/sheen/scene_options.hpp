// SPDX-License-Identifier: MIT
/// \file
/// The options that describe a scene, shared by every subcommand that draws one.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "material_options.hpp"
#include "sheen/image.hpp"
#include "sheen/scene.hpp"

namespace sheen::command {

/// Adds MESH and the scene's options to a subcommand, and collects what the user says. Must outlive the parsing.
class SceneOptions {
 public:
    explicit SceneOptions(CLI::App& command);
    SceneOptions(const SceneOptions&) = delete;
    SceneOptions& operator=(const SceneOptions&) = delete;

    /// The scene with its mesh loaded, and the default light where the user gave none. \throws UsageError for options
    /// that don't go together; Error naming the file.
    [[nodiscard]] Scene load() const;
    [[nodiscard]] const std::string& mesh() const { return mesh_; }
    [[nodiscard]] int width() const { return scene_.width; }
    [[nodiscard]] int height() const { return scene_.height; }
    [[nodiscard]] bool has_lights() const { return !scene_.lights.empty(); }
    /// The image as it is to be stored.
    [[nodiscard]] Image finish(const Image& image) const;

 private:
    void add_light_options(CLI::App& command);

    MaterialOptions material_;
    Scene scene_;
    bool light_has_colour_ = false;  ///< the last light was given one
    std::string mesh_;
    bool srgb_ = false;
};

}  // namespace sheen::command
