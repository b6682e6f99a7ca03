// SPDX-License-Identifier: MIT
// Operations that the papers state, counted by running the formulas with numbers that count.
#include <cmath>

#include "printed_quadratic.hpp"
#include "results.hpp"
#include "screen_terms.hpp"
#include "sheen/cost.hpp"
#include "sheen/counted.hpp"
#include "sheen/recurrence.hpp"
#include "sheen/taylor.hpp"

namespace sheen::paper {
namespace {

using Vector = glm::vec<3, Counted>;

ordered_json to_json(const OperationCounts& counts) {
    return {{"additions", counts.additions},    {"multiplications", counts.multiplications},
            {"divisions", counts.divisions},    {"roots", counts.roots},
            {"powers", counts.powers},          {"comparisons", counts.comparisons},
            {"table_reads", counts.table_reads}};
}

template <typename Work>
ordered_json counted(const Work& work) {
    const CountingScope scope;
    work();
    return to_json(scope.counts());
}

ScreenTriangle some_triangle() {
    ScreenTriangle triangle;
    triangle.vertices[0].point = {100, 200};
    triangle.vertices[1].point = {9000, 1700};
    triangle.vertices[2].point = {3000, 8000};
    return triangle;
}

/// The coefficients of one colour from its six nodes, the corners' places on the screen given; and of three colours,
/// which share what depends on the places alone.
ordered_json quadratic_setup() {
    const ScreenTriangle triangle = some_triangle();
    ordered_json json;
    json["printed"] = counted([] {
        (void)printed_terms<Counted>({35.0, 6.0, 11.0, 30.0}, {10.0, 40.0, 20.0, 30.0, 17.0, 35.0});
    });
    json["barycentric"] = counted([&triangle] {
        Terms<Counted, Counted> terms;
        terms.fit_quadratic(Barycentrics<Counted>(triangle), {10.0, 40.0, 20.0, 30.0, 17.0, 35.0});
    });
    json["barycentric_rgb"] = counted([&triangle] {
        Terms<Counted, Vector> terms;
        std::array<Vector, 6> nodes;
        for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] = Vector(static_cast<double>(k * k));
        terms.fit_quadratic(Barycentrics<Counted>(triangle), nodes);
    });
    return json;
}

/// One diffuse colour as paper `fast-phong` counts it: no ambient, no highlight, setups without A, B and C, which all
/// share.
ordered_json one_diffuse_colour() {
    const LinearVector<Counted> normal{Vector(0.01, 0.002, -0.003), Vector(-0.002, 0.012, 0.001),
                                       Vector(0.1, 0.2, 0.9)};
    const Vector light(0.3, 0.4, std::sqrt(0.75));
    ordered_json json;
    json["phong_pixel"] = counted([&normal, &light] {
        const Vector n = normal.constant + normal.x;  // forward differences: one addition a component
        (void)(scalar_product(n, light) / sqrt(scalar_product(n, n)));
    });
    json["duff_setup"] = counted([&normal, &light] {
        (void)dot_product(normal, light);
        (void)squared_length(normal);
    });
    json["duff_pixel"] = counted([] {
        const Counted numerator = Counted(0.5) + Counted(0.01);
        const Counted slope = Counted(0.02) + Counted(0.003);
        const Counted squared = Counted(0.9) + slope;
        (void)(numerator / sqrt(squared));
    });
    json["taylor_setup"] = counted(
        [&normal, &light] { (void)taylor_series(dot_product(normal, light), inverse_length(squared_length(normal))); });
    json["taylor_setup_printed"] = counted([&normal, &light] { (void)printed_taylor_series(normal, light); });
    json["taylor_pixel"] = counted([] {
        const Counted slope = Counted(0.01) + Counted(0.002);
        (void)(Counted(0.5) + slope);
    });
    return json;
}

/// A unit normal at one pixel: paper `recurrence`, conclusions.
ordered_json unit_normal() {
    const Vector step(0.01, 0.02, -0.01);
    const Vector now(0.1, 0.2, 0.95);
    const Vector before = now - step;
    ordered_json json;
    json["linear"] = counted([&] {
        const Vector n = now + step;
        const Counted length = sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
        (void)Vector(n.x / length, n.y / length, n.z / length);
    });
    const RecurrenceStep<Counted> recurrence(0.999, false, false);
    json["recurrence"] = counted([&] {
        for (int c = 0; c < 3; ++c) (void)recurrence.ahead(1, now[c], before[c]);
    });
    return json;
}

ordered_json pixel_costs() {
    Scene scene = grey_scene("sphere-168", 20.0);
    ordered_json rows = ordered_json::array();
    for (const double specular : {0.0, 0.45}) {
        scene.material.specular = specular;
        const auto triangles = project(scene);
        for (const Method method : all_methods()) {
            const MethodCost cost = method_cost(method, scene, triangles);
            ordered_json row = {{"method", to_string(method)}, {"highlight", specular > 0.0}};
            for (const auto& [name, value] : cost.pixel.named()) row[name] = value;
            rows.push_back(row);
        }
    }
    return rows;
}

}  // namespace

ordered_json operation_counts() {
    return {{"quadratic_setup", quadratic_setup()},
            {"one_diffuse_colour", one_diffuse_colour()},
            {"unit_normal", unit_normal()},
            {"pixels", pixel_costs()}};
}

}  // namespace sheen::paper
