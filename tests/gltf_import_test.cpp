// SPDX-License-Identifier: MIT
// glTF files: where buffers may lie, what nodes do, and that each fault is named by file and field.
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "support/mesh_files.hpp"

namespace sheen::test {
namespace {

using nlohmann::json;

class GltfImport : public MeshFiles {
 protected:
    /// Loads the square with a change to its JSON.
    template <typename Change>
    [[nodiscard]] Mesh load_changed(Change change, const std::string& buffer = square_buffer()) const {
        json gltf = square_gltf();
        change(gltf);
        return load("a.glb", glb(gltf.dump(), buffer));
    }
    template <typename Change>
    [[nodiscard]] std::string fault_of(Change change, const std::string& buffer = square_buffer()) const {
        json gltf = square_gltf();
        change(gltf);
        return fault("a.glb", glb(gltf.dump(), buffer));
    }
};

/// Twice the sum of the triangles' area vectors.
glm::dvec3 area(const Mesh& mesh) {
    glm::dvec3 sum(0.0);
    for (const auto& t : mesh.triangles) {
        sum += glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
    }
    return sum;
}

TEST_F(GltfImport, BuffersAreEmbeddedBesideOrBinary) {
    const Mesh binary = load("a.glb", glb(square_gltf().dump(), square_buffer()));
    EXPECT_EQ(binary.triangles.size(), 2U);
    EXPECT_EQ(binary.positions.size(), 4U);
    EXPECT_EQ(area(binary), glm::dvec3(0, 0, 2));
    EXPECT_TRUE(binary.materials.empty());
    json gltf = square_gltf();
    gltf["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(square_buffer());
    const Mesh embedded = load("A.GLTF", gltf.dump());
    std::filesystem::create_directory(path("sub"));
    write("sub/the buffer.bin", square_buffer());
    gltf["buffers"][0]["uri"] = "sub/the%20buffer.bin";
    const Mesh beside = load("b.gltf", gltf.dump());
    for (const Mesh& mesh : {embedded, beside}) {
        EXPECT_EQ(mesh.positions, binary.positions);
        EXPECT_EQ(mesh.triangles, binary.triangles);
    }
}

TEST_F(GltfImport, NodesPlaceTheirMeshesOneInTheOther) {
    const Mesh mesh = load_changed([](json& gltf) {
        // Scale (2, 1, 1), then a quarter turn about z, then 10 along x; all of it 100 higher.
        const double half = std::sqrt(0.5);
        gltf["nodes"] = {
            {{"children", {1}}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 100, 0, 1}}},
            {{"mesh", 0}, {"scale", {2, 1, 1}}, {"rotation", {0, 0, half, half}}, {"translation", {10, 0, 0}}}};
    });
    const std::vector<glm::dvec3> expected{{10, 100, 0}, {10, 102, 0}, {9, 102, 0}, {9, 100, 0}};
    ASSERT_EQ(mesh.positions.size(), expected.size());
    for (const glm::dvec3& corner : expected) {
        const bool found = std::any_of(mesh.positions.begin(), mesh.positions.end(),
                                       [&](const glm::dvec3& p) { return glm::distance(p, corner) < 1e-5; });
        EXPECT_TRUE(found) << corner.x << " " << corner.y << " " << corner.z;
    }
}

TEST_F(GltfImport, MirroredNodesKeepTheirOutsideAndNormalsGoByTheInverseTranspose) {
    // A sloping plane through (1, 0, 0), (0, 1, 0) and (0, 0, 1) with its normal.
    const float n = std::sqrt(1.0F / 3.0F);
    const std::string buffer = floats({1, 0, 0, 0, 1, 0, 0, 0, 1}) + floats({n, n, n, n, n, n, n, n, n});
    for (const glm::dvec3 scale : {glm::dvec3(2, 3, 5), glm::dvec3(-2, 3, 5), glm::dvec3(-1, -1, -1)}) {
        const Mesh mesh = load_changed(
            [&](json& gltf) {
                gltf["buffers"][0]["byteLength"] = buffer.size();
                gltf["bufferViews"] = {{{"buffer", 0}, {"byteLength", 36}},
                                       {{"buffer", 0}, {"byteOffset", 36}, {"byteLength", 36}}};
                for (int i = 0; i < 2; ++i) {
                    gltf["accessors"][i] = {{"bufferView", i}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}};
                }
                gltf["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}};
                gltf["nodes"][0]["scale"] = {scale.x, scale.y, scale.z};
            },
            buffer);
        ASSERT_EQ(mesh.triangles.size(), 1U);
        const glm::dvec3 expected = glm::normalize(glm::dvec3(1.0) / scale);
        for (const glm::dvec3& normal : mesh.normals) {
            EXPECT_NEAR(glm::distance(normal, expected), 0.0, 1e-6);
        }
        EXPECT_NEAR(glm::distance(glm::normalize(area(mesh)), expected), 0.0, 1e-6) << "winding agrees with normals";
    }
}

TEST_F(GltfImport, StripsAndFansAreTrianglesOfOneSide) {
    const std::string buffer = floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0});
    const auto strip = [&](std::size_t mode, std::size_t count) {
        return load_changed(
            [&](json& gltf) {
                gltf["buffers"][0]["byteLength"] = buffer.size();
                gltf["bufferViews"][0]["byteLength"] = buffer.size();
                gltf["accessors"][0]["count"] = count;
                gltf["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 0}}}, {"mode", mode}};
            },
            buffer);
    };
    EXPECT_EQ(area(strip(5, 6)), glm::dvec3(0, 0, 4));
    EXPECT_EQ(strip(5, 6).triangles.size(), 4U);
    EXPECT_EQ(area(strip(5, 5)), glm::dvec3(0, 0, 3));
    EXPECT_EQ(area(strip(6, 3)), glm::dvec3(0, 0, 1));
    EXPECT_EQ(strip(6, 6).triangles.size(), 4U);
}

