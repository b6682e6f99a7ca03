// SPDX-License-Identifier: MIT
// Subdivision: what it gains, that colours and coverage stay whole along edges, and what the paper's own test misses.
#include "sheen/subdivide.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "sheen/error.hpp"
#include "support/edge_jumps.hpp"
#include "support/quality.hpp"
#include "support/random_triangles.hpp"
#include "support/scenes.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 7601;

double real(Rng& rng, double low, double high) { return std::uniform_real_distribution<double>(low, high)(rng); }

constexpr Subdivision by_edges{4.0, SubdivisionTest::edge, 5};
constexpr Subdivision by_centre{4.0, SubdivisionTest::centre, 5};

/// Quality and number of triangles, over the measured lights.
struct Gain {
    ErrorMeter meter;  ///< over the pixels that both cover
    double triangles = 0.0;
    std::size_t silhouette_pixels = 0;  ///< covered by one only
};

Gain gain(Method method, Scene scene, const Subdivision& subdivision) {
    Gain result;
    const std::vector<ScreenTriangle> triangles = project(scene, Uncovered::keep);
    const std::vector<std::vector<Light>> runs = measured_lights();
    for (const std::vector<Light>& lights : runs) {
        scene.lights = lights;
        const ReferenceImage phong = render_reference(Method::phong, scene, triangles);
        const ReferenceImage drawn =
            render_reference(method, scene, subdivide(method, {}, scene, triangles, subdivision));
        std::vector<bool> both = phong.covered;
        for (std::size_t i = 0; i < both.size(); ++i) {
            result.silhouette_pixels += phong.covered[i] != drawn.covered[i] ? 1 : 0;
            both[i] = phong.covered[i] && drawn.covered[i];
        }
        result.meter.add(phong.colour, drawn.colour, both);
        result.triangles += static_cast<double>(drawn.triangles) / static_cast<double>(phong.triangles * runs.size());
    }
    return result;
}

TEST(subdivide, edges_gain_fifteen_decibels_for_quadratic) {
    const Gain edges = gain(Method::quadratic, measured_scene("sphere-168"), by_edges);
    fmt::print("quadratic, by edges: {:.2f} dB, max {:.2f}, triangles x{:.2f}, {} pixels at the silhouette\n",
               edges.meter.psnr(), edges.meter.max_error(), edges.triangles, edges.silhouette_pixels);
    EXPECT_GE(edges.meter.psnr(), 52.0);
    EXPECT_LE(edges.triangles, 1.7);
    EXPECT_LE(edges.silhouette_pixels, 8U);
}

TEST(subdivide, the_centre_misses_what_edges_find) {
    const Gain centre = gain(Method::quadratic, measured_scene("sphere-168"), by_centre);
    fmt::print("quadratic, by centre: {:.2f} dB, max {:.2f}, triangles x{:.2f}\n", centre.meter.psnr(),
               centre.meter.max_error(), centre.triangles);
    EXPECT_GT(centre.meter.psnr(), 41.0);
    EXPECT_GT(centre.meter.max_error(), 40.0) << "a highlight beside the centre";
    const Gain edges = gain(Method::quadratic, measured_scene("sphere-168"), by_edges);
    EXPECT_LT(edges.meter.max_error(), 8.0);
}

TEST(subdivide, gouraud_and_log_quadratic_gain_too) {
    const Gain gouraud = gain(Method::gouraud, measured_scene("sphere-168"), by_edges);
    const Gain log = gain(Method::log_quadratic, measured_scene("sphere-168"), {1.0, SubdivisionTest::edge, 5});
    fmt::print(
        "gouraud, 4 steps: {:.2f} dB, max {:.2f}, x{:.2f}; log-quadratic, 1 step: {:.2f} dB, max {:.2f}, x{:.2f}\n",
        gouraud.meter.psnr(), gouraud.meter.max_error(), gouraud.triangles, log.meter.psnr(), log.meter.max_error(),
        log.triangles);
    EXPECT_GE(gouraud.meter.psnr(), 47.0);
    EXPECT_LE(gouraud.triangles, 3.5);
    EXPECT_LE(log.meter.max_error(), 1.6);
    EXPECT_LE(log.triangles, 1.15);
}

class Jumps : public testing::TestWithParam<Method> {};

TEST_P(Jumps, along_shared_edges_are_below_a_quarter_step_split_or_not) {
    Scene scene = measured_scene("sphere-168");
    const std::vector<ScreenTriangle> whole = project(scene, Uncovered::keep);
    double unsplit = 0.0;
    double split = 0.0;
    for (const std::vector<Light>& lights : measured_lights()) {
        scene.lights = lights;
        unsplit = std::max(unsplit, largest_edge_jump(GetParam(), {}, scene, whole, 0.05));
        const Subdivision fine{GetParam() == Method::log_quadratic ? 1.0 : 4.0, SubdivisionTest::edge, 3};
        const std::vector<ScreenTriangle> pieces = subdivide(GetParam(), {}, scene, whole, fine);
        EXPECT_GT(pieces.size(), whole.size() / 2);
        split = std::max(split, largest_edge_jump(GetParam(), {}, scene, pieces, 0.05));
    }
    fmt::print("{}: largest jump along shared edges {:.4f} steps, subdivided {:.4f}\n", to_string(GetParam()), unsplit,
               split);
    EXPECT_LE(unsplit, 0.25);
    EXPECT_LE(split, 0.25);
}

