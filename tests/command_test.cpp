// SPDX-License-Identifier: MIT
/// \file
/// The built command as a subprocess: what it refuses, how it says so, and what it leaves behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/command_fixture.hpp"

namespace {

using sheen::test::Outcome;
using sheen::test::Words;

class command : public sheen::test::CommandTest {};

/// A small picture by the reference, with `more` options.
Words small_render(const Words& more) {
    Words words = {"render", "builtin:sphere-168", "--device", "reference", "--size", "40x30", "-o", "out.png"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST_F(command, what_the_parser_refuses_is_answered_with_where_to_look) {
    expect_refusal({}, 2, "`sheen --help`");
    expect_refusal({"info", "--colour"}, 2, "`sheen info --help`");
    expect_refusal(small_render({"--srgb=maybe"}), 2, "`sheen render --help`");
    expect_refusal(small_render({"--size", "9x9"}), 2, "`sheen render --help`");
}

TEST_F(command, malformed_requests_exit_with_2_and_one_line_that_names_the_culprit) {
    expect_refusal({}, 2, "subcommand");
    expect_refusal({"paint"}, 2, "paint");
    expect_refusal({"render"}, 2, "MESH");
    expect_refusal({"render", "good.obj"}, 2, "output");
    expect_refusal({"render", "builtin:cube", "-o", "out.png"}, 2, "builtin:cube");
    expect_refusal(small_render({"--colour", "red"}), 2, "--colour");
    expect_refusal(small_render({"--method", "toon"}), 2, "toon");
    expect_refusal(small_render({"--pixels", "out.pixels"}), 2, "--pixels");
    expect_refusal({"render", "good.obj", "-o", "out.png", "--device", "crayon"}, 2, "crayon");
    expect_refusal({"render", "good.obj", "-o", "out.png", "--method", "phong"}, 2, "phong");
    expect_refusal({"render", "good.obj", "-o", "--srgb"}, 2, "--srgb");
    expect_refusal({"render", "good.obj", "-o", ""}, 2, "--output");
    expect_refusal({"run", "odd.packets", "--device", "hls", "--pixels", ""}, 2, "--pixels");
    expect_refusal({"compare", "good.obj", "--methods", ""}, 2, "--methods");
    expect_refusal({"render", "good.obj", "-o", "same", "--stats", "same"}, 2, "same");
    expect_refusal({"render", "good.obj", "-o", "-", "--stats", "-"}, 2, "'-'");
    for (const char* size : {"0x0", "0x5", "5x0", "4096x5", "5x4096", "-5x5", "5", "5x", "x5", "5x5x5", "5.5x5", "",
                             " 5x5", "99999999999x5"}) {
        expect_refusal({"render", "good.obj", "-o", "out.png", "--size", size}, 2, "--size");
    }
    for (const char* light : {"0,0,0", "-0,0,0", "nan,0,1", "0,inf,1", "0,-inf,1", "1,2", "1,2,3,4", "1,2,x", "1,,3",
                              "1;2;3", "1e999,0,0", "0x1,0,1", "--size", "1, 2,3"}) {
        expect_refusal(small_render({"--light", light}), 2, "--light");
    }
    for (const char* colour : {"nan,0,0", "-1,0,0", "1,1", "white", "inf,1,1"}) {
        expect_refusal(small_render({"--light", "0,0,1", "--light-colour", colour}), 2, "--light-colour");
    }
    expect_refusal(small_render({"--light-colour", "1,1,1", "--light", "0,0,1"}), 2, "--light-colour");
    expect_refusal(small_render({"--light", "0,0,1", "--light-colour", "1,1,1", "--light-colour", "1,0,0"}), 2,
                   "'1,0,0': the light before it has a colour");
    for (const char* shininess : {"-1", "nan", "inf", "many", "1,2", "5x"}) {
        expect_refusal(small_render({"--shininess", shininess}), 2, "--shininess");
    }
    for (const char* option : {"--ka", "--kd"}) {
        for (const char* value : {"1.5,0,0", "0,-.1,0", "0.5", "nan,0,0"}) {
            expect_refusal(small_render({option, value}), 2, option);
        }
    }
    expect_refusal(small_render({"--ks", "1.01"}), 2, "--ks");
    expect_refusal(small_render({"--brdf", "velvet"}), 2, "velvet");
    expect_refusal(small_render({"--rotate", "1,2,nan"}), 2, "--rotate");
    expect_refusal(small_render({"--size", "8x8"}), 2, "--size");
    expect_refusal({"run", "odd.packets", "--device", "reference", "--pixels", "out.pixels"}, 2, "reference");
    expect_refusal({"run", "odd.packets", "--device", "abacus", "--pixels", "out.pixels"}, 2, "abacus");
    expect_refusal({"run", "odd.packets", "--pixels", "out.pixels"}, 2, "--device");
    expect_refusal({"compare", "good.obj", "--methods", "flat,toon"}, 2, "toon");
    expect_refusal({"compare", "good.obj", "--methods", "flat,,gouraud"}, 2, "--methods");
    expect_refusal({"compare", "good.obj", "--devices", "hls,hls"}, 2, "--devices");
    expect_refusal({"compare", "good.obj", "--devices", "reference,loom", "--json", "out.json"}, 2, "loom");
    expect_refusal({"compare", "good.obj", "--lights", "candles"}, 2, "candles");
    expect_refusal({"compare", "good.obj", "--lights", ""}, 2, "--lights");
    expect_refusal({"compare", "good.obj", "--json", "same", "--csv", "same"}, 2, "same");
    expect_refusal({"compare", "good.obj", "--lights", "measured", "--light", "0,0,1"}, 2, "--light");
    expect_refusal({"info", "--device", "abacus"}, 2, "abacus");
}

TEST_F(command, faulty_files_exit_with_1_and_one_line_that_names_the_file) {
    for (const char* mesh :
         {"missing.obj", "broken.obj", "empty.obj", "points.obj", "nan.obj", "index.obj", "folder"}) {
        expect_refusal({"render", mesh, "--device", "reference", "-o", "out.png", "--stats", "out.json"}, 1, mesh);
        expect_refusal({"compare", mesh, "--devices", "reference", "-o", "out.png", "--json", "out.json"}, 1, mesh);
    }
    expect_refusal({"run", "missing.packets", "--device", "hls", "--pixels", "out.pixels"}, 1, "missing.packets");
    expect_refusal({"run", "odd.packets", "--device", "hls", "--pixels", "out.pixels"}, 1, "odd.packets");
    expect_refusal({"run", "folder", "--device", "hls", "--pixels", "out.pixels"}, 1, "folder");
}

TEST_F(command, an_unwritable_output_exits_with_1_and_leaves_no_other_output) {
    for (const char* path : {"absent/out.png", "folder", "good.obj/out.png", "/proc/out.png"}) {
        expect_refusal({"render", "good.obj", "--device", "reference", "--stats", "out.json", "-o", path}, 1, path);
        expect_refusal({"render", "good.obj", "--device", "reference", "-o", "out.png", "--stats", path}, 1, path);
        expect_refusal({"compare", "good.obj", "--devices", "reference", "-o", "out.png", "--json", path}, 1, path);
        expect_refusal({"compare", "good.obj", "--devices", "reference", "--json", "out.json", "--csv", path}, 1, path);
        expect_refusal({"run", "odd.packets", "--device", "hls", "--pixels", path}, 1, path);
    }
}

TEST_F(command, an_output_is_checked_before_the_mesh_is_read) {
    expect_refusal({"render", "missing.obj", "-o", "absent/out.png"}, 1, "absent/out.png");
}

TEST_F(command, a_name_with_a_line_break_still_gives_one_line) {
    expect_refusal({"render", "two\nlines.obj", "-o", "out.png"}, 1, "two lines.obj");
}

TEST_F(command, every_help_has_examples_and_exits_with_0) {
    for (const Words& words :
         {Words{"--help"}, Words{"render", "--help"}, Words{"run", "--help"}, Words{"compare", "--help"}}) {
        const Outcome outcome = sheen(words);
        EXPECT_EQ(outcome.status, 0);
        EXPECT_NE(outcome.out.find("Example"), std::string::npos) << outcome.out;
        EXPECT_EQ(outcome.err, "");
    }
    EXPECT_EQ(sheen({"--version"}).out.rfind("sheen ", 0), 0U);
}

TEST_F(command, standard_output_carries_the_same_png_as_a_file) {
    ASSERT_EQ(sheen(small_render({})).status, 0);
    const std::string png = read("out.png");
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    Words words = small_render({});
    words.back() = "-";
    EXPECT_TRUE(sheen(words).out == png) << "the PNG on standard output differs from the file's";
}

TEST_F(command, a_light_may_start_with_a_minus_and_a_point_and_needs_no_unit_length) {
    const auto png_with = [this](const Words& options) {
        const Outcome outcome = sheen(small_render(options));
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return read("out.png");
    };
    const std::string lit = png_with({"--light", "-.4,.5,.77"});
    EXPECT_TRUE(lit == png_with({})) << "the default light differs from -.4,.5,.77";
    EXPECT_TRUE(lit == png_with({"--light=-.4,.5,.77"}));
    EXPECT_FALSE(lit == png_with({"--light", ".4,.5,.77"}));
    EXPECT_TRUE(png_with({"--light", "0,0,1"}) == png_with({"--light", "0,0,1e300"}));
    EXPECT_TRUE(png_with({"--light", "0,1,1"}) == png_with({"--light", "0,1e-200,1e-200"}));
}

TEST_F(command, a_light_colour_belongs_to_the_light_before_it) {
    const auto png_with = [this](const Words& options) {
        const Outcome outcome = sheen(small_render(options));
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return read("out.png");
    };
    const std::string red_left = png_with({"--light", "-1,0,1", "--light-colour", "1,0,0", "--light", "1,0,1"});
    const std::string red_right = png_with({"--light", "-1,0,1", "--light", "1,0,1", "--light-colour", "1,0,0"});
    EXPECT_FALSE(red_left == red_right);
    EXPECT_TRUE(red_right == png_with({"--light", "1,0,1", "--light-colour", "1,0,0", "--light", "-1,0,1"}));
}

TEST_F(command, stats_hold_their_five_figures) {
    ASSERT_EQ(sheen(small_render({"--stats", "reference.json"})).status, 0);
    ASSERT_EQ(sheen({"render", "builtin:sphere-168", "--size", "40x30", "-o", "out.png", "--stats", "hls.json"}).status,
              0);
    const auto reference = nlohmann::json::parse(read("reference.json"));
    const auto hls = nlohmann::json::parse(read("hls.json"));
    for (const auto& stats : {reference, hls}) {
        ASSERT_EQ(stats.size(), 5U) << stats;
        EXPECT_GT(stats.at("pixels"), 0);
        EXPECT_GT(stats.at("triangles"), 0);
        EXPECT_TRUE(stats.at("cycles").is_null());
        EXPECT_TRUE(stats.at("pixels_per_clock").is_null());
    }
    EXPECT_EQ(hls.at("pixels"), reference.at("pixels"));
    EXPECT_EQ(hls.at("triangles"), reference.at("triangles"));
    EXPECT_TRUE(reference.at("packet_words").is_null());
    EXPECT_GT(hls.at("packet_words"), 0);
}

TEST_F(command, replayed_packets_give_the_same_pixels_and_figures) {
    ASSERT_EQ(sheen({"render", "builtin:sphere-168", "--size", "60x50", "-o", "out.png", "--packets", "p", "--pixels",
                     "q", "--stats", "s.json"})
                  .status,
              0);
    const Outcome replay = sheen({"run", "p", "--device", "hls", "--pixels", "r", "--stats", "t.json"});
    ASSERT_EQ(replay.status, 0) << replay.err;
    EXPECT_FALSE(read("q").empty());
    EXPECT_TRUE(read("q") == read("r")) << "the replayed pixel file differs";
    EXPECT_EQ(read("s.json"), read("t.json"));
    EXPECT_EQ(read("p").size(), 4 * nlohmann::json::parse(read("s.json")).at("packet_words").get<std::size_t>());
}

TEST_F(command, run_completes_the_pixel_file_despite_error_words_prints_each_and_exits_with_1) {
    ASSERT_EQ(
        sheen({"render", "builtin:sphere-168", "--size", "60x50", "-o", "out.png", "--packets", "p", "--pixels", "q"})
            .status,
        0);
    const std::string no_such_packet("\x01\x00\x00\x63\xff\xff\xff\xff", 8);  // opcode 0x63, one payload word
    write("bad", no_such_packet + read("p") + no_such_packet);
    const Outcome outcome = sheen({"run", "bad", "--device", "hls", "--pixels", "r"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 3) << outcome.err;
    EXPECT_NE(outcome.err.find("0x63000001"), std::string::npos) << outcome.err;
    const std::string pixels = read("r");
    ASSERT_EQ(pixels.size(), read("q").size() + 16);
    EXPECT_TRUE(pixels.substr(8, pixels.size() - 16) == read("q")) << "the good packets' words differ";
}

TEST_F(command, info_tells_version_formats_and_capabilities) {
    for (const char* device : {"hls", "reference"}) {
        const Outcome outcome = sheen({"info", "--device", device});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        for (const char* word : {"sheen ", "protocol", "<32,10>", "quadratic", "builtin:teapot", device}) {
            EXPECT_NE(outcome.out.find(word), std::string::npos) << word << " is missing in: " << outcome.out;
        }
    }
}

}  // namespace
