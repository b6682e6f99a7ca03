// SPDX-License-Identifier: MIT
// The packet protocol: words there and back, headers, messages, and files whole or not at all.
#include "sheen/packet.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"
#include "support/fitted_setups.hpp"

namespace sheen::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::uint32_t>;
constexpr std::uint64_t seed = 20031115;

/// A setup of arbitrary words that a packet can hold exactly: signed fields within 12 bits.
TriangleSetup random_encodable_setup(Rng& rng) {
    TriangleSetup setup = random_setup(rng, 4095);
    const auto log_channels = static_cast<std::size_t>(uniform(rng, 0, hls::max_log_channels));
    for (std::size_t k = 0; k < log_channels; ++k) setup.log.push_back(random_channel(rng, setup.linear));
    for (int* field : {&setup.walk.kappa, &setup.walk.m, &setup.walk.m_below}) {
        *field = static_cast<int>(uniform(rng, -2048, 2047));
    }
    return setup;
}

void expect_same(const TriangleSetup& a, const TriangleSetup& b) {
    EXPECT_EQ(a.walk.x, b.walk.x);
    EXPECT_EQ(a.walk.y, b.walk.y);
    EXPECT_EQ(a.walk.rows_above, b.walk.rows_above);
    EXPECT_EQ(a.walk.rows_below, b.walk.rows_below);
    EXPECT_EQ(a.walk.kappa, b.walk.kappa);
    EXPECT_EQ(a.walk.length, b.walk.length);
    EXPECT_EQ(a.walk.m, b.walk.m);
    EXPECT_EQ(a.walk.length_reload, b.walk.length_reload);
    EXPECT_EQ(a.walk.m_below, b.walk.m_below);
    EXPECT_EQ(a.walk.leftward, b.walk.leftward);
    const auto phases = [](const TriangleWalk& w) {
        return std::array{w.long_edge.phase, w.long_edge.step, w.upper.phase,
                          w.upper.step,      w.lower.phase,    w.lower.step};
    };
    EXPECT_EQ(phases(a.walk), phases(b.walk));
    EXPECT_EQ(a.linear, b.linear);
    EXPECT_EQ(a.colour, b.colour);
    EXPECT_EQ(a.log, b.log);
    EXPECT_EQ(a.depth, b.depth);
}

