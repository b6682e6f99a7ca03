// SPDX-License-Identifier: MIT
#include "plain_gltf.hpp"

#include <algorithm>
#include <cstdint>

#include "scalars.hpp"

namespace sheen {
namespace {

/// Appends a chunk of binary glTF, padded to four bytes.
void append_chunk(std::string& file, const char* type, std::string content, char padding) {
    content.resize((content.size() + 3) / 4 * 4, padding);
    append_u32(file, static_cast<std::uint32_t>(content.size()));
    file.append(type, 4);
    file += content;
}

}  // namespace

std::size_t PlainGltf::add_mesh() {
    meshes_.push_back({{"primitives", nlohmann::json::array()}});
    return meshes_.size() - 1;
}

void PlainGltf::add_primitive(const GltfCorners& corners, std::size_t material) {
    nlohmann::json attributes{{"POSITION", add_accessor(corners.positions, corners.count)}};
    if (corners.has_normals) {
        attributes["NORMAL"] = add_accessor(corners.normals, corners.count);
    }
    meshes_.back()["primitives"].push_back({{"attributes", std::move(attributes)}, {"material", material}});
    material_count_ = std::max(material_count_, material + 1);
}

std::size_t PlainGltf::add_accessor(const std::string& vectors, std::size_t count) {
    constexpr int float_type = 5126;
    accessors_.push_back({{"bufferView", 0},
                          {"byteOffset", binary_.size()},
                          {"componentType", float_type},
                          {"count", count},
                          {"type", "VEC3"}});
    binary_ += vectors;
    return accessors_.size() - 1;
}

void PlainGltf::add_node(std::size_t mesh, const glm::dmat4& to_world) {
    nlohmann::json matrix = nlohmann::json::array();
    for (int i = 0; i < 16; ++i) {
        matrix.push_back(to_world[i / 4][i % 4]);
    }
    nodes_.push_back({{"mesh", mesh}, {"matrix", std::move(matrix)}});
}

std::string PlainGltf::take() {
    nlohmann::json roots = nlohmann::json::array();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        roots.push_back(i);
    }
    nlohmann::json materials = nlohmann::json::array();
    for (std::size_t i = 0; i < material_count_; ++i) {
        materials.push_back({{"name", std::to_string(i)}});
    }
    const nlohmann::json json{
        {"asset", {{"version", "2.0"}}},
        {"scene", 0},
        {"scenes", {{{"nodes", std::move(roots)}}}},
        {"nodes", std::move(nodes_)},
        {"meshes", std::move(meshes_)},
        {"materials", std::move(materials)},
        {"accessors", std::move(accessors_)},
        {"bufferViews", {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", binary_.size()}}}},
        {"buffers", {{{"byteLength", binary_.size()}}}},
    };
    std::string chunks;
    append_chunk(chunks, "JSON", json.dump(), ' ');
    append_chunk(chunks, "BIN\0", std::move(binary_), '\0');
    constexpr std::uint32_t header_size = 12;
    std::string file = "glTF";
    append_u32(file, 2);
    append_u32(file, header_size + static_cast<std::uint32_t>(chunks.size()));
    return file + chunks;
}

}  // namespace sheen
