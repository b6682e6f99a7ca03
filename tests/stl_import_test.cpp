// SPDX-License-Identifier: MIT
// STL files: text and binary agree, and each fault is named by file and line or triangle.
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "support/mesh_files.hpp"

namespace sheen::test {
namespace {

class StlImport : public MeshFiles {};

TEST_F(StlImport, BinaryFilesKeepEveryBitAndJoinEqualPlaces) {
    constexpr unsigned seed = 5201;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> coordinate(-9.0F, 9.0F);
    for (int round = 0; round < 20; ++round) {
        std::vector<float> places(3 * (3 + random() % 20));
        std::generate(places.begin(), places.end(), [&] { return coordinate(random); });
        std::vector<float> coordinates;
        const std::size_t corners = 3 * (1 + random() % 60);
        for (std::size_t i = 0; i < corners; ++i) {
            const auto place = static_cast<std::ptrdiff_t>(3 * (random() % (places.size() / 3)));
            coordinates.insert(coordinates.end(), places.begin() + place, places.begin() + place + 3);
        }
        const Mesh mesh = load("a.StL", binary_stl(coordinates));
        ASSERT_EQ(mesh.triangles.size(), corners / 3);
        EXPECT_LE(mesh.positions.size(), places.size() / 3);
        for (std::size_t i = 0; i < corners; ++i) {
            const float* v = &coordinates[3 * i];
            ASSERT_EQ(mesh.positions[mesh.triangles[i / 3][i % 3]], glm::dvec3(v[0], v[1], v[2]));
        }
        expect_sound(mesh);
    }
}

TEST_F(StlImport, TextAndBinaryGiveTheSameMesh) {
    const Mesh text = load("a.stl", square_stl());
    const Mesh binary = load("b.stl", binary_stl({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}));
    EXPECT_EQ(text.positions, binary.positions);
    EXPECT_EQ(text.triangles, binary.triangles);
    EXPECT_EQ(text.normals, binary.normals);
}

TEST_F(StlImport, NormalsAreSmoothWhateverTheFacetsSay) {
    const Mesh mesh = load("a.stl",
                           "SOLID\nFACET NORMAL nan 0 7\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 0 1 0\nVERTEX -4 0 0\n"
                           "ENDLOOP\nENDFACET\nfacet normal 0 0 1\nouter loop\nvertex 0 1 0\nvertex 0 0 0\n"
                           "vertex 0 0 -1\nendloop\nendfacet\nendsolid\nsolid second\nendsolid second\n");
    EXPECT_EQ(mesh.positions.size(), 4U);
    const glm::dvec3 expected = glm::normalize(4.0 * glm::dvec3(0, 0, 1) + 1.0 * glm::dvec3(1, 0, 0));
    EXPECT_NEAR(glm::distance(mesh.normals[mesh.triangles[0][0]], expected), 0.0, 1e-7);
}

TEST_F(StlImport, FaultsNameFileAndLine) {
    const std::string text = square_stl();
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        return fault("a.stl", changed.replace(changed.find(from), from.size(), to));
    };
    expect_message(with("facet", "facets"), "a.stl:2: ", "'facets'");
    expect_message(with("normal 0", "normal"), "a.stl:2: ", "'facet'");
    expect_message(with("outer", "inner"), "a.stl:3: ", "'inner'");
    expect_message(with("outer loop", "outer"), "a.stl:3: ", "'outer'");
    expect_message(with("vertex 1 0 0", "vertex 1 0"), "a.stl:5: ", "'vertex'");
    expect_message(with("vertex 1 0 0", "vertex 1 0 x"), "a.stl:5: ", "'x'");
    expect_message(with("vertex 1 0 0", "vertex 1 0 -inf"), "a.stl:5: ", "'-inf'");
    expect_message(with("vertex 1 0 0\n", ""), "a.stl:6: ", "'endloop'");
    expect_message(with("endloop", "vertex 0 0 0"), "a.stl:7: ", "'vertex'");
    expect_message(with("endfacet\n", ""), "a.stl:8: ", "'facet'");
    expect_message(with("endsolid\n", ""), "a.stl: ", "endsolid");
    expect_message(fault("a.stl", "solid a\nendsolid\n"), "a.stl: ", "no triangles");
    expect_message(fault("a.stl", text + "facet normal 0 0 1\n"), "a.stl:17: ", "'facet'");
}

TEST_F(StlImport, ABinaryFileHasTheSizeThatItsCountAsksFor) {
    const std::string whole = binary_stl(std::vector<float>(18, 1.0F));
    ASSERT_EQ(fault("a.stl", whole), "accepted");
    for (std::size_t length = 1; length < whole.size(); ++length) {
        ASSERT_NE(fault("a.stl", whole.substr(0, length)), "accepted") << length << " of " << whole.size() << " bytes";
    }
    EXPECT_NE(fault("a.stl", whole + "x"), "accepted");
    std::string many = whole;
    many.replace(80, 4, bytes_of(std::uint32_t{1000000000}));
    expect_message(fault("a.stl", many), "a.stl: ", "1000000000");
    expect_message(fault("a.stl", binary_stl({})), "a.stl: ", "no triangles");
}

TEST_F(StlImport, ABinaryHeaderMayBeginWithSolid) {
    const std::string whole = binary_stl(std::vector<float>(9, 1.0F));
    EXPECT_EQ(load("a.stl", "solid" + whole.substr(5)).triangles.size(), 1U);
}

TEST_F(StlImport, ACoordinateThatIsNotFiniteIsNamed) {
    for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
        std::vector<float> coordinates(18, 1.0F);
        coordinates[13] = wrong;
        expect_message(fault("a.stl", binary_stl(coordinates)), "a.stl: triangle 2, corner 2: ", "finite");
    }
}

}  // namespace
}  // namespace sheen::test
