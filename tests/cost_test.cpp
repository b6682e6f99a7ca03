// SPDX-License-Identifier: MIT
// What a method costs on a scene: means over its triangles, spans and pixels.
#include "sheen/cost.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sheen/mesh.hpp"

namespace sheen::test {
namespace {

Scene sphere() {
    Scene scene;
    scene.mesh = make_builtin_mesh("builtin:sphere-168");
    scene.lights.emplace_back();
    scene.lights.back().vector = glm::normalize(scene.lights.back().vector);
    scene.width = 60;
    scene.height = 50;
    return scene;
}

TEST(MethodCost, MeansAreOverAllTrianglesSpansAndPixels) {
    const Scene scene = sphere();
    const auto triangles = project(scene);
    OperationCounts setups;
    OperationCounts spans;
    std::size_t rows = 0;
    for (const auto& triangle : triangles) {
        const CountingScope all;
        const auto loop = make_loop<Counted>(Method::quadratic, {}, scene, triangle);
        setups += all.counts();
        for (const PixelRow& row : triangle_rows(triangle)) {
            const CountingScope scope;
            loop->start_row(row);
            spans += scope.counts();
            for (int i = 0; i < row.length; ++i) (void)loop->next();
            ++rows;
        }
    }
    const MethodCost cost = method_cost(Method::quadratic, scene, triangles);
    EXPECT_DOUBLE_EQ(cost.nodes.multiplications + cost.triangle.multiplications,
                     static_cast<double>(setups.multiplications) / static_cast<double>(triangles.size()));
    EXPECT_EQ(cost.triangle.divisions, 1.0) << "one, by the area";
    EXPECT_EQ(cost.nodes.powers, 6.0) << "one a node";
    EXPECT_DOUBLE_EQ(cost.span.additions, static_cast<double>(spans.additions) / static_cast<double>(rows));
}

TEST(MethodCost, NamesEachOperationAndPartOnce) {
    const MeanCounts counts{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};
    double expected = 1.0;
    for (const auto& [name, count] : counts.named()) EXPECT_EQ(count, expected++) << name;
    const MethodCost cost{{1.0}, {2.0}, {3.0}, {4.0}};
    expected = 1.0;
    for (const auto& [name, part] : cost.named()) EXPECT_EQ(part.additions, expected++) << name;
}

TEST(MethodCost, TrianglesThatCoverNothingAreNoneOfTheMean) {
    const Scene scene = sphere();
    const auto covering = project(scene);
    auto all = covering;
    all.insert(all.begin() + 1, 5, covering.front());
    for (std::size_t k = 1; k < 6; ++k) all[k].walks.clear();
    const MethodCost expected = method_cost(Method::gouraud, scene, covering);
    const MethodCost cost = method_cost(Method::gouraud, scene, all);
    for (std::size_t part = 0; part < 4; ++part) {
        EXPECT_EQ(cost.named()[part].second.named(), expected.named()[part].second.named());
    }
}

TEST(MethodCost, NothingCoveredCostsNothing) {
    const MethodCost cost = method_cost(Method::quadratic, sphere(), {});
    for (const auto& [part, counts] : cost.named()) {
        for (const auto& [operation, count] : counts.named()) EXPECT_EQ(count, 0.0) << part << " " << operation;
    }
}

}  // namespace
}  // namespace sheen::test
