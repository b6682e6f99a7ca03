// SPDX-License-Identifier: MIT
/// \file
/// forward_difference: one channel of the datapath, start edge and span, by additions only.
///
/// A channel is six words {I, D, E, h, dD, dE}. Its value on row j, u pixels along the stepping direction, is
///   V(u, j) = I + u·D + j·E + C(u,2)·h + u·j·dD + C(j,2)·dE   (mod 2^W),
/// exactly, for any six words: integer additions carry no rounding.
///
/// Start edge: step  I += E, E += dE, D += dD;
///             carry I += D, D += h,  E += dD.
/// Span:       step  I += D, D += h.
/// Between the two stands the span queue, which holds {I, D} of the rows that the edge walker is ahead. h (and the D of
/// a linear channel, which is constant) is taken over with a triangle's first span.
///
/// Formats: value_t is the channel's ac_fixed; all six words have its format. Latency: 1 per part.
/// Source: paper `quadratic`, section 5 and figure 6; the carry step is Sheen's (the paper steps X_start by a real
/// number).
#pragma once

#include "sheen/hls/types.hpp"

namespace sheen::hls {

/// \tparam value_t      ac_fixed of the channel, wrapping
/// \tparam second_order the channel has h, dD and dE
template <typename value_t, bool second_order>
struct forward_difference {
    static constexpr int width = value_t::width;

    /// The six words as a packet carries them (three for a linear channel: the rest is not read).
    struct words_t {
        word_t i = 0, d = 0, e = 0, h = 0, dd = 0, de = 0;
    };

    struct edge_state_t {
        value_t i = 0, d = 0, e = 0, h = 0, dd = 0, de = 0;
    };

    /// What the span queue stores per row.
    struct start_t {
        value_t i = 0, d = 0;
    };

    struct span_state_t {
        value_t i = 0, d = 0, h = 0;
    };

    /// \param present with command.load: the packet carries the channel; if not, its value is 0
    static edge_state_t edge_step(const edge_state_t& state, const edge_command_t& command, bit_t present,
                                  const words_t& words) {
        edge_state_t next;
        const value_t zero = 0;
        const value_t i_sum = state.i + select(command.carry, state.d, state.e);
        next.i = select(command.load, select(present, value_of(words.i), zero), select(command.step, i_sum, state.i));
        if constexpr (second_order) {
            const bit_t curved = present & ~command.linear;
            const value_t d_sum = state.d + select(command.carry, state.h, state.dd);
            const value_t e_sum = state.e + select(command.carry, state.dd, state.de);
            next.d =
                select(command.load, select(present, value_of(words.d), zero), select(command.step, d_sum, state.d));
            next.e =
                select(command.load, select(present, value_of(words.e), zero), select(command.step, e_sum, state.e));
            next.h = select(command.load, select(curved, value_of(words.h), zero), state.h);
            next.dd = select(command.load, select(curved, value_of(words.dd), zero), state.dd);
            next.de = select(command.load, select(curved, value_of(words.de), zero), state.de);
        } else {
            next.d = select(command.load, select(present, value_of(words.d), zero), state.d);
            next.e = select(command.load, select(present, value_of(words.e), zero), state.e);
        }
        return next;
    }

    /// What the queue gets when a span is pushed: the row's start, before the row's own step.
    static start_t start(const edge_state_t& edge) { return {edge.i, edge.d}; }

    /// \param head  the queue's entry at its head
    /// \param edge  the edge part, whose constants a triangle's first span takes over
    static span_state_t span_step(const span_state_t& state, const span_command_t& command, const start_t& head,
                                  const edge_state_t& edge) {
        span_state_t next;
        const bit_t takes_over = command.load & command.first;
        const value_t i_sum = state.i + state.d;
        next.i = select(command.load, head.i, select(command.step, i_sum, state.i));
        if constexpr (second_order) {
            const value_t d_sum = state.d + state.h;
            next.d = select(command.load, head.d, select(command.step, d_sum, state.d));
            next.h = select(takes_over, edge.h, state.h);
        } else {
            next.d = select(takes_over, edge.d, state.d);
        }
        return next;
    }

 private:
    static value_t value_of(const word_t& word) {
        value_t value = 0;
        value.set_slc(0, ac_int<width, false>(word));
        return value;
    }
};

}  // namespace sheen::hls
