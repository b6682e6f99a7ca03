// SPDX-License-Identifier: MIT
#include "hls_device.hpp"

#include <memory>

#include "sheen/framing.hpp"
#include "sheen/hls/shading_core.hpp"

namespace sheen {
namespace {

/// All that the methods ask for; GHDL and Verilator run the VHDL with the same generics (cmake/devices.cmake).
using device_config = hls::core_config<2, true, true, hls::word_bits, hls::word_bits, 3, true>;
using core_t = hls::shading_core<device_config>;
using beat_t = core_t::decoder::beat_t;

beat_t to_beat(const Beat& beat) {
    beat_t b;
    b.valid = 1;
    b.last = beat.last;
    b.keep = (1 << beat.count) - 1;
    for (int k = 0; k < 2; ++k) b.words[k] = beat.words[static_cast<std::size_t>(k)];
    return b;
}

}  // namespace

RunResult HlsDevice::run(const std::vector<std::uint32_t>& packets) {
    const std::vector<Beat> beats = frame_packets(packets, 2);
    const auto core = std::make_unique<core_t>();
    RunResult result;
    const auto clock = [&](const beat_t& beat) {
        core->clock(beat, 1);
        if (core->stage_state.valid) result.words.push_back(core->stage_state.word.to_uint64());
    };
    for (const Beat& beat : beats) {
        const beat_t offered = to_beat(beat);
        for (bool taken = false; !taken;) {
            taken = core->ready() != 0;
            clock(offered);
        }
    }
    while (core->busy()) clock(beat_t{});
    return result;
}

}  // namespace sheen
