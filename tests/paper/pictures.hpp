// SPDX-License-Identifier: MIT
/// \file
/// The pictures of `make paper`: scenes as the papers show them, drawn with any shader, measured against Phong.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sheen/reference.hpp"
#include "sheen/shader.hpp"

namespace sheen::paper {

using nlohmann::ordered_json;

/// Where pictures go.
class Album {
 public:
    explicit Album(std::string folder) : folder_(std::move(folder)) {}
    /// Writes FOLDER/NAME.png. Pixels whose colour is no number become a checkerboard.
    void keep(const std::string& name, const ReferenceImage& picture) const;
    void keep(const std::string& name, const Image& picture) const;

 private:
    std::string folder_;
};

/// A surface without colour under one white light from the upper left, 512×512, turned so that no edge is special.
/// \param mesh a built-in mesh, named without "builtin:"
Scene grey_scene(const std::string& mesh, double shininess);

/// A single triangle, 480 px wide and high, its normals leaning up to 30 degrees outwards; n = 20.
Scene one_triangle_scene();

/// A unit sphere of 2·segments·(rings − 1) triangles with its poles on y.
Mesh sphere(std::uint32_t segments, std::uint32_t rings);

using MakeShader = std::function<std::unique_ptr<Shader>(const ScreenTriangle&)>;

/// render_reference() with shaders of the caller's. Colours are clamped where they are numbers.
ReferenceImage draw(const Scene& scene, const std::vector<ScreenTriangle>& triangles, const MakeShader& make);

/// The mesh's visible edges, dark on light.
Image wireframe(const Scene& scene, const std::vector<ScreenTriangle>& triangles);

/// PSNR in dB (null where equal) and largest error in 8-bit steps, over the pixels that are numbers, and the percentage
/// of those that are none.
ordered_json quality(const ReferenceImage& expected, const ReferenceImage& drawn);

}  // namespace sheen::paper
