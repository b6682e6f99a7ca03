// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_power_rom OUTDIR [seed] [count]: vectors of tb_power_rom, from the kernel.
///
/// A vector is a clock: write {valid, bank, address, data}, bank, t; whether the value that t brings is known, and that
/// value. Both banks are loaded first; then words are written at random, also where they are read.
#include <random>
#include <vector>

#include "sheen/hls/power_rom.hpp"
#include "vector_file.hpp"

namespace {

using sheen::test::VectorFile;
using sheen::test::VectorOptions;

template <int address_bits, int fraction_bits>
void write(const VectorOptions& options) {
    using unit = sheen::hls::power_rom<address_bits, fraction_bits>;
    struct Clock {
        sheen::hls::table_write_t write;
        sheen::hls::bit_t bank;
        typename unit::t_t t;
    };
    VectorFile file(options, "power_rom",
                    "address_bits=" + std::to_string(address_bits) + ",fraction_bits=" + std::to_string(fraction_bits));
    std::mt19937 random(options.seed);
    std::vector<sheen::hls::word_t> memory(unit::words, 0);
    std::vector<Clock> clocks;
    std::vector<int> values;
    typename unit::state_t state;
    // As many clocks more as the last value takes to come out.
    for (int i = 0; i < options.count + unit::latency - 1; ++i) {
        Clock clock;
        const bool loading = i < unit::words;
        clock.write.valid = loading || random() % 4 == 0;
        clock.write.bank = loading ? i >= unit::words / 2 : random() % 2 != 0;
        clock.write.address = loading ? i : static_cast<int>(random());
        clock.write.data = random();
        clock.bank = random() % 2;
        // Mostly near and inside the table.
        const int spread = random() % 4 == 0 ? static_cast<int>(random()) : static_cast<int>(random() % 1200) - 80;
        clock.t = spread;
        const sheen::hls::word_t read = memory[state.address.to_uint()];
        state = unit::step(state, clock.t, clock.bank, read);
        if (clock.write.valid != 0) memory[unit::place(clock.write).to_uint()] = clock.write.data;
        clocks.push_back(clock);
        values.push_back(state.value.to_int());
    }
    for (int i = 0; i < options.count; ++i) {
        const Clock& clock = clocks[static_cast<std::size_t>(i)];
        file.word(clock.write.valid.to_int(), 1)
            .word(clock.write.bank.to_int(), 1)
            .word(clock.write.address.to_int(), unit::word_address_bits)
            .word(clock.write.data.to_int64(), 32)
            .word(clock.bank.to_int(), 1)
            .word(clock.t.to_int(), unit::t_bits)
            .word(i >= unit::words ? 1 : 0, 1)
            .word(values[static_cast<std::size_t>(i + unit::latency - 1)], 8 + fraction_bits)
            .end_vector();
    }
    file.close();
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        write<10, 0>(options);
        write<10, 4>(options);
        write<7, 2>(options);
    });
}
