// SPDX-License-Identifier: MIT
// Methods with log channels on a device: within a derived bound of the method in double, whatever came before.
#include "sheen/lit_setup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "sheen/device.hpp"
#include "sheen/error.hpp"
#include "sheen/packet.hpp"
#include "sheen/render.hpp"
#include "sheen/shader.hpp"
#include "support/lit_triangles.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 20260814;
constexpr std::array<Method, 3> lit_methods{Method::log_quadratic, Method::taylor, Method::taylor_finite};

/// One walk of a subject's triangle.
struct Piece {
    const LitSubject* subject;
    LitNodes nodes;
    TriangleSetup setup;
};

/// The pieces of all subjects but those that a channel can't hold, which are counted.
std::vector<Piece> pieces_of(const std::vector<LitSubject>& subjects, std::size_t& refused) {
    std::vector<Piece> pieces;
    for (const LitSubject& subject : subjects) {
        const LitSetups lit(subject.method, {}, subject.scene);
        try {
            const LitNodes nodes = lit.nodes(subject.triangle);
            for (const TriangleWalk& walk : subject.triangle.walks) {
                pieces.push_back({&subject, nodes, LitSetups::setup(nodes, subject.triangle, walk)});
            }
        } catch (const Error&) {
            ++refused;
        }
    }
    return pieces;
}

/// The pixels of each setup, drawn one after the other in one stream.
std::vector<std::vector<std::uint64_t>> draw_each(const std::vector<TriangleSetup>& setups) {
    const auto device = make_device("hls");
    const std::vector<std::uint64_t> words = device->run(picture_packets(setups)).words;
    std::vector<std::vector<std::uint64_t>> pixels;
    std::size_t next = 0;
    for (const TriangleSetup& setup : setups) {
        std::size_t count = 0;
        for_each_span(setup.walk, [&](int, int, int length, int) { count += static_cast<std::size_t>(length); });
        if (next + count > words.size()) throw Error("pixels are missing");
        const auto first = words.begin() + static_cast<std::ptrdiff_t>(next);
        pixels.emplace_back(first, first + static_cast<std::ptrdiff_t>(count));
        next += count;
    }
    if (next + 1 != words.size()) throw Error("more words than pixels and the fence's echo");
    return pixels;
}

/// How far this pixel's components may lie from the method in double precision.
glm::dvec3 bound_at(const Piece& piece, const Pixel& pixel, const glm::dvec3& weights) {
    const double log_error = channel_error(piece.setup.walk, pixel.x, pixel.y, hls::log_fraction_bits);
    double highlights = 0.0;
    for (std::size_t k = 0; k < piece.nodes.log.size(); ++k) {
        TriangleNodes channel;
        for (std::size_t node = 0; node < 6; ++node) channel.colour[node] = glm::dvec3(piece.nodes.log[k][node]);
        const double value = channel.colour_at(weights).x;
        if (piece.nodes.table == nullptr) {
            highlights += exp2_error(value, log_error);
            continue;
        }
        const Material& material = piece.subject->scene.material;
        const double strength = 255.0 * material.specular * piece.subject->scene.lights[0].colour.x;
        highlights += power_error(*piece.nodes.table, strength, (64.0 * value - 0.5) / 1023.0, log_error);
    }
    const double diffuse = channel_error(piece.setup.walk, pixel.x, pixel.y, hls::colour_fraction_bits);
    return glm::dvec3(pixel_error() + diffuse + highlights);
}

/// Largest errors met, in 8-bit steps.
struct Largest {
    double error = 0.0;
    double bound = 0.0;  ///< there
    double share = 0.0;  ///< of its bound, anywhere
    std::size_t pixels = 0;
};

void judge(const Piece& piece, const std::vector<std::uint64_t>& words, Largest& largest) {
    const LitSubject& subject = *piece.subject;
    MethodOptions options;
    options.log_node_limit = greatest_z_node;
    const auto shader = make_shader(subject.method, options, subject.scene, subject.triangle);
    for (const std::uint64_t word : words) {
        const Pixel pixel = decode_pixel(word);
        const glm::dvec3 weights = weights_at(subject.triangle, pixel.x, pixel.y);
        const glm::dvec3 exact = shader->colour(pixel.x, weights);
        const glm::dvec3 bound = bound_at(piece, pixel, weights);
        const glm::dvec3 drawn(pixel.red, pixel.green, pixel.blue);
        for (int c = 0; c < 3; ++c) {
            const double error = std::abs(drawn[c] - std::clamp(exact[c], 0.0, 255.0));
            ASSERT_LE(error, bound[c]) << to_string(subject.method) << " at (" << pixel.x << ", " << pixel.y
                                       << "), component " << c << ": expected " << exact[c] << ", got " << drawn[c];
            if (error > largest.error) largest = {error, bound[c], largest.share, largest.pixels};
            largest.share = std::max(largest.share, error / bound[c]);
        }
        ++largest.pixels;
    }
}

