// SPDX-License-Identifier: MIT
#include "sheen/device.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "hls_device.hpp"
#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/packet.hpp"
#include "sheen/simulator_device.hpp"

namespace sheen {

std::vector<std::string> device_names() { return {"hls", "ghdl", "verilator"}; }

std::unique_ptr<Device> make_device(const std::string& name) {
    constexpr int default_words_per_beat = 2;
    if (name == "hls") return std::make_unique<HlsDevice>();
    if (name == "ghdl" || name == "verilator") return std::make_unique<SimulatorDevice>(name, default_words_per_beat);
    throw UsageError(fmt::format("unknown device '{}': give one of {}", name, fmt::join(device_names(), ", ")));
}

Capabilities core_capabilities(const std::vector<std::uint64_t>& reply) {
    if (reply.size() != hls::query_reply_words) {
        throw Error(fmt::format("{} words answer a query, expected {}: not a core's reply", reply.size(),
                                hls::query_reply_words));
    }
    for (std::size_t k = 0; k < reply.size(); ++k) {
        const std::uint64_t expected = static_cast<std::uint64_t>(k) << hls::pixel_depth_lsb |
                                       std::uint64_t{hls::message_query} << hls::pixel_y_lsb | hls::message_x;
        if ((reply[k] & 0xffffffffU) != expected) {
            throw Error(fmt::format("word {} of a query's answer is '{}': expected a core's reply", k,
                                    describe_message(reply[k])));
        }
    }
    const auto field = [&](std::size_t word, int lsb, int bits) {
        return static_cast<int>(reply[word] >> (hls::word_bits + lsb) & ((std::uint64_t{1} << bits) - 1));
    };
    Capabilities c;
    c.protocol_version = field(0, 0, 8);
    c.log_channels = field(0, 8, 2);
    c.depth = field(0, 10, 1) != 0;
    c.quadratic = field(0, 11, 1) != 0;
    c.colour_bits = field(1, 0, 8);
    c.colour_fraction_bits = field(1, 8, 8);
    c.depth_bits = field(1, 16, 8);
    c.phase_bits = field(1, 24, 8);
    c.max_extent = field(2, 0, 12);
    c.exp2_address_bits = field(2, 12, 4);
    c.log_bits = field(2, 16, 8);
    c.log_fraction_bits = field(2, 24, 8);
    c.core_version = field(3, 0, 24);
    c.exp2_data_bits = field(3, 24, 4);
    if (field(0, 12, 1) != 0) c.power_address_bits = field(3, 28, 4);
    if (c.protocol_version != hls::protocol_version) {
        throw Error(
            fmt::format("the core speaks protocol {}, this library {}", c.protocol_version, hls::protocol_version));
    }
    return c;
}

Capabilities query_capabilities(Device& device) {
    std::vector<std::uint32_t> packets;
    append_query(packets);
    try {
        return core_capabilities(device.run(packets).words);
    } catch (const Error& error) {
        throw Error(fmt::format("device '{}': {}", device.name(), error.what()));
    }
}

}  // namespace sheen
