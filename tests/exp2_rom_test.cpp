// SPDX-License-Identifier: MIT
/// \file
/// exp2_rom: its tables against std::exp2, the error bound over every z, the ends of its range, and latency.
#include "sheen/hls/exp2_rom.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace {

using sheen::hls::exp2_rom;

constexpr unsigned seed = 20261122U;

/// The value that the unit gives for a z, `latency` clocks later.
template <typename unit>
double value_of(int z) {
    typename unit::state_t state = unit::step({}, z);
    for (int clock = 1; clock < unit::latency; ++clock) state = unit::step(state, 0);
    return state.value.to_int() * std::exp2(8 - unit::value_bits);
}

template <int address_bits, int data_bits, int fraction_bits>
void expect_bounded() {
    using unit = exp2_rom<address_bits, data_bits, fraction_bits>;
    const double bins = std::exp2(address_bits);
    const double step = std::exp2(-fraction_bits);
    double worst = 0.0;
    for (int z = 0; z < (1 << (unit::z_bits - 1)); ++z) {
        const double octaves = z / bins;
        // A z stands for all of its bin; what comes out must be near every value there.
        const double highest = std::exp2(8.0 - octaves);
        const double lowest = std::exp2(8.0 - octaves - 1.0 / bins);
        const double value = value_of<unit>(z);
        const double scale = std::exp2(-std::floor(octaves));
        const double unit_of_table = std::exp2(8 - data_bits);
        // The greatest entry is 2^data_bits − 1, up to a unit below its bin's centre where a unit is more than a bin.
        const double bound = scale * (unit_of_table + 128.0 * std::log(2.0) / bins) + step;
        const double error = std::max(std::abs(value - highest), std::abs(value - lowest));
        ASSERT_LE(error, bound) << "z " << octaves;
        worst = std::max(worst, error);
    }
    std::printf("exp2_rom: %4.0f entries of %2d bits, %d fraction bits: measured %.3f 8-bit steps\n", bins, data_bits,
                fraction_bits, worst);
}

TEST(exp2_rom, is_within_its_bound_at_every_z) {
    expect_bounded<6, 8, 0>();
    expect_bounded<6, 8, 2>();
    expect_bounded<6, 10, 2>();
    expect_bounded<7, 10, 4>();
}

template <int address_bits, int data_bits>
void expect_rounded_bin_centres() {
    constexpr auto& table = sheen::hls::exp2_table<address_bits, data_bits>;
    for (std::size_t bin = 0; bin < table.size(); ++bin) {
        const double centre = (static_cast<double>(bin) + 0.5) / static_cast<double>(table.size());
        const double exact = std::exp2(data_bits - centre);
        ASSERT_EQ(table[bin], std::min(std::lround(exact), (1L << data_bits) - 1)) << "bin " << bin << ", " << exact;
    }
}

TEST(exp2_rom, tables_are_powers_of_two_rounded_at_bin_centres) {
    expect_rounded_bin_centres<6, 8>();
    expect_rounded_bin_centres<6, 10>();
    expect_rounded_bin_centres<7, 8>();
    expect_rounded_bin_centres<10, 12>();
    expect_rounded_bin_centres<1, 8>();
}

TEST(exp2_rom, below_zero_is_the_peak_and_far_above_is_nothing) {
    using unit = exp2_rom<6, 10, 2>;
    const double peak = value_of<unit>(0);
    double before = peak;
    for (int z = -(1 << (unit::z_bits - 1)); z < 0; z += 7) ASSERT_EQ(value_of<unit>(z), peak) << "z " << z;
    for (int z = 0; z < (1 << (unit::z_bits - 1)); ++z) {
        const double value = value_of<unit>(z);
        ASSERT_LE(value, before) << "a highlight falls: z " << z;
        if (z >= 11 * 64) {
            ASSERT_EQ(value, 0.0) << "nothing is left: z " << z;
        }
        before = value;
    }
}

TEST(exp2_rom, one_z_a_clock_comes_out_in_order_after_its_latency) {
    using unit = exp2_rom<7, 10, 4>;
    std::mt19937 random(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    int history[unit::latency] = {};
    typename unit::state_t state;
    for (int clock = 0; clock < 2000; ++clock) {
        std::copy_backward(history, history + unit::latency - 1, history + unit::latency);
        history[0] = static_cast<int>(random() % 3000) - 300;
        state = unit::step(state, history[0]);
        if (clock >= unit::latency) {
            ASSERT_EQ(state.value.to_int() / 16.0, value_of<unit>(history[unit::latency - 1])) << "clock " << clock;
        }
    }
}

}  // namespace
