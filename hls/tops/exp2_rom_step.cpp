// SPDX-License-Identifier: MIT
/// \file
/// Top for an HLS tool: one clock of exp2_rom with its default table. Scalar ports only: the state's words in and out,
/// the registers stand around it.
#include <cstdint>

#include "sheen/hls/exp2_rom.hpp"
#include "sheen/hls/formats.hpp"

/// z: s8.6 in the low 14 bits; near, value: u8.4.
extern "C" void exp2_rom_step(std::int16_t z, std::uint8_t address, std::uint8_t address_shift, bool address_none,
                              std::uint8_t data, std::uint8_t data_shift, bool data_none, std::uint16_t near,
                              std::uint8_t near_shift, bool near_none, std::uint8_t* next_address,
                              std::uint8_t* next_address_shift, bool* next_address_none, std::uint8_t* next_data,
                              std::uint8_t* next_data_shift, bool* next_data_none, std::uint16_t* next_near,
                              std::uint8_t* next_near_shift, bool* next_near_none, std::uint16_t* value) {
    using unit = sheen::hls::exp2_rom<sheen::hls::exp2_address_bits, sheen::hls::exp2_data_bits,
                                      sheen::hls::colour_sum_fraction_bits>;
    unit::state_t state;
    state.address = address;
    state.address_shift = address_shift;
    state.address_none = address_none;
    state.data = data;
    state.data_shift = data_shift;
    state.data_none = data_none;
    state.near = near;
    state.near_shift = near_shift;
    state.near_none = near_none;
    const unit::state_t next = unit::step(state, z);
    *next_address = static_cast<std::uint8_t>(next.address.to_uint());
    *next_address_shift = static_cast<std::uint8_t>(next.address_shift.to_uint());
    *next_address_none = next.address_none != 0;
    *next_data = static_cast<std::uint8_t>(next.data.to_uint());
    *next_data_shift = static_cast<std::uint8_t>(next.data_shift.to_uint());
    *next_data_none = next.data_none != 0;
    *next_near = static_cast<std::uint16_t>(next.near.to_uint());
    *next_near_shift = static_cast<std::uint8_t>(next.near_shift.to_uint());
    *next_near_none = next.near_none != 0;
    *value = static_cast<std::uint16_t>(next.value.to_uint());
}
