// SPDX-License-Identifier: MIT
/// \file
/// Writes glTF with nothing in it but geometry.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "gltf_primitives.hpp"

namespace sheen {

/// A binary glTF file in the making: nodes without children, meshes of triangles without indices, materials of which
/// the k-th is named "k" and has no other property.
class PlainGltf {
 public:
    /// Begins a mesh and gives its index.
    std::size_t add_mesh();
    /// Adds triangles to the mesh that was begun last.
    void add_primitive(const GltfCorners& corners, std::size_t material);
    void add_node(std::size_t mesh, const glm::dmat4& to_world);
    /// The whole file.
    std::string take();

 private:
    std::size_t add_accessor(const std::string& vectors, std::size_t count);

    nlohmann::json meshes_ = nlohmann::json::array();
    nlohmann::json nodes_ = nlohmann::json::array();
    nlohmann::json accessors_ = nlohmann::json::array();
    std::size_t material_count_ = 0;
    std::string binary_;
};

}  // namespace sheen
