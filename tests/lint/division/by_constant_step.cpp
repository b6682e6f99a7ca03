// SPDX-License-Identifier: MIT
/// \file
/// Refused: a remainder by a constant that is no power of two.
#include <cstdint>

extern "C" void by_constant_step(std::int32_t state, std::int32_t* next) { *next = (state / 8) + (state % 10); }
