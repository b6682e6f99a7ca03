// SPDX-License-Identifier: MIT
/// \file
/// Accepted: an accumulator of ac_fixed with a wide sum and a loop of fixed turns, which is unrolled.
#include <cstdint>

#include "sheen/hls/select.hpp"

extern "C" void accumulator_step(std::int32_t state, std::int32_t increment, bool load, std::int32_t* next) {
    ac_int<80, true> sum = state;
    for (int channel = 0; channel < 3; ++channel) {
        sum = sheen::hls::select(load, ac_int<80, true>(increment), ac_int<80, true>(sum + increment));
    }
    *next = sum.slc<32>(0).to_int();
}
