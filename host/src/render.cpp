// SPDX-License-Identifier: MIT
/// \file
/// The stream's frame around a picture (contract 3): fence, echo, error words, and what they add up to.
#include "sheen/render.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/packet.hpp"

namespace sheen {
namespace {

/// The y field of a message says what kind it is.
int message_kind(std::uint64_t word) {
    constexpr std::uint64_t mask = (std::uint64_t{1} << hls::coordinate_bits) - 1;
    return static_cast<int>((word >> hls::pixel_y_lsb) & mask);
}

/// The header that a fence echo or an error word carries in its upper half.
std::uint32_t message_header(std::uint64_t word) { return static_cast<std::uint32_t>(word >> hls::word_bits); }

bool is_fence_echo(std::uint64_t word) { return is_message(word) && message_kind(word) == hls::message_fence; }

}  // namespace

std::optional<double> Statistics::pixels_per_clock() const {
    if (!cycles || *cycles == 0) {
        return std::nullopt;
    }
    return static_cast<double>(pixels) / static_cast<double>(*cycles);
}

bool is_error_word(std::uint64_t word) { return is_message(word) && message_kind(word) == hls::message_error; }

Statistics statistics_of(const std::vector<std::uint32_t>& packets, const RunResult& result) {
    const auto is_triangle = [](std::uint32_t header) { return decode_header(header).opcode == hls::opcode_triangle; };

    Statistics statistics;
    statistics.packet_words = packets.size();
    statistics.cycles = result.cycles;
    for (std::size_t at = 0; at < packets.size();
         at += 1 + static_cast<std::size_t>(decode_header(packets[at]).length)) {
        statistics.triangles += is_triangle(packets[at]) ? 1 : 0;
    }
    for (const std::uint64_t word : result.words) {
        if (!is_message(word)) {
            ++statistics.pixels;
        } else if (is_error_word(word) && is_triangle(message_header(word)) && statistics.triangles > 0) {
            --statistics.triangles;
        }
    }
    return statistics;
}

std::vector<std::uint32_t> picture_packets(const std::vector<TriangleSetup>& setups) {
    std::vector<std::uint32_t> words;
    std::optional<MaterialSetup> material;
    std::shared_ptr<const PowerEntries> table;
    for (const TriangleSetup& setup : setups) {
        if (!setup.log.empty()) {
            if (setup.table != nullptr && setup.table != table) {
                if (table == nullptr || *setup.table != *table) append_table(words, *setup.table);
                table = setup.table;
            }
            if (!material || !(setup.material == *material)) append_material(words, setup.material);
            material = setup.material;
        }
        append_triangle(words, setup);
    }
    append_fence(words);
    return words;
}

std::optional<std::string> why_incapable(const Capabilities& core, const std::vector<TriangleSetup>& setups) {
    const auto lacks = [](const std::string& what) { return fmt::format("the core {}", what); };
    for (const TriangleSetup& setup : setups) {
        const auto log_channels = static_cast<int>(setup.log.size());
        if (log_channels > core.log_channels) {
            return lacks(fmt::format("has {} log channels, and a triangle needs {}", core.log_channels, log_channels));
        }
        if (log_channels > 0 && setup.material.power_channels != 0 && core.power_address_bits == 0) {
            return lacks("has no power table, and a triangle needs one");
        }
        if (setup.table != nullptr && setup.table->size() != std::size_t{1} << core.power_address_bits) {
            return lacks(fmt::format("has power tables of {} entries, and a triangle needs {}",
                                     1 << core.power_address_bits, setup.table->size()));
        }
        if (!setup.linear && !core.quadratic) return lacks("has linear colour only, and a triangle needs quadratic");
        if (setup.depth && !core.depth) return lacks("has no depth channel, and a triangle needs one");
    }
    return std::nullopt;
}

Drawing draw(Device& device, const std::vector<std::uint32_t>& packets, int width, int height) {
    if (packets.empty() || decode_header(packets.back()).opcode != hls::opcode_fence) {
        throw Error("a picture's packets must end with a fence");
    }
    Drawing drawing{device.run(packets), Framebuffer(width, height)};
    const std::vector<std::uint64_t>& words = drawing.result.words;

    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!is_message(words[i])) {
            drawing.framebuffer.write(decode_pixel(words[i]));
        } else if (!is_fence_echo(words[i]) || i + 1 != words.size()) {
            throw Error(fmt::format("{}: word {} is '{}'; expected pixels, then the fence's echo", device.name(), i,
                                    describe_message(words[i])));
        }
    }
    if (words.empty() || !is_fence_echo(words.back())) {
        throw Error(fmt::format("{}: {} words came back without the fence's echo: the picture is incomplete",
                                device.name(), words.size()));
    }
    if (message_header(words.back()) != packets.back()) {
        throw Error(fmt::format("{}: the fence's echo carries header {:#010x}; expected {:#010x}", device.name(),
                                message_header(words.back()), packets.back()));
    }
    return drawing;
}

}  // namespace sheen
