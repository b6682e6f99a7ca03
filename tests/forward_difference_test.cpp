// SPDX-License-Identifier: MIT
/// \file
/// forward_difference: every path of steps holds the closed form of contract 1 exactly, for any six words.
#include "sheen/hls/forward_difference.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "sheen/polynomial.hpp"

namespace {

using namespace sheen::hls;

using Words = std::array<std::uint32_t, 6>;

/// One row of a walk along the start edge: the carries before it, and the pixels of its span.
struct Row {
    int carries;
    int pixels;
};

rc::Gen<std::vector<Row>> paths() {
    return rc::gen::container<std::vector<Row>>(rc::gen::map(
        rc::gen::pair(rc::gen::inRange(0, 4), rc::gen::inRange(0, 40)), [](const std::pair<int, int>& drawn) {
            return Row{drawn.first, drawn.second};
        }));
}

/// C(n, 2), for n ≥ 0.
std::uint64_t choose_two(std::uint64_t n) { return n * (n - 1) / 2; }

/// I + u·D + j·E + C(u,2)·h + u·j·dD + C(j,2)·dE modulo 2^width, any width up to 32.
std::uint64_t closed_form(const Words& w, std::uint64_t u, std::uint64_t j, int width) {
    const std::uint64_t sum = w[0] + u * w[1] + j * w[2] + choose_two(u) * w[3] + u * j * w[4] + choose_two(j) * w[5];
    return sum & ((std::uint64_t{1} << width) - 1);
}

Words without_second_order(const Words& w) { return {w[0], w[1], w[2], 0, 0, 0}; }

template <int width>
using colour_format = ac_fixed<width, colour_integer_bits, true, AC_TRN, AC_WRAP>;
template <int width>
using depth_format = ac_fixed<width, depth_integer_bits, false, AC_TRN, AC_WRAP>;

/// Both parts of a channel, with one queue entry between them.
template <typename value_t, bool second_order>
class Channel {
 public:
    using unit = forward_difference<value_t, second_order>;
    static constexpr int width = value_t::width;

    void load(const Words& w, bool linear, bool present) {
        edge_ = unit::edge_step(edge_, {1, linear, present, 0, 0}, present, {w[0], w[1], w[2], w[3], w[4], w[5]});
    }
    void next_row() { edge_ = unit::edge_step(edge_, {0, 0, 0, 1, 0}, 0, {}); }
    void carry() { edge_ = unit::edge_step(edge_, {0, 0, 0, 1, 1}, 0, {}); }
    void rest() {
        edge_ = unit::edge_step(edge_, {0, 1, 1, 0, 1}, 1, {~0U, ~0U, ~0U, ~0U, ~0U, ~0U});
        span_ = unit::span_step(span_, {0, 1, 0}, {}, edge_);
    }
    [[nodiscard]] typename unit::start_t start() const { return unit::start(edge_); }
    void start_span(const typename unit::start_t& head, bool first) {
        span_ = unit::span_step(span_, {1, first, 0}, head, edge_);
    }
    void next_pixel() { span_ = unit::span_step(span_, {0, 0, 1}, {}, edge_); }
    [[nodiscard]] std::uint64_t value() const {
        return ac_int<width, false>(span_.i.template slc<width>(0)).to_uint64();
    }

 private:
    typename unit::edge_state_t edge_;
    typename unit::span_state_t span_;
};

/// Walks the rows and draws their spans; every pixel must be closed_form of `expected`.
template <typename Unit>
void expect_closed_form(Unit& channel, const Words& expected, const std::vector<Row>& rows) {
    std::uint64_t u = 0;
    for (std::uint64_t j = 0; j < rows.size(); ++j) {
        const Row& row = rows[j];
        for (int k = 0; k < row.carries; ++k, ++u) channel.carry();
        channel.start_span(channel.start(), j == 0);
        for (std::uint64_t pixel = 0; pixel <= static_cast<std::uint64_t>(row.pixels); ++pixel) {
            RC_ASSERT(channel.value() == closed_form(expected, u + pixel, j, Unit::width));
            channel.next_pixel();
            if (pixel % 3 == 0) channel.rest();
        }
        channel.next_row();
    }
}

template <int width>
void expect_closed_form_of_width(const Words& words, const std::vector<Row>& rows) {
    Channel<colour_format<width>, true> quadratic;
    quadratic.load(words, false, true);
    expect_closed_form(quadratic, words, rows);
    Channel<colour_format<width>, true> flagged;
    flagged.load(words, true, true);
    expect_closed_form(flagged, without_second_order(words), rows);
    Channel<depth_format<width>, false> linear;
    linear.load(words, false, true);
    expect_closed_form(linear, without_second_order(words), rows);
}

RC_GTEST_PROP(forward_difference, any_path_holds_the_closed_form_for_any_words, (const Words& words)) {
    const std::vector<Row> rows = *paths();
    expect_closed_form_of_width<32>(words, rows);
    expect_closed_form_of_width<24>(words, rows);
    expect_closed_form_of_width<18>(words, rows);
}

RC_GTEST_PROP(forward_difference, the_host_has_the_same_closed_form, (const Words& words)) {
    const auto u = *rc::gen::inRange<std::int64_t>(0, 4096);
    const auto j = *rc::gen::inRange<std::int64_t>(0, 4096);
    const sheen::ChannelWords channel{words};
    RC_ASSERT(sheen::channel_value(channel, u, j) ==
              closed_form(words, static_cast<std::uint64_t>(u), static_cast<std::uint64_t>(j), 32));
}

RC_GTEST_PROP(forward_difference, a_channel_that_the_packet_does_not_carry_is_zero, (const Words& words)) {
    const std::vector<Row> rows = *paths();
    Channel<colour_value_t, true> quadratic;
    quadratic.load(words, false, true);
    quadratic.load(words, false, false);
    expect_closed_form(quadratic, {}, rows);
    Channel<depth_value_t, false> linear;
    linear.load(words, false, true);
    linear.load(words, false, false);
    expect_closed_form(linear, {}, rows);
}

/// The edge part is a triangle ahead: what the span part needs of the old one stays until a first span.
template <typename value_t, bool second_order>
void expect_constants_of_the_own_triangle(const Words& first, const Words& second) {
    const auto visible = [](const Words& words) { return second_order ? words : without_second_order(words); };
    Channel<value_t, second_order> channel;
    channel.load(first, false, true);
    channel.start_span(channel.start(), true);
    channel.next_row();
    const auto second_row = channel.start();
    channel.load(second, false, true);
    channel.start_span(second_row, false);
    for (std::uint64_t pixel = 0; pixel < 10; ++pixel, channel.next_pixel()) {
        RC_ASSERT(channel.value() == closed_form(visible(first), pixel, 1, value_t::width));
    }
    channel.start_span(channel.start(), true);
    for (std::uint64_t pixel = 0; pixel < 10; ++pixel, channel.next_pixel()) {
        RC_ASSERT(channel.value() == closed_form(visible(second), pixel, 0, value_t::width));
    }
}

RC_GTEST_PROP(forward_difference, constants_change_with_a_first_span_only, (const Words& first, const Words& second)) {
    expect_constants_of_the_own_triangle<colour_value_t, true>(first, second);
    expect_constants_of_the_own_triangle<depth_value_t, false>(first, second);
}

}  // namespace