TEST_F(GltfImport, BaseColourAndRoughnessBecomeBlinnMaterials) {
    const Mesh mesh = load_changed([](json& gltf) {
        gltf["materials"] = {
            {{"name", "unused"}},
            {{"pbrMetallicRoughness", {{"baseColorFactor", {0.25, 0.5, 0.75, 1.0}}, {"roughnessFactor", 0.5}}}}};
        gltf["meshes"][0]["primitives"][0]["material"] = 1;
        gltf["meshes"].push_back(square_gltf()["meshes"][0]);
        gltf["nodes"].push_back({{"mesh", 1}, {"translation", {0, 0, 5}}});
        gltf["scenes"][0]["nodes"] = {0, 1};
    });
    ASSERT_EQ(mesh.triangle_materials.size(), 4U);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Material& material = mesh.materials.at(mesh.triangle_materials[i]);
        const bool first = mesh.positions[mesh.triangles[i][0]].z == 0.0;
        const double exponent = first ? 30.0 : 0.0;
        EXPECT_EQ(material.diffuse, first ? glm::dvec3(0.25, 0.5, 0.75) : glm::dvec3(1.0));
        EXPECT_NEAR(material.shininess, exponent, 1e-9);
        EXPECT_NEAR(material.specular, 0.04 * (exponent + 8.0) / 8.0, 1e-9);
    }
    const Mesh smooth = load_changed([](json& gltf) {
        gltf["materials"] = {{{"pbrMetallicRoughness", {{"roughnessFactor", 0}}}}};
        gltf["meshes"][0]["primitives"][0]["material"] = 0;
    });
    EXPECT_EQ(smooth.materials.at(0).shininess, 1000.0);
    EXPECT_EQ(smooth.materials.at(0).specular, 1.0);
}

