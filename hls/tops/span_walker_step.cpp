// SPDX-License-Identifier: MIT
/// \file
/// Top for an HLS tool: one clock of span_walker. Scalar ports only: the state's words in and out, the registers stand
/// around it.
#include <cstdint>

#include "sheen/hls/span_walker.hpp"

/// Coordinates and lengths: u12.0 in the low bits. head_*: the span at the head of the queue; command_*, fragment_*:
/// the outputs' next state.
extern "C" void span_walker_step(bool active, bool last, bool message, bool query, bool leftward, std::uint16_t x,
                                 std::uint16_t y, std::uint16_t remaining, std::uint16_t head_x, std::uint16_t head_y,
                                 std::uint16_t head_length, bool head_single, bool head_leftward, bool head_first,
                                 bool head_message, bool head_valid, bool go, bool* next_active, bool* next_last,
                                 bool* next_message, bool* next_query, bool* next_leftward, std::uint16_t* next_x,
                                 std::uint16_t* next_y, std::uint16_t* next_remaining, bool* head_taken,
                                 bool* command_load, bool* command_first, bool* command_step, bool* fragment_valid,
                                 bool* fragment_message, bool* fragment_query, std::uint16_t* fragment_x,
                                 std::uint16_t* fragment_y, std::uint16_t* fragment_tail) {
    using unit = sheen::hls::span_walker;
    const unit::state_t state = {active, last, message, query, leftward, x, y, remaining, {}, {}};
    const sheen::hls::span_t head = {head_x, head_y, head_length, head_single, head_leftward, head_first, head_message};
    const unit::state_t next = unit::step(state, head, head_valid, go);
    const auto coordinate = [](const sheen::hls::coordinate_t& value) {
        return static_cast<std::uint16_t>(value.to_uint());
    };
    *next_active = next.active != 0;
    *next_last = next.last != 0;
    *next_message = next.message != 0;
    *next_query = next.query != 0;
    *next_leftward = next.leftward != 0;
    *next_x = coordinate(next.x);
    *next_y = coordinate(next.y);
    *next_remaining = coordinate(next.remaining);
    *head_taken = unit::taken(state, head_valid, go) != 0;
    *command_load = next.command.load != 0;
    *command_first = next.command.first != 0;
    *command_step = next.command.step != 0;
    *fragment_valid = next.fragment.valid != 0;
    *fragment_message = next.fragment.message != 0;
    *fragment_query = next.fragment.query != 0;
    *fragment_x = coordinate(next.fragment.x);
    *fragment_y = coordinate(next.fragment.y);
    *fragment_tail = coordinate(next.fragment.tail);
}
