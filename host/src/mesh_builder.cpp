// SPDX-License-Identifier: MIT
#include "mesh_builder.hpp"

#include <assimp/scene.h>

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <string_view>

#include "sheen/error.hpp"

namespace sheen {
namespace {

glm::dvec3 to_dvec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// assimp's matrices are row by row, glm's column by column.
glm::dmat4 to_dmat4(const aiMatrix4x4& m) {
    return glm::transpose(
        glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4));
}

/// The unit vector along `v`; zero where it has no direction.
glm::dvec3 direction(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

/// The cofactors of `m`, which are its inverse transpose times its determinant, and exist for every matrix.
glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

/// The number that a material's name is; 0 for other names.
std::uint32_t material_index(const aiMaterial& material) {
    const aiString ai_name = const_cast<aiMaterial&>(material).GetName();  // assimp forgot its const
    const std::string_view name(ai_name.data, ai_name.length);
    std::uint32_t index = 0;
    std::from_chars(name.data(), name.data() + name.size(), index);
    return index;
}

}  // namespace

MeshBuilder::MeshBuilder(std::vector<Material> materials, bool keep_normals) : keep_normals_(keep_normals) {
    mesh_.materials = std::move(materials);
}

void MeshBuilder::add(const aiScene& scene) { add(scene, *scene.mRootNode, glm::dmat4(1.0)); }

void MeshBuilder::add(const aiScene& scene, const aiNode& node, const glm::dmat4& parent) {
    const glm::dmat4 to_world = parent * to_dmat4(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        const aiMesh& source = *scene.mMeshes[node.mMeshes[i]];
        const bool named = !mesh_.materials.empty() && source.mMaterialIndex < scene.mNumMaterials;
        add(source, to_world, named ? material_index(*scene.mMaterials[source.mMaterialIndex]) : 0);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
        add(scene, *node.mChildren[i], to_world);
    }
}

void MeshBuilder::add(const aiMesh& source, const glm::dmat4& to_world, std::uint32_t material) {
    const glm::dmat3 linear(to_world);
    const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
    const glm::dmat3 to_normal = side * cofactors(linear);
    for (unsigned face = 0; face < source.mNumFaces; ++face) {
        const aiFace& corners = source.mFaces[face];
        if (corners.mNumIndices != 3) {
            continue;  // what is left of a polygon without area
        }
        std::array<std::uint32_t, 3> triangle{};
        std::array<std::uint32_t, 3> places{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const unsigned index = corners.mIndices[corner];
            glm::dvec3 normal(0.0);
            if (keep_normals_ && source.HasNormals()) {
                normal = direction(to_normal * direction(to_dvec3(source.mNormals[index])));
            }
            const std::size_t turned = side < 0.0 ? 2 - corner : corner;
            places[turned] = place(glm::dvec3(to_world * glm::dvec4(to_dvec3(source.mVertices[index]), 1.0)));
            triangle[turned] = vertex(places[turned], normal);
        }
        mesh_.triangles.push_back(triangle);
        place_triangles_.push_back(places);
        if (!mesh_.materials.empty()) {
            mesh_.triangle_materials.push_back(material);
        }
    }
}

Mesh MeshBuilder::take(const std::string& name) {
    const std::vector<glm::dvec3> smooth = smooth_normals(places_, place_triangles_);
    for (std::size_t vertex = 0; vertex < mesh_.normals.size(); ++vertex) {
        if (mesh_.normals[vertex] == glm::dvec3(0.0)) {
            mesh_.normals[vertex] = smooth[vertex_places_[vertex]];
        }
    }
    mesh_.name = name;
    return std::move(mesh_);
}

std::uint32_t MeshBuilder::place(const glm::dvec3& position) {
    constexpr double greatest = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(position[axis]) <= greatest)) {
            throw Error("a vertex lies outside single precision after its nodes' transforms; make their scale smaller");
        }
    }
    const auto [entry, added] =
        place_index_.try_emplace({position.x, position.y, position.z}, static_cast<std::uint32_t>(places_.size()));
    if (added) {
        places_.push_back(position);
    }
    return entry->second;
}

std::uint32_t MeshBuilder::vertex(std::uint32_t place, const glm::dvec3& normal) {
    const auto [entry, added] = vertex_index_.try_emplace({place, {normal.x, normal.y, normal.z}},
                                                          static_cast<std::uint32_t>(mesh_.positions.size()));
    if (added) {
        mesh_.positions.push_back(places_[place]);
        mesh_.normals.push_back(normal);
        vertex_places_.push_back(place);
    }
    return entry->second;
}

}  // namespace sheen
