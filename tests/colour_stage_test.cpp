// SPDX-License-Identifier: MIT
/// \file
/// colour_stage: saturation of every integer part, the pixel's fields, messages, and the pixel that no image holds.
#include "sheen/hls/colour_stage.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sheen/packet.hpp"

namespace {

using namespace sheen::hls;

using stage = colour_stage<colour_value_t, depth_value_t>;

/// A colour with the given integer part, −512…511, and fraction bits.
template <typename colour_t = colour_value_t>
colour_t colour(int integer, unsigned fraction = 0) {
    constexpr int fraction_bits = colour_t::width - colour_integer_bits;
    colour_t value = 0;
    value.set_slc(0, ac_int<fraction_bits, false>(fraction));
    value.set_slc(fraction_bits, ac_int<colour_integer_bits, true>(integer));
    return value;
}

depth_value_t depth(std::uint32_t bits) {
    depth_value_t value = 0;
    value.set_slc(0, word_t(bits));
    return value;
}

core_description_t describe(const std::array<std::uint32_t, query_reply_words>& data) {
    return {{data[0], data[1], data[2], data[3]}};
}

/// The word that a fragment becomes two clocks later, if any.
template <typename Stage = stage>
std::optional<std::uint64_t> word_of(const fragment_t& fragment, const typename Stage::values_t& values,
                                     const core_description_t& description = describe({})) {
    typename Stage::state_t state = Stage::step({}, fragment, values, description);
    EXPECT_EQ(state.valid.to_int(), 0) << "a word after one clock";
    state = Stage::step(state, {}, {}, description);
    EXPECT_EQ(Stage::step(state, {}, {}, description).valid.to_int(), 0) << "a second word";
    if (state.valid == 0) return std::nullopt;
    EXPECT_EQ(state.fence != 0, fragment.message != 0 && fragment.query == 0 && fragment.tail.slc<2>(0) == 0);
    return state.word.to_uint64();
}

fragment_t pixel_at(int x, int y) { return {1, 0, 0, 0, x, y, 0}; }

/// A message as edge_walker sends it: the header cut into x, y and tail.
fragment_t message_fragment(std::uint32_t header, unsigned code) {
    const std::uint32_t opcode = header >> header_opcode_lsb;
    return {1, 1, 0, 0, header & 4095U, header >> coordinate_bits & 4095U, opcode << 4 | code};
}

template <typename colour_t>
void expect_every_integer_part_saturates() {
    using narrow = colour_stage<colour_t, depth_value_t>;
    for (int integer = -512; integer < 512; ++integer) {
        for (const unsigned fraction : {0U, 1U, ~0U}) {
            typename narrow::values_t values;
            values.red = colour<colour_t>(integer, fraction);
            values.green = colour<colour_t>(511 - (integer + 512), fraction);
            values.blue = colour<colour_t>(integer ^ 1, fraction);
            const auto word = word_of<narrow>(pixel_at(1, 2), values);
            ASSERT_TRUE(word);
            const sheen::Pixel pixel = sheen::decode_pixel(*word);
            ASSERT_EQ(pixel.red, std::clamp(integer, 0, 255)) << integer << ", fraction bits " << fraction;
            ASSERT_EQ(pixel.green, std::clamp(-1 - integer, 0, 255)) << integer << ", fraction bits " << fraction;
            ASSERT_EQ(pixel.blue, std::clamp(integer ^ 1, 0, 255)) << integer << ", fraction bits " << fraction;
        }
    }
}

TEST(colour_stage, every_integer_part_saturates_whatever_its_fraction) {
    expect_every_integer_part_saturates<colour_value_t>();
    expect_every_integer_part_saturates<ac_fixed<18, colour_integer_bits, true, AC_TRN, AC_WRAP>>();
}

RC_GTEST_PROP(colour_stage, fields_stand_where_the_host_reads_them, (std::uint32_t depth_bits_32, unsigned fraction)) {
    const int x = *rc::gen::inRange(0, message_x);
    const int y = *rc::gen::inRange(0, 4096);
    const int red = *rc::gen::inRange(0, 256);
    const int green = *rc::gen::inRange(0, 256);
    const int blue = *rc::gen::inRange(0, 256);
    stage::values_t values;
    values.red = colour(red, fraction);
    values.green = colour(green, fraction);
    values.blue = colour(blue, fraction);
    values.depth = depth(depth_bits_32);
    const auto word = word_of(pixel_at(x, y), values);
    RC_ASSERT(word.has_value());
    RC_ASSERT(!sheen::is_message(*word));
    RC_ASSERT(*word == sheen::encode_pixel({x, y, static_cast<int>(depth_bits_32 >> 16), red, green, blue}));
}

TEST(colour_stage, a_pixel_at_x_4095_is_dropped_and_its_neighbour_is_not) {
    for (const int y : {0, 1, 2, 4095}) {
        EXPECT_FALSE(word_of(pixel_at(message_x, y), {})) << y;
        EXPECT_TRUE(word_of(pixel_at(message_x - 1, y), {})) << y;
    }
}

TEST(colour_stage, a_fragment_that_is_not_valid_gives_no_word) {
    fragment_t fragment = pixel_at(5, 6);
    fragment.valid = 0;
    EXPECT_FALSE(word_of(fragment, {}));
    fragment = message_fragment(0x05000000U, 0);
    fragment.valid = 0;
    EXPECT_FALSE(word_of(fragment, {}));
}

RC_GTEST_PROP(colour_stage, errors_and_fence_echoes_bring_their_header_back, (std::uint32_t header)) {
    const auto code = *rc::gen::inRange(0U, 4U);
    const auto word = word_of(message_fragment(header, code), {colour(100), colour(100), colour(100), depth(~0U)});
    const std::uint64_t kind = code == 0 ? message_fence : message_error;
    RC_ASSERT(word.has_value());
    RC_ASSERT(*word == (std::uint64_t{header} << 32 | std::uint64_t{code} << 24 | kind << 12 | 4095U));
    RC_ASSERT(sheen::is_message(*word));
}

RC_GTEST_PROP(colour_stage, a_query_is_answered_by_the_cores_description,
              (std::array<std::uint32_t, query_reply_words> data, std::uint32_t y)) {
    for (unsigned index = 0; index < data.size(); ++index) {
        const auto word = word_of({1, 1, 1, 0, index, y, query_reply_words - index}, {}, describe(data));
        RC_ASSERT(word.has_value());
        RC_ASSERT(*word ==
                  (std::uint64_t{data[index]} << 32 | std::uint64_t{index} << 24 | message_query << 12 | 4095U));
    }
}

RC_GTEST_PROP(colour_stage, a_word_a_clock_in_order, (const std::vector<bool>& valid)) {
    stage::state_t state;
    for (std::size_t clock = 0; clock < valid.size() + 2; ++clock) {
        fragment_t fragment = pixel_at(static_cast<int>(clock), 3);
        fragment.valid = clock < valid.size() && valid[clock];
        stage::values_t values;
        values.green = colour(static_cast<int>(clock % 256));
        state = stage::step(state, fragment, values, describe({}));
        const bool expected = clock >= 1 && clock <= valid.size() && valid[clock - 1];
        RC_ASSERT((state.valid != 0) == expected);
        if (expected) {
            const sheen::Pixel pixel = sheen::decode_pixel(state.word.to_uint64());
            RC_ASSERT(pixel.x == static_cast<int>(clock - 1));
            RC_ASSERT(pixel.green == static_cast<int>((clock - 1) % 256));
        }
    }
}

}  // namespace
