// SPDX-License-Identifier: MIT
/// \file
/// line_interpolator: exact accumulation, ra, enable, the error bound against double, and the printed errata.
#include "sheen/hls/line_interpolator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>

#include "sheen/hls/formats.hpp"

namespace {

using sheen::hls::line_interpolator;

constexpr unsigned seed = 20260702U;

/// The low `bits` bits of a word, as a signed number: what a register of that width holds.
std::int64_t wrap(std::uint64_t word, int bits) {
    const int unused = 64 - bits;
    return static_cast<std::int64_t>(word << unused) >> unused;
}

/// Rounds down to a multiple of 2^shift and counts in it: floor(value / 2^shift), without a shift of a negative number.
std::int64_t floor_divide(std::int64_t value, int shift) {
    return static_cast<std::int64_t>(std::floor(static_cast<double>(value) / std::exp2(shift)));
}

template <int phase_bits, int ra_bits>
void expect_closed_form(int spans) {
    using unit = line_interpolator<phase_bits, ra_bits>;
    SCOPED_TRACE(testing::Message() << "phase_bits " << phase_bits << ", ra_bits " << ra_bits << ", seed " << seed);
    std::mt19937_64 random(seed);
    typename unit::angle_t phase = 0;
    for (int span = 0; span < spans; ++span) {
        const std::int64_t sxsb = wrap(random(), phase_bits);
        const std::int64_t s = wrap(random(), phase_bits);
        const int length = 1 + static_cast<int>(random() % 300);
        for (int x = 0; x < length; ++x) {
            while (random() % 4 == 0) {  // a pause with noise at the inputs
                const std::int64_t noise = wrap(random(), phase_bits);
                const auto out = unit::step(phase, {random() % 2 == 0, 0, noise, noise});
                ASSERT_EQ(out.phase.to_int64(), phase.to_int64()) << "paused before pixel " << x << " of span " << span;
                ASSERT_EQ(out.ra_valid.to_int(), 0);
            }
            const auto out = unit::step(phase, {x == 0, 1, sxsb, s});
            const std::int64_t expected =
                wrap(static_cast<std::uint64_t>(sxsb) + static_cast<std::uint64_t>(x) * static_cast<std::uint64_t>(s),
                     phase_bits);
            ASSERT_EQ(out.phase.to_int64(), expected) << "pixel " << x << " of span " << span;
            ASSERT_EQ(out.ra.to_int64(), floor_divide(expected, phase_bits - ra_bits)) << "pixel " << x;
            ASSERT_EQ(out.ra_valid.to_int(), 1);
            phase = out.phase;
        }
    }
}

TEST(line_interpolator, holds_sxsb_plus_x_times_s_at_every_pixel_whatever_the_pauses) {
    expect_closed_form<4, 2>(100);
    expect_closed_form<12, 6>(200);
    expect_closed_form<22, 12>(200);
    expect_closed_form<32, 32>(200);
    expect_closed_form<40, 8>(200);
}

/// The largest distance of ξ(X) from s·X + b in double over random spans, in units of the angle's last place.
template <int phase_bits, int wrap_bits>
double largest_error(int pixels) {
    using unit = line_interpolator<phase_bits, 4>;
    const double one = std::exp2(phase_bits - 1 - wrap_bits);  // a quadrant
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> angle(-0.99, 0.99);
    double worst = 0.0;
    for (int span = 0; span < 200; ++span) {
        const double first = angle(random);
        const double step = (angle(random) - first) / pixels;
        const auto s = static_cast<std::int64_t>(std::llround(step * one));
        const auto sxsb = static_cast<std::int64_t>(std::llround(first * one));
        typename unit::angle_t phase = 0;
        for (int x = 0; x < pixels; ++x) {
            phase = unit::step(phase, {x == 0, 1, sxsb, s}).phase;
            const double turn = std::exp2(phase_bits);
            worst = std::max(worst, std::abs(std::remainder(phase.to_double() - (first + x * step) * one, turn)));
        }
    }
    return worst;
}

template <int phase_bits, int wrap_bits>
void expect_bounded(int pixels) {
    const double bound = 0.5 * pixels;  // ½ from rounding b and ½ a step from rounding s
    const double measured = largest_error<phase_bits, wrap_bits>(pixels);
    std::printf("line_interpolator: phase s%d.%d, %4d px: bound %.1f LSB, measured %.3f LSB\n", 1 + wrap_bits,
                phase_bits - 1 - wrap_bits, pixels, bound, measured);
    EXPECT_LE(measured, bound);
    EXPECT_GE(measured, 0.8 * bound) << "the bound should be near what happens";
}

TEST(line_interpolator, strays_from_the_real_line_by_half_an_lsb_a_pixel_at_most) {
    expect_bounded<12, 0>(16);
    expect_bounded<12, 0>(512);
    expect_bounded<20, 3>(512);
    expect_bounded<22, 3>(512);
    expect_bounded<32, 5>(1024);
}

TEST(line_interpolator, twelve_bits_drift_by_addresses_over_512_pixels_and_twenty_two_do_not) {
    constexpr int paper_bits = sheen::hls::paper_phase_bits;
    const double paper_address = std::exp2(paper_bits - sheen::hls::paper_rom_address_bits);
    const double paper_drift = largest_error<paper_bits, 0>(512) / paper_address;
    const double drift = largest_error<22, 3>(512) / std::exp2(22 - 12);  // ra of the folded 8×8 table: 12 bits
    std::printf("line_interpolator: drift over 512 px: 12 bits %.2f, 22 bits %.2f ROM addresses\n", paper_drift, drift);
    EXPECT_GT(paper_drift, 3.0);
    EXPECT_LT(drift, 0.5);
}

TEST(line_interpolator, erratum_the_increment_is_s_not_b) {
    using unit = line_interpolator<12, 6>;
    const unit::angle_t b = 1000;
    const unit::angle_t s = -3;
    const unit::angle_t first = unit::step(0, {1, 1, b, s}).phase;
    EXPECT_EQ(unit::step(first, {0, 1, b, s}).phase.to_int(), 997) << "figure 12's text adds b and would give 2000";
}

TEST(line_interpolator, erratum_ra_has_the_roms_six_bits_not_the_registers_twelve) {
    using unit = line_interpolator<sheen::hls::paper_phase_bits, sheen::hls::paper_rom_address_bits>;
    EXPECT_EQ(int{unit::ra_t::width}, 6);
    EXPECT_EQ(unit::step(0, {1, 1, 0x7ff, 0}).ra.to_int(), 31);
    EXPECT_EQ(unit::step(0, {1, 1, -1, 0}).ra.to_int(), -1);
    EXPECT_EQ(unit::step(0, {1, 1, 0x03f, 0}).ra.to_int(), 0) << "the bin that the angle lies in: rounded down";
}

TEST(line_interpolator, init_acts_only_together_with_step) {
    using unit = line_interpolator<12, 6>;
    const auto out = unit::step(77, {1, 0, 500, 3});
    EXPECT_EQ(out.phase.to_int(), 77);
    EXPECT_EQ(out.ra_valid.to_int(), 0);
}

}  // namespace
