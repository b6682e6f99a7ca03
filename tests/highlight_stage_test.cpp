// SPDX-License-Identifier: MIT
/// \file
/// highlight_stage: colours against sums in plain arithmetic, triangles without log channels, materials and tables that
/// keep their place among the pixels, messages, latency; for 1 to 3 log channels, with and without power tables.
#include "sheen/hls/highlight_stage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>

#include "support/expected_pixels.hpp"
#include "support/highlight_bench.hpp"

namespace {

using namespace sheen::hls;
using sheen::test::has_power_of;
using sheen::test::HighlightBench;
using sheen::test::HighlightInput;
using sheen::test::HighlightSource;
using sheen::test::Lighting;
using sheen::test::log_channels_of;
using sheen::test::message_of;
using sheen::test::parts;
using sheen::test::Rng;

constexpr std::uint64_t seed = 20261122U;

/// Calls visit(a stage) for every configuration.
template <typename Visit>
void for_each_stage(Visit visit) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    visit(highlight_stage<1, false>{});
    visit(highlight_stage<2, false>{});
    visit(highlight_stage<3, false>{});
    visit(highlight_stage<1, true>{});
    visit(highlight_stage<2, true>{});
    visit(highlight_stage<3, true>{});
}

/// A channel word whose upper bits the stage gets, the lower ones 0.
std::uint32_t channel_word(int cut, int fraction_bits) { return static_cast<std::uint32_t>(cut) << fraction_bits; }

/// The 8-bit components of a pixel of a triangle with so many log channels.
template <typename stage>
std::array<int, 3> expected_components(const typename stage::values_t& values, int log_channels,
                                       const Lighting& lighting) {
    int highlights = 0;
    for (int k = 0; k < log_channels; ++k) {
        highlights += lighting.highlight(static_cast<std::size_t>(k), channel_word(values.log[k].to_int(), 18));
    }
    const auto component = [&](std::size_t c, int diffuse) {
        const std::uint32_t word = channel_word(diffuse, colour_fraction_bits - colour_sum_fraction_bits);
        return log_channels == 0 ? sheen::test::component(word) : lighting.component(c, word, highlights);
    };
    return {component(0, values.red.to_int()), component(1, values.green.to_int()), component(2, values.blue.to_int())};
}

/// What the colour stage makes of an output: it saturates.
template <typename stage>
std::array<int, 3> components_of(const typename stage::state_t& state) {
    const auto component = [](const typename stage::integer_t& integer) {
        const int value = integer.to_int();
        EXPECT_LT(value, 512) << "an s10.0 that is never negative";
        return std::min(value, 255);
    };
    return {component(state.red), component(state.green), component(state.blue)};
}

bool same_fragment(const fragment_t& a, const fragment_t& b) {
    return a.valid == b.valid && a.message == b.message && a.query == b.query && a.log == b.log && a.x == b.x &&
           a.y == b.y && a.tail == b.tail;
}

/// What an input must have become, `latency` clocks later.
struct Expected {
    fragment_t fragment;
    std::array<int, 3> components{};
    int depth = 0;
};

TEST(highlight_stage, every_pixel_is_the_sum_of_the_material_and_table_before_it_after_4_and_L_clocks) {
    for_each_stage([](auto configured) {
        using stage = decltype(configured);
        Rng rng(seed);
        HighlightBench<stage> bench;
        Lighting lighting;
        HighlightSource<stage> source(rng);
        std::deque<Expected> under_way(4 + log_channels_of<stage> - 1);
        for (int clock = 0; clock < 20000; ++clock) {
            const int materials = source.materials;
            const int tables = source.tables;
            const Lighting before = lighting;
            const HighlightInput<stage> input = source.next(lighting);
            const bool material = source.materials > materials;
            const bool table = source.tables > tables;
            Expected expected;
            expected.fragment = input.fragment;
            if (material || table) expected.fragment.valid = 0;
            const bool pixel = input.fragment.valid != 0 && input.fragment.message == 0;
            const int log = pixel ? input.fragment.log.to_int() : 0;
            expected.components = expected_components<stage>(input.values, log, before);
            expected.depth = input.values.depth.to_int();
            under_way.push_back(expected);

            const typename stage::state_t& state = bench.clock(input);
            ASSERT_EQ(state.material_applied != 0, material) << "clock " << clock;
            ASSERT_EQ(state.table_applied != 0, table) << "clock " << clock;
            const Expected out = under_way.front();
            under_way.pop_front();
            ASSERT_EQ(state.fragment.valid, out.fragment.valid) << "clock " << clock;
            if (out.fragment.valid == 0) continue;
            ASSERT_TRUE(same_fragment(state.fragment, out.fragment)) << "clock " << clock;
            if (out.fragment.message != 0) continue;
            ASSERT_EQ(components_of<stage>(state), out.components) << "clock " << clock;
            ASSERT_EQ(state.depth.to_int(), out.depth) << "clock " << clock;
        }
        ASSERT_GT(source.materials, 500) << "materials taken over";
        ASSERT_TRUE(!has_power_of<stage> || source.tables > 50) << source.tables << " tables taken over";
    });
}

/// The stage's output for one pixel after a message that takes the material over.
template <typename stage>
typename stage::state_t pixel_of(const HighlightInput<stage>& input, const material_t& material) {
    Rng rng(seed);
    HighlightBench<stage> bench;
    HighlightInput<stage> before;
    before.fragment = message_of(rng, opcode_material, 0);
    before.pending = material;
    bench.clock(before);
    bench.clock(input);
    for (int clock = 2; clock < stage::latency; ++clock) bench.clock({});
    return bench.clock({});
}

TEST(highlight_stage, a_triangle_without_log_channels_passes_at_every_colour) {
    for_each_stage([](auto configured) {
        using stage = decltype(configured);
        material_t material;
        material.red = material.green = material.blue = 256 * parts - 1;
        for (int colour = -512 * parts; colour < 512 * parts; ++colour) {
            HighlightInput<stage> input;
            input.fragment.valid = 1;
            input.values.red = colour;
            input.values.green = -1 - colour;
            input.values.blue = colour ^ 5;
            const typename stage::state_t state = pixel_of<stage>(input, material);
            ASSERT_EQ(state.red.to_int(), std::max(colour, 0) / parts);
            ASSERT_EQ(state.green.to_int(), std::max(-1 - colour, 0) / parts);
            ASSERT_EQ(state.blue.to_int(), std::max(colour ^ 5, 0) / parts);
        }
    });
}

TEST(highlight_stage, the_greatest_sum_saturates_and_a_dark_side_keeps_ambient_and_highlights) {
    for_each_stage([](auto configured) {
        using stage = decltype(configured);
        material_t material;
        material.red = material.green = 256 * parts - 1;
        HighlightInput<stage> input;
        input.fragment.valid = 1;
        input.fragment.log = log_channels_of<stage>;
        for (auto& log : input.values.log) log = 3 * 64;  // 2^(8 − 3), rounded at the centre of its bin
        input.values.red = 512 * parts - 1;
        input.values.green = -512 * parts;
        input.values.blue = -1;
        const typename stage::state_t state = pixel_of<stage>(input, material);
        const int highlight = parts * 255 / 8;
        EXPECT_GE(state.red.to_int(), 256) << "colour_stage makes 255 of it";
        EXPECT_LT(state.red.to_int(), 512) << "it is not negative";
        EXPECT_EQ(state.green.to_int(), (256 * parts - 1 + log_channels_of<stage> * highlight) / parts);
        EXPECT_EQ(state.blue.to_int(), log_channels_of<stage> * highlight / parts) << "no ambient, no diffuse";
    });
}

}  // namespace
