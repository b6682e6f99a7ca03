// SPDX-License-Identifier: MIT
// What a core says of itself, decoded from the words of docs/packet-protocol.md.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "sheen/device.hpp"
#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"

namespace sheen {
namespace {

constexpr unsigned seed = 20260901U;

/// The four words with these data.
std::vector<std::uint64_t> reply_of(const std::array<std::uint32_t, 4>& data) {
    std::vector<std::uint64_t> words;
    for (std::uint64_t k = 0; k < data.size(); ++k) words.push_back(std::uint64_t{data[k]} << 32 | k << 24 | 0x2fff);
    return words;
}

TEST(Capabilities, EveryFieldIsReadFromItsPlace) {
    std::mt19937 random(seed);
    for (int round = 0; round < 200; ++round) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", round " << round);
        std::array<std::uint32_t, 4> data{};
        for (std::uint32_t& word : data) word = static_cast<std::uint32_t>(random());
        data[0] = (data[0] & ~0xffU) | 1;
        const auto field = [&](std::size_t word, int lsb, int bits) {
            return static_cast<int>(data[word] >> lsb & ((1U << bits) - 1));
        };
        const Capabilities c = core_capabilities(reply_of(data));
        EXPECT_EQ(c.protocol_version, 1);
        EXPECT_EQ(c.log_channels, field(0, 8, 2));
        EXPECT_EQ(c.depth, field(0, 10, 1) == 1);
        EXPECT_EQ(c.quadratic, field(0, 11, 1) == 1);
        EXPECT_EQ(c.colour_bits, field(1, 0, 8));
        EXPECT_EQ(c.colour_fraction_bits, field(1, 8, 8));
        EXPECT_EQ(c.depth_bits, field(1, 16, 8));
        EXPECT_EQ(c.phase_bits, field(1, 24, 8));
        EXPECT_EQ(c.max_extent, field(2, 0, 12));
        EXPECT_EQ(c.exp2_address_bits, field(2, 12, 4));
        EXPECT_EQ(c.log_bits, field(2, 16, 8));
        EXPECT_EQ(c.log_fraction_bits, field(2, 24, 8));
        EXPECT_EQ(c.core_version, field(3, 0, 24));
        EXPECT_EQ(c.exp2_data_bits, field(3, 24, 4));
        EXPECT_EQ(c.power_address_bits, field(0, 12, 1) == 1 ? field(3, 28, 4) : 0);
    }
}

TEST(Capabilities, TheKernelsReportTheFormatsThatTheHostRoundsTo) {
    const Capabilities c = query_capabilities(*make_device("hls"));
    EXPECT_EQ(c.log_channels, 3);
    EXPECT_TRUE(c.depth);
    EXPECT_TRUE(c.quadratic);
    EXPECT_EQ(c.colour_fraction_bits, hls::colour_fraction_bits);
    EXPECT_EQ(c.log_fraction_bits, hls::log_fraction_bits);
    EXPECT_EQ(c.exp2_address_bits, hls::exp2_address_bits);
    EXPECT_EQ(c.exp2_data_bits, hls::exp2_data_bits);
    EXPECT_EQ(c.power_address_bits, hls::power_address_bits);
    EXPECT_EQ(c.max_extent, hls::max_extent);
    EXPECT_EQ(c.core_version, hls::core_version);
}

TEST(Capabilities, WhatIsNoReplyOrSpeaksAnotherProtocolIsRefused) {
    std::vector<std::uint64_t> reply = reply_of({1, 0, 0, 0});
    EXPECT_NO_THROW(core_capabilities(reply));
    EXPECT_THROW(core_capabilities({}), Error);
    EXPECT_THROW(core_capabilities({reply[0], reply[1], reply[2]}), Error);
    EXPECT_THROW(core_capabilities({reply[0], reply[2], reply[1], reply[3]}), Error);
    reply[3] = 0x0200000000001fff;
    EXPECT_THROW(core_capabilities(reply), Error) << "an error word";
    EXPECT_THROW(core_capabilities(reply_of({2, 0, 0, 0})), Error);
}

}  // namespace
}  // namespace sheen
