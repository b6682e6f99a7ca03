// SPDX-License-Identifier: MIT
/// \file
/// Mesh files that tests write themselves, and what loading them says.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sheen/error.hpp"
#include "sheen/mesh.hpp"

namespace sheen::test {

/// A folder of its own for each test.
class MeshFiles : public testing::Test {
 protected:
    MeshFiles() : folder_(std::filesystem::temp_directory_path() / ("sheen_mesh_files_" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(folder_ / "meshes");
    }
    ~MeshFiles() override { std::filesystem::remove_all(folder_); }

    /// The path of a mesh file of this name. The folder around its own is the test's too.
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / "meshes" / name).string(); }

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
    }

    [[nodiscard]] Mesh load(const std::string& name, const std::string& bytes) const {
        write(name, bytes);
        return load_mesh(path(name));
    }

    /// The message of the error that loading the file gives, from the file's name on.
    [[nodiscard]] std::string fault(const std::string& name) const {
        try {
            load_mesh(path(name));
        } catch (const UsageError& error) {
            return std::string("usage error: ") + error.what();
        } catch (const Error& error) {
            std::string message = error.what();
            const std::string start = (folder_ / "meshes").string() + "/";
            EXPECT_EQ(message.rfind(start, 0), 0U) << message << " does not begin with the file";
            EXPECT_EQ(message.find('\n'), std::string::npos) << message << " is more than one line";
            EXPECT_LT(message.size(), start.size() + 600) << message;
            return message.substr(std::min(message.size(), start.size()));
        }
        return "accepted";
    }

    [[nodiscard]] std::string fault(const std::string& name, const std::string& bytes) const {
        write(name, bytes);
        return fault(name);
    }

 private:
    std::filesystem::path folder_;
};

/// Expects that a message begins with `start` and holds `word`.
inline void expect_message(const std::string& message, const std::string& start, const std::string& word) {
    EXPECT_EQ(message.rfind(start, 0), 0U) << "got: " << message << "\nexpected at its start: " << start;
    EXPECT_NE(message.find(word), std::string::npos) << "got: " << message << "\nexpected in it: " << word;
}

/// Expects sound indices and unit normals.
inline void expect_sound(const Mesh& mesh) {
    ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
    ASSERT_TRUE(mesh.triangle_materials.empty() || mesh.triangle_materials.size() == mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t index : triangle) {
            ASSERT_LT(index, mesh.positions.size());
            const glm::dvec3& n = mesh.normals[index];
            ASSERT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1.0, 1e-9);
        }
    }
    for (const std::uint32_t material : mesh.triangle_materials) {
        ASSERT_LT(material, mesh.materials.size());
    }
}

/// The bytes of a value in the order of `T`'s memory, or turned round.
template <typename T>
std::string bytes_of(T value, bool turned = false) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (turned) {
        std::reverse(bytes.begin(), bytes.end());
    }
    return bytes;
}

inline std::string floats(const std::vector<float>& values, bool turned = false) {
    std::string bytes;
    for (const float value : values) {
        bytes += bytes_of(value, turned);
    }
    return bytes;
}

inline std::string base64(const std::string& bytes) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group * 256 + (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k > bytes.size() ? '=' : digits[(group >> (18 - 6 * k)) & 63U];
        }
    }
    return text;
}

/// Puts JSON and a binary chunk into a .glb file.
inline std::string glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const auto u32 = [](std::size_t value) { return bytes_of(static_cast<std::uint32_t>(value)); };
    return "glTF" + u32(2) + u32(12 + 8 + json.size() + 8 + binary.size()) + u32(json.size()) + "JSON" + json +
           u32(binary.size()) + std::string("BIN\0", 4) + binary;
}

/// A unit square of two triangles in the plane z = 0, facing +z: its buffer has four positions, then six 16-bit
/// indices.
inline std::string square_buffer() {
    std::string bytes = floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    for (const std::uint16_t index : std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}) {
        bytes += bytes_of(index);
    }
    return bytes;
}

/// The glTF JSON of the square, one node and one mesh, its buffer in the binary chunk.
inline nlohmann::json square_gltf() {
    return nlohmann::json::parse(R"({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "buffers": [{"byteLength": 60}]})");
}

/// The square as text PLY, with two lines of header that Sheen has no use for.
inline std::string square_ply() {
    return "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\nproperty uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0 255\n1 0 0 0\n1 1 0 7\n0 1 0 9\n4 0 1 2 3\n";
}

/// The square as text STL.
inline std::string square_stl() {
    return "solid a square\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 "
           "0\nendloop\nendfacet\n"
           "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
}

/// Triangles as binary STL, nine coordinates each.
inline std::string binary_stl(const std::vector<float>& coordinates) {
    std::string bytes(80, 'x');
    bytes += bytes_of(static_cast<std::uint32_t>(coordinates.size() / 9));
    for (std::size_t i = 0; i + 9 <= coordinates.size(); i += 9) {
        bytes += floats({0, 0, 1}) +
                 floats({coordinates.begin() + static_cast<std::ptrdiff_t>(i),
                         coordinates.begin() + static_cast<std::ptrdiff_t>(i + 9)}) +
                 std::string(2, '\0');
    }
    return bytes;
}

}  // namespace sheen::test
