// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_spherical_pair OUTDIR [seed] [count]: vectors of tb_spherical_pair, from both kernels in a row.
///
/// A vector is one pixel: init, sxsb, s and the value that the table must give for it. Pixels come as spans of 1 to 512
/// whose angle crosses part of the bell, some of them starting or ending outside of it.
#include <random>

#include "sheen/hls/bell_rom.hpp"
#include "sheen/hls/line_interpolator.hpp"
#include "vector_file.hpp"

namespace {

using sheen::test::VectorFile;
using sheen::test::VectorOptions;

template <int phase_bits, int address_bits, int data_bits, int exponent_tenths, int wrap_bits, bool folded>
void write(const VectorOptions& options) {
    using rom = sheen::hls::bell_rom<address_bits, data_bits, exponent_tenths, wrap_bits, folded>;
    using line = sheen::hls::line_interpolator<phase_bits, rom::ra_bits>;
    VectorFile file(options, "spherical_pair",
                    "phase_bits=" + std::to_string(phase_bits) + ",address_bits=" + std::to_string(address_bits) +
                        ",data_bits=" + std::to_string(data_bits) +
                        ",exponent_tenths=" + std::to_string(exponent_tenths) +
                        ",wrap_bits=" + std::to_string(wrap_bits) + ",folded=" + (folded ? "true" : "false"));
    constexpr int quadrant = 1 << (phase_bits - 1 - wrap_bits);
    constexpr int reach = wrap_bits > 0 ? 2 * quadrant : quadrant - 1;
    std::mt19937 random(options.seed);
    std::uniform_int_distribution<int> any_angle(-reach, reach);
    std::uniform_int_distribution<int> any_length(1, 512);
    typename line::output_t angle;
    typename line::angle_t sxsb = 0;
    typename line::angle_t s = 0;
    int left = 0;
    for (int i = 0; i < options.count; ++i) {
        const bool init = left == 0;
        if (init) {
            left = any_length(random);
            const int first = any_angle(random);
            const int last = any_angle(random);
            sxsb = first;
            s = (last - first) / left;
        }
        --left;
        angle = line::step(angle.phase, {init, 1, sxsb, s});
        typename rom::state_t state = rom::step({}, {angle.ra, angle.ra_valid});
        for (int clock = 1; clock < rom::latency; ++clock) {
            state = rom::step(state, {});
        }
        file.word(init, 1).word(sxsb.to_int(), phase_bits).word(s.to_int(), phase_bits);
        file.word(state.value.to_int(), data_bits).end_vector();
    }
    file.close();
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        write<12, 6, 6, 20, 0, false>(options);  // preset paper, specular
        write<12, 6, 6, 10, 0, false>(options);  // preset paper, diffuse
        write<12, 4, 4, 20, 0, false>(options);  // preset 4-bit
        write<22, 8, 8, 95, 3, true>(options);
    });
}