INSTANTIATE_TEST_SUITE_P(subdivide, Jumps, testing::Values(Method::gouraud, Method::quadratic, Method::log_quadratic));

TEST(subdivide, the_papers_split_jumps_where_a_neighbour_is_whole) {
    Scene scene = measured_scene("sphere-168");
    double largest = 0.0;
    for (const std::vector<Light>& lights : measured_lights()) {
        scene.lights = lights;
        const auto pieces = subdivide(Method::quadratic, {}, scene, project(scene, Uncovered::keep), by_centre);
        largest = std::max(largest, largest_edge_jump(Method::quadratic, {}, scene, pieces, 0.05));
    }
    fmt::print("quadratic, by centre: largest jump {:.2f} steps\n", largest);
    EXPECT_GT(largest, 10.0);
}

/// A sheet of triangles over the rectangle of 1…width−1 by 1…height−1 pixels, its inner vertices anywhere in their
/// cells, with random normals; many of its triangles are thin or cover no pixel. `on_centres` moves the inner ones to
/// within 1/256 px of pixel centres: then edges run through centres, and snapping a middle decides who covers one.
std::vector<ScreenTriangle> random_sheet(Rng& rng, const Scene& scene, int cells, bool on_centres) {
    const std::int64_t right = std::int64_t{256} * (scene.width - 2);
    const std::int64_t bottom = std::int64_t{256} * (scene.height - 2);
    std::vector<ScreenVertex> vertices;
    for (int row = 0; row <= cells; ++row) {
        for (int column = 0; column <= cells; ++column) {
            const auto jitter = [&](int index, std::int64_t side) {
                const std::int64_t pitch = side / cells;
                if (index == 0 || index == cells) return index == 0 ? std::int64_t{0} : side;
                if (on_centres)
                    return (index * pitch + uniform(rng, -pitch / 4, pitch / 4)) / 256 * 256 + 128 + uniform(rng, 0, 1);
                return index * pitch + uniform(rng, -pitch / 2 + 1, pitch / 2 - 1);
            };
            ScreenVertex vertex;
            vertex.point = {256 + jitter(column, right), 256 + jitter(row, bottom)};
            vertex.depth = 1000.0;
            vertex.position = {static_cast<double>(vertex.point.x) / 256, -static_cast<double>(vertex.point.y) / 256,
                               -4};
            vertex.normal = glm::normalize(glm::dvec3(real(rng, -1, 1), real(rng, -1, 1), real(rng, 0.1, 1)));
            vertices.push_back(vertex);
        }
    }
    const auto at = [&](int row, int column) { return vertices[static_cast<std::size_t>(row * (cells + 1) + column)]; };
    std::vector<ScreenTriangle> triangles;
    const auto add = [&](const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
        ScreenTriangle t;
        t.vertices = {a, b, c};
        t.face_normal = {0, 0, 1};
        t.walks = walk_in_image(a.point, b.point, c.point, scene.width, scene.height);
        triangles.push_back(t);
    };
    for (int row = 0; row < cells; ++row) {
        for (int column = 0; column < cells; ++column) {
            const ScreenVertex a = at(row, column), b = at(row, column + 1);
            const ScreenVertex c = at(row + 1, column + 1), d = at(row + 1, column);
            // Counter-clockwise for the viewer, along whichever diagonal keeps both triangles so.
            const bool falling =
                doubled_area(a.point, d.point, c.point) <= 0 && doubled_area(a.point, c.point, b.point) <= 0;
            add(a, d, falling ? c : b);
            add(falling ? a : d, c, b);
        }
    }
    return triangles;
}

/// How often each pixel is covered.
std::map<std::pair<int, int>, int> coverage(const std::vector<ScreenTriangle>& triangles) {
    std::map<std::pair<int, int>, int> count;
    for (const ScreenTriangle& triangle : triangles) {
        for (const TriangleWalk& walk : triangle.walks) {
            for_each_span(walk, [&](int x, int y, int length, int step) {
                for (int i = 0; i < length; ++i) ++count[{x + i * step, y}];
            });
        }
    }
    return count;
}

TEST(subdivide, every_pixel_of_a_sheet_stays_covered_once) {
    Rng rng(seed);
    std::size_t split = 0;
    for (int k = 0; k < 150; ++k) {
        Scene scene;
        scene.width = static_cast<int>(uniform(rng, 12, 90));
        scene.height = static_cast<int>(uniform(rng, 12, 90));
        scene.lights = measured_lights()[static_cast<std::size_t>(k % 4)];
        const bool on_centres = k % 3 == 0;
        if (on_centres) scene.width = scene.height = 90;
        const auto whole =
            random_sheet(rng, scene, static_cast<int>(uniform(rng, 2, on_centres ? 12 : 24)), on_centres);
        const auto pieces = subdivide(k % 2 == 0 ? Method::quadratic : Method::gouraud, {}, scene, whole, by_edges);
        split += pieces.size() > whole.size() ? 1 : 0;
        for (const auto* triangles : {&whole, &pieces}) {
            const auto count = coverage(*triangles);
            ASSERT_EQ(count.size(), static_cast<std::size_t>((scene.width - 2) * (scene.height - 2))) << "sheet " << k;
            for (const auto& [pixel, times] : count) {
                ASSERT_EQ(times, 1) << "sheet " << k << ": pixel " << pixel.first << ", " << pixel.second;
            }
        }
    }
    EXPECT_GT(split, 75U);
}

