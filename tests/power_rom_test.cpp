// SPDX-License-Identifier: MIT
/// \file
/// power_rom: which entry an argument reads, both ends of its range, banks that don't disturb each other, latency.
#include "sheen/hls/power_rom.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using unit = sheen::hls::power_rom<10, 2>;
constexpr unsigned seed = 20261122U;
constexpr int entries = 1024;

/// The unit with its memory, a clock at a time.
class Rom {
 public:
    void load(int bank, const std::vector<int>& table) {
        for (int word = 0; word < entries / 4; ++word) {
            sheen::hls::table_write_t write;
            write.valid = 1;
            write.bank = bank;
            write.address = word;
            const auto first = static_cast<std::size_t>(4 * word);
            write.data = static_cast<unsigned>(table[first] | table[first + 1] << 8 | table[first + 2] << 16) |
                         static_cast<unsigned>(table[first + 3]) << 24;
            clock(0, 0, write);
        }
    }
    /// The entry that t brings, `latency` clocks later, with its fraction.
    int clock(int t, int bank, const sheen::hls::table_write_t& write = {}) {
        const sheen::hls::word_t read = memory_[state_.address.to_uint()];
        state_ = unit::step(state_, t, bank, read);
        if (write.valid != 0) memory_[unit::place(write).to_uint()] = write.data;
        return state_.value.to_int();
    }
    int value(int t, int bank) {
        for (int i = 1; i < unit::latency; ++i) clock(t, bank);
        return clock(t, bank);
    }

 private:
    unit::state_t state_;
    std::vector<sheen::hls::word_t> memory_ = std::vector<sheen::hls::word_t>(unit::words, 0);
};

std::vector<int> random_table(std::mt19937& random) {
    std::vector<int> table(entries);
    std::generate(table.begin(), table.end(), [&] { return static_cast<int>(random() % 256); });
    return table;
}

TEST(power_rom, every_argument_reads_its_entry_and_the_ends_hold) {
    std::mt19937 random(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const std::vector<int> table = random_table(random);
    Rom rom;
    rom.load(1, table);
    const int all = 1 << unit::t_bits;
    for (int t = -all / 2; t < all / 2; ++t) {
        const double cosine = t / std::exp2(unit::t_fraction_bits) / 16.0;
        const auto entry = static_cast<std::size_t>(std::clamp(std::floor(cosine * entries), 0.0, entries - 1.0));
        ASSERT_EQ(rom.value(t, 1), 4 * table[entry]) << "cosine " << cosine;
    }
}

TEST(power_rom, loading_a_bank_leaves_the_other_alone) {
    std::mt19937 random(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const std::vector<int> first = random_table(random);
    const std::vector<int> second = random_table(random);
    Rom rom;
    rom.load(0, first);
    rom.load(1, second);
    for (int entry = 0; entry < entries; ++entry) {
        ASSERT_EQ(rom.value(entry, 0), 4 * first[static_cast<std::size_t>(entry)]);
        ASSERT_EQ(rom.value(entry, 1), 4 * second[static_cast<std::size_t>(entry)]);
    }
}

TEST(power_rom, one_argument_a_clock_comes_out_in_order_after_its_latency) {
    std::mt19937 random(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const std::vector<int> table = random_table(random);
    Rom rom;
    rom.load(0, table);
    std::vector<int> asked;
    for (int clock = 0; clock < 2000; ++clock) {
        asked.push_back(static_cast<int>(random() % entries));
        const int value = rom.clock(asked.back(), 0);
        if (clock >= unit::latency) {
            const int t = asked[asked.size() - unit::latency];
            ASSERT_EQ(value, 4 * table[static_cast<std::size_t>(t)]) << "clock " << clock;
        }
    }
}

}  // namespace
