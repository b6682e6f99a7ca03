// SPDX-License-Identifier: MIT
/// \file
/// shading_core: every output word by the closed form (support/expected_pixels.hpp) and the protocol's rules, for every
/// stream width and every choice of channels; and that no stream of words, however wrong, stops it.
#include "sheen/hls/shading_core.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <vector>

#include "../hls/tops/shading_core.cpp"
#include "sheen/framing.hpp"
#include "support/core_run.hpp"
#include "support/expected_pixels.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 20253;
constexpr std::int64_t unbounded = std::int64_t{1} << 40;

using Packets = std::vector<StreamPacket>;
using PixelWords = std::vector<std::uint64_t>;

template <typename shape>
using config_of = hls::core_config<shape::words_per_beat, shape::has_depth, shape::has_quadratic, 32, 32,
                                   shape::log_channels, shape::has_power>;

std::uint64_t message(int kind, int tail, std::uint32_t data) {
    return static_cast<std::uint64_t>(data) << 32 | static_cast<std::uint64_t>(tail) << 24 |
           static_cast<std::uint64_t>(kind) << 12 | 4095;
}

PixelWords query_reply(const CoreShape& shape) {
    const std::uint32_t channels = static_cast<std::uint32_t>(shape.log_channels) << 8 | (shape.depth ? 1U << 10 : 0U) |
                                   (shape.quadratic ? 1U << 11 : 0U) | (shape.power ? 1U << 12 : 0U);
    const bool lit = shape.log_channels > 0;
    return {message(2, 0, 1 | channels), message(2, 1, 32 | 22 << 8 | (shape.depth ? 32 << 16 : 0) | 32 << 24),
            message(2, 2, 4095 | (lit ? 6U << 12 | 32U << 16 | 24U << 24 : 0U)),
            message(2, 3, hls::core_version | (lit ? 8U << 24 : 0U) | (shape.power ? 10U << 28 : 0U))};
}

/// The answer to one packet, which may change what holds for those that follow.
PixelWords expected_answer(const StreamPacket& packet, const CoreShape& shape, Lighting& lighting) {
    const std::uint32_t header = packet[0].words[0];
    const int error = packet_error(packet, shape);
    if (error != 0) return {message(1, error, header)};
    if (is_triangle(packet)) {
        const std::vector<std::uint32_t> words = words_of(packet);
        return expected_pixels(decode_triangle(words.data(), words.size()), lighting);
    }
    if (header >> 24 == hls::opcode_material || header >> 24 == hls::opcode_table) {
        const std::vector<std::uint32_t> words = words_of(packet);
        if (header >> 24 == hls::opcode_material) {
            lighting.set_material(words);
        } else {
            lighting.set_table(words);
        }
        return {};
    }
    return header >> 24 == 0 ? query_reply(shape) : PixelWords{message(0, 0, header)};
}

PixelWords expected_answer(const StreamPacket& packet, const CoreShape& shape) {
    Lighting lighting;
    return expected_answer(packet, shape, lighting);
}

PixelWords expected_answers(const Packets& packets, const CoreShape& shape) {
    PixelWords words;
    Lighting lighting;
    for (const StreamPacket& packet : packets) {
        const PixelWords answer = expected_answer(packet, shape, lighting);
        words.insert(words.end(), answer.begin(), answer.end());
    }
    return words;
}

/// A triangle's walk, or a few rows of any fields, which may wrap round the image.
TriangleWalk any_walk(Rng& rng) { return rng() % 8 == 0 ? random_walk(rng, 2) : covering_walk(rng, 48); }

StreamPacket any_triangle(Rng& rng, const CoreShape& shape) {
    return framed(triangle_words(rng, any_walk(rng), shape), shape.words_per_beat);
}

Packets packets_of(const std::vector<std::uint32_t>& words, int words_per_beat) {
    Packets packets(1);
    for (const Beat& beat : frame_packets(words, words_per_beat)) {
        packets.back().push_back({beat.words, (1U << beat.count) - 1, beat.last});
        if (beat.last) packets.emplace_back();
    }
    packets.pop_back();
    return packets;
}

class ShadingCore : public testing::Test {
 protected:
    void SetUp() override { std::cout << "seed " << seed << '\n'; }

    /// Runs check(shape_t) for each shape, on a trace that names it.
    template <typename Check>
    void for_shapes(Check check) {
        for_each_shape([&](auto shape) {
            SCOPED_TRACE("words_per_beat=" + std::to_string(shape.words_per_beat) + " depth=" +
                         std::to_string(shape.has_depth) + " quadratic=" + std::to_string(shape.has_quadratic));
            if (!HasFatalFailure()) check(shape);
        });
    }

