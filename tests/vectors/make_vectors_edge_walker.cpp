// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_edge_walker OUTDIR [seed] [count]: vectors of tb_edge_walker, from the kernel.
///
/// A vector is one clock: the inputs, and the outputs that stand in that clock. Jobs are triangles of many shapes,
/// arbitrary fields (parts without rows among them) and messages; each stays until it is taken, its geometry a clock
/// longer. With stall_percent, that share of clocks has no room, no new job, and leaves a waiting first span in its
/// queue.
#include "../support/kernel_records.hpp"
#include "sheen/hls/edge_walker.hpp"
#include "vector_file.hpp"

namespace {

using namespace sheen::hls;
using sheen::test::Rng;
using sheen::test::VectorFile;
using sheen::test::VectorOptions;

struct Job {
    job_t job;
    geometry_t geometry;
};

/// Any fields; not valid, this is noise on the ports.
Job random_job(Rng& rng) {
    Job j;
    const sheen::TriangleWalk walk =
        rng() % 2 == 0 ? sheen::test::covering_walk(rng, 40) : sheen::test::random_walk(rng, 6);
    j.geometry = sheen::test::geometry_of(walk);
    j.job.message = rng() % 4 == 0;
    j.job.leftward = walk.leftward;
    j.job.linear = rng() % 2;
    j.job.depth = rng() % 2;
    j.job.code = rng() % 4;
    j.job.header = static_cast<std::uint32_t>(rng() % 6 << 24 | (rng() & 0xffffff));
    return j;
}

void write_job(VectorFile& file, const Job& j) {
    const job_t& job = j.job;
    for (const bit_t& bit : {job.valid, job.message, job.leftward, job.linear, job.depth}) file.word(bit.to_int(), 1);
    file.word(job.code.to_int(), 2).word(job.header.to_int64(), word_bits);
    const geometry_t& g = j.geometry;
    for (const coordinate_t& field :
         {g.x, g.y, g.rows_above, g.rows_below, g.kappa, g.length, g.m, g.length_reload, g.m_below}) {
        file.word(field.to_int(), coordinate_bits);
    }
    for (const phase_t& phase : {g.long_phase, g.long_step, g.upper_phase, g.upper_step, g.lower_phase, g.lower_step}) {
        file.word(phase.to_int64(), phase_bits);
    }
}

void write_outputs(VectorFile& file, bit_t taken, const edge_walker::state_t& state) {
    const edge_command_t& c = state.command;
    const span_t& s = state.span;
    for (const bit_t& bit : {taken, c.load, c.linear, c.depth, c.step, c.carry, state.push}) file.word(bit.to_int(), 1);
    for (const coordinate_t& field : {s.x, s.y, s.length}) file.word(field.to_int(), coordinate_bits);
    for (const bit_t& bit : {s.single, s.leftward, s.first, s.message}) file.word(bit.to_int(), 1);
}

void write(const VectorOptions& options, unsigned stall_percent) {
    VectorFile file(options, "edge_walker", "stall_percent=" + std::to_string(stall_percent));
    Rng rng(options.seed);
    const auto stalls = [&] { return rng() % 100 < stall_percent; };
    edge_walker::state_t state;
    Job offered = random_job(rng);
    bool first_waits = false;
    bool just_taken = false;
    for (int clock = 0; clock < options.count; ++clock) {
        if (!offered.job.valid && !just_taken) {
            offered = random_job(rng);
            offered.job.valid = !stalls();
        }
        const bit_t room = !stalls();
        const bit_t first_taken = first_waits && !stalls();
        const bit_t taken = edge_walker::taken(state, offered.job, room);
        write_job(file, offered);
        file.word(room.to_int(), 1).word(first_taken.to_int(), 1);
        write_outputs(file, taken, state);
        file.end_vector();
        state = edge_walker::step(state, offered.job, offered.geometry, room, first_taken);
        first_waits = (first_waits && !first_taken) || (state.push & state.span.first);
        if (taken) offered.job.valid = 0;
        just_taken = taken != 0;
    }
    file.close();
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        write(options, 0);
        write(options, 50);
    });
}
