// SPDX-License-Identifier: MIT
/// \file
/// Refused: recursion of a function into itself, which the optimiser can turn into a loop only in part.
#include <cstdint>

extern "C" std::uint32_t self_core(std::uint32_t value) {
    return value < 2 ? value : self_core(value - 1) + self_core(value - 2);
}
