// SPDX-License-Identifier: MIT
/// \file
/// Top for an HLS tool: one clock of edge_walker. Scalar ports only: the state's words in and out, the registers stand
/// around it. Fields share a port where they are narrow, from bit 0 up in the order of the record.
#include <cstdint>

#include "sheen/hls/edge_walker.hpp"

namespace {

using namespace sheen::hls;
using port_t = ac_int<64, false>;

/// Five coordinates as one port.
port_t fields(const coordinate_t& a, const coordinate_t& b, const coordinate_t& c, const coordinate_t& d,
              const coordinate_t& e) {
    port_t port = 0;
    port.set_slc(0, a);
    port.set_slc(coordinate_bits, b);
    port.set_slc(2 * coordinate_bits, c);
    port.set_slc(3 * coordinate_bits, d);
    port.set_slc(4 * coordinate_bits, e);
    return port;
}

phase_t word(const port_t& port, int index) { return port.slc<phase_bits>(index * phase_bits); }

coordinate_t field(const port_t& port, int index) { return port.slc<coordinate_bits>(index * coordinate_bits); }

bit_t flag(const port_t& port, int index) { return port[static_cast<unsigned>(index)]; }

constexpr int half_bits = edge_walker::half_bits;

/// An edge's port: its accumulator and its addend, 32 bits each; the three bits more come with the flags.
edge_walker::edge_t edge_of(const port_t& port, const port_t& flags, int first_flag) {
    edge_walker::edge_t edge;
    edge.low.set_slc(0, port.slc<half_bits>(0));
    edge.high = port.slc<half_bits>(half_bits);
    edge.low_addend.set_slc(0, port.slc<half_bits>(2 * half_bits));
    edge.high_addend = port.slc<half_bits>(3 * half_bits);
    edge.low.set_slc(half_bits, flag(flags, first_flag));
    edge.low_addend.set_slc(half_bits, flag(flags, first_flag + 1));
    edge.overflow = flag(flags, first_flag + 2);
    return edge;
}

port_t port_of(const edge_walker::edge_t& edge) {
    port_t port = 0;
    port.set_slc(0, edge.low.slc<half_bits>(0));
    port.set_slc(half_bits, edge.high);
    port.set_slc(2 * half_bits, edge.low_addend.slc<half_bits>(0));
    port.set_slc(3 * half_bits, edge.high_addend);
    return port;
}

void set_flags_of(const edge_walker::edge_t& edge, port_t& flags, int first_flag) {
    flags.set_slc(first_flag, edge.low.slc<1>(half_bits));
    flags.set_slc(first_flag + 1, edge.low_addend.slc<1>(half_bits));
    flags.set_slc(first_flag + 2, edge.overflow);
}

edge_walker::part_t part_of(const port_t& rows) { return {field(rows, 0), field(rows, 1), field(rows, 2)}; }

edge_walker::state_t state_of(const port_t& flags, const port_t& position, const port_t& part, const port_t& preset,
                              const port_t& long_edge, const port_t& upper_edge, const port_t& lower_edge) {
    edge_walker::state_t s;
    s.walk = flags.slc<3>(0);
    s.in_row = flag(flags, 3);
    s.free = flag(flags, 4);
    s.last_part = flag(flags, 6);
    s.middle_row = flag(flags, 7);
    s.final_row = flag(flags, 8);
    s.long_moves = flag(flags, 9);
    s.end_moves = flag(flags, 10);
    s.first = flag(flags, 11);
    s.first_pending = flag(flags, 12);
    s.leftward = flag(flags, 13);
    s.in_lower = flag(flags, 14);
    s.length_moves = flag(flags, 15);
    s.none_above = flag(flags, 16);
    s.none_below = flag(flags, 17);
    s.x = field(position, 0);
    s.y = field(position, 1);
    s.x_addend = field(position, 2);
    s.growth = field(position, 3);
    s.part = part_of(part);
    s.preset = part_of(preset);
    s.long_edge = edge_of(long_edge, flags, 18);
    s.upper_edge = edge_of(upper_edge, flags, 21);
    s.lower_edge = edge_of(lower_edge, flags, 24);
    return s;
}

port_t flags_of(const edge_walker::state_t& s) {
    port_t flags = 0;
    flags.set_slc(0, s.walk);
    flags.set_slc(3, s.in_row);
    flags.set_slc(4, s.free);
    flags.set_slc(6, s.last_part);
    flags.set_slc(7, s.middle_row);
    flags.set_slc(8, s.final_row);
    flags.set_slc(9, s.long_moves);
    flags.set_slc(10, s.end_moves);
    flags.set_slc(11, s.first);
    flags.set_slc(12, s.first_pending);
    flags.set_slc(13, s.leftward);
    flags.set_slc(14, s.in_lower);
    flags.set_slc(15, s.length_moves);
    flags.set_slc(16, s.none_above);
    flags.set_slc(17, s.none_below);
    set_flags_of(s.long_edge, flags, 18);
    set_flags_of(s.upper_edge, flags, 21);
    set_flags_of(s.lower_edge, flags, 24);
    return flags;
}

geometry_t geometry_of(const port_t& start, const port_t& rest, const port_t& long_edge, const port_t& upper_edge,
                       const port_t& lower_edge) {
    geometry_t g;
    g.x = field(start, 0);
    g.y = field(start, 1);
    g.rows_above = field(start, 2);
    g.rows_below = field(start, 3);
    g.kappa = field(start, 4);
    g.length = field(rest, 0);
    g.m = field(rest, 1);
    g.length_reload = field(rest, 2);
    g.m_below = field(rest, 3);
    g.long_phase = word(long_edge, 0);
    g.long_step = word(long_edge, 1);
    g.upper_phase = word(upper_edge, 0);
    g.upper_step = word(upper_edge, 1);
    g.lower_phase = word(lower_edge, 0);
    g.lower_step = word(lower_edge, 1);
    return g;
}

/// Commands and span: load, linear, depth, step, carry, push, single, leftward, first, message, then x, y, length.
port_t outputs_of(const edge_walker::state_t& s) {
    port_t out = 0;
    out.set_slc(0, s.command.load);
    out.set_slc(1, s.command.linear);
    out.set_slc(2, s.command.depth);
    out.set_slc(3, s.command.step);
    out.set_slc(4, s.command.carry);
    out.set_slc(5, s.push);
    out.set_slc(6, s.span.single);
    out.set_slc(7, s.span.leftward);
    out.set_slc(8, s.span.first);
    out.set_slc(9, s.span.message);
    out.set_slc(10, s.span.x);
    out.set_slc(10 + coordinate_bits, s.span.y);
    out.set_slc(10 + 2 * coordinate_bits, s.span.length);
    return out;
}

}  // namespace

