// SPDX-License-Identifier: MIT
// The papers' times, as times of this machine: fast-phong's table, quadratic's 230 : 250 : 450, recurrence's factor.
#include "results.hpp"
#include "sheen/cost.hpp"
#include "stopwatch.hpp"

namespace sheen::paper {
namespace {

constexpr int repetitions = 9;

ordered_json rows_of(const std::vector<Contestant>& contestants, int turns) {
    const std::vector<Times> times = race(contestants, turns);
    ordered_json rows = ordered_json::array();
    for (std::size_t c = 0; c < contestants.size(); ++c) {
        const Workload& work = *contestants[c].workload;
        rows.push_back({{"name", contestants[c].name},
                        {"setup_seconds", times[c].setup},
                        {"whole_seconds", times[c].whole},
                        {"triangles", work.triangles.size()},
                        {"pixels", work.pixels}});
    }
    return rows;
}

/// 14,620 triangles at 2048×2048, as in the paper; here a sphere, half of whose triangles face away.
ordered_json fast_phong_table() {
    Scene scene = grey_scene("sphere-168", 20.0);
    scene.mesh = sphere(86, 86);
    scene.width = scene.height = 2048;
    const Workload infinite(scene);
    scene.field_of_view = 40.0;
    const Workload finite(scene);
    return {{"triangles", scene.mesh.triangles.size()},
            {"seconds_per_root_and_division", root_and_division_seconds()},
            {"rows", rows_of({{"gouraud", Method::gouraud, &infinite},
                              {"taylor", Method::taylor, &infinite},
                              {"taylor-finite", Method::taylor_finite, &finite},
                              {"duff", Method::duff, &infinite},
                              {"phong", Method::phong, &infinite},
                              {"phong-finite", Method::phong, &finite},
                              {"quadratic", Method::quadratic, &infinite},
                              {"log-quadratic", Method::log_quadratic, &infinite}},
                             5)}};
}

ordered_json quadratic_ratio() {
    const Workload coarse(grey_scene("sphere-168", 50.0));
    return rows_of({{"gouraud", Method::gouraud, &coarse},
                    {"quadratic", Method::quadratic, &coarse},
                    {"phong", Method::phong, &coarse}},
                   repetitions);
}

ordered_json recurrence_factor() {
    Scene scene = grey_scene("sphere-168", 50.0);
    const Workload shiny(scene);
    scene.material.specular = 0.0;
    const Workload dull(scene);
    MethodOptions four;
    four.recurrence_pixels = 4;
    return rows_of({{"phong", Method::phong, &shiny},
                    {"recurrence", Method::recurrence, &shiny},
                    {"recurrence, 4 pixels", Method::recurrence, &shiny, four},
                    {"phong, diffuse", Method::phong, &dull},
                    {"recurrence, diffuse", Method::recurrence, &dull},
                    {"recurrence, 4 pixels, diffuse", Method::recurrence, &dull, four}},
                   repetitions);
}

/// As paper `fast-phong` prices: additions, products, quotients and reads of memory cost 1, a root and the quotient by
/// it 10 together. A power is a read, since a table can hold it.
double price(const MeanCounts& counts) {
    return counts.additions + counts.multiplications + counts.divisions + 9.0 * counts.roots + counts.powers +
           counts.table_reads;
}

/// The price of a pixel with its share of triangle and span.
double price_of_pixel(Method method, const Workload& work) {
    const MethodCost cost = method_cost(method, work.scene, work.triangles);
    double spans = 0.0;
    for (const auto& rows : work.rows) spans += static_cast<double>(rows.size());
    const auto triangles = static_cast<double>(work.triangles.size());
    return price(cost.pixel) +
           (triangles * (price(cost.nodes) + price(cost.triangle)) + spans * price(cost.span)) / work.pixels;
}

}  // namespace

ordered_json times() {
    return {{"fast_phong", fast_phong_table()}, {"quadratic", quadratic_ratio()}, {"recurrence", recurrence_factor()}};
}

ordered_json break_even() {
    const std::vector<std::pair<std::string, Method>> methods = {{"gouraud", Method::gouraud},
                                                                 {"quadratic", Method::quadratic},
                                                                 {"taylor", Method::taylor},
                                                                 {"duff", Method::duff},
                                                                 {"phong", Method::phong}};
    ordered_json rows = ordered_json::array();
    for (const std::uint32_t segments : {230U, 163U, 115U, 73U, 52U, 29U, 16U}) {
        Scene scene = grey_scene("sphere-168", 20.0);
        scene.mesh = sphere(segments, segments);
        const Workload work(scene);
        std::vector<Contestant> contestants;
        for (const auto& [name, method] : methods) contestants.push_back({name, method, &work});
        const std::vector<Times> seconds = race(contestants, 3);
        ordered_json row = {{"pixels_per_triangle", work.pixels / static_cast<double>(work.triangles.size())}};
        for (std::size_t c = 0; c < methods.size(); ++c) {
            row[methods[c].first] = {{"seconds", seconds[c].whole / work.pixels},
                                     {"price", price_of_pixel(methods[c].second, work)}};
        }
        rows.push_back(row);
    }
    return rows;
}

}  // namespace sheen::paper
