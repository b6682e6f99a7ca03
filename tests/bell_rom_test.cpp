// SPDX-License-Identifier: MIT
/// \file
/// bell_rom: its tables against std::cos and std::pow, the error bound over every angle, symmetry, the zero outside,
/// folding, and latency.
#include "sheen/hls/bell_rom.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>

#include "sheen/hls/formats.hpp"

namespace {

using sheen::hls::bell_rom;

constexpr double half_pi = 1.57079632679489661923;
constexpr unsigned seed = 20260703U;

/// cos^p ξ inside |ξ| < π/2, else 0 (eq. 19); ξ in quadrants.
double bell(double quadrants, double p) {
    return std::abs(quadrants) < 1.0 ? std::pow(std::cos(quadrants * half_pi), p) : 0.0;
}

/// The value that the unit gives for an ra, `latency` clocks later.
template <typename unit>
typename unit::value_t value_of(typename unit::ra_t ra) {
    typename unit::state_t state = unit::step({}, {ra, 1});
    for (int clock = 1; clock < unit::latency; ++clock) {
        state = unit::step(state, {});
    }
    EXPECT_EQ(state.value_valid.to_int(), 1);
    return state.value;
}

template <int quadrant_bits, int data_bits, int exponent_tenths>
void expect_rounded_bin_centres() {
    constexpr auto& table = sheen::hls::bell_table<quadrant_bits, data_bits, exponent_tenths>;
    const double full_scale = std::exp2(data_bits) - 1.0;
    double worst = 0.0;
    for (std::size_t bin = 0; bin < table.size(); ++bin) {
        const double centre = (static_cast<double>(bin) + 0.5) / static_cast<double>(table.size());
        const double exact = full_scale * bell(centre, exponent_tenths / 10.0);
        ASSERT_EQ(table[bin], std::lround(exact)) << "bin " << bin << " of " << table.size() << ", " << exact;
        worst = std::max(worst, std::abs(table[bin] - exact));
    }
    EXPECT_LE(worst, 0.5);
    std::printf("bell_rom: cos^%.1f, %4zu bins a quadrant, %2d bits: at bin centres bound 0.5 LSB, measured %.3f LSB\n",
                exponent_tenths / 10.0, table.size(), data_bits, worst);
}

TEST(bell_rom, tables_are_cosine_powers_rounded_at_bin_centres) {
    expect_rounded_bin_centres<5, 6, 20>();
    expect_rounded_bin_centres<5, 6, 10>();
    expect_rounded_bin_centres<3, 4, 20>();
    expect_rounded_bin_centres<8, 8, 95>();
    expect_rounded_bin_centres<8, 8, 10>();
    expect_rounded_bin_centres<1, 1, 10>();
    expect_rounded_bin_centres<7, 8, 35>();
    expect_rounded_bin_centres<10, 12, 60>();
    expect_rounded_bin_centres<10, 16, 1000>();
    expect_rounded_bin_centres<12, 16, 20>();
}

/// Every ra, at both ends of its bin and 32 angles between, against cos^p in double.
template <typename unit>
double largest_error(int data_bits, int wrap_bits, double p) {
    const double full_scale = std::exp2(data_bits) - 1.0;
    const double bins = std::exp2(unit::quadrant_bits);
    const int angles = 1 << (wrap_bits + 1 + unit::quadrant_bits);
    double worst = 0.0;
    for (int ra = -angles / 2; ra < angles / 2; ++ra) {
        const double value = value_of<unit>(ra).to_double();
        for (int i = 0; i <= 32; ++i) {
            const double exact = full_scale * bell((ra + i / 32.0) / bins, p);
            worst = std::max(worst, std::abs(value - exact));
        }
    }
    return worst;
}

template <int address_bits, int data_bits, int exponent_tenths, int wrap_bits, bool folded>
void expect_bounded() {
    using unit = bell_rom<address_bits, data_bits, exponent_tenths, wrap_bits, folded>;
    const double p = exponent_tenths / 10.0;
    const double slope = std::sqrt(p) * std::pow((p - 1.0) / p, (p - 1.0) / 2.0);
    const double bound = 0.5 + (std::exp2(data_bits) - 1.0) * slope * (half_pi / 2.0) / std::exp2(unit::quadrant_bits);
    const double measured = largest_error<unit>(data_bits, wrap_bits, p);
    std::printf("bell_rom: cos^%.1f, %dx%d%s, %d wrap bits: over all angles bound %.3f LSB, measured %.3f LSB\n", p,
                address_bits, data_bits, folded ? " folded" : "", wrap_bits, bound, measured);
    EXPECT_LE(measured, bound);
    EXPECT_GE(measured, 0.6 * bound) << "the bound should be near what happens";
}

TEST(bell_rom, strays_from_the_bell_by_half_an_lsb_and_half_a_bin_at_most) {
    expect_bounded<6, 6, 20, 0, false>();
    expect_bounded<6, 6, 10, 0, false>();
    expect_bounded<4, 4, 20, 0, false>();
    expect_bounded<6, 6, 20, 3, true>();
    expect_bounded<8, 8, 95, 3, true>();
    expect_bounded<8, 8, 10, 5, true>();
    expect_bounded<10, 12, 60, 1, true>();
}

template <int quadrant_bits, int data_bits, int exponent_tenths, int wrap_bits>
void expect_folding_changes_nothing() {
    using whole = bell_rom<quadrant_bits + 1, data_bits, exponent_tenths, wrap_bits, false>;
    using half = bell_rom<quadrant_bits, data_bits, exponent_tenths, wrap_bits, true>;
    for (int pattern = 0; pattern < (1 << whole::ra_bits); ++pattern) {
        const typename whole::ra_t ra = pattern;
        const typename whole::ra_t mirrored = ~ra;
        const int value = value_of<whole>(ra).to_int();
        ASSERT_EQ(value_of<half>(ra).to_int(), value) << "ra " << ra;
        ASSERT_EQ(value_of<whole>(mirrored).to_int(), value) << "the bell is even: ra " << ra;
        const int bin = std::max(ra.to_int(), mirrored.to_int());  // of the positive side
        if (bin >= (1 << quadrant_bits)) {
            ASSERT_EQ(value, 0) << "outside: ra " << ra;
        } else if (bin > 0) {
            ASSERT_LE(value, value_of<whole>(bin - 1).to_int()) << "the bell falls: ra " << ra;
        }
    }
}

TEST(bell_rom, is_even_falls_to_both_sides_is_zero_outside_and_folds_without_a_trace) {
    expect_folding_changes_nothing<5, 6, 20, 0>();
    expect_folding_changes_nothing<3, 4, 10, 2>();
    expect_folding_changes_nothing<7, 8, 95, 4>();
}

TEST(bell_rom, without_wrap_bits_an_angle_past_the_quadrant_comes_round_again) {
    using unit = bell_rom<6, 6, 20, 0, false>;
    using wrapped = bell_rom<6, 6, 20, 1, false>;
    const int past = 32 + 8;  // a quarter of a quadrant too far
    EXPECT_EQ(value_of<unit>(past).to_int(), value_of<unit>(past - 64).to_int());
    EXPECT_GT(value_of<unit>(past).to_int(), 0);
    EXPECT_EQ(value_of<wrapped>(past).to_int(), 0);
}

TEST(bell_rom, the_papers_rom_stores_384_bits) {
    constexpr auto& rom =
        sheen::hls::whole_bell_table<sheen::hls::paper_rom_address_bits - 1, sheen::hls::paper_rom_data_bits, 20>;
    EXPECT_EQ(static_cast<int>(rom.size()) * sheen::hls::paper_rom_data_bits, 384);
    EXPECT_EQ(rom[0], 63);
    EXPECT_EQ(rom[63], 63);
    EXPECT_EQ(*std::max_element(rom.begin(), rom.end()), 63) << "an entry fits its six bits";
}

TEST(bell_rom, one_angle_a_clock_comes_out_in_order_after_its_latency) {
    using unit = bell_rom<8, 8, 95, 3, true>;
    std::mt19937 random(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    typename unit::input_t history[unit::latency] = {};
    typename unit::state_t state;
    for (int clock = 0; clock < 2000; ++clock) {
        const typename unit::input_t in = {static_cast<int>(random() % 600) - 300, random() % 2 == 0};
        std::copy_backward(history, history + unit::latency - 1, history + unit::latency);
        history[0] = in;
        state = unit::step(state, in);
        const typename unit::input_t due = history[unit::latency - 1];
        ASSERT_EQ(state.value_valid.to_int(), due.ra_valid.to_int()) << "clock " << clock;
        if (due.ra_valid != 0) {
            ASSERT_EQ(state.value.to_int(), value_of<unit>(due.ra).to_int()) << "clock " << clock;
        }
    }
}

}  // namespace
