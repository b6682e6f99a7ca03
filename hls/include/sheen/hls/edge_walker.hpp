// SPDX-License-Identifier: MIT
/// \file
/// edge_walker: the geometry of a triangle, row by row.
///
/// Walks the long edge in whole pixels. Each row gives one span {x, y, length, direction} and one command to the
/// channels: a step (one row down, κ pixels along), then, when the long edge's phase accumulator carries, a carry (one
/// pixel more). A row takes 1 + carry clocks. Phases run a row ahead, so that a carry is a registered bit when it is
/// needed; that costs one clock (state `prime`) per triangle, and one at the middle vertex unless a carry step fills
/// it.
///
/// Rows: u = s·x advances by κ + carry; L += m + carry_end − carry_long; at the middle vertex L, m and the end edge's
/// phase are reloaded. All fields are modulo 2^12; a row of length 0 gives no span.
///
/// Format: coordinates u12.0, phases u0.32. Latency: 1. Source: docs/architecture.md, "Coverage"; in place of paper
/// `quadratic`, section 5 (X_start += A_start in real steps), which samples off the pixel centres.
#pragma once

#include "sheen/hls/types.hpp"

namespace sheen::hls {

struct edge_walker {
    enum walk_state { idle, prime, row, carry };
    using walk_state_t = ac_int<2, false>;

    struct state_t {
        walk_state_t walk = idle;
        bit_t below = 0;          ///< past the middle vertex
        bit_t none_below = 0;     ///< the triangle ends at the middle vertex
        bit_t last_row = 0;       ///< of this part
        bit_t long_fresh = 0;     ///< the long phase was loaded and has given no carry yet
        bit_t end_fresh = 0;      ///< the same of the end edge's phase
        bit_t first = 0;          ///< the next span is the triangle's first
        bit_t first_pending = 0;  ///< the triangle's first span waits in the queue
        bit_t leftward = 0;
        bit_t long_carry = 0, end_carry = 0;
        coordinate_t x = 0, y = 0, x_step = 0, rows = 0, length = 0, m = 0, m_less_one = 0;
        coordinate_t rows_below = 0, length_reload = 0, m_below = 0;
        phase_t long_phase = 0, long_step = 0, end_phase = 0, end_step = 0, lower_phase = 0, lower_step = 0;
        // Outputs.
        edge_command_t command;
        bit_t push = 0;
        span_t span;
    };

    /// True when the job offered in this clock is taken. \param room the span queue takes a span
    static bit_t taken(const state_t& state, const job_t& job, bit_t room) {
        const bit_t begins = job.valid & ~job.message & ~state.first_pending;
        const bit_t answers = job.valid & job.message & room;
        // With `first` still set, the last row's span may be the triangle's only one, and its constants are still
        // needed.
        const bit_t row_frees =
            bit_t(state.walk == row) & room & state.last_row & (state.below | state.none_below) & ~state.first;
        return (bit_t(state.walk == idle) & (begins | answers)) | (row_frees & begins);
    }