/// A closed surface: a lumpy ball, front and back.
Scene lumpy_ball(Rng& rng) {
    Scene scene;
    scene.width = 70;
    scene.height = 60;
    scene.two_sided = true;
    scene.rotate_degrees = {real(rng, 0, 360), real(rng, 0, 360), real(rng, 0, 360)};
    scene.lights = measured_lights()[static_cast<std::size_t>(uniform(rng, 0, 3))];
    scene.mesh = make_builtin_mesh(uniform(rng, 0, 1) == 0 ? "builtin:sphere-168" : "builtin:sphere-374");
    for (glm::dvec3& p : scene.mesh.positions) p *= real(rng, 0.5, 1.0);
    scene.mesh.normals = smooth_normals(scene.mesh.positions, scene.mesh.triangles);
    return scene;
}

TEST(subdivide, closed_meshes_stay_closed) {
    Rng rng(seed + 1);
    for (int k = 0; k < 40; ++k) {
        const Scene scene = lumpy_ball(rng);
        const auto whole = project(scene, Uncovered::keep);
        const auto pieces = subdivide(Method::quadratic, {}, scene, whole, by_edges);
        ASSERT_GT(pieces.size(), whole.size() / 2);
        for (const auto* triangles : {&whole, &pieces}) {
            std::vector<ScreenTriangle> front;
            std::vector<ScreenTriangle> back;
            for (const ScreenTriangle& t : *triangles) (screen_area(t) > 0 ? back : front).push_back(t);
            // A ray that enters a closed surface leaves it.
            ASSERT_EQ(coverage(front), coverage(back)) << "ball " << k;
        }
    }
}

TEST(subdivide, phong_on_the_pieces_is_phong_on_the_whole) {
    Scene scene = measured_scene("sphere-168");
    for (const bool perspective : {false, true}) {
        if (perspective) scene.field_of_view = 60.0;
        scene.lights = measured_lights().front();
        const auto whole = project(scene, Uncovered::keep);
        const auto pieces = subdivide(Method::quadratic, {}, scene, whole, {1.0, SubdivisionTest::edge, 5});
        ASSERT_GT(pieces.size(), 2 * project(scene).size());
        const ReferenceImage expected = render_reference(Method::phong, scene, whole);
        const ReferenceImage drawn = render_reference(Method::phong, scene, pieces);
        double largest = 0.0;
        for (std::size_t i = 0; i < drawn.colour.size(); ++i) {
            if (!drawn.covered[i] || !expected.covered[i]) continue;
            largest = std::max(largest, glm::length(drawn.colour[i] - expected.colour[i]));
        }
        fmt::print("phong on pieces: {:.3f} steps from phong on the whole\n", largest);
        EXPECT_LT(largest, 1.0);
    }
}

TEST(subdivide, a_generous_tolerance_changes_nothing) {
    Scene scene = measured_scene("torus-knot");
    scene.lights = measured_lights().front();
    const auto whole = project(scene);
    for (const SubdivisionTest test : {SubdivisionTest::edge, SubdivisionTest::centre}) {
        const auto pieces = subdivide(Method::quadratic, {}, scene, whole, {300.0, test, 5});
        ASSERT_EQ(pieces.size(), whole.size());
        for (std::size_t i = 0; i < whole.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_EQ(pieces[i].vertices[k].point, whole[i].vertices[k].point);
                ASSERT_EQ(pieces[i].vertices[k].normal, whole[i].vertices[k].normal);
            }
        }
    }
}

TEST(subdivide, refuses_what_it_cannot_do) {
    const Scene scene;
    for (const Method method : all_methods()) {
        const bool divisible =
            method == Method::gouraud || method == Method::quadratic || method == Method::log_quadratic;
        EXPECT_EQ(why_indivisible(method).has_value(), !divisible) << to_string(method);
        if (divisible) continue;
        EXPECT_THROW(subdivide(method, {}, scene, {}, {}), UsageError) << to_string(method);
    }
    for (const double tolerance : {0.0, -1.0, std::nan("")}) {
        EXPECT_THROW(subdivide(Method::quadratic, {}, scene, {}, {tolerance, SubdivisionTest::edge, 5}), UsageError);
    }
    EXPECT_EQ(parse_subdivision_test("centre"), SubdivisionTest::centre);
    EXPECT_EQ(parse_subdivision_test("edge"), SubdivisionTest::edge);
    EXPECT_THROW(parse_subdivision_test("middle"), UsageError);
}

}  // namespace
}  // namespace sheen::test