    template <typename shape>
    PixelWords run(const Packets& packets, unsigned stall_percent = 0, std::int64_t max_clocks = unbounded) {
        return run_core<config_of<shape>>(packets, rng_, stall_percent, max_clocks);
    }

    Rng rng_{seed};
};

TEST_F(ShadingCore, DrawsTheClosedFormForAnyWords) {
    for_shapes([&](auto shape) {
        for (int i = 0; i < 60; ++i) {
            const Packets packets = {any_triangle(rng_, shape.value())};
            ASSERT_EQ(run<decltype(shape)>(packets), expected_answers(packets, shape.value())) << "triangle " << i;
        }
    });
}

TEST_F(ShadingCore, AnswersEveryPacketInOrderUnderAnyStalls) {
    for_shapes([&](auto shape) {
        for (int i = 0; i < 6; ++i) {
            Packets packets;
            for (int k = 0; k < 25; ++k) packets.push_back(random_packet(rng_, any_walk(rng_), shape.value()));
            const PixelWords expected = expected_answers(packets, shape.value());
            ASSERT_EQ(run<decltype(shape)>(packets), expected) << "stream " << i << ", full speed";
            const auto percent = static_cast<unsigned>(uniform(rng_, 1, 80));
            ASSERT_EQ(run<decltype(shape)>(packets, percent), expected) << "stream " << i << ", stalls " << percent;
        }
    });
}

TEST_F(ShadingCore, LosesOneMalformedPacketAndNothingAroundIt) {
    for_shapes([&](auto shape) {
        for (int i = 0; i < 20; ++i) {
            const StreamPacket before = any_triangle(rng_, shape.value());
            const StreamPacket after = any_triangle(rng_, shape.value());
            StreamPacket wrong = random_packet(rng_, any_walk(rng_), shape.value());
            while (packet_error(wrong, shape.value()) == 0) break_framing(rng_, wrong, shape.words_per_beat);
            PixelWords expected = expected_answer(before, shape.value());
            expected.push_back(message(1, packet_error(wrong, shape.value()), wrong[0].words[0]));
            const PixelWords tail = expected_answer(after, shape.value());
            expected.insert(expected.end(), tail.begin(), tail.end());
            ASSERT_EQ(run<decltype(shape)>({before, wrong, after}), expected) << "case " << i;
        }
    });
}

TEST_F(ShadingCore, AWrongLengthInAFileCostsOnlyWhatItsHeaderAnnounces) {
    using shape = shape_t<2, true, true>;
    for (int i = 0; i < 100; ++i) {
        std::vector<std::uint32_t> swallowed = triangle_words(rng_, any_walk(rng_), shape::value());
        std::vector<std::uint32_t> file = triangle_words(rng_, any_walk(rng_), shape::value());
        const PixelWords before = expected_answers(packets_of(file, 2), shape::value());
        const std::vector<std::uint32_t> after = triangle_words(rng_, any_walk(rng_), shape::value());
        std::vector<std::uint32_t> wrong = triangle_words(rng_, any_walk(rng_), shape::value());
        wrong[0] += static_cast<std::uint32_t>(swallowed.size());
        for (const std::vector<std::uint32_t>& part : {wrong, swallowed, after}) {
            file.insert(file.end(), part.begin(), part.end());
        }
        PixelWords expected = before;
        expected.push_back(message(1, hls::error_bad_length, wrong[0]));
        const PixelWords tail = expected_answers(packets_of(after, 2), shape::value());
        expected.insert(expected.end(), tail.begin(), tail.end());
        ASSERT_EQ(run<shape>(packets_of(file, 2)), expected) << "case " << i;
    }
}

/// Random words, in which headers of many lengths occur; none of them is a triangle that would be drawn.
std::vector<std::uint32_t> garbage(Rng& rng, std::size_t count, const CoreShape& shape) {
    std::vector<std::uint32_t> words(count);
    for (std::uint32_t& word : words) {
        word = static_cast<std::uint32_t>(rng());
        const auto kind = rng() % 3;
        if (kind == 0) word = (word & 0x07ff003fU);
        if (kind == 1) word = (word & 0x07070007U);
        if (word >> 24 == hls::opcode_triangle && header_error(word, shape) == 0) word ^= 1;
    }
    return words;
}

