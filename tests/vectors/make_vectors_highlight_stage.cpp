// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_highlight_stage OUTDIR [seed] [count]: vectors of tb_highlight_stage, from the kernel.
///
/// A vector is one clock: fragment, diffuse, depth, log channels, the decoder's material and table write, and what
/// leaves the stage in that clock. All fields are random over their whole range, a pause's fragment too, and log
/// channels mostly lie where highlights show. Both power banks are loaded first, by pixels of triangles without log
/// channels; then words are written at random, also where they are read.
#include <random>
#include <vector>

#include "pauses.hpp"
#include "sheen/hls/highlight_stage.hpp"
#include "vector_file.hpp"

namespace {

using namespace sheen::hls;
using sheen::test::Pauses;
using sheen::test::VectorFile;
using sheen::test::VectorOptions;

/// One fragment in four is a message, half of them a material's or a table's.
fragment_t random_fragment(std::mt19937_64& random, bool valid) {
    fragment_t fragment;
    fragment.valid = valid;
    fragment.message = random() % 4 == 0;
    fragment.query = random() % 8 == 0;
    fragment.log = random();
    fragment.x = random();
    fragment.y = random();
    fragment.tail = random() % 2 == 0 ? random() : (random() % 2 == 0 ? opcode_material : opcode_table) << 4;
    return fragment;
}

table_write_t random_write(std::mt19937_64& random) {
    table_write_t write;
    write.valid = random() % 2;
    write.bank = random();
    write.address = random();
    write.data = random();
    return write;
}

material_t random_material(std::mt19937_64& random) {
    material_t material;
    material.red = random();
    material.green = random();
    material.blue = random();
    material.power = random();
    return material;
}

template <typename values_t>
values_t random_values(std::mt19937_64& random) {
    values_t values;
    values.red = random();
    values.green = random();
    values.blue = random();
    values.depth = random();
    for (auto& log : values.log) {
        log = random() % 4 == 0 ? static_cast<int>(random()) : static_cast<int>(random() % 1200) - 80;
    }
    return values;
}

void put(VectorFile& file, const fragment_t& fragment) {
    file.word(fragment.valid.to_int(), 1).word(fragment.message.to_int(), 1).word(fragment.query.to_int(), 1);
    file.word(fragment.log.to_int(), flag_log_channels_bits).word(fragment.x.to_int(), coordinate_bits);
    file.word(fragment.y.to_int(), coordinate_bits).word(fragment.tail.to_int(), coordinate_bits);
}

/// Red, green, blue, and the width of each.
template <typename colours_t>
void put_colour(VectorFile& file, const colours_t& colours) {
    constexpr int bits = decltype(colours.red)::width;
    file.word(colours.red.to_int64(), bits).word(colours.green.to_int64(), bits).word(colours.blue.to_int64(), bits);
}

template <int log_channels, bool has_power>
void write(const VectorOptions& options, int stall_percent) {
    using unit = highlight_stage<log_channels, has_power>;
    VectorFile file(options, "highlight_stage",
                    "log_channels=" + std::to_string(log_channels) + ",has_power=" + (has_power ? "true" : "false") +
                        ",stall_percent=" + std::to_string(stall_percent));
    std::mt19937_64 random(options.seed);
    Pauses source(stall_percent);
    std::vector<word_t> memory(unit::power::words, 0);
    typename unit::state_t state;
    for (int i = 0; i < options.count; ++i) {
        fragment_t fragment = random_fragment(random, !source.pause(random));
        table_write_t table_write = random_write(random);
        if (i < unit::power::words) {
            table_write.valid = 1;
            table_write.bank = i >= unit::power::words / 2;
            table_write.address = i;
            fragment.log = 0;
        }
        const material_t pending = random_material(random);
        const auto values = random_values<typename unit::values_t>(random);
        put(file, fragment);
        put_colour(file, values);
        file.word(values.depth.to_int(), depth_bits);
        for (const auto& log : values.log) file.word(log.to_int(), unit::log_t::width);
        put_colour(file, pending);
        file.word(pending.power.to_int(), max_log_channels);
        file.word(table_write.valid.to_int(), 1).word(table_write.bank.to_int(), 1);
        file.word(table_write.address.to_int(), power_word_bits).word(table_write.data.to_int64(), word_bits);
        file.word(state.material_applied.to_int(), 1).word(state.table_applied.to_int(), 1);
        put(file, state.fragment);
        put_colour(file, state);
        file.word(state.depth.to_int(), depth_bits).end_vector();

        typename unit::reads_t reads;
        for (int k = 0; k < log_channels; ++k) reads.word[k] = memory[state.tables[k].power_state.address.to_uint()];
        state = unit::step(state, fragment, values, pending, reads);
        if (table_write.valid != 0) memory[unit::power::place(table_write).to_uint()] = table_write.data;
    }
    file.close();
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        for (const int stall_percent : {0, 50}) {
            write<1, false>(options, stall_percent);
            write<2, false>(options, stall_percent);
            write<3, false>(options, stall_percent);
            write<1, true>(options, stall_percent);
            write<2, true>(options, stall_percent);
            write<3, true>(options, stall_percent);
        }
    });
}
