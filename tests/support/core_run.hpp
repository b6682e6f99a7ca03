// SPDX-License-Identifier: MIT
/// \file
/// The kernel shading_core, run over packets.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel_records.hpp"
#include "sheen/hls/shading_core.hpp"

namespace sheen::test {

/// The core's words for these packets. Of 100 clocks, stall_percent offer no beat, and as many take no pixel.
/// \throws std::runtime_error when that takes more than max_clocks
template <typename config>
std::vector<std::uint64_t> run_core(const std::vector<StreamPacket>& packets, Rng& rng, unsigned stall_percent,
                                    std::int64_t max_clocks) {
    using core_t = hls::shading_core<config>;
    using decoder = typename core_t::decoder;
    const auto core = std::make_unique<core_t>();
    std::vector<std::uint64_t> words;
    std::int64_t clocks = 0;
    const auto stalls = [&] { return stall_percent != 0 && rng() % 100 < stall_percent; };
    const auto clock = [&](const typename decoder::beat_t& beat) {
        if (++clocks > max_clocks) {
            throw std::runtime_error("shading_core: " + std::to_string(words.size()) + " words and still busy after " +
                                     std::to_string(max_clocks) + " clocks");
        }
        core->clock(beat, !stalls());
        if (core->stage_state.valid) words.push_back(core->stage_state.word.to_uint64());
    };
    for (const StreamPacket& packet : packets) {
        for (const StreamBeat& beat : packet) {
            while (stalls()) clock(no_beat<decoder>(rng));
            const auto offered = beat_of<decoder>(beat);
            for (bool taken = false; !taken;) {
                taken = core->ready() != 0;
                clock(offered);
            }
        }
    }
    while (core->busy()) clock(typename decoder::beat_t{});
    return words;
}

}  // namespace sheen::test
