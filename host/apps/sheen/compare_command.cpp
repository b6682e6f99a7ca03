// SPDX-License-Identifier: MIT
/// \file
/// sheen compare: methods and devices side by side, as a table, a contact sheet and JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>

#include "commands.hpp"
#include "output.hpp"
#include "scene_options.hpp"
#include "sheen/compare.hpp"
#include "sheen/error.hpp"
#include "values.hpp"

namespace sheen::command {
namespace {

std::string all_method_names() {
    std::vector<std::string> names;
    for (const Method method : all_methods()) {
        names.push_back(to_string(method));
    }
    return fmt::format("{}", fmt::join(names, ","));
}

struct CompareOptions {
    explicit CompareOptions(CLI::App& command) : scene(command) {}
    SceneOptions scene;
    std::string methods = all_method_names();
    std::string devices = "reference,hls";
    std::string lights;
    std::string sheet;
    std::string json;
};

ComparisonRequest make_request(const CompareOptions& options) {
    ComparisonRequest request;
    for (const std::string& word : parse_list("--methods", options.methods)) {
        request.methods.push_back(parse_method(word));
    }
    request.devices = parse_list("--devices", options.devices);
    for (const std::string& name : request.devices) {
        require_drawing_name(name);
    }
    if (!options.lights.empty()) {
        if (options.scene.has_lights()) {
            throw UsageError("--lights measured brings its own lights: leave --light out, or --lights");
        }
        request.runs = measured_lights();
    }
    return request;
}

nlohmann::ordered_json to_json(const ComparisonRow& row) {
    nlohmann::ordered_json json = {{"method", to_string(row.method)}, {"device", row.device}};
    const bool drawn = row.reason.empty();
    const auto figure = [drawn](const auto& value) { return drawn ? nlohmann::ordered_json(value) : nullptr; };
    json["psnr"] = std::isinf(row.psnr) ? nullptr : figure(row.psnr);
    json["max_error"] = figure(row.max_error);
    json["bit_exact"] = json_or_null(row.bit_exact);
    json["triangles"] = figure(row.triangles);
    json["pixels"] = figure(row.pixels);
    json["cycles"] = json_or_null(row.cycles);
    json["pixels_per_clock"] = json_or_null(row.pixels_per_clock());
    if (!drawn) {
        json["reason"] = row.reason;
    }
    return json;
}

std::string table_row(const ComparisonRow& row) {
    const std::string names = fmt::format("{:<10} {:<10} ", to_string(row.method), row.device);
    if (!row.reason.empty()) {
        return names + row.reason + "\n";
    }
    const std::string bit_exact = row.bit_exact ? (*row.bit_exact ? "yes" : "no") : "-";
    const std::string cycles = row.cycles ? std::to_string(*row.cycles) : "-";
    const std::optional<double> rate = row.pixels_per_clock();
    return names + fmt::format("{:>7.2f} {:>9.2f} {:>9} {:>9} {:>9} {:>10} {:>16}\n", row.psnr, row.max_error,
                               bit_exact, row.triangles, row.pixels, cycles, rate ? fmt::format("{:.3f}", *rate) : "-");
}

std::string table(const Comparison& comparison) {
    std::string text =
        fmt::format("{:<10} {:<10} {:>7} {:>9} {:>9} {:>9} {:>9} {:>10} {:>16}\n", "method", "device", "psnr",
                    "max_error", "bit_exact", "triangles", "pixels", "cycles", "pixels_per_clock");
    for (const ComparisonRow& row : comparison.rows) {
        text += table_row(row);
    }
    return text;
}

/// The comparison with its pictures as they are to be stored; errors stay as measured.
Comparison finished(Comparison comparison, const SceneOptions& scene) {
    comparison.reference = scene.finish(comparison.reference);
    for (ComparisonRow& row : comparison.rows) {
        row.picture = scene.finish(row.picture);
    }
    return comparison;
}

void compare_and_report(const CompareOptions& options) {
    const ComparisonRequest request = make_request(options);
    const Outputs outputs({{"-o", options.sheet}, {"--json", options.json}});
    Comparison comparison;
    {
        const ProgressBar progress;
        progress.show(0, 1, "loading " + options.scene.mesh());
        const Scene scene = options.scene.load();
        comparison = compare(scene, request, [&progress](std::size_t done, std::size_t total, const std::string& what) {
            progress.show(done, total, what);
        });
    }
    if (!options.json.empty()) {
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        for (const ComparisonRow& row : comparison.rows) {
            rows.push_back(to_json(row));
        }
        write_json(options.json, rows);
    }
    outputs.print(table(comparison));
    if (!options.sheet.empty()) {
        write_png(options.sheet, contact_sheet(finished(std::move(comparison), options.scene)));
    }
}

}  // namespace

void add_compare(CLI::App& app) {
    CLI::App* command = app.add_subcommand("compare", "Methods and devices side by side, against Phong per pixel");
    const auto options = std::make_shared<CompareOptions>(*command);
    const auto add = [&command](const char* name, std::string& value, const char* word, const char* description) {
        return command->add_option(name, value, description)->type_name(word)->group("Comparison");
    };
    add("--methods,--method", options->methods, "M,...", "Methods to compare [all]");
    add("--devices,--device", options->devices, "D,...", "Devices to compare [reference,hls]");
    add("--lights", options->lights, "measured", "Four runs, each with one of the lights of the quality figures")
        ->check(CLI::IsMember({"measured"}));
    add_output(*command, "-o,--output", options->sheet, "SHEET.png",
               "Contact sheet: picture and error map x16; - for standard output");
    add_output(*command, "--json", options->json, "FILE", "The rows as JSON; - for standard output");
    command->footer(
        "Figures are over the mesh's pixels: double against double for the reference, 8-bit against 8-bit for "
        "devices.\n"
        "An infinite PSNR is inf in the table and null in JSON.\n"
        "\n"
        "Examples:\n"
        "  sheen compare builtin:sphere-168 --rotate 23,0,11 --lights measured\n"
        "  sheen compare mine.obj --methods gouraud,quadratic --devices hls,verilator -o sheet.png --json rows.json");
    command->callback([options] { compare_and_report(*options); });
}

}  // namespace sheen::command
