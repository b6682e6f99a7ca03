// SPDX-License-Identifier: MIT
/// \file
/// Top for an HLS tool: one clock of stream_fifo as the span queue (16 places, 2 in reserve). Scalar ports only: the
/// state's words in and out, the registers and the memory stand around it.
#include <cstdint>

#include "sheen/hls/formats.hpp"
#include "sheen/hls/stream_fifo.hpp"

/// Addresses: u4.0 in the low bits; room, stored: s6.0, sign-extended; fetch: the memory is read in this clock.
extern "C" void stream_fifo_step(std::uint8_t write_address, std::uint8_t read_address, std::int8_t room,
                                 std::int8_t stored, bool valid, bool write, bool taken,
                                 std::uint8_t* next_write_address, std::uint8_t* next_read_address,
                                 std::int8_t* next_room, std::int8_t* next_stored, bool* next_valid, bool* ready,
                                 bool* fetch) {
    using unit = sheen::hls::stream_fifo<sheen::hls::span_queue_log2, sheen::hls::span_queue_reserve>;
    const unit::state_t state = {write_address, read_address, room, stored, valid};
    const unit::state_t next = unit::step(state, write, taken);
    *next_write_address = static_cast<std::uint8_t>(next.write_address.to_uint());
    *next_read_address = static_cast<std::uint8_t>(next.read_address.to_uint());
    *next_room = static_cast<std::int8_t>(next.room.to_int());
    *next_stored = static_cast<std::int8_t>(next.stored.to_int());
    *next_valid = next.valid != 0;
    *ready = unit::ready(state) != 0;
    *fetch = unit::fetches(state, taken) != 0;
}
