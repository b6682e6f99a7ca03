// SPDX-License-Identifier: MIT
/// \file
/// Tops for an HLS tool: one clock of forward_difference, a second-order colour channel of 32 bits, start edge and
/// span. Scalar ports only: the state's words in and out; the registers and the channel's share of the span queue stand
/// around them.
#include <cstdint>

#include "sheen/hls/forward_difference.hpp"

namespace {

using sheen::hls::word_t;
using value_t = sheen::hls::colour_value_t;
using unit = sheen::hls::forward_difference<value_t, true>;

value_t value(std::uint32_t word) {
    value_t result = 0;
    result.set_slc(0, word_t(word));
    return result;
}

std::uint32_t bits(const value_t& channel_value) { return channel_value.slc<sheen::hls::word_bits>(0).to_uint(); }

}  // namespace

/// i, d, e, h, dd, de: s10.22; word_*: the same six as the packet has them.
extern "C" void forward_difference_edge_step(std::uint32_t i, std::uint32_t d, std::uint32_t e, std::uint32_t h,
                                             std::uint32_t dd, std::uint32_t de, bool load, bool linear, bool step,
                                             bool carry, bool present, std::uint32_t word_i, std::uint32_t word_d,
                                             std::uint32_t word_e, std::uint32_t word_h, std::uint32_t word_dd,
                                             std::uint32_t word_de, std::uint32_t* next_i, std::uint32_t* next_d,
                                             std::uint32_t* next_e, std::uint32_t* next_h, std::uint32_t* next_dd,
                                             std::uint32_t* next_de) {
    const unit::edge_state_t state = {value(i), value(d), value(e), value(h), value(dd), value(de)};
    const unit::edge_state_t next = unit::edge_step(state, {load, linear, present, step, carry}, present,
                                                    {word_i, word_d, word_e, word_h, word_dd, word_de});
    *next_i = bits(next.i);
    *next_d = bits(next.d);
    *next_e = bits(next.e);
    *next_h = bits(next.h);
    *next_dd = bits(next.dd);
    *next_de = bits(next.de);
}

/// i, d, h: s10.22; head_*: the span queue's entry; edge_h: the edge part's h.
extern "C" void forward_difference_span_step(std::uint32_t i, std::uint32_t d, std::uint32_t h, bool load, bool first,
                                             bool step, std::uint32_t head_i, std::uint32_t head_d,
                                             std::uint32_t edge_h, std::uint32_t* next_i, std::uint32_t* next_d,
                                             std::uint32_t* next_h) {
    unit::edge_state_t edge;
    edge.h = value(edge_h);
    const unit::span_state_t next =
        unit::span_step({value(i), value(d), value(h)}, {load, first, step}, {value(head_i), value(head_d)}, edge);
    *next_i = bits(next.i);
    *next_d = bits(next.d);
    *next_h = bits(next.h);
}
