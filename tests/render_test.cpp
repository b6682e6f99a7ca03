// SPDX-License-Identifier: MIT
/// \file
/// A picture through a device is complete or an error; figures follow the headers' framing.
#include "sheen/render.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <string>

#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/packet.hpp"

namespace {

using sheen::Pixel;
using Words32 = std::vector<std::uint32_t>;
using Words64 = std::vector<std::uint64_t>;

constexpr unsigned seed = 20260702U;

/// Answers with the words it was made with.
class CannedDevice : public sheen::Device {
 public:
    explicit CannedDevice(Words64 words, std::optional<std::uint64_t> cycles = std::nullopt)
        : result_{std::move(words), cycles} {}
    [[nodiscard]] std::string name() const override { return "canned"; }
    sheen::RunResult run(const Words32& /*packets*/) override { return result_; }

 private:
    sheen::RunResult result_;
};

std::uint64_t message(int kind, std::uint32_t header) {
    return static_cast<std::uint64_t>(header) << 32 | static_cast<std::uint64_t>(kind) << sheen::hls::pixel_y_lsb |
           static_cast<std::uint64_t>(sheen::hls::message_x);
}

std::uint32_t header(int opcode, int length) {
    return static_cast<std::uint32_t>(opcode) << sheen::hls::header_opcode_lsb | static_cast<std::uint32_t>(length);
}

Words32 empty_picture() { return sheen::picture_packets({}); }
std::uint64_t echo() { return message(sheen::hls::message_fence, empty_picture().back()); }
std::uint64_t pixel(int x, int y, int depth, int red) { return sheen::encode_pixel(Pixel{x, y, depth, red, 0, 0}); }

/// What draw says of these words; empty when it accepts them.
std::string complaint(const Words64& words) {
    CannedDevice device(words);
    try {
        (void)sheen::draw(device, empty_picture(), 8, 6);
    } catch (const sheen::Error& error) {
        return error.what();
    }
    return "";
}

TEST(render, a_picture_s_packets_are_its_triangles_and_then_a_fence) {
    const Words32 packets = sheen::picture_packets({sheen::TriangleSetup{}, sheen::TriangleSetup{}});
    Words32 expected;
    sheen::append_triangle(expected, {});
    sheen::append_triangle(expected, {});
    sheen::append_fence(expected);
    EXPECT_EQ(packets, expected);
}

/// A setup with one log channel.
sheen::TriangleSetup lit_setup(int ambient, const std::shared_ptr<const sheen::PowerEntries>& table = nullptr) {
    sheen::TriangleSetup setup;
    setup.log.resize(1);
    setup.material.ambient = {ambient, 2, 3};
    setup.material.power_channels = table == nullptr ? 0 : 1;
    setup.table = table;
    return setup;
}

std::shared_ptr<const sheen::PowerEntries> filled_table(std::uint8_t entry) {
    return std::make_shared<const sheen::PowerEntries>(1024, entry);
}

TEST(render, a_material_and_a_table_are_sent_before_the_first_triangle_that_needs_them_and_when_they_change) {
    const auto one = filled_table(1);
    const auto same = filled_table(1);
    const auto two = filled_table(2);
    const auto lit_by = [](const std::shared_ptr<const sheen::PowerEntries>& table) { return lit_setup(7, table); };
    const std::vector<sheen::TriangleSetup> setups{{},          lit_setup(7), lit_setup(7), {},           lit_setup(8),
                                                   lit_by(one), lit_by(one),  lit_by(same), lit_setup(8), lit_by(one),
                                                   lit_by(two), {},           lit_by(two),  lit_by(one)};
    const Words32 packets = sheen::picture_packets(setups);
    // t: triangle, m: material, p: power table.
    std::string order;
    for (std::size_t at = 0; at < packets.size();) {
        const sheen::PacketHeader found = sheen::decode_header(packets[at]);
        order += found.opcode == sheen::hls::opcode_table      ? 'p'
                 : found.opcode == sheen::hls::opcode_material ? 'm'
                 : found.opcode == sheen::hls::opcode_triangle ? 't'
                                                               : 'f';
        at += 1 + static_cast<std::size_t>(found.length);
    }
    EXPECT_EQ(order, "tmtttmtpmtttmtmtptttptf");
    Words32 first;
    sheen::append_triangle(first, {});
    sheen::append_material(first, setups[1].material);
    EXPECT_TRUE(std::equal(first.begin(), first.end(), packets.begin()));
}

/// A core that has everything.
sheen::Capabilities rich_core() {
    sheen::Capabilities core;
    core.log_channels = 3;
    core.depth = core.quadratic = true;
    core.power_address_bits = 10;
    return core;
}

TEST(render, what_a_core_lacks_is_named_before_anything_is_sent) {
    sheen::TriangleSetup full = lit_setup(1, filled_table(9));
    full.log.resize(3);
    full.depth.emplace();
    EXPECT_FALSE(sheen::why_incapable(rich_core(), {full, {}}).has_value());
    const auto reason = [&](const sheen::Capabilities& core) {
        return sheen::why_incapable(core, {{}, full}).value_or("");
    };
    sheen::Capabilities core = rich_core();
    core.log_channels = 2;
    EXPECT_EQ(reason(core), "the core has 2 log channels, and a triangle needs 3");
    core = rich_core();
    core.power_address_bits = 0;
    EXPECT_EQ(reason(core), "the core has no power table, and a triangle needs one");
    core.power_address_bits = 8;
    EXPECT_EQ(reason(core), "the core has power tables of 256 entries, and a triangle needs 1024");
    core = rich_core();
    core.depth = false;
    EXPECT_EQ(reason(core), "the core has no depth channel, and a triangle needs one");
    core = rich_core();
    core.quadratic = false;
    EXPECT_EQ(reason(core), "the core has linear colour only, and a triangle needs quadratic");
    sheen::TriangleSetup plain;
    plain.linear = true;
    EXPECT_FALSE(sheen::why_incapable({}, {plain}).has_value());
}

TEST(render, pixels_before_the_echo_make_the_picture_and_the_nearer_one_stays) {
    CannedDevice device({pixel(1, 2, 700, 10), pixel(1, 2, 600, 20), pixel(1, 2, 800, 30), pixel(7, 5, 1, 40), echo()},
                        9);
    const sheen::Drawing drawing = sheen::draw(device, empty_picture(), 8, 6);
    EXPECT_EQ(drawing.framebuffer.image().at(1, 2)[0], 20);
    EXPECT_EQ(drawing.framebuffer.image().at(7, 5)[0], 40);
    EXPECT_EQ(drawing.result.words.size(), 5U);
    EXPECT_EQ(drawing.result.cycles, 9U);
}

TEST(render, a_missing_wrong_early_or_doubled_echo_is_an_error) {
    EXPECT_EQ(complaint({pixel(0, 0, 1, 1), echo()}), "");
    EXPECT_NE(complaint({}).find("incomplete"), std::string::npos);
    EXPECT_NE(complaint({pixel(0, 0, 1, 1)}).find("incomplete"), std::string::npos);
    EXPECT_NE(complaint({echo(), pixel(0, 0, 1, 1)}).find("word 0"), std::string::npos);
    EXPECT_NE(complaint({echo(), echo()}).find("word 0"), std::string::npos);
    const std::uint64_t other = message(sheen::hls::message_fence, empty_picture().back() ^ 1U << 16);
    EXPECT_NE(complaint({other}).find("expected"), std::string::npos);
}

TEST(render, an_error_word_a_query_reply_and_a_pixel_outside_are_errors) {
    const std::uint64_t refusal = message(sheen::hls::message_error, 0x03010001);
    for (const Words64& words : {Words64{refusal, echo()}, Words64{pixel(0, 0, 1, 1), refusal}}) {
        EXPECT_NE(complaint(words).find("0x03010001"), std::string::npos) << complaint(words);
    }
    EXPECT_NE(complaint({message(sheen::hls::message_query, 0), echo()}), "");
    EXPECT_NE(complaint({pixel(8, 0, 1, 1), echo()}), "");
    EXPECT_NE(complaint({pixel(0, 6, 1, 1), echo()}), "");
}

TEST(render, packets_without_a_fence_are_refused_before_they_are_sent) {
    CannedDevice device({echo()});
    EXPECT_THROW(sheen::draw(device, {}, 8, 6), sheen::Error);
    EXPECT_THROW(sheen::draw(device, {header(sheen::hls::opcode_query, 0)}, 8, 6), sheen::Error);
}

TEST(render, figures_count_accepted_triangles_by_framing_and_pixels_by_words) {
    std::mt19937 generator(seed);
    const auto below = [&generator](int bound) { return std::uniform_int_distribution<int>(0, bound - 1)(generator); };
    for (int round = 0; round < 300; ++round) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", round " << round);
        Words32 packets;
        sheen::RunResult result;
        std::size_t triangles = 0;
        std::size_t pixels = 0;
        for (int packet = below(20); packet > 0; --packet) {
            const bool is_triangle = below(2) == 0;
            const int length = below(5);
            const int other = below(2) == 0 ? sheen::hls::opcode_material : 7;
            packets.push_back(header(is_triangle ? sheen::hls::opcode_triangle : other, length));
            const std::uint32_t own = packets.back();
            // Payloads that look like triangle headers must not count.
            packets.insert(packets.end(), static_cast<std::size_t>(length), header(sheen::hls::opcode_triangle, 0));
            const bool refused = below(3) == 0;
            triangles += is_triangle && !refused ? 1 : 0;
            if (refused) {
                result.words.push_back(message(sheen::hls::message_error, own));
            }
            for (int i = below(4); i > 0; --i, ++pixels) {
                result.words.push_back(pixel(below(4095), 1, 1, 1));
            }
        }
        const sheen::Statistics statistics = sheen::statistics_of(packets, result);
        ASSERT_EQ(statistics.triangles, triangles);
        ASSERT_EQ(statistics.pixels, pixels);
        ASSERT_EQ(statistics.packet_words, packets.size());
        ASSERT_FALSE(statistics.cycles.has_value());
        ASSERT_FALSE(statistics.pixels_per_clock().has_value());
    }
}

TEST(render, pixels_per_clock_needs_cycles) {
    sheen::Statistics statistics;
    statistics.pixels = 30;
    EXPECT_FALSE(statistics.pixels_per_clock().has_value());
    statistics.cycles = 0;
    EXPECT_FALSE(statistics.pixels_per_clock().has_value());
    statistics.cycles = 40;
    EXPECT_EQ(statistics.pixels_per_clock(), 0.75);
}

}  // namespace
