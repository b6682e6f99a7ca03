// SPDX-License-Identifier: MIT
// PLY files: text and binary agree, and each fault is named by file and line or row.
#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <random>

#include "support/mesh_files.hpp"

namespace sheen::test {
namespace {

class PlyImport : public MeshFiles {};

/// The text with its first `from` replaced.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// A binary file of random triangles with normals, an element before the vertices and properties around theirs.
std::string binary_ply(bool big, const std::vector<float>& vertices, const std::vector<std::uint32_t>& corners) {
    const std::size_t count = vertices.size() / 6;
    std::string bytes = fmt::format(
        "ply\r\nformat binary_{}_endian 1.0\r\nobj_info none\r\nelement junk 2\r\nproperty list uchar short a\r\n"
        "element vertex {}\r\nproperty double nx\r\nproperty float y\r\nproperty float x\r\nproperty uchar red\r\n"
        "property float ny\r\nproperty float nz\r\nproperty float z\r\nelement face {}\r\nproperty uchar flag\r\n"
        "property list ushort uint vertex_index\r\nend_header\r\n",
        big ? "big" : "little", count, corners.size() / 3);
    bytes += std::string("\x02", 1) + std::string(4, '\n') + std::string(1, '\0');
    for (std::size_t i = 0; i < count; ++i) {
        const float* v = &vertices[6 * i];
        bytes += bytes_of(static_cast<double>(v[3]), big) + floats({v[1], v[0]}, big) + "\r" +
                 floats({v[4], v[5], v[2]}, big);
    }
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        bytes += "f" + bytes_of(std::uint16_t{3}, big) + bytes_of(corners[i], big) + bytes_of(corners[i + 1], big) +
                 bytes_of(corners[i + 2], big);
    }
    return bytes;
}

TEST_F(PlyImport, BinaryFilesOfBothByteOrdersKeepEveryBit) {
    constexpr unsigned seed = 5101;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> coordinate(-9.0F, 9.0F);
    for (int round = 0; round < 20; ++round) {
        std::vector<float> vertices(6 * (3 + random() % 40));
        std::generate(vertices.begin(), vertices.end(), [&] { return coordinate(random); });
        std::vector<std::uint32_t> corners(3 * (1 + random() % 60));
        std::generate(corners.begin(), corners.end(),
                      [&] { return static_cast<std::uint32_t>(random() % (vertices.size() / 6)); });
        for (const bool big : {false, true}) {
            const Mesh mesh = load("a.ply", binary_ply(big, vertices, corners));
            ASSERT_EQ(mesh.triangles.size(), corners.size() / 3);
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const std::uint32_t at = mesh.triangles[i / 3][i % 3];
                const float* v = &vertices[6 * std::size_t{corners[i]}];
                ASSERT_EQ(mesh.positions[at], glm::dvec3(v[0], v[1], v[2]));
                ASSERT_NEAR(glm::distance(mesh.normals[at], glm::normalize(glm::dvec3(v[3], v[4], v[5]))), 0.0, 1e-6);
            }
        }
    }
}

TEST_F(PlyImport, PolygonsBecomeTrianglesAndMissingNormalsSmooth) {
    const Mesh mesh = load("A.PLY", square_ply());
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.positions.size(), 4U);
    for (const glm::dvec3& normal : mesh.normals) {
        EXPECT_NEAR(glm::distance(normal, glm::dvec3(0, 0, 1)), 0.0, 1e-12);
    }
    EXPECT_TRUE(mesh.materials.empty());
}

TEST_F(PlyImport, NormalsThatAreNotFiniteAreReplaced) {
    const std::string text = replaced(
        replaced(square_ply(), "property uchar red", "property float nx\nproperty float ny\nproperty float nz"),
        "0 0 0 255\n1 0 0 0\n1 1 0 7\n0 1 0 9\n", "0 0 0 nan 0 0\n1 0 0 inf 0 1\n1 1 0 0 0 0\n0 1 0 1e300 0 0\n");
    for (const glm::dvec3& normal : load("a.ply", text).normals) {
        EXPECT_NEAR(glm::distance(normal, glm::dvec3(0, 0, 1)), 0.0, 1e-12);
    }
}

