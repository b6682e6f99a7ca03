// SPDX-License-Identifier: MIT
/// \file
/// select(c, a, b) equals c ? a : b, for every bit pattern of narrow types and random ones of wide types.
#include "sheen/hls/select.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using sheen::hls::select;

constexpr unsigned seed = 20260701U;

/// A value of W random bits.
template <typename Value, int W>
Value random_bits(std::mt19937& random) {
    Value value = 0;
    for (int lsb = 0; lsb < W; ++lsb) {
        value.set_slc(lsb, ac_int<1, false>(random() & 1U));
    }
    return value;
}

template <typename Value, int W>
void expect_choice(int cases) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", width " << W);
    std::mt19937 random(seed);
    for (int i = 0; i < cases; ++i) {
        const Value a = random_bits<Value, W>(random);
        const Value b = random_bits<Value, W>(random);
        ASSERT_TRUE(select(true, a, b) == a) << "a " << a << ", b " << b;
        ASSERT_TRUE(select(false, a, b) == b) << "a " << a << ", b " << b;
    }
}

template <bool S>
void expect_every_pair_of_four_bits() {
    for (int i = 0; i < 16; ++i) {
        for (int j = 0; j < 16; ++j) {
            const ac_int<4, S> a = i;
            const ac_int<4, S> b = j;
            ASSERT_EQ(select(true, a, b).to_int(), a.to_int()) << i << " " << j;
            ASSERT_EQ(select(false, a, b).to_int(), b.to_int()) << i << " " << j;
        }
    }
}

TEST(select, chooses_the_first_when_set_and_the_second_when_clear_for_every_pair) {
    expect_every_pair_of_four_bits<false>();
    expect_every_pair_of_four_bits<true>();
}

TEST(select, holds_at_every_word_boundary) {
    expect_choice<ac_int<1, false>, 1>(100);
    expect_choice<ac_int<1, true>, 1>(100);
    expect_choice<ac_int<31, true>, 31>(500);
    expect_choice<ac_int<32, false>, 32>(500);
    expect_choice<ac_int<32, true>, 32>(500);
    expect_choice<ac_int<33, false>, 33>(500);
    expect_choice<ac_int<64, false>, 64>(500);
    expect_choice<ac_int<65, true>, 65>(500);
    expect_choice<ac_int<200, false>, 200>(500);
}

TEST(select, keeps_fixed_point_bits_and_format) {
    expect_choice<ac_fixed<32, 10, true>, 32>(500);
    expect_choice<ac_fixed<32, 16, false>, 32>(500);
    expect_choice<ac_fixed<40, 8, true>, 40>(500);
    expect_choice<ac_fixed<12, -3, false, AC_RND, AC_SAT>, 12>(500);
}

TEST(select, takes_a_one_bit_result_as_its_condition) {
    const ac_int<12, false> x = 2049;
    const ac_int<12, false> b = 7;
    EXPECT_EQ(select(x.slc<1>(11), x, b).to_int(), 2049);
    EXPECT_EQ(select(x.slc<1>(10), x, b).to_int(), 7);
    EXPECT_EQ(select(x == 2049, x, b).to_int(), 2049);
}

}  // namespace
