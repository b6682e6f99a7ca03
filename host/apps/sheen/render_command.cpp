// SPDX-License-Identifier: MIT
/// \file
/// sheen render: one picture of one mesh, by one method on one device.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "method_choices.hpp"
#include "output.hpp"
#include "scene_options.hpp"
#include "sheen/compare.hpp"
#include "sheen/error.hpp"
#include "sheen/reference.hpp"
#include "sheen/render.hpp"
#include "subdivide_options.hpp"

namespace sheen::command {
namespace {

/// What the user asked for.
struct RenderOptions {
    explicit RenderOptions(CLI::App& command) : scene(command), subdivide(command), choices(command) {}
    SceneOptions scene;
    SubdivideOptions subdivide;
    MethodChoices choices;
    std::string method = "quadratic";
    std::string device = "hls";
    std::string image;
    std::string packets;
    std::string pixels;
    std::string stats;
};

/// A picture, and what a device streamed for it (nothing for the reference).
struct Result {
    Image image;
    Statistics statistics;
    std::vector<std::uint32_t> packets;
    std::vector<std::uint64_t> words;
};

Result draw_with_reference(Method method, const MethodOptions& choices, const Scene& scene,
                           const std::vector<ScreenTriangle>& triangles) {
    const ReferenceImage drawn = render_reference(method, scene, triangles, choices);
    return {drawn.image(), Statistics{drawn.pixels, drawn.triangles, std::nullopt, std::nullopt}, {}, {}};
}

Result draw_with_device(Method method, const MethodOptions& choices, const Scene& scene,
                        const std::vector<ScreenTriangle>& triangles, Device& device) {
    const std::vector<TriangleSetup> setups = make_setups(method, scene, triangles, choices);
    if (const std::optional<std::string> reason = why_incapable(query_capabilities(device), setups)) {
        throw Error(fmt::format("{} on {}: {}", to_string(method), device.name(), *reason));
    }
    Result result;
    result.packets = picture_packets(setups);
    Drawing drawing = draw(device, result.packets, scene.width, scene.height);
    result.image = drawing.framebuffer.image();
    result.statistics = statistics_of(result.packets, drawing.result);
    result.words = std::move(drawing.result.words);
    return result;
}

/// \throws UsageError where the options don't fit together.
void check(const RenderOptions& options, Method method) {
    require_drawing_name(options.device);
    if (const std::optional<std::string> reason = why_impossible(method, options.device)) {
        throw UsageError(fmt::format("--method {} --device {}: {}", options.method, options.device, *reason));
    }
    if (options.subdivide.subdivision()) {
        if (const std::optional<std::string> reason = why_indivisible(method)) {
            throw UsageError(fmt::format("--subdivide with --method {}: {}", options.method, *reason));
        }
    }
    if (options.device == reference_name && !(options.packets.empty() && options.pixels.empty())) {
        throw UsageError(fmt::format("{} with --device {}: it takes setups, not packets; give one of the devices",
                                     options.packets.empty() ? "--pixels" : "--packets", reference_name));
    }
}

/// The triangles to draw, split where the user asked for it.
std::vector<ScreenTriangle> screen_triangles(const RenderOptions& options, Method method, const Scene& scene) {
    const std::optional<Subdivision> subdivision = options.subdivide.subdivision();
    return subdivision
               ? subdivide(method, options.choices.options(), scene, project(scene, Uncovered::keep), *subdivision)
               : project(scene);
}

std::string summary(const RenderOptions& options, const Statistics& statistics) {
    std::string text =
        fmt::format("{}: {}x{}, {} on {}: {} triangles, {} pixels", options.image, options.scene.width(),
                    options.scene.height(), options.method, options.device, statistics.triangles, statistics.pixels);
    if (statistics.cycles) {
        text += fmt::format(", {} cycles, {:.3f} pixels per clock", *statistics.cycles,
                            statistics.pixels_per_clock().value_or(0.0));
    }
    return text + "\n";
}

void render(const RenderOptions& options) {
    constexpr std::size_t steps = 3;
    const Method method = parse_method(options.method);
    check(options, method);
    const Outputs outputs({{"-o", options.image},
                           {"--packets", options.packets},
                           {"--pixels", options.pixels},
                           {"--stats", options.stats}});

    Result result;
    {
        const ProgressBar progress;
        progress.show(0, steps, "loading " + options.scene.mesh());
        const Scene scene = options.scene.load();
        progress.show(1, steps, "projecting");
        const std::vector<ScreenTriangle> triangles = screen_triangles(options, method, scene);
        progress.show(2, steps, fmt::format("{} on {}", options.method, options.device));
        result =
            options.device == reference_name
                ? draw_with_reference(method, options.choices.options(), scene, triangles)
                : draw_with_device(method, options.choices.options(), scene, triangles, *make_device(options.device));
    }
    if (!options.packets.empty()) {
        write_packet_file(options.packets, result.packets);
    }
    if (!options.pixels.empty()) {
        write_pixel_file(options.pixels, result.words);
    }
    if (!options.stats.empty()) {
        write_json(options.stats, to_json(result.statistics));
    }
    write_png(options.image, options.scene.finish(result.image));
    outputs.print(summary(options, result.statistics));
}

}  // namespace

void add_render(CLI::App& app) {
    CLI::App* command = app.add_subcommand("render", "Draw a mesh to a PNG");
    const auto options = std::make_shared<RenderOptions>(*command);
    add_output(*command, "-o,--output", options->image, "OUT.png", "The picture; - for standard output")->required();
    command
        ->add_option("--method", options->method,
                     "flat, gouraud, quadratic, taylor, taylor-finite, log-quadratic; on the reference all that "
                     "`sheen info` names [quadratic]")
        ->type_name("M")
        ->group("Shading");
    command->add_option("--device", options->device, "hls, ghdl, verilator or reference [hls]")
        ->type_name("D")
        ->group("Shading");
    add_output(*command, "--packets", options->packets, "FILE", "Also keep the packets, 32-bit words");
    add_output(*command, "--pixels", options->pixels, "FILE", "Also keep the pixels, 64-bit words");
    add_output(*command, "--stats", options->stats, "FILE.json", "Also keep the figures");
    command->footer(
        "Examples:\n"
        "  sheen render builtin:torus-knot -o knot.png --size 1024x768 --rotate 30,20,0\n"
        "  sheen render mine.obj -o mine.png --light -.4,.5,.77 --light .8,0,.6 --light-colour 1,.6,.3\n"
        "  sheen render builtin:teapot -o teapot.png --device verilator --stats teapot.json");
    command->callback([options] { render(*options); });
}

}  // namespace sheen::command
