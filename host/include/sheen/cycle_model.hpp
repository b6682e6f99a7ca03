// SPDX-License-Identifier: MIT
/// \file
/// How many clocks the core takes, without simulating it: docs/cycle-model.md.
#pragma once

#include <cstdint>
#include <vector>

#include "sheen/simulator_device.hpp"

namespace sheen {

/// What a packet gives each stage to do, in clocks of a stage that never waits.
struct StageWork {
    std::uint64_t beats = 0;   ///< setup stream
    std::uint64_t walk = 0;    ///< edge walker: two clocks to begin, one a row, one a carry; one for a message
    std::uint64_t pixels = 0;  ///< span walker: pixels and message words
};

/// Sums over a packet stream that bound its clocks from both sides: no stage is faster than its own work, and where a
/// packet is in one stage while its neighbours are in others, each costs about its greatest stage.
struct CycleBounds {
    StageWork total;
    std::uint64_t serial = 0;  ///< the greatest stage of each packet, summed
    [[nodiscard]] std::uint64_t lower() const;
};

/// \param packets        triangle, fence and query packets
/// \param words_per_beat 1, 2 or 4
/// \throws Error for a packet that the core would refuse.
CycleBounds cycle_bounds(const std::vector<std::uint32_t>& packets, int words_per_beat);

/// Clocks from the first beat offered to the last word taken, as RunResult::cycles counts them: a recurrence over
/// beats, rows and words that knows every queue of the core. Equal to the simulation where nothing stalls; with stalls,
/// a random pattern of its own with the same chances. \throws Error for a packet that the core would refuse.
std::uint64_t predict_cycles(const std::vector<std::uint32_t>& packets, int words_per_beat, const Stalls& stalls = {});

}  // namespace sheen