/// Runs `action`, which must throw, and returns its message.
std::string error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "no error";
    return {};
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A fresh folder that disappears with the test.
class PacketFile : public testing::Test {
 protected:
    PacketFile() : folder_(fs::temp_directory_path() / ("sheen_packet_test_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~PacketFile() override { fs::remove_all(folder_); }
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    void write_bytes(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
    }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    fs::path folder_;
};

TEST(Packet, RandomSetupsComeBackUnchanged) {
    Rng rng(seed);
    for (int k = 0; k < 5000; ++k) {
        const TriangleSetup setup = random_encodable_setup(rng);
        Words words;
        append_triangle(words, setup);
        expect_same(decode_triangle(words.data(), words.size()), setup);
        if (HasFailure()) FAIL() << "setup " << k << " of seed " << seed;
    }
}

TEST(Packet, WalksOfTrianglesDrawTheSameAfterDecoding) {
    Rng rng(seed + 1);
    int setups = 0;
    for (int k = 0; k < 3000; ++k) {
        const auto setup = fitted_setup(rng, random_triangle(rng, 300));
        if (!setup) continue;
        ++setups;
        Words words;
        append_triangle(words, *setup);
        const TriangleSetup decoded = decode_triangle(words.data(), words.size());
        std::vector<std::array<int, 4>> sent;
        std::vector<std::array<int, 4>> got;
        for_each_span(setup->walk, [&](int x, int y, int length, int step) { sent.push_back({x, y, length, step}); });
        for_each_span(decoded.walk, [&](int x, int y, int length, int step) { got.push_back({x, y, length, step}); });
        ASSERT_EQ(got, sent) << "setup " << k;
        Words again;
        append_triangle(again, decoded);
        ASSERT_EQ(again, words) << "setup " << k;
    }
    EXPECT_GT(setups, 1000);
}

TEST(Packet, FieldsLieWhereTheProtocolPutsThem) {
    TriangleSetup setup;
    setup.walk.x = 0x123;
    setup.walk.y = 0x456;
    setup.walk.rows_above = 0x789;
    setup.walk.rows_below = 0xabc;
    setup.walk.kappa = -1;
    setup.walk.length = 0xdef;
    setup.walk.m = -2048;
    setup.walk.length_reload = 0x135;
    setup.walk.m_below = 0x246;
    setup.walk.leftward = true;
    setup.walk.long_edge = {1, 2};
    setup.walk.upper = {3, 4};
    setup.walk.lower = {5, 6};
    for (std::uint32_t c = 0; c < 3; ++c) {
        setup.colour[c].words = {10 * c, 10 * c + 1, 10 * c + 2, 10 * c + 3, 10 * c + 4, 10 * c + 5};
    }
    setup.depth = ChannelWords{{90, 91, 92, 0, 0, 0}};
    Words words;
    append_triangle(words, setup);
    const Words geometry{0x89456123, 0xffffabc7, 0x135800de, 0x00000246, 1, 2, 3, 4, 5, 6};
    ASSERT_EQ(words.size(), 32U);
    EXPECT_EQ(words[0], 0x0305001fU);  // triangle, leftward and depth, 31 words
    EXPECT_EQ(Words(words.begin() + 1, words.begin() + 11), geometry);
    EXPECT_EQ(Words(words.begin() + 17, words.begin() + 23), (Words{10, 11, 12, 13, 14, 15}));
    EXPECT_EQ(Words(words.end() - 3, words.end()), (Words{90, 91, 92}));
}

TEST(Packet, LengthsFollowTheFlags) {
    for (const bool linear : {false, true}) {
        for (const bool depth : {false, true}) {
            for (std::size_t log = 0; log <= hls::max_log_channels; ++log) {
                TriangleSetup setup;
                setup.linear = linear;
                setup.log.resize(log);
                if (depth) setup.depth = ChannelWords{};
                Words words;
                append_triangle(words, setup);
                const std::size_t expected = 11 + (3 + log) * (linear ? 3 : 6) + (depth ? 3 : 0);
                EXPECT_EQ(words.size(), expected);
                const PacketHeader header = decode_header(words[0]);
                EXPECT_EQ(header.opcode, hls::opcode_triangle);
                EXPECT_EQ(header.length, static_cast<int>(expected) - 1);
                EXPECT_EQ(header.flags,
                          static_cast<int>(linear) << 1 | static_cast<int>(depth) << 2 | static_cast<int>(log) << 3);
            }
        }
    }
    TriangleSetup setup;
    setup.log.resize(hls::max_log_channels + 1);
    Words words;
    EXPECT_TRUE(holds(error_of([&] { append_triangle(words, setup); }), "4 log channels"));
    EXPECT_TRUE(words.empty());
}

TEST(Packet, DecodingNamesWhatDoesNotFit) {
    Rng rng(seed + 2);
    Words words;
    append_triangle(words, random_encodable_setup(rng));
    const auto decode = [](const Words& packet) { return [packet] { decode_triangle(packet.data(), packet.size()); }; };

    Words changed = words;
    changed[0] = (changed[0] & 0x00ffffffU) | 4U << 24;
    EXPECT_TRUE(holds(error_of(decode(changed)), "opcode 4, expected 3"));
    changed = words;
    ++changed[0];
    EXPECT_TRUE(holds(error_of(decode(changed)), "length " + std::to_string(words.size())));
    changed = words;
    changed[0] |= 1U << 23;
    EXPECT_TRUE(holds(error_of(decode(changed)), "bits 21–23"));
    changed = words;
    changed.pop_back();
    EXPECT_TRUE(holds(error_of(decode(changed)), "packet of " + std::to_string(changed.size()) + " words"));
    EXPECT_TRUE(holds(error_of(decode({})), "without words"));
}

TEST(Packet, FencesAndQueriesAreOneWord) {
    Words words;
    append_query(words);
    append_fence(words);
    append_fence(words, 255);
    EXPECT_EQ(words, (Words{0x00000000, 0x05000000, 0x05ff0000}));
    EXPECT_TRUE(holds(error_of([&] { append_fence(words, 256); }), "fence tag 256"));
    EXPECT_TRUE(holds(error_of([&] { append_fence(words, -1); }), "fence tag -1"));
}

TEST(Packet, PixelsComeBackUnchangedAndLieWhereTheProtocolPutsThem) {
    EXPECT_EQ(encode_pixel({0x123, 0x456, 0x789a, 0xbc, 0xde, 0xf0}), 0xf0debc789a456123U);
    Rng rng(seed + 3);
    for (int k = 0; k < 1000; ++k) {
        const std::uint64_t word = rng();
        EXPECT_EQ(encode_pixel(decode_pixel(word)), word);
        EXPECT_EQ(is_message(word), (word & 0xfff) == 0xfff);
    }
    EXPECT_TRUE(is_message(0xfff));
    EXPECT_FALSE(is_message(0xffe));
}

TEST(Packet, MessagesAreDescribedInWords) {
    EXPECT_EQ(describe_message(0x0507000000000fffU), "fence 7");
    EXPECT_EQ(describe_message(0x0305000101001fffU), "error 1 (unknown opcode) for header 0x03050001");
    EXPECT_EQ(describe_message(0x0305000102001fffU), "error 2 (bad length or framing) for header 0x03050001");
    EXPECT_EQ(describe_message(0x0305000103001fffU), "error 3 (not supported by this core) for header 0x03050001");
    EXPECT_EQ(describe_message(0x0305000109001fffU), "error 9 (unknown code) for header 0x03050001");
    EXPECT_EQ(describe_message(0xdeadbeef03002fffU), "query reply word 3: 0xdeadbeef");
    EXPECT_EQ(describe_message(0xdeadbeef00007fffU), "message of unknown kind 7: 0xdeadbeef00007fff");
    EXPECT_EQ(describe_message(encode_pixel({3, 4, 0, 0, 0, 0})), "pixel (3, 4)");
}

TEST_F(PacketFile, WordsComeBackUnchangedAndAreLittleEndian) {
    Rng rng(seed + 4);
    Words packets(70000);
    for (auto& word : packets) word = static_cast<std::uint32_t>(rng());
    std::vector<std::uint64_t> pixels(30001);
    for (auto& word : pixels) word = rng();
    write_packet_file(path("a.packets"), packets);
    write_pixel_file(path("a.pixels"), pixels);
    EXPECT_EQ(read_packet_file(path("a.packets")), packets);
    EXPECT_EQ(read_pixel_file(path("a.pixels")), pixels);
    EXPECT_EQ(files(), 2U) << "temporary files stay behind";

    write_bytes("known", {'\x01', '\x02', '\x03', '\x84', '\x05', '\x06', '\x07', '\x88'});
    EXPECT_EQ(read_packet_file(path("known")), (Words{0x84030201, 0x88070605}));
    EXPECT_EQ(read_pixel_file(path("known")), (std::vector<std::uint64_t>{0x8807060584030201}));
    write_packet_file(path("empty"), {});
    EXPECT_TRUE(read_packet_file(path("empty")).empty());
}

TEST_F(PacketFile, ErrorsNameTheFileAndWhatWouldBeRight) {
    const std::string missing = error_of([&] { read_packet_file(path("missing")); });
    EXPECT_TRUE(holds(missing, path("missing")) && holds(missing, "No such file")) << missing;

    write_bytes("odd", "1234567");
    const std::string odd = error_of([&] { read_packet_file(path("odd")); });
    EXPECT_TRUE(holds(odd, path("odd")) && holds(odd, "7 bytes") && holds(odd, "multiple of 4")) << odd;
    write_bytes("odd", "123456789012");
    const std::string odd_pixels = error_of([&] { read_pixel_file(path("odd")); });
    EXPECT_TRUE(holds(odd_pixels, "12 bytes") && holds(odd_pixels, "multiple of 8")) << odd_pixels;

    const std::string folder = error_of([&] { read_packet_file(folder_.string()); });
    EXPECT_TRUE(holds(folder, folder_.string())) << folder;
    const std::string unwritable = error_of([&] { write_pixel_file(path("no/such/folder"), {1}); });
    EXPECT_TRUE(holds(unwritable, path("no/such/folder"))) << unwritable;
    for (const std::string& message : {missing, odd, folder, unwritable}) EXPECT_FALSE(holds(message, "\n"));
}

}  // namespace
}  // namespace sheen::test
