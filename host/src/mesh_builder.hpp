// SPDX-License-Identifier: MIT
/// \file
/// A mesh out of an imported scene.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sheen/mesh.hpp"

struct aiMesh;
struct aiNode;
struct aiScene;

namespace sheen {

/// Joins assimp's vertices, one per corner, where place and normal are equal; a missing normal is smoothed over all
/// triangles at its place.
class MeshBuilder {
 public:
    /// Materials are those that the scene's materials name by index; without any, names mean nothing. Normals of the
    /// scene are kept if `keep_normals`.
    MeshBuilder(std::vector<Material> materials, bool keep_normals);

    /// Adds every mesh of the scene's nodes, placed by their transforms; mirrored ones keep their outside. Normals go
    /// by the inverse transpose. \throws Error when a vertex leaves single precision.
    void add(const aiScene& scene);

    Mesh take(const std::string& name);

 private:
    using Key = std::array<double, 3>;
    void add(const aiScene& scene, const aiNode& node, const glm::dmat4& parent);
    void add(const aiMesh& source, const glm::dmat4& to_world, std::uint32_t material);
    std::uint32_t place(const glm::dvec3& position);
    std::uint32_t vertex(std::uint32_t place, const glm::dvec3& normal);

    Mesh mesh_;
    bool keep_normals_;
    std::vector<glm::dvec3> places_;
    std::vector<std::array<std::uint32_t, 3>> place_triangles_;
    std::vector<std::uint32_t> vertex_places_;
    std::map<Key, std::uint32_t> place_index_;
    std::map<std::pair<std::uint32_t, Key>, std::uint32_t> vertex_index_;
};

}  // namespace sheen