TEST_F(GltfImport, FaultsNameFileAndField) {
    const std::string accessors = "a.glb: accessors[0]";
    const std::vector<std::tuple<const char*, json, std::string, std::string>> changes{
        {"/asset/version", "1.0", "a.glb: asset.version", "'1.0'"},
        {"/extensionsRequired", {"KHR_draco_mesh_compression"}, "a.glb: extensionsRequired[0]", "draco"},
        {"/scene", 7, "a.glb: scenes", "7"},
        {"/scenes/0/nodes/0", 3, "a.glb: scenes[0].nodes[0]", "1 nodes"},
        {"/scenes/0/nodes/0", -1, "a.glb: scenes[0].nodes[0]", "whole"},
        {"/scenes/0/nodes/1", 0, "a.glb: scenes[0].nodes[1]", "second time"},
        {"/nodes/0/children", {0}, "a.glb: nodes[0].children[0]", "cycle"},
        {"/nodes/0/mesh", 1, "a.glb: meshes", "1"},
        {"/nodes/0/rotation", {0, 0, 0, 0}, "a.glb: nodes[0].rotation", "quaternion"},
        {"/nodes/0/scale", {1, 1}, "a.glb: nodes[0].scale", "3"},
        {"/nodes/0/scale", {1e39, 1, 1}, "a.glb: nodes[0].scale[0]", "single precision"},
        {"/nodes/0/matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "a.glb: nodes[0].matrix", "affine"},
        {"/nodes/0/translation", {3.4e38, "a", 0}, "a.glb: nodes[0].translation[1]", "number"},
        {"/meshes/0/primitives", 1, "a.glb: meshes[0].primitives", "array"},
        {"/meshes/0/primitives/0/mode", 7, "a.glb: meshes[0].primitives[0].mode", "0 to 6"},
        {"/meshes/0/primitives/0/mode", 1, "a.glb: ", "no triangles"},
        {"/meshes/0/primitives/0/attributes/POSITION", 1, "a.glb: accessors[1].type", "VEC3"},
        {"/meshes/0/primitives/0/indices", 2, "a.glb: accessors", "2"},
        {"/meshes/0/primitives/0/material", 0, "a.glb: the JSON", "materials"},
        {"/accessors/0/count", 5, accessors, "48 bytes"},
        {"/accessors/0/count", 1000000000, accessors, "1000000000"},
        {"/accessors/0/count", 1e9, accessors, "whole"},
        {"/accessors/0/count", 2, "a.glb: meshes[0].primitives[0].indices", "out of range"},
        {"/accessors/0/byteOffset", 4, accessors, "48 bytes"},
        {"/accessors/0/byteOffset", 4294967295, accessors, "48 bytes"},
        {"/accessors/0/componentType", 5124, accessors, "5126"},
        {"/accessors/0/sparse", json::object(), accessors, "sparse"},
        {"/accessors/1/componentType", 5126, "a.glb: accessors[1]", "12 bytes"},
        {"/accessors/1/componentType", 5122, "a.glb: meshes[0].primitives[0].indices", "5123"},
        {"/accessors/1/count", 5, "a.glb: meshes[0].primitives[0]", "5 corners"},
        {"/bufferViews/0/byteStride", 4, accessors, "48 bytes"},
        {"/bufferViews/0/byteLength", 61, "a.glb: bufferViews[0].byteLength", "outside"},
        {"/bufferViews/1/byteOffset", 49, "a.glb: bufferViews[1].byteLength", "outside"},
        {"/bufferViews/0/buffer", 1, "a.glb: buffers", "1"},
        {"/buffers/0/byteLength", 61, "a.glb: buffers[0].byteLength", "60"},
        {"/buffers/0/byteLength", 59, "a.glb: bufferViews[1].byteLength", "59"},
        {"/buffers/0/uri", "data:;base64,@@@@", "a.glb: buffers[0].uri", "base64"},
        {"/buffers/0/uri", "data:;base64,AAAAA", "a.glb: buffers[0].uri", "base64"},
        {"/buffers/0/uri", "data:text/plain,abc", "a.glb: buffers[0].uri", "base64"},
        {"/buffers/0/uri", "data:;base64,AAAA", "a.glb: buffers[0].byteLength", "3 bytes"},
        {"/buffers/0/uri", "gone.bin", "a.glb: buffers[0].uri", "'gone.bin'"},
        {"/buffers/0/uri", "../outside.bin", "a.glb: buffers[0].uri", "outside the folder"},
        {"/buffers/0/uri", "sub/../../outside.bin", "a.glb: buffers[0].uri", "outside the folder"},
        {"/buffers/0/uri", "%2e%2e/outside.bin", "a.glb: buffers[0].uri", "outside the folder"},
        {"/buffers/0/uri", "/etc/passwd", "a.glb: buffers[0].uri", "relative"},
        {"/buffers/0/uri", "file:///etc/passwd", "a.glb: buffers[0].uri", "relative"},
        {"/buffers/0/uri", "a%zz", "a.glb: buffers[0].uri", "relative"},
        {"/buffers/0/uri", std::string("a\0b", 3), "a.glb: buffers[0].uri", "relative"},
        {"/buffers/0/uri", "", "a.glb: buffers[0].uri", "relative"},
        {"/buffers/0/uri", "sub", "a.glb: buffers[0].uri", "directory"},
    };
    write("../outside.bin", square_buffer());
    std::filesystem::create_directory(path("sub"));
    for (const auto& [pointer, value, start, word] : changes) {
        SCOPED_TRACE(pointer);
        const std::string message =
            fault_of([&, where = pointer, what = value](json& gltf) { gltf[json::json_pointer(where)] = what; });
        expect_message(message, start, word);
    }
}

TEST_F(GltfImport, ALinkOutOfTheFolderIsNotFollowed) {
    write("../outside.bin", square_buffer());
    std::filesystem::create_symlink("../outside.bin", path("link.bin"));
    expect_message(fault_of([](json& gltf) { gltf["buffers"][0]["uri"] = "link.bin"; }), "a.glb: buffers[0].uri",
                   "outside the folder");
}

TEST_F(GltfImport, ACoordinateThatIsNotFiniteIsNamed) {
    for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        std::string buffer = square_buffer();
        buffer.replace(28, 4, bytes_of(wrong));
        expect_message(fault_of([](json&) {}, buffer), "a.glb: meshes[0].primitives[0].attributes.POSITION",
                       "vertex 2");
    }
    expect_message(fault_of([](json& gltf) {
                       gltf["nodes"][0]["scale"] = {3e38, 1, 1};
                       gltf["nodes"][0]["translation"] = {3e38, 0, 0};
                   }),
                   "a.glb: ", "single precision");
}

