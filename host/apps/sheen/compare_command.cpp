// SPDX-License-Identifier: MIT
/// \file
/// sheen compare: methods and devices side by side, as a table, a contact sheet, JSON and CSV.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "commands.hpp"
#include "comparison_text.hpp"
#include "method_choices.hpp"
#include "output.hpp"
#include "scene_options.hpp"
#include "sheen/compare.hpp"
#include "sheen/error.hpp"
#include "subdivide_options.hpp"
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
    explicit CompareOptions(CLI::App& command) : scene(command), subdivide(command), choices(command) {}
    SceneOptions scene;
    SubdivideOptions subdivide;
    MethodChoices choices;
    std::string methods = all_method_names();
    std::string devices = "reference,hls";
    std::string lights;
    std::string sheet;
    std::string json;
    std::string csv;
    bool quick = false;
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
    request.subdivision = options.subdivide.subdivision();
    request.options = options.choices.options();
    if (!options.lights.empty()) {
        if (options.scene.has_lights()) {
            throw UsageError("--lights measured brings its own lights: leave --light out, or --lights");
        }
        request.runs = measured_lights();
    }
    request.picture_metrics = !options.quick;
    return request;
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
    const Outputs outputs({{"-o", options.sheet}, {"--json", options.json}, {"--csv", options.csv}});
    Comparison comparison;
    {
        const ProgressBar progress;
        progress.show(0, 1, "loading " + options.scene.mesh());
        const Scene scene = options.scene.load();
        comparison = compare(scene, request, [&progress](std::size_t done, std::size_t total, const std::string& what) {
            progress.show(done, total, what);
        });
    }
    if (!comparison.metrics_unavailable.empty()) {
        print_warning("ssim and flip are left out: " + comparison.metrics_unavailable);
    }
    if (!options.json.empty()) {
        write_json(options.json, comparison_json(comparison));
    }
    if (!options.csv.empty()) {
        const std::string text = comparison_csv(comparison);
        write_file_atomically(options.csv, text.data(), text.size());
    }
    outputs.print(comparison_table(comparison));
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
    command->add_flag("--quick", options->quick, "Leaves out ssim and flip, which take seconds a picture")
        ->group("Comparison");
    add_output(*command, "-o,--output", options->sheet, "SHEET.png",
               "Contact sheet: picture and error map x16; - for standard output");
    add_output(*command, "--json", options->json, "FILE", "The rows as JSON; - for standard output");
    add_output(*command, "--csv", options->csv, "FILE", "The rows as CSV; - for standard output");
    command->footer(
        "Figures are over the mesh's pixels: double against double for the reference, 8-bit against 8-bit for "
        "devices.\n"
        "An infinite PSNR is inf in the table and in CSV, and null in JSON.\n"
        "ssim and flip need a Python with scikit-image and flip-evaluator: $SHEEN_PYTHON, or what `make setup` makes.\n"
        "\n"
        "Examples:\n"
        "  sheen compare builtin:sphere-168 --rotate 23,0,11 --lights measured\n"
        "  sheen compare mine.obj --methods gouraud,quadratic --devices hls,verilator -o sheet.png --json rows.json");
    command->callback([options] { compare_and_report(*options); });
}

}  // namespace sheen::command
