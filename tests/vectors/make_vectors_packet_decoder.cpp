// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_packet_decoder OUTDIR [seed] [count]: vectors of tb_packet_decoder, from the kernel.
///
/// A vector is one clock: the inputs, and the outputs that stand in that clock. The first packet fills every register;
/// then come triangles, fences, queries and malformed packets of every kind. With stall_percent, that share of clocks
/// offers no beat and leaves the job untaken.
#include "../support/kernel_records.hpp"
#include "sheen/hls/packet_decoder.hpp"
#include "vector_file.hpp"

namespace {

using namespace sheen::hls;
using sheen::test::CoreShape;
using sheen::test::Rng;
using sheen::test::StreamPacket;
using sheen::test::VectorFile;
using sheen::test::VectorOptions;

/// A triangle with every channel that the core has, in its fullest form.
StreamPacket full_triangle(Rng& rng, const CoreShape& shape) {
    sheen::TriangleSetup setup = sheen::test::random_setup(rng, 9);
    setup.linear = !shape.quadratic;
    for (sheen::ChannelWords& channel : setup.colour) channel = sheen::test::random_channel(rng, setup.linear);
    setup.depth.reset();
    if (shape.depth) setup.depth = sheen::test::random_channel(rng, true);
    setup.log.resize(static_cast<std::size_t>(shape.log_channels));
    for (sheen::ChannelWords& channel : setup.log) channel = sheen::test::random_channel(rng, setup.linear);
    std::vector<std::uint32_t> words;
    sheen::append_triangle(words, setup);
    return sheen::test::framed(words, shape.words_per_beat);
}

template <typename decoder>
void write_vector(VectorFile& file, const typename decoder::beat_t& beat, bit_t taken,
                  const typename decoder::applied_t& applied, const typename decoder::state_t& state,
                  int words_per_beat) {
    file.word(beat.valid.to_int(), 1).word(beat.last.to_int(), 1).word(beat.keep.to_int(), words_per_beat);
    for (const word_t& word : beat.words) file.word(word.to_int64(), word_bits);
    file.word(taken.to_int(), 1).word(applied.material.to_int(), 1).word(applied.table.to_int(), 1);
    file.word(decoder::ready(state).to_int(), 1);
    const job_t& job = state.job;
    for (const bit_t& bit : {job.valid, job.message, job.leftward, job.linear, job.depth}) file.word(bit.to_int(), 1);
    file.word(job.log.to_int(), 2).word(job.code.to_int(), 2).word(job.header.to_int64(), word_bits);
    const material_t& material = state.material;
    for (const auto& ambient : {material.red, material.green, material.blue}) {
        file.word(ambient.to_int(), component_bits + colour_sum_fraction_bits);
    }
    file.word(material.power.to_int(), 3);
    const table_write_t& write = state.table_write;
    file.word(write.valid.to_int(), 1).word(write.bank.to_int(), 1).word(write.address.to_int(), power_word_bits);
    file.word(write.data.to_int64(), word_bits);
    for (const word_t& word : state.words) file.word(word.to_int64(), word_bits);
    file.end_vector();
}

/// A bit that is set some clocks after its packet's message was taken: the highlight stage's answer.
class Arrival {
 public:
    explicit Arrival(std::uint32_t opcode) : opcode_(opcode) {}
    bit_t clock(bit_t taken, const job_t& job) {
        const bit_t arrives = left_ == 1;
        left_ -= left_ > 0 ? 1 : 0;
        if (taken != 0 && job.message != 0 && job.code == 0 && job.header.to_uint() >> 24 == opcode_) left_ = 20;
        return arrives;
    }

 private:
    std::uint32_t opcode_;
    int left_ = 0;
};

template <int words_per_beat, bool has_depth, bool has_quadratic, int log_channels = 0, bool has_power = false>
void write_one(const VectorOptions& options, unsigned stall_percent) {
    using decoder = packet_decoder<words_per_beat, has_depth, has_quadratic, log_channels, has_power>;
    const auto word = [](bool value) { return value ? "true" : "false"; };
    VectorFile file(options, "packet_decoder",
                    "words_per_beat=" + std::to_string(words_per_beat) + ",has_depth=" + word(has_depth) +
                        ",has_quadratic=" + word(has_quadratic) + ",log_channels=" + std::to_string(log_channels) +
                        ",has_power=" + word(has_power) + ",stall_percent=" + std::to_string(stall_percent));
    const CoreShape shape{words_per_beat, has_depth, has_quadratic, log_channels, has_power};
    Rng rng(options.seed);
    const auto stalls = [&] { return rng() % 100 < stall_percent; };
    typename decoder::state_t state;
    StreamPacket packet = full_triangle(rng, shape);
    std::size_t next = 0;
    bool offering = false;
    Arrival material(opcode_material);
    Arrival table(opcode_table);
    for (int clock = 0; clock < options.count; ++clock) {
        if (next == packet.size()) {
            packet = sheen::test::random_packet(rng, sheen::test::random_walk(rng, 4095), shape);
            next = 0;
        }
        offering = offering || !stalls();
        const auto beat = offering ? sheen::test::beat_of<decoder>(packet[next]) : sheen::test::no_beat<decoder>(rng);
        const bit_t taken = state.job.valid && !stalls();
        const typename decoder::applied_t applied = {material.clock(taken, state.job), table.clock(taken, state.job)};
        write_vector<decoder>(file, beat, taken, applied, state, words_per_beat);
        if (offering && decoder::ready(state)) {
            ++next;
            offering = false;
        }
        state = decoder::step(state, beat, taken, applied);
    }
    file.close();
}

template <int words_per_beat>
void write(const VectorOptions& options) {
    for (const unsigned stall_percent : {0U, 50U}) {
        write_one<words_per_beat, false, false>(options, stall_percent);
        write_one<words_per_beat, false, true>(options, stall_percent);
        write_one<words_per_beat, true, false>(options, stall_percent);
        write_one<words_per_beat, true, true>(options, stall_percent);
    }
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        write<1>(options);
        write<2>(options);
        write<4>(options);
        for (const unsigned stall_percent : {0U, 50U}) {
            write_one<1, true, true, 1, true>(options, stall_percent);
            write_one<2, false, true, 1, false>(options, stall_percent);
            write_one<2, true, true, 3, true>(options, stall_percent);
            write_one<4, true, true, 2, true>(options, stall_percent);
        }
    });
}
