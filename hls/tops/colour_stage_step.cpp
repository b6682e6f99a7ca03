// SPDX-License-Identifier: MIT
/// \file
/// Top for an HLS tool: one clock of colour_stage with 32-bit channels. Scalar ports only: the state's words in and
/// out, the registers stand around it.
#include <cstdint>

#include "sheen/hls/colour_stage.hpp"

/// Coordinates and tail: u12.0 in the low bits; red, green, blue: s10.22; depth: u16.16; saturated_*: the stage between
/// saturation and packing, u8.0 and u16.0; description_k: the data of a query's reply; word: an output word.
extern "C" void colour_stage_step(bool saturated_valid, bool saturated_message, bool saturated_query,
                                  std::uint16_t saturated_x, std::uint16_t saturated_y, std::uint16_t saturated_tail,
                                  std::uint8_t saturated_red, std::uint8_t saturated_green, std::uint8_t saturated_blue,
                                  std::uint16_t saturated_depth, bool valid, bool message, bool query, std::uint16_t x,
                                  std::uint16_t y, std::uint16_t tail, std::uint32_t red, std::uint32_t green,
                                  std::uint32_t blue, std::uint32_t depth, std::uint32_t description_0,
                                  std::uint32_t description_1, std::uint32_t description_2, std::uint32_t description_3,
                                  bool* next_valid, bool* next_message, bool* next_query, std::uint16_t* next_x,
                                  std::uint16_t* next_y, std::uint16_t* next_tail, std::uint8_t* next_red,
                                  std::uint8_t* next_green, std::uint8_t* next_blue, std::uint16_t* next_depth,
                                  bool* word_valid, bool* word_fence, std::uint64_t* word) {
    using namespace sheen::hls;
    using unit = colour_stage<colour_value_t, depth_value_t>;
    unit::state_t state;
    state.fragment = {saturated_valid, saturated_message, saturated_query, saturated_x, saturated_y, saturated_tail};
    state.red = saturated_red;
    state.green = saturated_green;
    state.blue = saturated_blue;
    state.depth = saturated_depth;
    unit::values_t values;
    values.red.set_slc(0, word_t(red));
    values.green.set_slc(0, word_t(green));
    values.blue.set_slc(0, word_t(blue));
    values.depth.set_slc(0, word_t(depth));
    const unit::state_t next = unit::step(state, {valid, message, query, x, y, tail}, values,
                                          {{description_0, description_1, description_2, description_3}});
    *next_valid = next.fragment.valid != 0;
    *next_message = next.fragment.message != 0;
    *next_query = next.fragment.query != 0;
    *next_x = static_cast<std::uint16_t>(next.fragment.x.to_uint());
    *next_y = static_cast<std::uint16_t>(next.fragment.y.to_uint());
    *next_tail = static_cast<std::uint16_t>(next.fragment.tail.to_uint());
    *next_red = static_cast<std::uint8_t>(next.red.to_uint());
    *next_green = static_cast<std::uint8_t>(next.green.to_uint());
    *next_blue = static_cast<std::uint8_t>(next.blue.to_uint());
    *next_depth = static_cast<std::uint16_t>(next.depth.to_uint());
    *word_valid = next.valid != 0;
    *word_fence = next.fence != 0;
    *word = next.word.to_uint64();
}