/// Subjects with triangles of every kind that cover a pixel: up to `max_px` pixels wide and high.
std::vector<LitSubject> random_subjects(Rng& rng, Method method, int max_px, std::size_t count) {
    std::vector<LitSubject> subjects;
    while (subjects.size() < count) {
        LitSubject subject = random_subject(rng, method, random_triangle(rng, max_px));
        if (!subject.triangle.walks.empty()) subjects.push_back(std::move(subject));
    }
    return subjects;
}

TEST(LitSetup, EveryPixelLiesWithinTheBoundOfTheMethodInDouble) {
    Rng rng(seed);
    struct Extent {
        int max_px;
        std::size_t count;
    };
    for (const Method method : lit_methods) {
        for (const Extent& extent : {Extent{2, 150}, Extent{60, 150}, Extent{300, 40}, Extent{1000, 12}}) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << ", up to " << extent.max_px << " px");
            const auto subjects = random_subjects(rng, method, extent.max_px, extent.count);
            std::size_t refused = 0;
            const std::vector<Piece> pieces = pieces_of(subjects, refused);
            EXPECT_LT(refused, subjects.size() / 4);
            std::vector<TriangleSetup> setups;
            for (const Piece& piece : pieces) setups.push_back(piece.setup);
            const auto pixels = draw_each(setups);
            Largest largest;
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                judge(pieces[i], pixels[i], largest);
                if (HasFatalFailure()) return;
            }
            std::cout << to_string(method) << ", up to " << extent.max_px << " px, " << largest.pixels
                      << " pixels: at most " << largest.error << " steps, where " << largest.bound
                      << " are the bound; at most " << largest.share << " of the bound; " << refused << " refused\n";
        }
    }
}

/// Plain and lit triangles, materials and tables in any order: each is drawn as it is alone.
TEST(LitSetup, MethodMaterialAndTableOfATriangleChangeNoOtherTrianglesPixels) {
    Rng rng(seed + 1);
    for (int round = 0; round < 12; ++round) {
        SCOPED_TRACE(testing::Message() << "seed " << seed + 1 << ", round " << round);
        std::vector<TriangleSetup> setups;
        std::size_t refused = 0;
        for (const Method method : lit_methods) {
            const auto subjects = random_subjects(rng, method, 20, 8);
            for (const Piece& piece : pieces_of(subjects, refused)) setups.push_back(piece.setup);
        }
        for (const Method method : {Method::flat, Method::gouraud, Method::quadratic}) {
            for (const LitSubject& subject : random_subjects(rng, Method::log_quadratic, 20, 4)) {
                for (TriangleSetup& setup : make_setups(method, subject.scene, {subject.triangle})) {
                    setups.push_back(std::move(setup));
                }
            }
        }
        // Each several times, so that materials and tables come back.
        const std::vector<TriangleSetup> once = setups;
        setups.insert(setups.end(), once.begin(), once.end());
        std::shuffle(setups.begin(), setups.end(), rng);
        const auto together = draw_each(setups);
        for (std::size_t i = 0; i < setups.size(); ++i) {
            ASSERT_EQ(together[i], draw_each({setups[i]}).front()) << "triangle " << i;
        }
    }
}

/// One triangle that faces the eye, 40 pixels wide and high.
ScreenTriangle facing_triangle(const Scene& scene) {
    ScreenTriangle triangle;
    const std::array<SnappedPoint, 3> points{{{1000, 1000}, {11000, 1200}, {5000, 11000}}};
    for (std::size_t k = 0; k < 3; ++k) {
        triangle.vertices[k] = {points[k], 100.0, {0.1 * static_cast<double>(k), 0.0, -4.0}, {0.0, 0.0, 1.0}};
    }
    triangle.face_normal = {0.0, 0.0, 1.0};
    triangle.material = scene.material;
    triangle.walks = walk_in_image(points[0], points[1], points[2], scene.width, scene.height);
    return triangle;
}

Scene scene_of(const std::vector<Light>& lights) {
    Scene scene;
    scene.lights = lights;
    return scene;
}

const Light white{glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(1.0)};
const Light reddish{glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(1.0, 0.5, 0.5)};
const Light black{glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0)};

/// What devices have against it; empty where nothing.
std::string reason(Method method, const Scene& scene, const MethodOptions& options = {}) {
    return why_not_on_devices(method, options, scene).value_or("");
}

