// SPDX-License-Identifier: MIT
/// \file
/// Refused: recursion, over two functions; neither call is the last thing done, so no loop can replace it.
#include <cstdint>

namespace {

std::uint32_t odd_levels(std::uint32_t depth, std::uint32_t seed);

__attribute__((noinline)) std::uint32_t even_levels(std::uint32_t depth, std::uint32_t seed) {
    return depth == 0 ? seed : odd_levels(depth - 1, seed ^ depth) ^ (seed << 1U);
}

__attribute__((noinline)) std::uint32_t odd_levels(std::uint32_t depth, std::uint32_t seed) {
    return depth == 0 ? ~seed : even_levels(depth - 1, seed + depth) ^ (seed >> 1U);
}

}  // namespace

extern "C" void mutual_core(std::uint32_t depth, std::uint32_t* value) { *value = even_levels(depth, 1); }
