// SPDX-License-Identifier: MIT
/// \file
/// Accepted: the loop that is refused in a step, in a stream top.
#include <cstdint>

extern "C" void loop_core(const std::uint32_t* words, std::uint32_t count, std::uint32_t* sum) {
    std::uint32_t state = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        state = (state << 1U) ^ (state >> 3U) ^ words[i];
    }
    *sum = state;
}