TEST_F(GltfImport, ATruncatedBinaryFileIsNamedAtEveryLength) {
    const std::string whole = glb(square_gltf().dump(), square_buffer());
    for (std::size_t length = 1; length < whole.size(); ++length) {
        ASSERT_NE(fault("a.glb", whole.substr(0, length)), "accepted") << length << " of " << whole.size() << " bytes";
    }
}

TEST_F(GltfImport, MoreTrianglesByInstancesThanSheenReadsAreRefused) {
    const std::string message = fault_of([](json& gltf) {
        json corners = {{"attributes", {{"POSITION", 0}}}, {"mode", 6}};
        gltf["buffers"][0] = {{"byteLength", 60}};
        gltf["accessors"][0] = {{"bufferView", 0}, {"componentType", 5121}, {"count", 16}, {"type", "VEC3"}};
        gltf["meshes"][0]["primitives"] = json::array();
        for (int i = 0; i < 1000; ++i) {
            gltf["meshes"][0]["primitives"].push_back(corners);
        }
        gltf["nodes"] = json::array();
        gltf["scenes"][0]["nodes"] = json::array();
        for (int i = 0; i < 1000; ++i) {
            gltf["nodes"].push_back({{"mesh", 0}});
            gltf["scenes"][0]["nodes"].push_back(i);
        }
    });
    expect_message(message, "a.glb: ", "2097152 triangles");
}

}  // namespace
}  // namespace sheen::test
