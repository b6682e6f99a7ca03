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
/// Each phase accumulator is cut in two halves, so that no carry chain is longer than one: the lower half is a step
/// ahead of the upper one and hands its carry on through a register. Its first step is made on the way to the
/// accumulator.
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
    /// An upper part without rows: the lower one comes into preset (`empty`) and from there (`skip`).
    enum walk_state { idle, prime, row, carry, empty, skip };
    using walk_state_t = ac_int<3, false>;

    static constexpr int half_bits = phase_bits / 2;
    using half_t = ac_int<half_bits, false>;
    using half_sum_t = ac_int<half_bits + 1, false>;
    using low_t = half_sum_t;  ///< with the carry of the last step, into the upper half's next

    /// A phase accumulator, skewed: the lower half is a step ahead of the upper one. While the walker is idle its
    /// addend is the edge's start, which the accumulator takes over as it stands.
    struct edge_t {
        low_t low = 0;
        half_t high = 0;
        low_t low_addend = 0;
        half_t high_addend = 0;
        bit_t overflow = 0;  ///< the carry out of the last step: for the row that ends next
    };

    /// One side of the middle vertex.
    struct part_t {
        coordinate_t rows = 0, length = 0, m = 0;
    };

    struct state_t {
        walk_state_t walk = idle;
        bit_t in_row = 0;         ///< in state row: this clock ends the row (the queue had room a clock ago)
        bit_t free = 0;           ///< idle, and the channels' constants are no longer needed
        bit_t last_part = 0;      ///< past the middle vertex, or no row below it
        bit_t middle_row = 0;     ///< the last row above the middle vertex
        bit_t final_row = 0;      ///< the triangle's last row
        bit_t long_moves = 1;     ///< the long edge is loaded or steps in this clock
        bit_t end_moves = 1;      ///< the same of the end edge
        bit_t length_moves = 1;   ///< the same of the part's length
        bit_t first = 0;          ///< the next span is the triangle's first
        bit_t first_pending = 0;  ///< the triangle's first span waits in the queue
        bit_t in_lower = 0;       ///< past the middle vertex
        bit_t leftward = 0;
        bit_t none_above = 0;  ///< geometry, a clock ago: no row above the middle vertex
        bit_t none_below = 0;
        coordinate_t x = 0;         ///< inverted when leftward
        coordinate_t x_addend = 0;  ///< κ; while idle, where the triangle starts
        coordinate_t y = 0;
        edge_t long_edge, upper_edge, lower_edge;
        coordinate_t growth = 0;  ///< of the length in this clock: m, or −1 in a carry
        part_t part;              ///< the part being walked
        part_t preset;            ///< the next one: the lower part, then the next triangle's upper part
        // Outputs.
        edge_command_t command;
        bit_t push = 0;
        span_t span;
    };

    /// True when the job offered in this clock is taken. \param room the span queue takes a span
    static bit_t taken(const state_t& state, const job_t& job, bit_t room) {
        return job.valid & select(job.message, bit_t(bit_t(state.walk == idle) & room), state.free);
    }

    /// \param geometry stable, like job.leftward, from the clock before job.valid to the clock after the job is taken
    /// \param first_taken the span walker starts a triangle's first span in this clock
    static state_t step(const state_t& state, const job_t& job, const geometry_t& geometry, bit_t room,
                        bit_t first_taken) {
        state_t next = state;
        const bit_t take = taken(state, job, room);
        const bit_t load = take & ~job.message;
        const bit_t answer = take & job.message;
        const bit_t idling = bit_t(state.walk == idle);
        const bit_t priming = bit_t(state.walk == prime);
        const bit_t emptying = bit_t(state.walk == empty);
        const bit_t in_row = state.in_row;
        const bit_t carrying = bit_t(state.walk == carry);
        const bit_t triangle_ends = in_row & state.final_row;
        const bit_t reload = (in_row & state.middle_row) | bit_t(state.walk == skip);

        // Control. A triangle without rows above its middle vertex skips its upper part, and may have no row at all.
        next.none_above = bit_t(geometry.rows_above == 0);
        next.none_below = bit_t(geometry.rows_below == 0);
        const walk_state_t after_row = select(state.long_edge.overflow, walk_state_t(carry),
                                              select(reload, walk_state_t(prime), walk_state_t(row)));
        const walk_state_t after_load = select(state.none_above, walk_state_t(empty), walk_state_t(prime));
        next.walk = select(in_row, select(triangle_ends, walk_state_t(idle), after_row), next.walk);
        next.walk = select(priming | carrying, walk_state_t(row), next.walk);
        next.walk = select(emptying, walk_state_t(skip), next.walk);
        next.walk = select(bit_t(state.walk == skip), walk_state_t(prime), next.walk);
        next.walk = select(load & ~(state.none_above & state.none_below), after_load, next.walk);
        next.free = bit_t(next.walk == idle) & ~(state.first_pending | (in_row & state.first));
        next.in_row = bit_t(next.walk == row) & room;
        next.last_part = select(idling, state.none_below, bit_t(state.last_part | reload));
        const bit_t last_row = select(in_row, bit_t(state.part.rows == 2), bit_t(state.part.rows == 1));
        next.middle_row = last_row & ~state.last_part & ~idling;
        next.final_row = last_row & state.last_part & ~idling;

        // A triangle begins with the part that waits in preset, and so does what follows the middle vertex. While the
        // walker is idle it gets ready for the triangle that may come in this clock: no register waits for `load`.
        const bit_t begins_part = idling | reload;
        next.preset = select_part(priming | emptying, lower_part(geometry),
                                  select_part(idling | state.last_part, upper_part(geometry), state.preset));
        next.part.rows = select(begins_part, state.preset.rows, coordinate_t(state.part.rows - in_row));
        next.part.m = select(begins_part, state.preset.m, state.part.m);

        // Phases, a row ahead: a carry is ready when its row ends.
        const bit_t ready = idling | state.final_row;
        const bit_t lower_moves = idling | (state.end_moves & state.in_lower);
        next.long_edge = clocked(state.long_edge, {state.long_moves, idling, ready, load, ~idling}, geometry.long_phase,
                                 geometry.long_step);
        next.upper_edge = clocked(state.upper_edge, {state.end_moves, idling, ready, load, ~state.in_lower},
                                  geometry.upper_phase, geometry.upper_step);
        next.lower_edge = clocked(state.lower_edge, {lower_moves, idling, ready, load, ~idling}, geometry.lower_phase,
                                  geometry.lower_step);
        next.in_lower = (state.in_lower | reload) & ~idling;

        // The long edge steps in the first prime and with every row; the end edge once more in the clock after the
        // middle vertex; the length with every row and every carry but that in the clock after the middle vertex.
        const bit_t waits = bit_t(next.walk == row) & ~room;
        const bit_t carries_on = bit_t(next.walk == carry) & ~state.middle_row;
        next.long_moves = idling | triangle_ends | next.in_row;
        next.end_moves = ~(waits | carries_on);
        next.length_moves = ~(waits | load | reload);

        // Position: x + s·(κ + carry); leftward, not x + κ + carry = not (x − κ − carry).
        const coordinate_t moved = state.x + state.x_addend + state.long_edge.overflow;
        next.x = select(idling, state.x_addend, select(in_row, moved, state.x));
        const coordinate_t x_addend = select(load, geometry.kappa, inverted(job.leftward, geometry.x));
        next.x_addend = select(ready, x_addend, state.x_addend);
        next.y = select(idling, geometry.y, coordinate_t(state.y + in_row));
        next.leftward = select(idling, job.leftward, state.leftward);

        // Length: m + carry_end with the row, −1 with a carry; a part begins with its own, which has had its carry.
        const coordinate_t grown =
            state.part.length + state.growth + ((state.upper_edge.overflow | state.lower_edge.overflow) & in_row);
        next.part.length =
            select(state.length_moves, select(begins_part, state.preset.length, grown), state.part.length);
        next.growth = select(bit_t(next.walk == carry), coordinate_t(-1), state.part.m);

        // Outputs: the span of this row, and what the channels do meanwhile.
        const bit_t push_row = in_row & bit_t(state.part.length != 0);
        next.push = push_row | answer;
        next.first = idling | (state.first & ~push_row);
        next.first_pending = (state.first_pending | (push_row & state.first)) & ~first_taken;
        next.span = select_span(idling, message_span(job), row_span(state));
        next.command.load = load;
        next.command.linear = job.linear;
        next.command.depth = job.depth;
        next.command.step = in_row | carrying;
        next.command.carry = carrying;
        return next;
    }

 private:
    /// What an accumulator does in a clock.
    struct edge_control_t {
        bit_t moves;  ///< it takes over its addend or steps
        bit_t takes;  ///< with moves: it takes over
        bit_t ready;  ///< its addend becomes the start, or, with load, the step
        bit_t load;
        bit_t counts;  ///< with moves: the carry is one of a row
    };

    static edge_t clocked(const edge_t& edge, const edge_control_t& control, const phase_t& phase,
                          const phase_t& step) {
        const low_t low = edge.low.slc<half_bits>(0) + edge.low_addend;
        const half_sum_t high = edge.high + edge.high_addend + edge.low.slc<1>(half_bits);
        const low_t start = phase.slc<half_bits>(0) + step.slc<half_bits>(0);
        edge_t next;
        next.low = select(control.moves, select(control.takes, edge.low_addend, low), edge.low);
        next.high = select(control.moves, select(control.takes, edge.high_addend, half_t(high)), edge.high);
        next.overflow = select(control.moves, bit_t(bit_t(high[half_bits]) & control.counts), edge.overflow);
        const half_t high_addend =
            select(control.load, step.slc<half_bits>(half_bits), phase.slc<half_bits>(half_bits));
        next.low_addend =
            select(control.ready, select(control.load, low_t(step.slc<half_bits>(0)), start), edge.low_addend);
        next.high_addend = select(control.ready, high_addend, edge.high_addend);
        return next;
    }

    static part_t upper_part(const geometry_t& g) { return {g.rows_above, g.length, g.m}; }
    static part_t lower_part(const geometry_t& g) { return {g.rows_below, g.length_reload, g.m_below}; }
    static part_t select_part(bit_t choose, const part_t& a, const part_t& b) {
        return {select(choose, a.rows, b.rows), select(choose, a.length, b.length), select(choose, a.m, b.m)};
    }

    static coordinate_t inverted(bit_t invert, const coordinate_t& x) { return select(invert, coordinate_t(~x), x); }

    static span_t row_span(const state_t& state) {
        span_t span;
        span.x = inverted(state.leftward, state.x);
        span.y = state.y;
        span.length = state.part.length;
        span.single = bit_t(state.part.length == 1);
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
