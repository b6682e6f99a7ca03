// SPDX-License-Identifier: MIT
/// \file
/// Throughput of the core: clocks of random triangles and of real meshes on Verilator, for each stream width, never
/// stalling and randomly stalling; and how fast each device simulates.
///
/// Usage: throughput quick|full OUT.json. Prints tables as it goes; the file is for scripts/bench/report.py.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../support/shaped_triangles.hpp"
#include "sheen/cycle_model.hpp"
#include "sheen/error.hpp"
#include "sheen/render.hpp"

namespace {

using namespace sheen;
using nlohmann::json;

constexpr std::uint64_t seed = 20263;

struct Width {
    const char* device;
    int words_per_beat;
};
constexpr Width widths[] = {{"verilator-w32", 1}, {"verilator", 2}, {"verilator-w128", 4}};

/// The stage that has most to do.
const char* busiest(const StageWork& work) {
    if (work.pixels >= work.beats && work.pixels >= work.walk) return "pixels";
    return work.beats >= work.walk ? "setup stream" : "edge walker";
}

/// Runs the packets and says what came of it, as a row of the report.
json measure(const Width& width, const Stalls& stalls, const std::vector<std::uint32_t>& packets) {
    SimulatorDevice device(width.device, width.words_per_beat, stalls);
    const RunResult result = device.run(packets);
    const Statistics statistics = statistics_of(packets, result);
    const std::uint64_t predicted = predict_cycles(packets, width.words_per_beat, stalls);
    const auto cycles = static_cast<double>(result.cycles.value());
    return {{"stream_bits", 32 * width.words_per_beat},
            {"source_stall_percent", stalls.source_percent},
            {"sink_stall_percent", stalls.sink_percent},
            {"triangles", statistics.triangles},
            {"pixels", statistics.pixels},
            {"cycles", result.cycles.value()},
            {"predicted_cycles", predicted},
            {"deviation_percent", 100 * (static_cast<double>(predicted) / cycles - 1)},
            {"busiest", busiest(cycle_bounds(packets, width.words_per_beat).total)},
            {"pixels_per_clock", statistics.pixels_per_clock().value()}};
}

/// The standard error of pixels per clock, relative, from how much groups of the triangles differ in the cycle model.
double relative_error(test::Rng& rng, test::Shape shape, double area, int count, const test::PacketForm& form,
                      int words_per_beat) {
    constexpr int groups = 10;
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < groups; ++i) {
        const auto packets = test::shaped_packets(rng, shape, area, std::max(1, count / groups), form);
        const double rate = static_cast<double>(cycle_bounds(packets, words_per_beat).total.pixels) /
                            static_cast<double>(predict_cycles(packets, words_per_beat));
        sum += rate;
        squares += rate * rate;
    }
    const double mean = sum / groups;
    const double variance = std::max(0.0, squares / groups - mean * mean) * groups / (groups - 1);
    return std::sqrt(variance / groups) / mean;
}

void print_row(const json& row) {
    fmt::print(
        "{:<28} {:>3} bits  source {:>2} %  sink {:>2} %  {:>6} triangles  {:.4f} pixels per clock  "
        "model {:+.3f} %  {}\n",
        row["name"].get<std::string>(), row["stream_bits"].get<int>(), row["source_stall_percent"].get<int>(),
        row["sink_stall_percent"].get<int>(), row["triangles"].get<int>(), row["pixels_per_clock"].get<double>(),
        row["deviation_percent"].get<double>(), row["busiest"].get<std::string>());
    std::fflush(stdout);
}

