// SPDX-License-Identifier: MIT
/// \file
/// Refused: floating point. The ports are integers, the sum between them is not.
#include <cstdint>

extern "C" void product_step(std::int32_t state, std::int32_t* next) {
    *next = static_cast<std::int32_t>(static_cast<double>(state) * 1.5);
}