/// flags … lower_edge: the state; job_flags: valid, message, leftward, linear, depth, code; job_*: geometry.
extern "C" void edge_walker_step(std::uint64_t flags, std::uint64_t position, std::uint64_t part, std::uint64_t preset,
                                 std::uint64_t long_edge, std::uint64_t upper_edge, std::uint64_t lower_edge,
                                 std::uint8_t job_flags, std::uint32_t job_header, std::uint64_t job_start,
                                 std::uint64_t job_rest, std::uint64_t job_long, std::uint64_t job_upper,
                                 std::uint64_t job_lower, bool room, bool first_taken, std::uint64_t* next_flags,
                                 std::uint64_t* next_position, std::uint64_t* next_part, std::uint64_t* next_preset,
                                 std::uint64_t* next_long_edge, std::uint64_t* next_upper_edge,
                                 std::uint64_t* next_lower_edge, std::uint64_t* outputs, bool* job_taken) {
    const edge_walker::state_t state = state_of(flags, position, part, preset, long_edge, upper_edge, lower_edge);
    job_t job;
    const port_t bits = job_flags;
    job.valid = flag(bits, 0);
    job.message = flag(bits, 1);
    job.leftward = flag(bits, 2);
    job.linear = flag(bits, 3);
    job.depth = flag(bits, 4);
    job.code = bits.slc<2>(5);
    job.header = job_header;
    const geometry_t geometry = geometry_of(job_start, job_rest, job_long, job_upper, job_lower);

    *job_taken = edge_walker::taken(state, job, room) != 0;
    const edge_walker::state_t next = edge_walker::step(state, job, geometry, room, first_taken);
    const coordinate_t none = 0;
    *next_flags = flags_of(next).to_uint64();
    *next_position = fields(next.x, next.y, next.x_addend, next.growth, none).to_uint64();
    *next_part = fields(next.part.rows, next.part.length, next.part.m, none, none).to_uint64();
    *next_preset = fields(next.preset.rows, next.preset.length, next.preset.m, none, none).to_uint64();
    *next_long_edge = port_of(next.long_edge).to_uint64();
    *next_upper_edge = port_of(next.upper_edge).to_uint64();
    *next_lower_edge = port_of(next.lower_edge).to_uint64();
    *outputs = outputs_of(next).to_uint64();
}
