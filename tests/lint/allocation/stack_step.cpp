// SPDX-License-Identifier: MIT
/// \file
/// Refused: allocation, of an array on the stack whose size is data.
#include <cstdint>

extern "C" void stack_step(std::uint32_t size, std::uint32_t at, std::uint32_t* next) {
    auto* words = static_cast<std::uint32_t*>(__builtin_alloca(size));
    words[at] = size;
    words[at / 2] = at;
    *next = words[size - 1];
}
