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

Capabilities query_capabilities(Device& device) {
    std::vector<std::uint32_t> packets;
    append_query(packets);
    const std::vector<std::uint64_t> reply = device.run(packets).words;
    if (reply.size() != hls::query_reply_words) {
        throw Error(fmt::format("device '{}' answered a query with {} words instead of {}", device.name(), reply.size(),
                                hls::query_reply_words));
    }
    const auto field = [&](std::size_t word, int lsb, int bits) {
        return static_cast<int>(reply[word] >> (32 + lsb) & ((std::uint64_t{1} << bits) - 1));
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
    c.max_extent = field(2, 0, 16);
    if (c.protocol_version != hls::protocol_version) {
        throw Error(fmt::format("device '{}' speaks protocol {}, this library {}", device.name(), c.protocol_version,
                                hls::protocol_version));
    }
    return c;
}

}  // namespace sheen
