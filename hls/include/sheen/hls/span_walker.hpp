// SPDX-License-Identifier: MIT
/// \file
/// span_walker: one pixel position a clock.
///
/// Takes spans from the head of the span queue and steps through them; the next span starts in the clock after the last
/// pixel of the one before. Messages pass in their place, a query as four words whose x counts. The only back-pressure
/// is `go`, a registered bit: it stops this unit, and what has left it flows on into the pixel queue.
///
/// Format: coordinates u12.0. Latency: 1 (from the head of the queue to the position register), and one more to the
/// fragment. Source: paper `quadratic`, section 5 (the inner loop).
#pragma once

#include "sheen/hls/types.hpp"

namespace sheen::hls {

struct span_walker {
    struct state_t {
        bit_t active = 0;
        bit_t last = 0;  ///< the position is the span's last
        bit_t message = 0;
        bit_t query = 0;
        bit_t leftward = 0;
        coordinate_t x = 0, y = 0;
        coordinate_t remaining = 0;  ///< words left, this one included; a message's tail
        // Outputs.
        span_command_t command;
        fragment_t fragment;
    };

    /// True when the span at the head of the queue is taken in this clock.
    static bit_t taken(const state_t& state, bit_t head_valid, bit_t go) {
        return go & head_valid & (~state.active | state.last);
    }

    static state_t step(const state_t& state, const span_t& head, bit_t head_valid, bit_t go) {
        state_t next = state;
        const bit_t load = taken(state, head_valid, go);
        const bit_t steps = go & state.active & ~state.last;
        const coordinate_t one_along = select(state.leftward, coordinate_t(-1), coordinate_t(1));
        next.active = select(go, bit_t(load | steps), state.active);
        next.last = select(load, head.single, select(steps, bit_t(state.remaining == 2), state.last));
        next.x = select(load, head.x, select(steps, coordinate_t(state.x + one_along), state.x));
        next.y = select(load, head.y, state.y);
        next.remaining = select(load, head.length, select(steps, coordinate_t(state.remaining - 1), state.remaining));
        next.leftward = select(load, head.leftward, state.leftward);
        next.message = select(load, head.message, state.message);
        next.query = select(load, bit_t(head.message & ~head.single), state.query);

        next.command.load = load;
        next.command.first = head.first;
        next.command.step = steps;
        next.fragment.valid = go & state.active;
        next.fragment.message = state.message;
        next.fragment.query = state.query;
        next.fragment.x = state.x;
        next.fragment.y = state.y;
        next.fragment.tail = state.remaining;
        return next;
    }
};

}  // namespace sheen::hls