TEST(LitSetup, WhatDevicesCantDrawIsRefusedByNameAndWithAWayOut) {
    for (const Method method : lit_methods) {
        EXPECT_EQ(reason(method, scene_of({white})), "");
        EXPECT_EQ(reason(method, scene_of({})), "");
        EXPECT_EQ(reason(method, scene_of({black, white, black})), "");
        const std::string coloured = reason(method, scene_of({black, reddish}));
        EXPECT_NE(coloured.find(to_string(method) + ": light 2 is coloured"), std::string::npos) << coloured;
        EXPECT_NE(coloured.find("or take quadratic"), std::string::npos) << coloured;
        EXPECT_THROW(make_setups(method, scene_of({reddish}), {}), Error);
        Scene dull = scene_of({reddish});
        dull.material.specular = 0.0;
        EXPECT_EQ(reason(method, dull), "") << "no highlight is coloured";
    }
    EXPECT_EQ(reason(Method::log_quadratic, scene_of({white, white, white, white})), "");
    MethodOptions many;
    many.log_channels = 4;
    EXPECT_NE(reason(Method::log_quadratic, scene_of({white, white, white, white}), many), "");
    MethodOptions none;
    none.log_channels = 0;
    EXPECT_EQ(reason(Method::log_quadratic, scene_of({reddish}), none), "") << "the highlight is in the colour nodes";
    MethodOptions large;
    large.taylor_table_bytes = 8192;
    for (const Method method : {Method::taylor, Method::taylor_finite}) {
        const std::string lights = reason(method, scene_of({white, black, white}));
        EXPECT_NE(lights.find("2 lights"), std::string::npos) << lights;
        EXPECT_NE(reason(method, scene_of({white}), large).find("8192"), std::string::npos);
    }
    EXPECT_EQ(reason(Method::quadratic, scene_of({reddish, reddish})), "");
    EXPECT_THROW(LitSetups(Method::quadratic, {}, scene_of({white})), Error);
}

/// The error of make_setups; empty when there is none.
std::string complaint(Method method, const Scene& scene, const ScreenTriangle& triangle) {
    try {
        (void)make_setups(method, scene, {triangle});
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(LitSetup, NodesThatNoChannelHoldsAreAnErrorThatNamesThePlace) {
    Scene bright = scene_of({white});
    bright.lights[0].colour = glm::dvec3(std::ldexp(1.0, 15));
    bright.material.specular = 1.0;
    EXPECT_EQ(complaint(Method::log_quadratic, bright, facing_triangle(bright)), "");
    bright.lights[0].colour *= 4.0;
    const std::string log = complaint(Method::log_quadratic, bright, facing_triangle(bright));
    EXPECT_NE(log.find("log-quadratic: the triangle at pixel (22, 17) has a highlight's z of"), std::string::npos)
        << log;

    // Normals that nearly cancel at the centre: the series runs away from it.
    const Scene scene = scene_of({white});
    ScreenTriangle bent = facing_triangle(scene);
    bent.vertices[0].normal = glm::normalize(glm::dvec3(1.0, 0.0, 0.05));
    bent.vertices[1].normal = glm::normalize(glm::dvec3(-0.5, 0.87, 0.05));
    bent.vertices[2].normal = glm::normalize(glm::dvec3(-0.5, -0.87, 0.05));
    const std::string taylor = complaint(Method::taylor, scene, bent);
    EXPECT_NE(taylor.find("taylor: the triangle at pixel (22, 17) has"), std::string::npos) << taylor;
    EXPECT_NE(taylor.find("smaller triangles"), std::string::npos) << taylor;
    EXPECT_EQ(complaint(Method::log_quadratic, scene, bent), "");
}

/// Without a highlight a triangle keeps its clamp: ambient alone where it is turned away from the light.
TEST(LitSetup, ATriangleWithoutAHighlightIsStillClampedBeforeAmbient) {
    for (const Method method : lit_methods) {
        Scene scene = scene_of({{glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(1.0)}});
        scene.material.specular = 0.0;
        scene.material.ambient = glm::dvec3(20.0 / 255.0, 0.0, 1.0);
        const auto setups = make_setups(method, scene, {facing_triangle(scene)});
        ASSERT_EQ(setups.size(), 1U);
        EXPECT_EQ(setups[0].log.size(), 1U);
        EXPECT_EQ(setups[0].table, nullptr);
        const auto pixels = draw_each(setups);
        for (const std::uint64_t word : pixels.front()) {
            const Pixel pixel = decode_pixel(word);
            ASSERT_EQ((std::array<int, 3>{pixel.red, pixel.green, pixel.blue}), (std::array<int, 3>{20, 0, 255}));
        }
    }
}

TEST(LitSetup, TrianglesOfOneMaterialShareItsTable) {
    const Scene scene = scene_of({white});
    const ScreenTriangle triangle = facing_triangle(scene);
    ScreenTriangle other = triangle;
    other.material.shininess = 7.0;
    const auto setups = make_setups(Method::taylor, scene, {triangle, other, triangle});
    ASSERT_EQ(setups.size(), 3U);
    EXPECT_EQ(setups[0].table, setups[2].table);
    EXPECT_NE(setups[0].table, setups[1].table);
    EXPECT_EQ(setups[0].material.power_channels, 1);
}

TEST(LitSetup, APowerTableHoldsTheRoundedHighlightAndSaturates) {
    for (const double strength : {0.0, 102.0, 255.0, 3000.0}) {
        for (const double shininess : {0.0, 1.0, 50.0, 400.0}) {
            const PowerEntries entries = power_entries(strength, shininess);
            ASSERT_EQ(entries.size(), 1024U);
            for (std::size_t k = 0; k < entries.size(); ++k) {
                const double exact = strength * std::pow(static_cast<double>(k) / 1023.0, shininess);
                ASSERT_NEAR(entries[k], std::min(exact, 255.0), 0.5) << "entry " << k;
            }
        }
    }
}

}  // namespace
}  // namespace sheen::test
