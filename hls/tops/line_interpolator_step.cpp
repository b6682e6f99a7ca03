// SPDX-License-Identifier: MIT
/// \file
/// Top for an HLS tool: one clock of line_interpolator in the preset `paper`. Scalar ports only: the state's word in
/// and out, the registers stand around it.
#include <cstdint>

#include "sheen/hls/formats.hpp"
#include "sheen/hls/line_interpolator.hpp"

/// phase, sxsb, s: s1.11 quadrants in the low 12 bits; ra: s1.5, sign-extended.
extern "C" void line_interpolator_step(std::int16_t phase, bool init, bool step, std::int16_t sxsb, std::int16_t s,
                                       std::int16_t* next_phase, std::int8_t* ra, bool* ra_valid) {
    using unit = sheen::hls::line_interpolator<sheen::hls::paper_phase_bits, sheen::hls::paper_rom_address_bits>;
    const unit::output_t out = unit::step(phase, {init, step, sxsb, s});
    *next_phase = static_cast<std::int16_t>(out.phase.to_int());
    *ra = static_cast<std::int8_t>(out.ra.to_int());
    *ra_valid = out.ra_valid != 0;
}
