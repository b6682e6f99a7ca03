// SPDX-License-Identifier: MIT
// The papers' times, as times of this machine: fast-phong's table, quadratic's 230 : 250 : 450, recurrence's factor.
#include <cmath>
#include <glm/geometric.hpp>

#include "results.hpp"
#include "sheen/cost.hpp"
#include "sheen/great_arc.hpp"
#include "stopwatch.hpp"

namespace sheen::paper {
namespace {

constexpr int repetitions = 25;

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

/// A square root and the quotient by it, each waiting for the one before.
double root_and_quotient_seconds() {
    constexpr int count = 1 << 21;
    return median_seconds(5,
                          [] {
                              double x = 1.5;
                              for (int i = 0; i < count; ++i) x = 3.0 / std::sqrt(x + 1.0);
                              return x;
                          }) /
           count;
}

/// 14,620 triangles at 2048×2048, as in the paper; here a sphere, half of whose triangles face away.
ordered_json fast_phong_table() {
    Scene scene = grey_scene("sphere-168", 20.0);
    scene.mesh = sphere(86, 86);
    scene.width = scene.height = 2048;
    const Workload work(scene);
    return {{"triangles", scene.mesh.triangles.size()},
            {"seconds_per_root_and_division", root_and_quotient_seconds()},
            {"rows", rows_of({{"gouraud", Method::gouraud, &work},
                              {"taylor", Method::taylor, &work},
                              {"taylor-finite", Method::taylor_finite, &work},
                              {"duff", Method::duff, &work},
                              {"phong", Method::phong, &work},
                              {"quadratic", Method::quadratic, &work}},
                             15)}};
}

ordered_json quadratic_ratio() {
    const Workload coarse(grey_scene("sphere-168", 50.0));
    return rows_of({{"gouraud", Method::gouraud, &coarse},
                    {"quadratic", Method::quadratic, &coarse},
                    {"phong", Method::phong, &coarse}},
                   repetitions);
}

/// Unit normals and their product with L, and nothing else, along spans of 512 pixels: by interpolation and
/// normalisation, by recurrence of the normal (eq. 7) and of the product (eq. 14). Seconds a pixel.
ordered_json normals_alone() {
    constexpr int spans = 2000;
    constexpr int length = 512;
    const glm::dvec3 light = glm::normalize(glm::dvec3(-0.4, 0.5, 0.77));
    const glm::dvec3 first = glm::normalize(glm::dvec3(-0.3, 0.1, 1.0));
    const glm::dvec3 last = glm::normalize(glm::dvec3(0.4, 0.2, 1.0));
    const GreatArc<double> arc(first, last, glm::dvec3(0.0, 0.0, 1.0));
    const double twice_cosine = 2.0 * std::cos(arc.angle() / length);
    const glm::dvec3 second = arc.at(1.0 / length);
    const auto along_spans = [](const auto& sum_of_span) {
        return median_seconds(repetitions,
                              [&sum_of_span] {
                                  double sum = 0.0;
                                  for (int span = 0; span < spans; ++span) sum += sum_of_span();
                                  return sum;
                              }) /
               (spans * length);
    };
    const double linear = along_spans([&] {
        glm::dvec3 normal = first;
        const glm::dvec3 step = (last - first) * (1.0 / length);
        double sum = 0.0;
        for (int i = 0; i < length; ++i) {
            sum += glm::dot(normal / std::sqrt(glm::dot(normal, normal)), light);
            normal += step;
        }
        return sum;
    });
    const double recurrent_normal = along_spans([&] {
        glm::dvec3 before = first;
        glm::dvec3 now = second;
        double sum = 0.0;
        for (int i = 0; i < length; ++i) {
            sum += glm::dot(before, light);
            const glm::dvec3 next = twice_cosine * now - before;
            before = now;
            now = next;
        }
        return sum;
    });
    const double recurrent_product = along_spans([&] {
        double before = glm::dot(first, light);
        double now = glm::dot(second, light);
        double sum = 0.0;
        for (int i = 0; i < length; ++i) {
            sum += before;
            const double next = twice_cosine * now - before;
            before = now;
            now = next;
        }
        return sum;
    });
    return {{"linear", linear}, {"recurrent_normal", recurrent_normal}, {"recurrent_product", recurrent_product}};
}

ordered_json recurrence_factor() {
    const Workload sphere_168(grey_scene("sphere-168", 50.0));
    const Workload long_spans(one_triangle_scene());
    MethodOptions four;
    four.recurrence_pixels = 4;
    std::vector<Contestant> contestants;
    for (const auto& [suffix, work] :
         std::vector<std::pair<std::string, const Workload*>>{{"", &sphere_168}, {", long spans", &long_spans}}) {
        contestants.push_back({"phong" + suffix, Method::phong, work});
        contestants.push_back({"recurrence" + suffix, Method::recurrence, work});
        contestants.push_back({"recurrence, 4 pixels" + suffix, Method::recurrence, work, four});
    }
    return rows_of(contestants, repetitions);
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
    return {{"fast_phong", fast_phong_table()},
            {"quadratic", quadratic_ratio()},
            {"recurrence", recurrence_factor()},
            {"normals", normals_alone()}};
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
        const std::vector<Times> seconds = race(contestants, 11);
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
