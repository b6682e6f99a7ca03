// SPDX-License-Identifier: MIT
/// \file
/// The scene's options through the built command: what they refuse, and that each reaches the picture.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "support/command_fixture.hpp"

namespace {

using sheen::test::Outcome;
using sheen::test::Words;

class command_scene : public sheen::test::CommandTest {
 protected:
    /// The bytes of a small picture of `mesh` by the reference.
    [[nodiscard]] std::string picture(const std::string& mesh, const Words& more) const {
        Words words = {"render", mesh, "--device", "reference", "--size", "40x30", "-o", "out.png"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = sheen(words);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return read("out.png");
    }
    void expect_usage_error(const Words& more, const std::string& culprit) const {
        Words words = {"render", "builtin:sphere-168", "--device", "reference", "--size", "40x30", "-o", "out.png"};
        words.insert(words.end(), more.begin(), more.end());
        expect_refusal(words, 2, culprit);
    }
};

TEST_F(command_scene, values_out_of_range_are_refused_by_name) {
    for (const char* degrees : {"0", "0.9", "171", "180", "-30", "nan", "inf", "wide", "", "60,60"}) {
        expect_usage_error({"--perspective", degrees}, "--perspective");
    }
    for (const char* radii : {"-1", "1001", "nan", "inf", "far"}) {
        expect_usage_error({"--perspective", "30", "--distance", radii}, "--distance");
    }
    for (const char* place : {"1,2", "nan,0,0", "0,inf,0", "1e999,0,0", "1e101,0,0", "here", "1,2,3,4"}) {
        expect_usage_error({"--point-light", place}, "--point-light");
    }
    for (const char* slope : {"0", "0.009", "1.1", "nan", "-1"}) {
        expect_usage_error({"--brdf", "cook-torrance", "--roughness", slope}, "--roughness");
    }
    for (const char* reflectance : {"-.1", "1.1", "nan"}) {
        expect_usage_error({"--brdf", "cook-torrance", "--fresnel", reflectance}, "--fresnel");
    }
    for (const char* model : {"velvet", "Phong", "cook_torrance", ""}) expect_usage_error({"--brdf", model}, "--brdf");
}

TEST_F(command_scene, options_that_do_not_go_together_are_refused) {
    expect_usage_error({"--distance", "3"}, "--perspective");
    expect_usage_error({"--roughness", ".3"}, "--roughness");
    expect_usage_error({"--brdf", "phong", "--fresnel", ".3"}, "--fresnel");
    expect_usage_error({"--shininess", "20", "--brdf", "cook-torrance"}, "--shininess");
    expect_usage_error({"--light-colour", "1,1,1", "--point-light", "0,0,0"}, "--light-colour");
    expect_usage_error({"--point-light", "0,0,0", "--light-colour", "1,1,1", "--light-colour", "1,0,0"}, "'1,0,0'");
    expect_refusal({"compare", "builtin:sphere-168", "--lights", "measured", "--point-light", "0,0,0"}, 2, "--light");
}

TEST_F(command_scene, each_option_changes_the_picture) {
    const Words facets = {"--brdf", "cook-torrance"};
    const std::map<std::string, Words> scenes = {
        {"default", {}},
        {"perspective", {"--perspective", "60"}},
        {"wider", {"--perspective", "90"}},
        {"nearer", {"--perspective", "90", "--distance", "1.2"}},
        {"inside", {"--perspective", "90", "--distance", ".5", "--two-sided"}},
        {"lamp", {"--point-light", "0,0,-2.5"}},
        {"red lamp", {"--point-light", "0,0,-2.5", "--light-colour", "1,0,0"}},
        {"lamp and default light", {"--light", "-.4,.5,.77", "--point-light", "0,0,-2.5"}},
        {"phong", {"--brdf", "phong"}},
        {"dull phong", {"--brdf", "phong", "--shininess", "3"}},
        {"facets", facets},
        {"rough facets", {"--brdf", "cook-torrance", "--roughness", ".5"}},
        {"mirrors", {"--brdf", "cook-torrance", "--fresnel", ".9"}},
    };
    std::map<std::string, std::string> seen;
    for (const auto& [name, words] : scenes) {
        const auto [other, fresh] = seen.try_emplace(picture("builtin:sphere-168", words), name);
        EXPECT_TRUE(fresh) << name << " looks like " << other->second;
    }
    const std::string defaults = picture("builtin:sphere-168", {});
    EXPECT_EQ(picture("builtin:sphere-168", {"--brdf", "blinn", "--light", "-.4,.5,.77"}), defaults);
    EXPECT_EQ(picture("builtin:sphere-168", {"--perspective", "60"}),
              picture("builtin:sphere-168", {"--distance", "2.168802366", "--perspective", "60"}));
    EXPECT_EQ(picture("builtin:sphere-168", facets),
              picture("builtin:sphere-168", {"--fresnel", ".1", "--roughness", ".2", "--brdf", "cook-torrance"}));
}

TEST_F(command_scene, options_override_their_component_in_the_meshs_own_materials) {
    const std::string lines = "mtllib own.mtl\nusemtl own\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
    write("own.obj", lines);
    write("own.mtl", "newmtl own\nKa 0 0 0\nKd 0 1 0\nKs 0 0 0\nNs 10\n");
    const Words light = {"--light", "0,0,1"};
    const auto with = [&light](Words more) {
        more.insert(more.end(), light.begin(), light.end());
        return more;
    };
    const std::string own = picture("own.obj", light);
    EXPECT_NE(own, picture("good.obj", light)) << "the file's material is not used";
    EXPECT_EQ(own, picture("own.obj", with({"--kd", "0,1,0"}))) << "the file's own value changes nothing";
    EXPECT_EQ(picture("own.obj", with({"--kd", "1,0,0"})),
              picture("good.obj", with({"--ka", "0,0,0", "--kd", "1,0,0", "--ks", "0"})));
}

TEST_F(command_scene, a_flight_through_a_mesh_is_drawn_alike_by_reference_and_kernels) {
    for (const char* distance : {"0", ".4", "1"}) {
        const Outcome outcome = sheen({"compare", "builtin:torus-knot", "--perspective", "100", "--distance", distance,
                                       "--two-sided", "--point-light", "0,0,0", "--methods", "flat,gouraud,quadratic",
                                       "--size", "64x48", "--json", "rows.json"});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const auto rows = nlohmann::json::parse(read("rows.json"));
        ASSERT_EQ(rows.size(), 6U);
        for (std::size_t k = 0; k < rows.size(); k += 2) {
            SCOPED_TRACE(rows[k].dump() + " " + rows[k + 1].dump());
            EXPECT_GT(rows[k]["pixels"], 500);
            EXPECT_EQ(rows[k]["pixels"], rows[k + 1]["pixels"]);
            EXPECT_NEAR(rows[k]["max_error"].get<double>(), rows[k + 1]["max_error"].get<double>(), 1.5);
        }
    }
}

}  // namespace
