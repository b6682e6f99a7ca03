// SPDX-License-Identifier: MIT
/// \file
/// Top for an HLS tool: one clock of power_rom with 1 KB banks. Scalar ports only: the state's words in and out; the
/// registers and the memory stand around it.
#include <cstdint>

#include "sheen/hls/formats.hpp"
#include "sheen/hls/power_rom.hpp"

/// t: s8.6 in the low 14 bits; read: the memory's word at `address`; value: u8.4.
extern "C" void power_rom_step(std::int16_t t, bool bank, std::uint32_t read, std::uint8_t address_lane,
                               std::uint32_t memory, std::uint8_t memory_lane, std::uint32_t fetched,
                               std::uint8_t fetched_lane, std::uint16_t* next_address, std::uint8_t* next_address_lane,
                               std::uint32_t* next_memory, std::uint8_t* next_memory_lane, std::uint32_t* next_fetched,
                               std::uint8_t* next_fetched_lane, std::uint16_t* value) {
    using unit = sheen::hls::power_rom<sheen::hls::power_address_bits, sheen::hls::colour_sum_fraction_bits>;
    unit::state_t state;
    state.address_lane = address_lane;
    state.memory = memory;
    state.memory_lane = memory_lane;
    state.fetched = fetched;
    state.fetched_lane = fetched_lane;
    const unit::state_t next = unit::step(state, t, bank, read);
    *next_address = static_cast<std::uint16_t>(next.address.to_uint());
    *next_address_lane = static_cast<std::uint8_t>(next.address_lane.to_uint());
    *next_memory = next.memory.to_uint();
    *next_memory_lane = static_cast<std::uint8_t>(next.memory_lane.to_uint());
    *next_fetched = next.fetched.to_uint();
    *next_fetched_lane = static_cast<std::uint8_t>(next.fetched_lane.to_uint());
    *value = static_cast<std::uint16_t>(next.value.to_uint());
}
