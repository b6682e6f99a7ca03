// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_stream_fifo OUTDIR [seed] [count]: vectors of tb_stream_fifo, from the kernel and a memory beside it.
///
/// A vector is one clock: write, write_data, taken, and all that the queue shows in that clock. The writer goes on into
/// the reserve after ready has fallen, the reader takes only what is valid; both pause at random.
#include <array>
#include <random>

#include "pauses.hpp"
#include "sheen/hls/stream_fifo.hpp"
#include "vector_file.hpp"

namespace {

using sheen::test::Pauses;
using sheen::test::VectorFile;
using sheen::test::VectorOptions;

constexpr int width = 16;

template <int depth_log2, int reserve>
void write(const VectorOptions& options, int stall_percent) {
    using unit = sheen::hls::stream_fifo<depth_log2, reserve>;
    constexpr int depth = 1 << depth_log2;
    VectorFile file(options, "stream_fifo",
                    "width=" + std::to_string(width) + ",depth_log2=" + std::to_string(depth_log2) +
                        ",reserve=" + std::to_string(reserve) + ",stall_percent=" + std::to_string(stall_percent));
    std::mt19937_64 random(options.seed);
    Pauses writer(stall_percent);
    Pauses reader(stall_percent);
    typename unit::state_t state;
    std::array<std::int64_t, depth> memory{};
    std::int64_t data = 0;
    int entries = 0;
    for (int i = 0; i < options.count; ++i) {
        const bool ready = unit::ready(state) != 0;
        const bool into_reserve = random() % 4 == 0 && entries < depth;
        const bool writes = !writer.pause(random) && (ready || into_reserve);
        const bool takes = !reader.pause(random) && state.valid != 0;
        const bool fetches = unit::fetches(state, takes) != 0;
        const auto written = static_cast<std::int64_t>(random() % (1U << width));
        file.word(writes, 1).word(written, width).word(takes, 1);
        file.word(ready, 1).word(state.valid.to_int(), 1).word(data, width);
        file.word(state.write_address.to_int(), depth_log2).word(fetches, 1);
        file.word(state.read_address.to_int(), depth_log2).end_vector();

        const auto read_address = static_cast<std::size_t>(state.read_address.to_uint());
        const auto write_address = static_cast<std::size_t>(state.write_address.to_uint());
        if (fetches) data = memory[read_address];
        if (writes) memory[write_address] = written;
        entries += static_cast<int>(writes) - static_cast<int>(fetches);
        state = unit::step(state, writes, takes);
    }
    file.close();
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        for (const int stall_percent : {0, 50}) {
            write<2, 0>(options, stall_percent);
            write<2, 2>(options, stall_percent);
            write<4, 0>(options, stall_percent);  // the setup stream's
            write<4, 2>(options, stall_percent);  // the span queue
            write<4, 10>(options, stall_percent);
            write<5, 0>(options, stall_percent);
            write<5, 10>(options, stall_percent);  // the pixel queue
        }
    });
}
