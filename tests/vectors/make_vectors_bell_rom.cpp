// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_bell_rom OUTDIR [seed] [count]: vectors of tb_bell_rom, from the kernel.
///
/// A vector is an ra and the value that it must bring. The first half runs through the bell from one side to the other,
/// over every ra there is if `count` reaches that far; the second half is random.
#include <random>

#include "sheen/hls/bell_rom.hpp"
#include "vector_file.hpp"

namespace {

using sheen::test::VectorFile;
using sheen::test::VectorOptions;

template <int address_bits, int data_bits, int exponent_tenths, int wrap_bits, bool folded>
void write(const VectorOptions& options) {
    using unit = sheen::hls::bell_rom<address_bits, data_bits, exponent_tenths, wrap_bits, folded>;
    VectorFile file(options, "bell_rom",
                    "address_bits=" + std::to_string(address_bits) + ",data_bits=" + std::to_string(data_bits) +
                        ",exponent_tenths=" + std::to_string(exponent_tenths) +
                        ",wrap_bits=" + std::to_string(wrap_bits) + ",folded=" + (folded ? "true" : "false"));
    std::mt19937 random(options.seed);
    for (int i = 0; i < options.count; ++i) {
        const typename unit::ra_t ra = i < options.count / 2 ? i - options.count / 4 : static_cast<int>(random());
        typename unit::state_t state = unit::step({}, {ra, 1});
        for (int clock = 1; clock < unit::latency; ++clock) {
            state = unit::step(state, {});
        }
        file.word(ra.to_int(), unit::ra_bits).word(state.value.to_int(), data_bits).end_vector();
    }
    file.close();
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        write<6, 6, 20, 0, false>(options);  // preset paper, specular
        write<6, 6, 10, 0, false>(options);  // preset paper, diffuse
        write<4, 4, 20, 0, false>(options);  // preset 4-bit, specular
        write<4, 4, 10, 0, false>(options);  // preset 4-bit, diffuse
        write<5, 6, 20, 2, true>(options);   // the paper's table, folded, with wrap bits
        write<6, 6, 20, 3, false>(options);  // the paper's table with wrap bits
        write<8, 8, 95, 3, true>(options);
        write<8, 8, 10, 5, true>(options);
        write<9, 8, 95, 4, false>(options);
    });
}
