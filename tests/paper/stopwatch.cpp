// SPDX-License-Identifier: MIT
#include "stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include "sheen/error.hpp"
#include "sheen/exponent_table.hpp"

namespace sheen::paper {
namespace {

double thread_seconds() {
    timespec now{};
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) throw Error("no processor time on this system");
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Fails on a sum that is no number, so that no compiler leaves out the work behind it.
void require_number(double sum) {
    if (!std::isfinite(sum)) throw Error("a timed loop gave a colour that is no number");
}

/// With the smallest exponent table: a program makes the table once a material, a loop alone makes it once a triangle.
/// The pixel reads it the same.
MethodOptions timed_options(const Contestant& c) {
    MethodOptions options = c.options;
    options.taylor_table_bytes = ExponentTable::least_bytes;
    return options;
}

double setup_once(const Contestant& c) {
    const MethodOptions options = timed_options(c);
    const double start = thread_seconds();
    for (const ScreenTriangle& triangle : c.workload->triangles) {
        (void)make_loop<double>(c.method, options, c.workload->scene, triangle);
    }
    return thread_seconds() - start;
}

double whole_once(const Contestant& c) {
    const MethodOptions options = timed_options(c);
    const Workload& work = *c.workload;
    const double start = thread_seconds();
    glm::dvec3 sum(0.0);
    for (std::size_t t = 0; t < work.triangles.size(); ++t) {
        const auto loop = make_loop<double>(c.method, options, work.scene, work.triangles[t]);
        for (const PixelRow& row : work.rows[t]) {
            loop->start_row(row);
            for (int i = 0; i < row.length; ++i) sum += loop->next();
        }
    }
    const double seconds = thread_seconds() - start;
    require_number(sum.x + sum.y + sum.z);
    return seconds;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace

Workload::Workload(Scene scene_) : scene(std::move(scene_)), triangles(project(scene)) {
    for (const ScreenTriangle& triangle : triangles) {
        rows.push_back(triangle_rows(triangle));
        for (const PixelRow& row : rows.back()) pixels += row.length;
    }
}

std::vector<Times> race(const std::vector<Contestant>& contestants, int repetitions) {
    std::vector<std::vector<double>> setups(contestants.size());
    std::vector<std::vector<double>> wholes(contestants.size());
    for (int turn = 0; turn < repetitions; ++turn) {
        for (std::size_t c = 0; c < contestants.size(); ++c) {
            setups[c].push_back(setup_once(contestants[c]));
            wholes[c].push_back(whole_once(contestants[c]));
        }
    }
    std::vector<Times> times;
    for (std::size_t c = 0; c < contestants.size(); ++c) times.push_back({median(setups[c]), median(wholes[c])});
    return times;
}

double median_seconds(int repetitions, const std::function<double()>& work) {
    std::vector<double> runs;
    for (int turn = 0; turn < repetitions; ++turn) {
        const double start = thread_seconds();
        const double result = work();
        runs.push_back(thread_seconds() - start);
        require_number(result);
    }
    return median(runs);
}

}  // namespace sheen::paper