    /// \param first_taken the span walker starts a triangle's first span in this clock
    static state_t step(const state_t& state, const job_t& job, const geometry_t& geometry, bit_t room,
                        bit_t first_taken) {
        state_t next = state;
        const bit_t take = taken(state, job, room);
        const bit_t load = take & ~job.message;
        const bit_t answer = take & job.message;
        const bit_t priming = bit_t(state.walk == prime);
        const bit_t in_row = bit_t(state.walk == row) & room;
        const bit_t carrying = bit_t(state.walk == carry);
        const bit_t in_last_part = state.below | state.none_below;
        const bit_t part_ends = in_row & state.last_row;
        const bit_t triangle_ends = part_ends & in_last_part;
        const bit_t empty_part = priming & bit_t(state.rows == 0);
        const bit_t nothing_left = empty_part & in_last_part;
        const bit_t reload = (part_ends | empty_part) & ~in_last_part;

        // Control.
        const walk_state_t after_row =
            select(state.long_carry, walk_state_t(carry), select(reload, walk_state_t(prime), walk_state_t(row)));
        next.walk = select(in_row, select(triangle_ends, walk_state_t(idle), after_row), next.walk);
        next.walk = select(carrying | (priming & ~empty_part), walk_state_t(row), next.walk);
        next.walk = select(nothing_left, walk_state_t(idle), next.walk);
        next.walk = select(load, walk_state_t(prime), next.walk);
        next.below = ~load & (state.below | reload);
        next.none_below = select(load, bit_t(geometry.rows_below == 0), state.none_below);
        next.last_row = select(in_row, bit_t(state.rows == 2), bit_t(state.rows == 1));
        next.rows = select(in_row, coordinate_t(state.rows - 1), state.rows);
        next.rows = select(reload, state.rows_below, next.rows);
        next.rows = select(load, geometry.rows_above, next.rows);
        next.rows_below = select(load, geometry.rows_below, state.rows_below);

        // Phases, a row ahead: a carry is ready when its row ends.
        const bit_t long_steps = in_row | (priming & state.long_fresh);
        const bit_t end_steps = in_row | (priming & ~empty_part) | (carrying & state.end_fresh);
        const ac_int<phase_bits + 1, false> long_sum = state.long_phase + state.long_step;
        const ac_int<phase_bits + 1, false> end_sum = state.end_phase + state.end_step;
        next.long_phase = select(load, geometry.long_phase, select(long_steps, phase_t(long_sum), state.long_phase));
        next.long_step = select(load, geometry.long_step, state.long_step);
        next.long_carry = select(long_steps, bit_t(long_sum[phase_bits]), state.long_carry);
        next.long_fresh = load | (state.long_fresh & ~priming);
        next.end_phase = select(end_steps, phase_t(end_sum), state.end_phase);
        next.end_phase = select(reload, state.lower_phase, next.end_phase);
        next.end_phase = select(load, geometry.upper_phase, next.end_phase);
        next.end_step = select(load, geometry.upper_step, select(reload, state.lower_step, state.end_step));
        next.end_carry = select(end_steps, bit_t(end_sum[phase_bits]), state.end_carry);
        next.end_fresh = load | reload | (state.end_fresh & ~(priming | carrying));
        next.lower_phase = select(load, geometry.lower_phase, state.lower_phase);
        next.lower_step = select(load, geometry.lower_step, state.lower_step);

        // Position: κ pixels along and one row down, then one pixel more on a carry.
        const coordinate_t one_along = select(state.leftward, coordinate_t(-1), coordinate_t(1));
        const coordinate_t along = select(carrying, one_along, state.x_step);
        next.x = select(in_row | carrying, coordinate_t(state.x + along), state.x);
        next.x = select(load, geometry.x, next.x);
        next.x_step = select(load, select(job.leftward, coordinate_t(-geometry.kappa), geometry.kappa), state.x_step);
        next.y = select(load, geometry.y, coordinate_t(state.y + in_row));
        next.leftward = select(load, job.leftward, state.leftward);

        // Length: m + carry_end − carry_long, with m − 1 at hand.
        const coordinate_t growth = select(state.long_carry, state.m_less_one, state.m);
        next.length = select(in_row, coordinate_t(state.length + growth + state.end_carry), state.length);
        next.length = select(reload, state.length_reload, next.length);
        next.length = select(load, geometry.length, next.length);
        next.length_reload = select(load, geometry.length_reload, state.length_reload);
        next.m = select(load, geometry.m, select(reload, state.m_below, state.m));
        next.m_less_one = state.m - 1;
        next.m_below = select(load, geometry.m_below, state.m_below);

        // Outputs: the span of this row, and what the channels do meanwhile.
        const bit_t push_row = in_row & bit_t(state.length != 0);
        next.push = push_row | answer;
        next.first = load | (state.first & ~push_row);
        next.first_pending = (state.first_pending | (push_row & state.first)) & ~first_taken;
        next.span = select_span(job.message & answer, message_span(job), row_span(state));
        next.command.load = load;
        next.command.linear = job.linear;
        next.command.depth = job.depth;
        next.command.step = in_row | carrying;
        next.command.carry = carrying;
        return next;
    }

 private:
    static span_t row_span(const state_t& state) {
        span_t span;
        span.x = state.x;
        span.y = state.y;
        span.length = state.length;
        span.single = bit_t(state.length == 1);
        span.leftward = state.leftward;
        span.first = state.first;
        return span;
    }

    static span_t message_span(const job_t& job) {
        const bit_t query = bit_t(job.code == 0) & bit_t(job.header.slc<8>(header_opcode_lsb) == opcode_query);
        coordinate_t tail = 0;
        tail.set_slc(0, job.code);
        tail.set_slc(4, job.header.slc<8>(header_opcode_lsb));
        span_t span;
        span.x = job.header.slc<coordinate_bits>(0);
        span.y = job.header.slc<coordinate_bits>(coordinate_bits);
        span.length = select(query, coordinate_t(query_reply_words), tail);
        span.single = ~query;
        span.message = 1;
        return span;
    }

    static span_t select_span(bit_t choose, const span_t& a, const span_t& b) {
        span_t span;
        span.x = select(choose, a.x, b.x);
        span.y = select(choose, a.y, b.y);
        span.length = select(choose, a.length, b.length);
        span.single = select(choose, a.single, b.single);
        span.leftward = select(choose, a.leftward, b.leftward);
        span.first = select(choose, a.first, b.first);
        span.message = select(choose, a.message, b.message);
        return span;
    }
};

}  // namespace sheen::hls
