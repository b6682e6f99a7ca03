// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_colour_stage OUTDIR [seed] [count]: vectors of tb_colour_stage, from the kernel.
///
/// A vector is one clock: description, fragment, the integer parts of the channels, and the word that leaves in that
/// clock. All fields are random over their whole range; x = 4095 and the colours about 0 and 255 occur often, one
/// fragment in four is a message.
#include <random>

#include "pauses.hpp"
#include "sheen/hls/colour_stage.hpp"
#include "vector_file.hpp"

namespace {

using namespace sheen::hls;
using sheen::test::Pauses;
using sheen::test::VectorFile;
using sheen::test::VectorOptions;

fragment_t random_fragment(std::mt19937_64& random, bool valid) {
    fragment_t fragment;
    fragment.valid = valid;
    fragment.message = random() % 4 == 0;
    fragment.query = fragment.message & bit_t(random() % 4 == 0);
    fragment.x = random() % 8 == 0 ? static_cast<std::uint64_t>(message_x) : random();
    fragment.y = random();
    fragment.tail = random();
    return fragment;
}

/// Bits of any kind; one time in four the integer part is next to a limit of the saturation.
template <typename colour_t>
colour_t random_colour(std::mt19937_64& random) {
    const int limits[] = {0, 1, -1, 254, 255, 256, 257, 511, -512};
    ac_int<colour_t::width, false> bits = random();
    if (random() % 4 == 0) {
        bits.set_slc(colour_t::width - colour_integer_bits, ac_int<colour_integer_bits, true>(limits[random() % 9]));
    }
    colour_t colour = 0;
    colour.set_slc(0, bits);
    return colour;
}

template <int colour_width, int depth_width>
void write(const VectorOptions& options, int stall_percent) {
    using unit = colour_stage<ac_fixed<colour_width, colour_integer_bits, true, AC_TRN, AC_WRAP>,
                              ac_fixed<depth_width, depth_integer_bits, false, AC_TRN, AC_WRAP>>;
    VectorFile file(options, "colour_stage",
                    "colour_width=" + std::to_string(colour_width) + ",depth_width=" + std::to_string(depth_width) +
                        ",stall_percent=" + std::to_string(stall_percent));
    const auto integer_part = [](const auto& value) {
        return value.template slc<colour_integer_bits>(colour_width - colour_integer_bits).to_int64();
    };
    std::mt19937_64 random(options.seed);
    Pauses source(stall_percent);
    typename unit::state_t state;
    for (int i = 0; i < options.count; ++i) {
        const fragment_t fragment = random_fragment(random, !source.pause(random));
        typename unit::values_t values;
        values.red = random_colour<decltype(values.red)>(random);
        values.green = random_colour<decltype(values.green)>(random);
        values.blue = random_colour<decltype(values.blue)>(random);
        values.depth.set_slc(0, ac_int<depth_width, false>(random()));
        core_description_t description;
        for (word_t& word : description.data) {
            word = random();
            file.word(word.to_int64(), word_bits);
        }
        file.word(fragment.valid.to_int(), 1).word(fragment.message.to_int(), 1).word(fragment.query.to_int(), 1);
        file.word(fragment.x.to_int(), coordinate_bits).word(fragment.y.to_int(), coordinate_bits);
        file.word(fragment.tail.to_int(), coordinate_bits);
        for (const auto& colour : {values.red, values.green, values.blue}) {
            file.word(integer_part(colour), colour_integer_bits);
        }
        file.word(values.depth.template slc<depth_bits>(depth_width - depth_bits).to_int64(), depth_bits);
        file.word(state.valid.to_int(), 1).word(state.fence.to_int(), 1);
        file.word(state.word.to_int64(), pixel_bits).end_vector();
        state = unit::step(state, fragment, values, description);
    }
    file.close();
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        for (const int stall_percent : {0, 50}) {
            write<32, 32>(options, stall_percent);
            write<24, 24>(options, stall_percent);
            write<18, 18>(options, stall_percent);
        }
    });
}
