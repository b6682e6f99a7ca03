// SPDX-License-Identifier: MIT
#include "gltf_check.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "gltf_buffers.hpp"
#include "gltf_json.hpp"
#include "gltf_material.hpp"
#include "gltf_nodes.hpp"
#include "gltf_primitives.hpp"
#include "plain_gltf.hpp"
#include "sheen/error.hpp"
#include "statements.hpp"

namespace sheen {
namespace {

constexpr std::size_t max_triangles = std::size_t{1} << 21;
constexpr std::size_t max_primitives = 65536;

/// The two parts of a glTF file.
struct Container {
    std::string_view json;
    std::optional<std::string_view> binary;
};

/// Splits a .glb file into its chunks; a .gltf file is all JSON.
Container open_container(const std::string& name, std::string_view bytes) {
    constexpr std::string_view magic = "glTF";
    if (bytes.substr(0, magic.size()) != magic) {
        return {bytes, std::nullopt};
    }
    constexpr std::size_t header_size = 12;
    constexpr std::size_t chunk_header_size = 8;
    constexpr std::size_t json_type = 0x4E4F534A;
    constexpr std::size_t binary_type = 0x004E4942;
    const auto u32 = [&](std::size_t at) { return static_cast<std::size_t>(load_scalar(bytes, at, ScalarType::u32)); };
    if (bytes.size() < header_size + chunk_header_size || u32(4) != 2 || u32(8) != bytes.size()) {
        throw Error(fmt::format("{}: is no whole binary glTF 2.0 file; bytes 4 to 11 must hold 2 and its size, {}",
                                name, bytes.size()));
    }
    Container container;
    for (std::size_t at = header_size; at < bytes.size();) {
        const std::size_t rest = bytes.size() - at;
        if (rest < chunk_header_size || u32(at) > rest - chunk_header_size) {
            throw Error(fmt::format("{}: the chunk at byte {} reaches beyond the end of the file", name, at));
        }
        const std::string_view chunk = bytes.substr(at + chunk_header_size, u32(at));
        const std::size_t type = u32(at + 4);
        if (at == header_size && type != json_type) {
            throw Error(name + ": the first chunk must be 'JSON'");
        }
        if (at == header_size) {
            container.json = chunk;
        } else if (type == binary_type && !container.binary) {
            container.binary = chunk;
        }
        at += chunk_header_size + chunk.size();
    }
    return container;
}

/// Extensions that change no geometry, or that only widen the types of accessors.
bool is_harmless(std::string_view extension) {
    constexpr std::array<std::string_view, 6> beginnings{"KHR_materials_",        "KHR_texture_", "KHR_lights_",
                                                         "KHR_mesh_quantization", "EXT_texture_", "KHR_xmp"};
    for (const std::string_view beginning : beginnings) {
        if (extension.substr(0, beginning.size()) == beginning) {
            return true;
        }
    }
    return false;
}

void check_version(const GltfField& root) {
    const GltfField version = root["asset"]["version"];
    if (version.text().substr(0, 2) != "2.") {
        version.fail(fmt::format("is {}; Sheen reads glTF 2", in_quotes(version.text())));
    }
    if (root.has("extensionsRequired")) {
        const GltfField extensions = root["extensionsRequired"];
        for (std::size_t i = 0; i < extensions.size(); ++i) {
            if (!is_harmless(extensions[i].text())) {
                extensions[i].fail(
                    fmt::format("the file requires {}, which Sheen hasn't", in_quotes(extensions[i].text())));
            }
        }
    }
}

class Checker {
 public:
    Checker(const std::string& name, const GltfField& root, std::optional<std::string_view> chunk)
        : name_(name), root_(root), buffers_(name, root_, chunk) {}

    PlainMesh check() {
        for (const GltfInstance& instance : gltf_instances(root_)) {
            auto mesh = meshes_.find(instance.mesh);
            if (mesh == meshes_.end()) {
                mesh = meshes_.emplace(instance.mesh, read_mesh(root_["meshes"][instance.mesh])).first;
            }
            triangles_ += mesh->second.triangles;
            if (triangles_ > max_triangles) {
                throw Error(fmt::format("{}: the nodes draw more than {} triangles, the most that Sheen reads", name_,
                                        max_triangles));
            }
            if (mesh->second.triangles > 0) {
                plain_.add_node(mesh->second.index, instance.to_world);
            }
        }
        if (triangles_ == 0) {
            throw Error(name_ + ": the file has no triangles; a node of the scene needs a mesh with some");
        }
        PlainMesh result;
        result.bytes = plain_.take();
        if (has_materials_) {
            result.materials = std::move(materials_);
        }
        return result;
    }

 private:
    struct MeshEntry {
        std::size_t index = 0;  ///< in the plain file
        std::size_t triangles = 0;
    };

    MeshEntry read_mesh(const GltfField& mesh) {
        MeshEntry entry;
        entry.index = plain_.add_mesh();
        const GltfField primitives = mesh["primitives"];
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const GltfField primitive = primitives[i];
            if (++primitives_ > max_primitives) {
                primitive.fail(fmt::format("is one primitive more than {}, the most of a file", max_primitives));
            }
            const GltfCorners corners =
                read_gltf_primitive(primitive, buffers_, max_triangles - triangles_ - entry.triangles);
            if (corners.count > 0) {
                plain_.add_primitive(corners, material(primitive));
                entry.triangles += corners.count / 3;
            }
        }
        return entry;
    }

    /// The index of the primitive's material among those that are used.
    std::size_t material(const GltfField& primitive) {
        std::optional<std::size_t> index;
        if (primitive.has("material")) {
            index = primitive["material"].whole();
            has_materials_ = true;
        }
        const auto [entry, added] = material_index_.try_emplace(index, materials_.size());
        if (added) {
            if (materials_.size() == max_materials) {
                primitive.fail(fmt::format("uses one material more than {}, the most of a file", max_materials));
            }
            materials_.push_back(index ? gltf_material(root_["materials"][*index]) : gltf_default_material());
        }
        return entry->second;
    }

    const std::string& name_;
    GltfField root_;
    GltfBuffers buffers_;
    PlainGltf plain_;
    std::map<std::size_t, MeshEntry> meshes_;  ///< by their index in the file
    std::map<std::optional<std::size_t>, std::size_t> material_index_;
    std::vector<Material> materials_;
    bool has_materials_ = false;
    std::size_t primitives_ = 0;
    std::size_t triangles_ = 0;
};

}  // namespace

PlainMesh check_gltf(const std::string& name, std::string_view bytes) {
    const Container container = open_container(name, bytes);
    const nlohmann::json json = parse_gltf_json(name, container.json);
    const GltfField root(name, json);
    check_version(root);
    return Checker(name, root, container.binary).check();
}

}  // namespace sheen
