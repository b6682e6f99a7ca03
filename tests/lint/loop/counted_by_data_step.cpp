// SPDX-License-Identifier: MIT
/// \file
/// Refused: a loop in a step, whose number of turns is data; it takes as many clocks.
#include <cstdint>

extern "C" void counted_by_data_step(std::uint32_t state, std::uint32_t turns, std::uint32_t* next) {
    for (std::uint32_t i = 0; i < turns; ++i) {
        state = (state << 1U) ^ (state >> 3U) ^ i;
    }
    *next = state;
}
