// SPDX-License-Identifier: MIT
/// \file
/// sheen run: replays a packet file on a device.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "output.hpp"
#include "sheen/compare.hpp"
#include "sheen/error.hpp"
#include "sheen/packet.hpp"
#include "sheen/render.hpp"

namespace sheen::command {
namespace {

struct RunOptions {
    std::string packets;
    std::string device;
    std::string pixels;
    std::string stats;
};

/// Prints each error word. Returns how many there are.
std::size_t report_errors(const std::string& device, const std::vector<std::uint64_t>& words) {
    std::size_t errors = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (is_error_word(words[i])) {
            ++errors;
            std::fputs(fmt::format("{}: word {}: {}\n", device, i, describe_message(words[i])).c_str(), stderr);
        }
    }
    return errors;
}

void run(const RunOptions& options) {
    if (options.device == reference_name) {
        throw UsageError(fmt::format("--device {}: it takes setups, not packets; give one of {}", reference_name,
                                     fmt::join(device_names(), ", ")));
    }
    require_drawing_name(options.device);
    const Outputs outputs({{"--pixels", options.pixels}, {"--stats", options.stats}});
    const std::vector<std::uint32_t> packets = read_packet_file(options.packets);

    RunResult result;
    {
        const ProgressBar progress;
        progress.show(0, 1, fmt::format("{} packet words on {}", packets.size(), options.device));
        result = make_device(options.device)->run(packets);
    }
    write_pixel_file(options.pixels, result.words);
    const Statistics statistics = statistics_of(packets, result);
    if (!options.stats.empty()) {
        write_json(options.stats, to_json(statistics));
    }
    if (const std::size_t errors = report_errors(options.device, result.words); errors > 0) {
        throw Error(fmt::format("{}: {} of its packets were refused; {} is complete and holds the error words",
                                options.packets, errors, options.pixels));
    }
    outputs.print(fmt::format("{}: {} triangles, {} pixels on {}\n", options.pixels, statistics.triangles,
                              statistics.pixels, options.device));
}

}  // namespace

void add_run(CLI::App& app) {
    CLI::App* command = app.add_subcommand("run", "Replay a packet file on a device");
    const auto options = std::make_shared<RunOptions>();
    command
        ->add_option("PACKETS", options->packets, "Little-endian 32-bit words, as `sheen render --packets` writes them")
        ->required()
        ->type_name("");
    command->add_option("--device", options->device, "hls, ghdl or verilator")->required()->type_name("D");
    add_output(*command, "--pixels", options->pixels, "FILE",
               "The words that come back, 64 bits; - for standard output")
        ->required();
    add_output(*command, "--stats", options->stats, "FILE.json", "Also keep the figures");
    command->footer(
        "Refused packets are answered by error words: the pixel file is completed, each is printed, and the exit "
        "status is 1.\n"
        "\n"
        "Example:\n"
        "  sheen run knot.packets --device ghdl --pixels knot.pixels --stats knot.json");
    command->callback([options] { run(*options); });
}

}  // namespace sheen::command