TEST_F(ShadingCore, AnswersGarbageInBoundedTimeWithOneWordAPacketAtMost) {
    for_shapes([&](auto shape) {
        for (int i = 0; i < 20; ++i) {
            const Packets packets = packets_of(garbage(rng_, 3000, shape.value()), shape.words_per_beat);
            std::size_t beats = 0;
            for (const StreamPacket& packet : packets) beats += packet.size();
            const PixelWords words =
                run<decltype(shape)>(packets, 0, static_cast<std::int64_t>(beats + 10 * packets.size() + 100));
            ASSERT_EQ(words, expected_answers(packets, shape.value())) << "case " << i;
            const auto errors = std::count_if(words.begin(), words.end(), [](std::uint64_t word) {
                return decode_pixel(word).x == hls::message_x && decode_pixel(word).y == hls::message_error;
            });
            ASSERT_LE(static_cast<std::size_t>(errors), packets.size());
        }
    });
}

TEST_F(ShadingCore, LeavesOutThePixelsWhoseXIsThatOfMessages) {
    using shape = shape_t<2, true, true>;
    for (const bool leftward : {false, true}) {
        TriangleWalk walk;
        walk.x = leftward ? 3 : 4090;  // over the edge of the 12-bit fields, one way or the other
        walk.y = 7;
        walk.rows_above = 1;
        walk.length = 12;
        walk.leftward = leftward;
        const Packets packets = {framed(triangle_words(rng_, walk, shape::value()), 2)};
        const PixelWords words = run<shape>(packets);
        ASSERT_EQ(words.size(), 11U);
        ASSERT_EQ(words, expected_answers(packets, shape::value()));
        ASSERT_EQ(std::count_if(words.begin(), words.end(), is_message), 0);
    }
}

TEST_F(ShadingCore, DrawsAPixelAClock) {
    using shape = shape_t<2, true, true>;
    const SnappedPoint a{0, 0};
    const SnappedPoint b{200 * 256, 10 * 256};
    const SnappedPoint c{30 * 256, 180 * 256};
    Packets packets;
    for (int k = 0; k < 10; ++k) {
        packets.push_back(framed(triangle_words(rng_, *walk_triangle(a, b, c), shape::value()), 2));
    }
    const auto pixels = static_cast<std::int64_t>(expected_answers(packets, shape::value()).size());
    const std::int64_t limit = pixels + pixels / 100 + 60;
    EXPECT_EQ(static_cast<std::int64_t>(run<shape>(packets, 0, limit).size()), pixels);
    std::cout << pixels << " pixels in at most " << limit << " clocks\n";
}

TEST_F(ShadingCore, AnswersTheSameThroughItsStreamTopHoweverCallsCutTheStream) {
    using shape = shape_t<2, true, true>;
    for (int i = 0; i < 20; ++i) {
        Packets packets;
        for (int k = 0; k < 8; ++k) packets.push_back(random_packet(rng_, any_walk(rng_), shape::value()));
        hls::channel<beat_bits_t> setup;
        hls::channel<pixel_bits_t> pixels;
        for (const StreamPacket& packet : packets) {
            for (const StreamBeat& beat : packet) {
                beat_bits_t bits = 0;
                for (int k = 0; k < 2; ++k) bits.set_slc(32 * k, hls::word_t(beat.words[static_cast<std::size_t>(k)]));
                bits.set_slc(64, ac_int<2, false>(static_cast<int>(beat.keep)));
                bits.set_slc(66, hls::bit_t(beat.last));
                setup.write(bits);
            }
            if (rng_() % 2 == 0) shading_core_top(setup, pixels);
        }
        shading_core_top(setup, pixels);
        PixelWords words;
        for (pixel_bits_t pixel; pixels.nb_read(pixel);) {
            words.push_back(pixel.slc<64>(0).to_uint64());
            ASSERT_EQ(pixel[64] != 0, (words.back() & 0xffffffU) == 4095) << "set on the echo of a fence";
        }
        ASSERT_EQ(words, expected_answers(packets, shape::value())) << "stream " << i;
    }
}

TEST_F(ShadingCore, ReportsTheWidthsThatItIsBuiltWith) {
    const Packets query = {framed({0}, 4)};
    const PixelWords words = run_core<hls::core_config<4, true, true, 24, 20>>(query, rng_, 0, 100);
    ASSERT_EQ(words.size(), 4U);
    EXPECT_EQ(words[1], message(2, 1, 24 | 14 << 8 | 20 << 16 | 32 << 24));
}

}  // namespace
}  // namespace sheen::test
