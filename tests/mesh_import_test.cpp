// SPDX-License-Identifier: MIT
// Mesh files: what is accepted, how normals are made, and that each fault is named by file, line and word.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <random>
#include <string>

#include "sheen/error.hpp"
#include "sheen/mesh.hpp"

namespace sheen {
namespace {

namespace fs = std::filesystem;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

class MeshImport : public testing::Test {
 protected:
    MeshImport() : folder_(fs::temp_directory_path() / ("sheen_mesh_import_test_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~MeshImport() override { fs::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

    Mesh load(const std::string& text) const {
        std::ofstream(path("mesh.obj"), std::ios::binary) << text;
        return load_mesh(path("mesh.obj"));
    }

    /// The message of the error that loading `text` gives, without the folder's name.
    std::string fault(const std::string& text) const {
        try {
            load(text);
        } catch (const Error& error) {
            std::string message = error.what();
            EXPECT_EQ(message.rfind(folder_.string(), 0), 0U) << message << " does not begin with the file";
            EXPECT_EQ(message.find('\n'), std::string::npos) << message << " is more than one line";
            return message.substr(std::min(message.size(), folder_.string().size() + 1));
        }
        return "accepted";
    }

 private:
    fs::path folder_;
};

#define EXPECT_FAULT(text, start, word)                                         \
    do {                                                                        \
        const std::string message = fault(text);                                \
        EXPECT_EQ(message.rfind(start, 0), 0U) << "got: " << message;           \
        EXPECT_NE(message.find(word), std::string::npos) << "got: " << message; \
    } while (false)

TEST_F(MeshImport, FaultsNameFileLineAndWord) {
    EXPECT_FAULT(square + "f 1 2 9\n", "mesh.obj:5: ", "'9'");
    EXPECT_FAULT(square + "f 1 2 0\n", "mesh.obj:5: ", "'0'");
    EXPECT_FAULT(square + "f -1 -2 -5\n", "mesh.obj:5: ", "'-5'");
    EXPECT_FAULT("v 0 0 0\nf -1 -1 -2\n" + square, "mesh.obj:2: ", "'-2'");
    EXPECT_FAULT(square + "f 1 2 99999999999999999999\n", "mesh.obj:5: ", "'99999999999999999999'");
    EXPECT_FAULT(square + "f 1 2 3x\n", "mesh.obj:5: ", "'3x'");
    EXPECT_FAULT(square + "f 1/7 2/7 3/7\n", "mesh.obj:5: ", "'1/7'");
    EXPECT_FAULT(square + "f 1//1 2//1 3//1\n", "mesh.obj:5: ", "'1//1'");
    EXPECT_FAULT(square + "f /1 2 3\n", "mesh.obj:5: ", "'/1'");
    EXPECT_FAULT(square + "f 1 2\n", "mesh.obj:5: ", "'f'");
    EXPECT_FAULT(square + "\n# note\nf 1 2 \\\n 3 8\n", "mesh.obj:8: ", "'8'");
    EXPECT_FAULT("v 0 nan 0\n" + square + "f 1 2 3\n", "mesh.obj:1: ", "'nan'");
    EXPECT_FAULT("v 0 0 -inf\n" + square + "f 1 2 3\n", "mesh.obj:1: ", "'-inf'");
    EXPECT_FAULT("v 1e39 0 0\n" + square + "f 1 2 3\n", "mesh.obj:1: ", "'1e39'");
    EXPECT_FAULT("v 0 1,5 0\n" + square + "f 1 2 3\n", "mesh.obj:1: ", "'1,5'");
    EXPECT_FAULT("v 0 1\n" + square + "f 1 2 3\n", "mesh.obj:1: ", "'v'");
    EXPECT_FAULT("vn 0 x 0\n" + square + "f 1 2 3\n", "mesh.obj:1: ", "'x'");
    EXPECT_FAULT(square + "ff 1 2 3\n", "mesh.obj:5: ", "'ff'");
    EXPECT_FAULT(square + std::string("f 1 2 \0 3\n", 10), "mesh.obj:5: ", "0x00");
    EXPECT_FAULT("solid cube\n", "mesh.obj:1: ", "'solid'");
}

TEST_F(MeshImport, FaultsOfAWholeFileNameIt) {
    EXPECT_FAULT(square, "mesh.obj: ", "no triangles");
    EXPECT_FAULT("", "mesh.obj: ", "empty");
    EXPECT_FAULT("# nothing\n", "mesh.obj: ", "no triangles");
    for (const std::string& name : {path("missing.obj"), path("")}) {
        try {
            load_mesh(name);
            FAIL() << name << " accepted";
        } catch (const UsageError&) {
            FAIL() << "a file's fault is no usage error";
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).rfind(name + ": ", 0), 0U) << error.what();
        }
    }
}

TEST_F(MeshImport, APolygonOfNCornersBecomesNMinusTwoTrianglesOfItsArea) {
    for (int corners = 3; corners <= 40; ++corners) {
        std::string text;
        std::string face = "f";
        double area = 0.0;
        for (int k = 0; k < corners; ++k) {
            // A star: every other corner nearer the centre, so that most polygons are concave.
            const double radius = k % 2 == 0 ? 1.0 : 0.6;
            const double next = k % 2 == 0 && k + 1 < corners ? 0.6 : 1.0;
            const double angle = 2.0 * std::acos(-1.0) * k / corners;
            text += "v " + std::to_string(radius * std::cos(angle)) + " " + std::to_string(radius * std::sin(angle)) +
                    " 0\n";
            face += " " + std::to_string(k + 1);
            area += 0.5 * radius * next * std::sin(2.0 * std::acos(-1.0) / corners);
        }
        const Mesh mesh = load(text + face + "\n");
        EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(corners - 2));
        double sum = 0.0;
        for (const auto& t : mesh.triangles) {
            sum +=
                0.5 *
                glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]).z;
        }
        EXPECT_NEAR(sum, area, 1e-4) << corners << " corners";
    }
}

