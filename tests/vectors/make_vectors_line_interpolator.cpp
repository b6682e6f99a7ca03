// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_line_interpolator OUTDIR [seed] [count]: vectors of tb_line_interpolator, from the kernel.
///
/// A vector is one step: init, sxsb, s and the ra that it must bring. Words are random over their whole range, spans
/// start at random (one step in eight), and the words at an angle's ends occur often.
#include <random>

#include "sheen/hls/line_interpolator.hpp"
#include "vector_file.hpp"

namespace {

using sheen::test::VectorFile;
using sheen::test::VectorOptions;

template <int phase_bits, int ra_bits>
void write(const VectorOptions& options) {
    using unit = sheen::hls::line_interpolator<phase_bits, ra_bits>;
    VectorFile file(options, "line_interpolator",
                    "phase_bits=" + std::to_string(phase_bits) + ",ra_bits=" + std::to_string(ra_bits));
    std::mt19937_64 random(options.seed);
    const auto angle = [&random]() -> typename unit::angle_t {
        constexpr long long extreme = 1LL << (phase_bits - 1);
        const long long corners[] = {0, 1, -1, extreme - 1, -extreme};
        const auto pick = random() % 16;
        return pick < 5 ? corners[pick] : static_cast<long long>(random());
    };
    typename unit::angle_t phase = 0;
    for (int i = 0; i < options.count; ++i) {
        const typename unit::input_t in = {random() % 8 == 0, 1, angle(), angle()};
        const typename unit::output_t out = unit::step(phase, in);
        phase = out.phase;
        file.word(in.init.to_int(), 1).word(in.sxsb.to_int64(), phase_bits).word(in.s.to_int64(), phase_bits);
        file.word(out.ra.to_int64(), ra_bits).end_vector();
    }
    file.close();
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        write<12, 6>(options);  // preset paper
        write<12, 4>(options);  // preset 4-bit
        write<22, 12>(options);
        write<32, 32>(options);
    });
}
