// SPDX-License-Identifier: MIT
/// \file
/// One interface over kernels, simulators and boards: packet words in, pixel words out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sheen {

/// What a device says of itself, decoded from its reply to a query.
struct Capabilities {
    int protocol_version = 0;
    int log_channels = 0;
    bool depth = false;
    bool quadratic = false;  ///< false: linear colour only
    int colour_bits = 0;     ///< W of the colour channels; 10 of them integer
    int colour_fraction_bits = 0;
    int depth_bits = 0;  ///< W of the depth channel; 16 of them integer; 0 without depth
    int phase_bits = 0;
    int max_extent = 0;  ///< greatest width and height of a triangle, in pixels
    // The highlight stage; all 0 where there are no log channels.
    int log_bits = 0;            ///< W of the log channels
    int log_fraction_bits = 0;   ///< of them
    int exp2_address_bits = 0;   ///< the table of 2^(8 − z): an octave of 2^exp2_address_bits entries …
    int exp2_data_bits = 0;      ///< … of as many bits
    int power_address_bits = 0;  ///< a power table has 2^power_address_bits entries of 8 bits; 0: the core has none
    // Of the core itself.
    int core_version = 0;  ///< major · 2^16 + minor · 2^8 + patch
};

struct RunResult {
    std::vector<std::uint64_t> words;  ///< pixels and messages, in the device's order
    std::optional<std::uint64_t>
        cycles;  ///< clock cycles from the first input beat to the last output beat; simulators only
};

class Device {
 public:
    virtual ~Device() = default;
    [[nodiscard]] virtual std::string name() const = 0;
    /// Streams `packets` in and collects every word that comes back. Any words are valid input: malformed packets are
    /// answered by error words. \throws Error when the device itself fails.
    virtual RunResult run(const std::vector<std::uint32_t>& packets) = 0;
};

/// Names that make_device takes: hls, ghdl, verilator. (`reference` takes setups, not packets: see reference.hpp.)
std::vector<std::string> device_names();
/// \throws UsageError for an unknown name; Error when the device is not built (and how to build it).
std::unique_ptr<Device> make_device(const std::string& name);
/// Decodes the words of a core's reply to a query. \throws Error unless they are such a reply in this protocol's
/// version.
Capabilities core_capabilities(const std::vector<std::uint64_t>& reply);
/// Sends a query and decodes the reply. \throws Error naming the device.
Capabilities query_capabilities(Device& device);

}  // namespace sheen
