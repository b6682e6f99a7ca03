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
    enum walk_state { idle, prime, row, carry, skip };
    using walk_state_t = ac_int<3, false>;

    /// One side of the middle vertex.
    struct part_t {
        coordinate_t rows = 0, length = 0, m = 0;
        phase_t end_phase = 0, end_step = 0;
    };

    struct state_t {
        walk_state_t walk = idle;
        bit_t in_row = 0;         ///< in state row: this clock ends the row (the queue had room a clock ago)
        bit_t free = 0;           ///< idle, and the channels' constants are no longer needed
        bit_t starts_below = 0;   ///< no row above the middle vertex, but some below it
        bit_t last_part = 0;      ///< past the middle vertex, or no row below it
        bit_t middle_row = 0;     ///< the last row above the middle vertex
        bit_t final_row = 0;      ///< the triangle's last row
        bit_t long_fresh = 0;     ///< the long phase was loaded and has given no carry yet
        bit_t end_fresh = 0;      ///< the same of the end edge's phase
        bit_t first = 0;          ///< the next span is the triangle's first
        bit_t first_pending = 0;  ///< the triangle's first span waits in the queue
        bit_t leftward = 0;
        bit_t long_carry = 0, end_carry = 0;
        coordinate_t x = 0, y = 0, x_step = 0;
        phase_t long_phase = 0, long_step = 0;
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

    /// \param geometry stable from the clock before job.valid until the job is taken
    /// \param first_taken the span walker starts a triangle's first span in this clock
    static state_t step(const state_t& state, const job_t& job, const geometry_t& geometry, bit_t room,
                        bit_t first_taken) {
        state_t next = state;
        const bit_t take = taken(state, job, room);
        const bit_t load = take & ~job.message;
        const bit_t answer = take & job.message;
        const bit_t priming = bit_t(state.walk == prime);
        const bit_t in_row = state.in_row;
        const bit_t carrying = bit_t(state.walk == carry);
        const bit_t triangle_ends = in_row & state.final_row;
        const bit_t reload = (in_row & state.middle_row) | bit_t(state.walk == skip);

        // Control. A triangle without rows above its middle vertex skips its upper part, and may have no row at all.
        const bit_t no_rows = bit_t(geometry.rows_above == 0) & bit_t(geometry.rows_below == 0);
        const walk_state_t after_row =
            select(state.long_carry, walk_state_t(carry), select(reload, walk_state_t(prime), walk_state_t(row)));
        const walk_state_t after_prime = select(state.starts_below, walk_state_t(skip), walk_state_t(row));
        next.walk = select(in_row, select(triangle_ends, walk_state_t(idle), after_row), next.walk);
        next.walk = select(priming, after_prime, next.walk);
        next.walk = select(carrying, walk_state_t(row), next.walk);
        next.walk = select(bit_t(state.walk == skip), walk_state_t(prime), next.walk);
        next.walk = select(load & ~no_rows, walk_state_t(prime), next.walk);
        next.free = bit_t(next.walk == idle) & ~(state.first_pending | (in_row & state.first));
        next.in_row = bit_t(next.walk == row) & room;
        next.starts_below = select(load, bit_t(geometry.rows_above == 0), bit_t(state.starts_below & ~reload));
        next.last_part = select(load, bit_t(geometry.rows_below == 0), bit_t(state.last_part | reload));
        const bit_t last_row = select(in_row, bit_t(state.part.rows == 2), bit_t(state.part.rows == 1));
        next.middle_row = last_row & ~state.last_part;
        next.final_row = last_row & state.last_part;

        // A triangle begins with the part that waits in preset, and so does what follows the middle vertex.
        const bit_t begins_part = load | reload;
        const bit_t preset_free = bit_t(state.walk == idle) | state.last_part;
        next.preset =
            select_part(load, lower_part(geometry), select_part(preset_free, upper_part(geometry), state.preset));
        next.part.rows = select(begins_part, state.preset.rows, coordinate_t(state.part.rows - in_row));
        next.part.m = select(begins_part, state.preset.m, state.part.m);

        // Phases, a row ahead: a carry is ready when its row ends.
        const bit_t long_steps = in_row | (priming & state.long_fresh);
        const bit_t end_steps = in_row | priming | (carrying & state.end_fresh);
        const ac_int<phase_bits + 1, false> long_sum = state.long_phase + state.long_step;
        const ac_int<phase_bits + 1, false> end_sum = state.part.end_phase + state.part.end_step;
        next.long_phase = select(load, geometry.long_phase, select(long_steps, phase_t(long_sum), state.long_phase));
        next.long_step = select(load, geometry.long_step, state.long_step);
        next.long_carry = select(long_steps, bit_t(long_sum[phase_bits]), state.long_carry);
        next.long_fresh = load | (state.long_fresh & ~priming);
        next.part.end_phase =
            select(begins_part, state.preset.end_phase, select(end_steps, phase_t(end_sum), state.part.end_phase));
        next.part.end_step = select(begins_part, state.preset.end_step, state.part.end_step);
        next.end_carry = select(end_steps, bit_t(end_sum[phase_bits]), state.end_carry);
        next.end_fresh = load | reload | (state.end_fresh & ~(priming | carrying));

        // Position: s·(κ + carry); leftward −κ − carry = not κ + not carry.
        const bit_t x_carry = state.long_carry ^ state.leftward;
        next.x = select(in_row, coordinate_t(state.x + state.x_step + x_carry), state.x);
        next.x = select(load, geometry.x, next.x);
        next.x_step = select(load, select(job.leftward, coordinate_t(~geometry.kappa), geometry.kappa), state.x_step);
        next.y = select(load, geometry.y, coordinate_t(state.y + in_row));
        next.leftward = select(load, job.leftward, state.leftward);

        // Length: m + carry_end with the row, −1 with a carry; a part begins with its own, which has had its carry.
        const bit_t length_steps = in_row | (carrying & ~state.end_fresh);
        const coordinate_t grown = state.part.length + state.growth + (state.end_carry & in_row);
        next.part.length = select(begins_part, state.preset.length, select(length_steps, grown, state.part.length));
        next.growth = select(bit_t(next.walk == carry), coordinate_t(-1), state.part.m);

        // Outputs: the span of this row, and what the channels do meanwhile.
        const bit_t push_row = in_row & bit_t(state.part.length != 0);
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
    static part_t upper_part(const geometry_t& g) { return {g.rows_above, g.length, g.m, g.upper_phase, g.upper_step}; }
    static part_t lower_part(const geometry_t& g) {
        return {g.rows_below, g.length_reload, g.m_below, g.lower_phase, g.lower_step};
    }
    static part_t select_part(bit_t choose, const part_t& a, const part_t& b) {
        return {select(choose, a.rows, b.rows), select(choose, a.length, b.length), select(choose, a.m, b.m),
                select(choose, a.end_phase, b.end_phase), select(choose, a.end_step, b.end_step)};
    }

    static span_t row_span(const state_t& state) {
        span_t span;
        span.x = state.x;
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
