// SPDX-License-Identifier: MIT
// Files that lie, of every format: what loads is sound, all else is one clear line, soon and in little memory.
#include <sys/stat.h>

#include <chrono>
#include <random>

#include "support/mesh_files.hpp"

namespace sheen::test {
namespace {

using nlohmann::json;

struct Sample {
    std::string name;
    std::string bytes;
};

/// A valid file of each format and encoding.
std::vector<Sample> samples() {
    json embedded = square_gltf();
    embedded["buffers"][0]["uri"] = "data:;base64," + base64(square_buffer());
    embedded["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.5, 1, 1}}}}}};
    embedded["meshes"][0]["primitives"][0]["material"] = 0;
    embedded["nodes"] = {{{"children", {1}}, {"scale", {1, -1, 2}}}, {{"mesh", 0}, {"rotation", {0, 0, 0, 1}}}};
    const std::string binary_ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar uint vertex_indices\nend_header\n" +
        floats({0, 0, 0, 1, 0, 0, 0, 1, 0}) + std::string("\x03\0\0\0\0\x01\0\0\0\x02\0\0\0", 13);
    return {
        {"a.obj",
         "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nusemtl m\nf 1//1 2//1 3//1\nusemtl\nf -1 -2 -3\n"},
        {"b.ply", square_ply()},
        {"c.ply", binary_ply},
        {"d.stl", square_stl()},
        {"e.stl", binary_stl(std::vector<float>(18, 1.0F))},
        {"f.gltf", embedded.dump()},
        {"g.glb", glb(square_gltf().dump(), square_buffer())},
    };
}

class HostileFiles : public MeshFiles {
 protected:
    HostileFiles() { write("a.mtl", "newmtl m\nKd 1 0 0\nKs .1 .2 .3\nNs 9\n"); }

    /// True for a sound mesh, false for an error of one line.
    [[nodiscard]] bool loads(const Sample& sample) const {
        try {
            expect_sound(load(sample.name, sample.bytes));
            return true;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            return false;
        }
    }
};

TEST_F(HostileFiles, DamagedFilesGiveASoundMeshOrOneLine) {
    constexpr unsigned seed = 5301;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (const Sample& sample : samples()) {
        ASSERT_TRUE(loads(sample)) << sample.name;
        std::size_t refused = 0;
        constexpr std::size_t rounds = 300;
        for (std::size_t round = 0; round < rounds; ++round) {
            Sample damaged = sample;
            for (unsigned damage = 0; damage <= random() % 4; ++damage) {
                char& byte = damaged.bytes[random() % damaged.bytes.size()];
                byte =
                    static_cast<char>(random() % 2 == 0 ? byte ^ (1 << random() % 8) : "0179-.[{\"\n"[random() % 10]);
            }
            if (random() % 8 == 0) {
                damaged.bytes.resize(1 + random() % damaged.bytes.size());
            }
            const auto start = std::chrono::steady_clock::now();
            refused += loads(damaged) ? 0 : 1;
            ASSERT_FALSE(HasFailure()) << sample.name << ", round " << round;
            ASSERT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << sample.name;
        }
        EXPECT_GT(refused, rounds / 10) << sample.name;
        EXPECT_LT(refused, rounds) << sample.name;
    }
}

TEST_F(HostileFiles, FilesOfOneFormatUnderAnothersNameAreRefused) {
    for (const Sample& sample : samples()) {
        for (const char* extension : {".obj", ".ply", ".stl", ".gltf", ".glb", ""}) {
            const std::string own = std::filesystem::path(sample.name).extension();
            const bool same = own == extension || (own == ".obj" && extension[0] == '\0') ||
                              (own[1] == 'g' && extension[0] == '.' && extension[1] == 'g');
            if (!same) {
                const std::string name = std::string("other") + extension;
                EXPECT_EQ(fault(name, sample.bytes).rfind(name + ":", 0), 0U) << sample.name;
            }
        }
    }
}

TEST_F(HostileFiles, OnlyKnownExtensionsAreRead) {
    for (const char* name : {"a.fbx", "a.png", "a.obj.gz", "a.3ds"}) {
        expect_message(fault(name, samples()[0].bytes), std::string(name) + ": ", ".obj, .ply, .stl, .gltf and .glb");
    }
    EXPECT_EQ(fault("plain", samples()[0].bytes), "accepted") << "no extension: OBJ";
}

TEST_F(HostileFiles, ManyFacesOfManyCornersAreRefusedBeforeTheyAreDivided) {
    constexpr int corners = 4096;
    std::string vertices;
    std::string face = "f";
    for (int k = 0; k < corners; ++k) {
        vertices += "v " + std::to_string(k % 64) + " " + std::to_string(k / 64) + " 0\n";
        face += " " + std::to_string(k + 1);
    }
    for (int faces = 0; faces < 20; ++faces) vertices += face + "\n";
    expect_message(fault("large.obj", vertices), "large.obj:4099: ", "faces of at most 16");
}

TEST_F(HostileFiles, WhatIsNoFileIsNotWaitedFor) {
    for (const Sample& sample : samples()) {
        const std::string name = "x" + sample.name;
        expect_message(fault(name), name + ": ", "No such file");
        std::filesystem::create_directory(path(name));
        expect_message(fault(name), name + ": ", "directory");
        std::filesystem::remove(path(name));
        ASSERT_EQ(::mkfifo(path(name).c_str(), 0600), 0);
        expect_message(fault(name), name + ": ", "pipe");
        std::filesystem::remove(path(name));
        std::filesystem::create_symlink("/dev/zero", path(name));
        expect_message(fault(name), name + ": ", "device");
        std::filesystem::remove(path(name));
        std::filesystem::create_symlink(name, path(name));
        EXPECT_NE(fault(name), "accepted");
        expect_message(fault(sample.name, ""), sample.name + ": ", "empty");
    }
}

TEST_F(HostileFiles, DeepOrManyJsonValuesAreRefused) {
    constexpr std::size_t deep = 2000000;
    expect_message(fault("a.gltf", std::string(deep, '[')), "a.gltf: ", "nests deeper than 64");
    std::string objects;
    for (int i = 0; i < 200000; ++i) {
        objects += "{\"a\":";
    }
    expect_message(fault("a.gltf", objects), "a.gltf: ", "nests deeper than 64");
    std::string many = "[0";
    for (int i = 0; i < 5000000; ++i) {
        many += ",0";
    }
    expect_message(fault("a.gltf", many + "]"), "a.gltf: ", "values");
    expect_message(fault("a.gltf", "{\n\"a\": 1,\n]"), "a.gltf:3: ", "JSON");
    expect_message(fault("a.gltf", "{\"a\": 1e999}"), "a.gltf:1: ", "JSON");
    expect_message(fault("a.gltf", "\xff\xfe{}"), "a.gltf:1: ", "JSON");
    expect_message(fault("a.gltf", "[]"), "a.gltf: the JSON", "object");
    expect_message(fault("a.gltf", "{}"), "a.gltf: the JSON", "asset");
}

TEST_F(HostileFiles, ADeepChainOfNodesIsWalkedToItsEnd) {
    json gltf = square_gltf();
    constexpr int depth = 50000;
    gltf["nodes"] = json::array();
    for (int i = 0; i < depth; ++i) {
        gltf["nodes"].push_back({{"children", {i + 1}}});
    }
    gltf["nodes"].push_back({{"mesh", 0}});
    EXPECT_EQ(load("a.glb", glb(gltf.dump(), square_buffer())).triangles.size(), 2U);
    gltf["nodes"][depth]["children"] = {0};
    expect_message(fault("a.glb", glb(gltf.dump(), square_buffer())), "a.glb: nodes[50000].children[0]", "second time");
    gltf.erase("scenes");
    expect_message(fault("a.glb", glb(gltf.dump(), square_buffer())), "a.glb: nodes", "cycle");
}

}  // namespace
}  // namespace sheen::test
