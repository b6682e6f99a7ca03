// SPDX-License-Identifier: MIT
/// \file
/// Top for an HLS tool: one clock of bell_rom in the preset `paper` (6×6, cos², no wrap bits, not folded). Scalar ports
/// only: the state's words in and out, the registers stand around it. Without wrap bits no angle is outside.
#include <cstdint>

#include "sheen/hls/bell_rom.hpp"
#include "sheen/hls/formats.hpp"

/// ra: s1.5 quadrants in the low 6 bits; data, value: u0.6 whose 63 stands for 1.
extern "C" void bell_rom_step(std::int8_t ra, bool ra_valid, std::uint8_t address, bool address_valid,
                              std::uint8_t data, bool data_valid, std::uint8_t* next_address, bool* next_address_valid,
                              std::uint8_t* next_data, bool* next_data_valid, std::uint8_t* value, bool* value_valid) {
    using unit =
        sheen::hls::bell_rom<sheen::hls::paper_rom_address_bits, sheen::hls::paper_rom_data_bits, 20, 0, false>;
    const unit::state_t state = {address, 0, address_valid, data, 0, data_valid, 0, 0};
    const unit::state_t next = unit::step(state, {ra, ra_valid});
    *next_address = static_cast<std::uint8_t>(next.address.to_uint());
    *next_address_valid = next.address_valid != 0;
    *next_data = static_cast<std::uint8_t>(next.data.to_uint());
    *next_data_valid = next.data_valid != 0;
    *value = static_cast<std::uint8_t>(next.value.to_uint());
    *value_valid = next.value_valid != 0;
}
