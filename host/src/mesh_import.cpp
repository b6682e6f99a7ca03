// SPDX-License-Identifier: MIT
/// \file
/// Mesh files. Sheen checks them itself, since assimp trusts sizes and indices, drops bad faces and takes garbage for
/// numbers in silence; assimp then makes triangles of what was checked, written anew.
#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <utility>

#include "gltf_check.hpp"
#include "mesh_builder.hpp"
#include "mesh_file.hpp"
#include "obj_check.hpp"
#include "plain_mesh.hpp"
#include "ply_check.hpp"
#include "sheen/error.hpp"
#include "sheen/mesh.hpp"
#include "statements.hpp"
#include "stl_check.hpp"

namespace sheen {
namespace {

constexpr std::string_view builtin_prefix = "builtin:";

/// A file format: its extension, what reads it, and how assimp calls it.
struct Format {
    std::string_view extension;
    PlainMesh (*check)(const std::string& name, std::string_view bytes);
    const char* hint;                ///< the plain mesh's extension
    std::string_view importer;       ///< the name of assimp's importer
    bool has_vertex_normals = true;  ///< false: assimp's are those of flat triangles
};

constexpr std::array<Format, 6> formats{{
    {"", check_obj, "obj", "Wavefront Object Importer"},
    {".obj", check_obj, "obj", "Wavefront Object Importer"},
    {".ply", check_ply, "ply", "Stanford Polygon Library (PLY) Importer"},
    {".stl", check_stl, "stl", "Stereolithography (STL) Importer", false},
    {".gltf", check_gltf, "glb", "glTF2 Importer"},
    {".glb", check_gltf, "glb", "glTF2 Importer"},
}};

const Format& format_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const Format& format : formats) {
        if (format.extension == extension) {
            return format;
        }
    }
    throw Error(
        path + ": " + in_quotes(extension) +
        " is no mesh format; Sheen reads .obj, .ply, .stl, .gltf and .glb, and files without an extension as OBJ");
}

/// Leaves only the importer of this name.
void restrict_to(Assimp::Importer& importer, std::string_view name) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        if (importer.GetImporterInfo(i)->mName != name) {
            Assimp::BaseImporter* other = importer.GetImporter(i);
            importer.UnregisterLoader(other);
            delete other;  // unregistering hands it over
        }
    }
}

Mesh load_file(const std::string& path) {
    const Format& format = format_of(path);
    PlainMesh plain = format.check(path, read_mesh_file(path));
    Assimp::Importer importer;
    restrict_to(importer, format.importer);
    const aiScene* scene =
        importer.ReadFileFromMemory(plain.bytes.data(), plain.bytes.size(), aiProcess_Triangulate, format.hint);
    if (scene == nullptr) {
        throw Error(path + ": cannot be read: " + importer.GetErrorString());
    }
    MeshBuilder builder(std::move(plain.materials), format.has_vertex_normals);
    try {
        builder.add(*scene);
    } catch (const Error& error) {
        throw Error(path + ": " + error.what());
    }
    Mesh mesh = builder.take(std::filesystem::path(path).filename().string());
    if (mesh.triangles.empty()) {
        throw Error(path + ": the file has no triangles; at least one face with area is needed");
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