json measure_triangles(bool full) {
    const std::vector<test::Shape> shapes = {test::Shape::equilateral, test::Shape::right, test::Shape::random};
    const std::vector<Stalls> stalls = {{0, 0, 1}, {25, 0, 2}, {0, 25, 3}};
    json rows = json::array();
    const auto measure_one = [&](test::Shape shape, int area, bool linear) {
        // Slivers differ most: half a per cent takes five times as many of them.
        const int pixels = !full ? 40'000 : shape == test::Shape::sliver ? 2'000'000 : 400'000;
        const int count = std::clamp(pixels / area, full ? 200 : 40, full ? 40'000 : 2'000);
        const test::PacketForm form{linear, true};
        test::Rng rng(seed + static_cast<std::uint64_t>(area));
        const auto packets = test::shaped_packets(rng, shape, area, count, form);
        for (const Width& width : widths) {
            const double error = relative_error(rng, shape, area, count, form, width.words_per_beat);
            for (const Stalls& stall : stalls) {
                json row = measure(width, stall, packets);
                row["name"] = fmt::format("{} {} px, {}", to_string(shape), area, linear ? "gouraud" : "quadratic");
                row["shape"] = to_string(shape);
                row["area"] = area;
                row["method"] = linear ? "gouraud" : "quadratic";
                row["relative_standard_error"] = error;
                print_row(row);
                rows.push_back(std::move(row));
            }
        }
    };
    for (const bool linear : {false, true}) {
        for (const test::Shape shape : shapes) {
            if (!full && (linear || shape != test::Shape::equilateral)) continue;
            for (const int area : {10, 20, 30, 50, 200, 1000, 5000}) measure_one(shape, area, linear);
        }
        measure_one(test::Shape::sliver, 50, linear);
    }
    return rows;
}

/// The packets of a built-in mesh, 512×512.
std::vector<std::uint32_t> mesh_packets(const std::string& mesh, Method method) {
    Scene scene;
    scene.mesh = load_mesh(mesh);
    return picture_packets(make_setups(method, scene, project(scene)));
}

json measure_meshes() {
    json rows = json::array();
    for (const std::string& mesh : builtin_mesh_names()) {
        for (const Method method : all_methods()) {
            if (!has_packets(method) || has_log_channels(method)) continue;
            const auto packets = mesh_packets(mesh, method);
            for (const Width& width : widths) {
                json row = measure(width, {}, packets);
                row["name"] = fmt::format("{} {}", mesh.substr(mesh.find(':') + 1), to_string(method));
                row["mesh"] = mesh;
                row["method"] = to_string(method);
                print_row(row);
                rows.push_back(std::move(row));
            }
        }
    }
    return rows;
}

/// Wall-clock speed of each device on one picture; the kernels are untimed and count no clocks.
json measure_devices(bool full) {
    const auto packets = mesh_packets("builtin:sphere-168", Method::quadratic);
    json rows = json::array();
    for (const std::string& name : device_names()) {
        const int runs = full && name != "ghdl" ? 5 : 1;
        const auto device = make_device(name);
        double best = 0;
        RunResult result;
        for (int run = 0; run < runs; ++run) {
            const auto start = std::chrono::steady_clock::now();
            result = device->run(packets);
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            best = run == 0 ? seconds : std::min(best, seconds);
        }
        const Statistics statistics = statistics_of(packets, result);
        json row = {{"device", name},
                    {"pixels", statistics.pixels},
                    {"seconds", best},
                    {"pixels_per_second", static_cast<double>(statistics.pixels) / best}};
        if (result.cycles) row["cycles_per_second"] = static_cast<double>(*result.cycles) / best;
        fmt::print("{:<10} {:>9.0f} pixels per second", name, row["pixels_per_second"].get<double>());
        if (result.cycles) fmt::print(", {:.0f} clocks per second", row["cycles_per_second"].get<double>());
        fmt::print("\n");
        rows.push_back(std::move(row));
    }
    return rows;
}

void run(bool full, const std::string& path) {
    json report = {{"extent", full ? "full" : "quick"}, {"seed", seed}};
    report["triangles"] = measure_triangles(full);
    report["meshes"] = measure_meshes();
    report["devices"] = measure_devices(full);
    double worst = 0;
    for (const char* part : {"triangles", "meshes"}) {
        for (const json& row : report[part]) {
            worst = std::max(worst, std::abs(row["deviation_percent"].get<double>()));
        }
    }
    report["worst_deviation_percent"] = worst;
    fmt::print("cycle model: at most {:.3f} % from the simulation\n", worst);
    std::ofstream out(path);
    out << report.dump(1) << '\n';
    out.flush();
    if (!out) throw Error(fmt::format("can't write '{}'", path));
}

}  // namespace

int main(int argc, char** argv) {
    const std::string extent = argc == 3 ? argv[1] : "";
    if (extent != "quick" && extent != "full") {
        std::cerr << "usage: throughput quick|full OUT.json\n";
        return 2;
    }
    try {
        run(extent == "full", argv[2]);
        return 0;
    } catch (const std::exception& failure) {
        std::cerr << "throughput: " << failure.what() << '\n';
        return 1;
    }
}