TEST_F(MeshImport, IndicesMayBeNegativeAndPointForward) {
    const Mesh plain = load(square + "f 1 2 3\n");
    for (const std::string& text : {square + "f -4 -3 -2\n", "f 1 2 3\n" + square, square + "f 1 \\\r\n2 3\r\n"}) {
        const Mesh mesh = load(text);
        EXPECT_EQ(mesh.positions, plain.positions) << text;
        EXPECT_EQ(mesh.triangles, plain.triangles) << text;
    }
}

TEST_F(MeshImport, NormalsOfTheFileAreKeptAndMadeUnit) {
    const Mesh mesh = load(square + "vn 0 3 4\nf 1//1 2//1 3//1\n");
    ASSERT_EQ(mesh.normals.size(), 3U);
    for (const glm::dvec3& normal : mesh.normals) {
        EXPECT_NEAR(glm::distance(normal, glm::dvec3(0.0, 0.6, 0.8)), 0.0, 1e-7);
    }
}

TEST_F(MeshImport, MissingNormalsAreSmoothAndWeightedByArea) {
    // A fold: a large triangle in the plane z = 0 and a small one in x = 0 share the edge on the y axis.
    const Mesh mesh = load("v 0 0 0\nv 0 1 0\nv -4 0 0\nv 0 0 -1\nf 1 2 3\nf 2 1 4\n");
    const glm::dvec3 expected = glm::normalize(4.0 * glm::dvec3(0, 0, 1) + 1.0 * glm::dvec3(1, 0, 0));
    std::size_t shared = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.positions[i].x == 0.0 && mesh.positions[i].z == 0.0) {
            EXPECT_NEAR(glm::distance(mesh.normals[i], expected), 0.0, 1e-7);
            ++shared;
        }
    }
    EXPECT_EQ(shared, 2U) << "smooth vertices are joined";
}

TEST_F(MeshImport, NormalsWithoutDirectionAreReplaced) {
    for (const char* normal : {"0 0 0", "nan nan nan", "inf 0 0", "1e300 0 0"}) {
        const Mesh mesh = load(square + "vn " + normal + "\nf 1//1 2//1 3//1\n");
        for (const glm::dvec3& n : mesh.normals) {
            EXPECT_EQ(n, glm::dvec3(0, 0, 1)) << normal;
        }
    }
}

TEST_F(MeshImport, DegenerateTrianglesAreHarmless) {
    const Mesh mesh = load(square + "f 1 1 1\nf 1 2 2\nf 1 2 3\n");
    for (const glm::dvec3& normal : mesh.normals) {
        EXPECT_NEAR(glm::length(normal), 1.0, 1e-12);
    }
    const BoundingSphere sphere = bounding_sphere(mesh);
    EXPECT_NEAR(sphere.radius, std::sqrt(0.5), 1e-12);
}

TEST_F(MeshImport, GroupsExtraNumbersAndUnusedLibrariesAreIgnored) {
    const Mesh mesh = load(
        "mtllib /nowhere/m.mtl\no a\ng b\ns off\nv 0 0 0 1 1 1\nv 1 0 0 0.5\nv 1 1 0\n"
        "vt 0 0\nf 1/1 2/1 3/1\nl 1 2\n");
    EXPECT_EQ(mesh.triangles.size(), 1U);
    EXPECT_EQ(mesh.positions[1], glm::dvec3(1.0, 0.0, 0.0));
}

TEST_F(MeshImport, BuiltinNamesAreTaken) {
    EXPECT_EQ(load_mesh("builtin:sphere-168").triangles.size(), 168U);
    EXPECT_THROW(load_mesh("builtin:nothing"), UsageError);
}

TEST_F(MeshImport, DamagedFilesGiveASoundMeshOrAnError) {
    constexpr unsigned seed = 7004;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::string sound =
        "# cube corner\nv 0 0 0\nv 1.5 0 0\nv 0 1e0 0\nv 0 0 1\nvt 0.5 0.5\nvn 0 0 1\n"
        "f 1//1 2//1 3//1\nf 1/1/1 3/1/1 4/1/1\nf -4 -1 \\\n -3\ns off\n";
    const std::string alphabet = "0123456789-+./ \n\\\r#evfntx\t\xFF";
    std::size_t loaded = 0;
    std::size_t refused = 0;
    for (int i = 0; i < 1000; ++i) {
        std::string text = sound;
        for (unsigned damage = 0; damage <= random() % 3; ++damage) {
            text[random() % text.size()] = alphabet[random() % alphabet.size()];
        }
        try {
            const Mesh mesh = load(text);
            ++loaded;
            for (const auto& triangle : mesh.triangles) {
                for (const std::uint32_t index : triangle) {
                    ASSERT_LT(index, mesh.positions.size()) << text;
                    ASSERT_NEAR(glm::length(mesh.normals[index]), 1.0, 1e-9) << text;
                }
            }
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(loaded, 100U);
    EXPECT_GT(refused, 100U);
}

}  // namespace
}  // namespace sheen
