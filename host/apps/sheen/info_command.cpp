// SPDX-License-Identifier: MIT
/// \file
/// sheen info: version, what there is to draw with, formats, and what a device says of itself.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "commands.hpp"
#include "output.hpp"
#include "sheen/compare.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/mesh.hpp"

namespace sheen::command {
namespace {

std::string general() {
    std::vector<std::string> methods;
    for (const Method method : all_methods()) {
        methods.push_back(to_string(method));
    }
    return fmt::format(
        "sheen {}, packet protocol {}\n"
        "methods   {}\n"
        "devices   {}\n"
        "meshes    {}\n",
        SHEEN_VERSION, hls::protocol_version, fmt::join(methods, ", "), fmt::join(drawing_names(), ", "),
        fmt::join(builtin_mesh_names(), ", "));
}

std::string formats() {
    return fmt::format(
        "formats   colour <{0},{1}>, log-specular <{0},{2}>, depth unsigned <{0},{3}> (width, integer bits)\n"
        "          vertices 1/{4} pixel, coordinates {5} bits, edge phases {6} bits\n"
        "          packet word {0} bits, pixel word {7} bits: x {5}, y {5}, depth {8}, red {9}, green {9}, blue {9}\n",
        hls::word_bits, hls::colour_integer_bits, hls::log_integer_bits, hls::depth_integer_bits,
        1 << hls::subpixel_bits, hls::coordinate_bits, hls::phase_bits, hls::pixel_bits, hls::depth_bits,
        hls::component_bits);
}

/// What the core has for highlights.
std::string highlights(const Capabilities& c) {
    if (c.log_channels == 0) return "no log channels";
    const std::string power =
        c.power_address_bits == 0 ? "no power table" : fmt::format("power table {}x8", 1 << c.power_address_bits);
    return fmt::format("{} log channels of {} bits, {} of them fraction; exp2 table {}x{}; {}", c.log_channels,
                       c.log_bits, c.log_fraction_bits, 1 << c.exp2_address_bits, c.exp2_data_bits, power);
}

std::string capabilities(const std::string& name) {
    if (name == reference_name) {
        return "reference: double precision on the host; takes setups, not packets; draws every method\n";
    }
    const Capabilities c = query_capabilities(*make_device(name));
    return fmt::format(
        "{}: protocol {}; colour {} bits, {} of them fraction, {}; depth {} bits; phase {} bits; triangles up to {} "
        "pixels wide and high; {}\n",
        name, c.protocol_version, c.colour_bits, c.colour_fraction_bits, c.quadratic ? "quadratic" : "linear only",
        c.depth ? c.depth_bits : 0, c.phase_bits, c.max_extent, highlights(c));
}

void info(const std::string& device) {
    require_drawing_name(device);
    const Outputs outputs({});
    outputs.print(general() + formats() + capabilities(device));
}

}  // namespace

void add_info(CLI::App& app) {
    CLI::App* command = app.add_subcommand("info", "Version, formats, and what a device says of itself");
    const auto device = std::make_shared<std::string>("hls");
    command->add_option("--device", *device, "hls, ghdl, verilator or reference [hls]")->type_name("D");
    command->callback([device] { info(*device); });
}

}  // namespace sheen::command