TEST_F(PlyImport, FaultsNameFileAndLine) {
    const std::string text = square_ply();
    const auto with = [&](const std::string& from, const std::string& to) {
        return fault("a.ply", replaced(text, from, to));
    };
    expect_message(with("ply\n", "plx\n"), "a.ply:1: ", "'ply'");
    expect_message(with("ascii", "asci"), "a.ply:2: ", "'format'");
    expect_message(with("ascii 1.0", "ascii 2.0"), "a.ply:2: ", "'format'");
    expect_message(with("format ascii 1.0\n", ""), "a.ply:10: ", "format");
    expect_message(with("comment", "remark"), "a.ply:3: ", "'remark'");
    expect_message(with("vertex 4", "vertex 1000000000"), "a.ply:4: ", "1000000000");
    expect_message(with("vertex 4", "vertex 99999999999999999999"), "a.ply:4: ", "'99999999999999999999'");
    expect_message(with("vertex 4", "vertex -4"), "a.ply:4: ", "'-4'");
    expect_message(with("vertex 4", "vertex 5"), "a.ply:16: ", "'3'");
    expect_message(with("vertex 4", "vertex 3"), "a.ply:15: ", "'0'");
    expect_message(with("float x", "real x"), "a.ply:5: ", "'real'");
    expect_message(with("property float x", "property list float float x"), "a.ply:5: ", "'float'");
    expect_message(with("property float x", "property list uchar float x"), "a.ply: ", "'x'");
    expect_message(with("float x", "float w"), "a.ply: ", "'x'");
    expect_message(with("float y", "float x"), "a.ply:6: ", "'x'");
    expect_message(with("element face", "element vertex"), "a.ply:9: ", "'vertex'");
    expect_message(with("vertex_indices", "corners"), "a.ply: ", "vertex_indices");
    expect_message(with("end_header\n", ""), "a.ply:11: ", "'0'");
    expect_message(with("1 0 0 0", "1 nan 0 0"), "a.ply:13: ", "'nan'");
    expect_message(with("1 0 0 0", "1 1e39 0 0"), "a.ply:13: ", "'1e39'");
    expect_message(with("1 0 0 0", "1 0 0"), "a.ply:13: ", "'0'");
    expect_message(with("1 0 0 0", "1 0 0 0 8"), "a.ply:13: ", "'8'");
    expect_message(with("4 0 1 2 3", "4 0 1 2 4"), "a.ply:16: ", "'4'");
    expect_message(with("4 0 1 2 3", "4 0 1 2 -1"), "a.ply:16: ", "'-1'");
    expect_message(with("4 0 1 2 3", "4 0 1 2 .5"), "a.ply:16: ", "'.5'");
    expect_message(with("4 0 1 2 3", "2 0 1"), "a.ply:16: ", "'2'");
    expect_message(with("4 0 1 2 3", "nan 0 1"), "a.ply:16: ", "'nan'");
    expect_message(with("4 0 1 2 3", "5 0 1 2 3"), "a.ply:16: ", "needs more");
    expect_message(with("4 0 1 2 3\n", ""), "a.ply: ", "row 1 of the 1 of element 'face'");
    expect_message(with("face 1", "face 0"), "a.ply: ", "no triangles");
}

TEST_F(PlyImport, ATruncatedBinaryFileIsNamedAtEveryLength) {
    const std::string whole = binary_ply(false, std::vector<float>(24, 1.0F), {0, 1, 2, 2, 1, 3});
    ASSERT_EQ(fault("a.ply", whole), "accepted");
    for (std::size_t length = 1; length < whole.size(); ++length) {
        ASSERT_NE(fault("a.ply", whole.substr(0, length)), "accepted") << length << " of " << whole.size() << " bytes";
    }
}

}  // namespace
}  // namespace sheen::test
