// SPDX-License-Identifier: MIT
/// \file
/// Refused: division, hidden in an ac_int operator.
#include <ac_int.h>

#include <cstdint>

extern "C" void ac_int_step(std::uint16_t state, std::uint16_t divisor, std::uint16_t* next) {
    const ac_int<12, false> remainder = ac_int<12, false>(state) % ac_int<12, false>(divisor | 1);
    *next = static_cast<std::uint16_t>(remainder.to_uint());
}
