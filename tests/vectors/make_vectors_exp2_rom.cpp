// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_exp2_rom OUTDIR [seed] [count]: vectors of tb_exp2_rom, from the kernel.
///
/// A vector is a z and the value that it must bring. The first half runs upwards from a little below 0, over every z
/// there is if `count` reaches that far; the second half is random.
#include <random>

#include "sheen/hls/exp2_rom.hpp"
#include "vector_file.hpp"

namespace {

using sheen::test::VectorFile;
using sheen::test::VectorOptions;

template <int address_bits, int data_bits, int fraction_bits>
void write(const VectorOptions& options) {
    using unit = sheen::hls::exp2_rom<address_bits, data_bits, fraction_bits>;
    VectorFile file(options, "exp2_rom",
                    "address_bits=" + std::to_string(address_bits) + ",data_bits=" + std::to_string(data_bits) +
                        ",fraction_bits=" + std::to_string(fraction_bits));
    std::mt19937 random(options.seed);
    for (int i = 0; i < options.count; ++i) {
        const typename unit::z_t z = i < options.count / 2 ? i - 100 : static_cast<int>(random());
        typename unit::state_t state = unit::step({}, z);
        for (int clock = 1; clock < unit::latency; ++clock) {
            state = unit::step(state, typename unit::z_t(static_cast<int>(random())));
        }
        file.word(z.to_int(), unit::z_bits).word(state.value.to_int(), unit::value_bits).end_vector();
    }
    file.close();
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        write<6, 8, 0>(options);
        write<6, 8, 4>(options);
        write<6, 10, 2>(options);
        write<7, 10, 4>(options);
    });
}
