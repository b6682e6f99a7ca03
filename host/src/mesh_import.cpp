// SPDX-License-Identifier: MIT
/// \file
/// Mesh files. Sheen checks the text itself, since assimp drops bad faces and takes garbage for numbers in silence;
/// assimp then makes triangles of what was checked.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <array>
#include <assimp/Importer.hpp>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <system_error>

#include "obj_check.hpp"
#include "sheen/error.hpp"
#include "sheen/mesh.hpp"

namespace sheen {
namespace {

constexpr std::string_view builtin_prefix = "builtin:";
constexpr std::size_t max_file_size = std::size_t{1} << 30;

std::string read_text(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw Error(path + ": cannot read: it is a directory; give a Wavefront OBJ file");
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) {
        throw Error(path + ": cannot read: " + std::strerror(errno) + "; give a Wavefront OBJ file or a built-in mesh");
    }
    std::string text;
    std::array<char, 1 << 16> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
        text.append(buffer.data(), count);
        if (text.size() > max_file_size) {
            throw Error(path + ": the file is larger than 1 GiB, the most that Sheen reads");
        }
    }
    if (std::ferror(file.get()) != 0) {
        throw Error(path + ": cannot read: " + std::strerror(errno));
    }
    if (text.empty()) {
        throw Error(path + ": the file is empty; give a Wavefront OBJ file");
    }
    return text;
}

glm::dvec3 to_dvec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// The unit vector along `v`; zero where it has no direction.
glm::dvec3 direction(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

/// Joins assimp's vertices, one per corner, where place and normal are equal; a missing normal is smoothed over all
/// triangles at its place.
class MeshBuilder {
 public:
    void add(const aiMesh& source) {
        for (unsigned face = 0; face < source.mNumFaces; ++face) {
            const aiFace& corners = source.mFaces[face];
            if (corners.mNumIndices != 3) {
                continue;  // what is left of a polygon without area
            }
            std::array<std::uint32_t, 3> triangle{};
            std::array<std::uint32_t, 3> places{};
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const unsigned index = corners.mIndices[corner];
                places[corner] = place(to_dvec3(source.mVertices[index]));
                triangle[corner] =
                    vertex(places[corner],
                           source.HasNormals() ? direction(to_dvec3(source.mNormals[index])) : glm::dvec3(0.0));
            }
            mesh_.triangles.push_back(triangle);
            place_triangles_.push_back(places);
        }
    }

    Mesh take(const std::string& name) {
        const std::vector<glm::dvec3> smooth = smooth_normals(places_, place_triangles_);
        for (std::size_t vertex = 0; vertex < mesh_.normals.size(); ++vertex) {
            if (mesh_.normals[vertex] == glm::dvec3(0.0)) {
                mesh_.normals[vertex] = smooth[vertex_places_[vertex]];
            }
        }
        mesh_.name = name;
        return std::move(mesh_);
    }

 private:
    std::uint32_t place(const glm::dvec3& position) {
        const auto [entry, added] =
            place_index_.try_emplace({position.x, position.y, position.z}, static_cast<std::uint32_t>(places_.size()));
        if (added) {
            places_.push_back(position);
        }
        return entry->second;
    }

    std::uint32_t vertex(std::uint32_t place, const glm::dvec3& normal) {
        const auto [entry, added] = vertex_index_.try_emplace({place, {normal.x, normal.y, normal.z}},
                                                              static_cast<std::uint32_t>(mesh_.positions.size()));
        if (added) {
            mesh_.positions.push_back(places_[place]);
            mesh_.normals.push_back(normal);
            vertex_places_.push_back(place);
        }
        return entry->second;
    }

    using Key = std::array<double, 3>;
    Mesh mesh_;
    std::vector<glm::dvec3> places_;
    std::vector<std::array<std::uint32_t, 3>> place_triangles_;
    std::vector<std::uint32_t> vertex_places_;
    std::map<Key, std::uint32_t> place_index_;
    std::map<std::pair<std::uint32_t, Key>, std::uint32_t> vertex_index_;
};

Mesh load_file(const std::string& path) {
    const std::string plain = check_obj(path, read_text(path));
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(plain.data(), plain.size(), aiProcess_Triangulate, "obj");
    if (scene == nullptr) {
        throw Error(path + ": cannot read as Wavefront OBJ: " + importer.GetErrorString());
    }
    MeshBuilder builder;
    for (unsigned index = 0; index < scene->mNumMeshes; ++index) {
        builder.add(*scene->mMeshes[index]);
    }
    Mesh mesh = builder.take(std::filesystem::path(path).filename().string());
    if (mesh.triangles.empty()) {
        throw Error(path + ": the file has no triangles; at least one 'f' statement with area is needed");
    }
    return mesh;
}

}  // namespace

Mesh load_mesh(const std::string& source) {
    if (source.compare(0, builtin_prefix.size(), builtin_prefix) == 0) {
        return make_builtin_mesh(source);
    }
    return load_file(source);
}

}  // namespace sheen
