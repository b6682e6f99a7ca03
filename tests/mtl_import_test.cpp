// SPDX-License-Identifier: MIT
// MTL materials of OBJ files: which face gets which, and that each fault is named by file, line and word.
#include "support/mesh_files.hpp"

namespace sheen::test {
namespace {

class MtlImport : public MeshFiles {
 protected:
    /// A mesh of two triangles that differ in z, with these lines before each.
    [[nodiscard]] static std::string two_faces(const std::string& before_first, const std::string& before_second) {
        return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 5\nv 1 0 5\nv 0 1 5\n" + before_first + "f 1 2 3\n" + before_second +
               "f 4 5 6\n";
    }
    /// The material of the triangle at this z.
    [[nodiscard]] static Material material_at(const Mesh& mesh, double z) {
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            if (mesh.positions[mesh.triangles[i][0]].z == z) {
                return mesh.materials.at(mesh.triangle_materials.at(i));
            }
        }
        ADD_FAILURE() << "no triangle at z = " << z;
        return {};
    }
};

const std::string red = "newmtl red\nKa .1 .2 .3\nKd 0.9 0.1 0\nKs 0.2 0.3 0.7\nNs 80\n";

TEST_F(MtlImport, FacesHaveTheMaterialThatTheirUsemtlNames) {
    write("m.mtl", "# library\n" + red + "illum 2\nmap_Kd a.png\n\nnewmtl dull grey\nKd .5\nKs .9 .9 .9\nillum 1\n");
    const Mesh mesh = load("a.obj", two_faces("mtllib m.mtl\nusemtl dull grey\n", "usemtl red\n"));
    const Material far = material_at(mesh, 0.0);
    EXPECT_EQ(far.diffuse, glm::dvec3(0.5));
    EXPECT_EQ(far.specular, 0.0) << "illum 1 has no highlight";
    EXPECT_EQ(far.ambient, Material().ambient) << "not stated: the default";
    const Material near = material_at(mesh, 5.0);
    EXPECT_EQ(near.ambient, glm::dvec3(0.1, 0.2, 0.3));
    EXPECT_EQ(near.diffuse, glm::dvec3(0.9, 0.1, 0.0));
    EXPECT_NEAR(near.specular, 0.4, 1e-12) << "the mean of Ks";
    EXPECT_EQ(near.shininess, 80.0);
}

TEST_F(MtlImport, FacesBeforeAnyUsemtlHaveTheDefault) {
    write("m.mtl", red);
    const Mesh mesh = load("a.obj", two_faces("", "mtllib m.mtl\nusemtl red\n"));
    EXPECT_EQ(material_at(mesh, 0.0).diffuse, Material().diffuse);
    EXPECT_EQ(material_at(mesh, 5.0).diffuse, glm::dvec3(0.9, 0.1, 0.0));
    const Mesh unnamed = load("a.obj", two_faces("mtllib m.mtl\nusemtl red\n", "usemtl\n"));
    EXPECT_EQ(material_at(unnamed, 5.0).diffuse, Material().diffuse);
}

TEST_F(MtlImport, AFileWithoutUsemtlHasNoMaterials) {
    write("m.mtl", red);
    const Mesh mesh = load("a.obj", two_faces("mtllib m.mtl\n", ""));
    EXPECT_TRUE(mesh.materials.empty());
    EXPECT_TRUE(mesh.triangle_materials.empty());
    EXPECT_EQ(load("a.obj", two_faces("mtllib missing.mtl\n", "")).triangles.size(), 2U) << "nothing is missed";
}

TEST_F(MtlImport, SeveralLibrariesAndNamesWithSpacesAreFound) {
    write("m.mtl", "newmtl other\nKd 0 0 1\n");
    write("two words.mtl", red);
    for (const char* statement : {"mtllib m.mtl\nmtllib two words.mtl\n", "mtllib two words.mtl\nmtllib ./m.mtl\n"}) {
        const Mesh mesh = load("a.obj", two_faces(statement, "usemtl red\n") + "usemtl other\nf 1 2 6\n");
        EXPECT_EQ(mesh.materials.size(), 3U);
    }
    write("n.mtl", red);
    const Mesh mesh = load("a.obj", two_faces("mtllib m.mtl n.mtl\nusemtl other\n", "usemtl red\n"));
    EXPECT_EQ(material_at(mesh, 0.0).diffuse, glm::dvec3(0, 0, 1));
}

TEST_F(MtlImport, FaultsNameFileLineAndWord) {
    write("m.mtl", red);
    std::filesystem::create_directory(path("sub"));
    const auto obj = [](const std::string& lines) { return two_faces(lines, ""); };
    expect_message(fault("a.obj", obj("mtllib m.mtl\nusemtl blue\n")), "a.obj:8: ", "'blue'");
    expect_message(fault("a.obj", obj("usemtl red\n")), "a.obj:7: ", "'red'");
    expect_message(fault("a.obj", obj("mtllib gone.mtl\nusemtl red\n")), "a.obj:7: ", "'gone.mtl'");
    expect_message(fault("a.obj", obj("mtllib ../gone.mtl\nusemtl red\n")), "a.obj:7: ", "outside the folder");
    expect_message(fault("a.obj", obj("mtllib sub\nusemtl red\n")), "a.obj:7: ", "directory");
    const std::string use = obj("mtllib b.mtl\nusemtl red\n");
    const std::vector<std::vector<std::string>> libraries{
        {"Kd 1 1 1\n" + red, "b.mtl:1: ", "'Kd'"},
        {"newmtl red\nKd 1 1\n", "b.mtl:2: ", "'Kd'"},
        {"newmtl red\nKd 1 2 1\n", "b.mtl:2: ", "'2'"},
        {"newmtl red\nKa x x x\n", "b.mtl:2: ", "'x'"},
        {"newmtl red\nKs -1 0 0\n", "b.mtl:2: ", "'-1'"},
        {"newmtl red\nKs nan 0 0\n", "b.mtl:2: ", "'nan'"},
        {"newmtl red\nNs -3\n", "b.mtl:2: ", "'-3'"},
        {"newmtl red\nNs inf\n", "b.mtl:2: ", "'inf'"},
        {"newmtl red\nKd spectral a.rfl\n", "b.mtl:2: ", "'spectral'"},
        {"newmtl\n", "b.mtl:1: ", "'newmtl'"},
        {std::string("newmtl red\n\0\n", 13), "b.mtl:2: ", "0x00"}};
    for (const auto& library : libraries) {
        write("b.mtl", library[0]);
        expect_message(fault("a.obj", use), library[1], library[2]);
    }
}

TEST_F(MtlImport, MoreMaterialsThanAFileMayUseAreRefused) {
    std::string library;
    std::string obj = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 5000; ++i) {
        library += "newmtl m" + std::to_string(i) + "\n";
        obj += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
    }
    write("m.mtl", library);
    expect_message(fault("a.obj", obj), "a.obj:", "4096");
}

}  // namespace
}  // namespace sheen::test
