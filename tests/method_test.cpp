// SPDX-License-Identifier: MIT
// Methods: what is interpolated, that neighbours agree, and what reaches the device for whole and clipped triangles.
#include "sheen/method.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "sheen/error.hpp"
#include "support/expected_pixels.hpp"
#include "support/fits.hpp"
#include "support/fitted_setups.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 19790806;

Scene lit_scene(int width = 512, int height = 512) {
    Scene scene;
    scene.lights = {{glm::normalize(glm::dvec3(-0.4, 0.5, 0.77)), glm::dvec3(1.0)}};
    scene.width = width;
    scene.height = height;
    return scene;
}

double real(Rng& rng, double low, double high) {
    return low + (high - low) * static_cast<double>(uniform(rng, 0, 1 << 20)) / (1 << 20);
}

glm::dvec3 random_normal(Rng& rng) {
    return glm::normalize(glm::dvec3(real(rng, -1, 1), real(rng, -1, 1), real(rng, 0.05, 1)));
}

/// A screen triangle with random normals, positions and depths, clipped to the scene's image.
ScreenTriangle screen_triangle(Rng& rng, const Scene& scene, const Triangle& points) {
    ScreenTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
        triangle.vertices[k] = {points[k],
                                real(rng, 1, 65534),
                                {real(rng, -1, 1), real(rng, -1, 1), real(rng, -5, -3)},
                                random_normal(rng)};
    }
    triangle.face_normal = random_normal(rng);
    triangle.walks = walk_in_image(points[0], points[1], points[2], scene.width, scene.height);
    return triangle;
}

/// A triangle's polynomials, about the middle of its bounding box.
struct Shading {
    std::array<Polynomial, 3> colour;
    Polynomial depth;
    bool linear = false;
};

Shading shade_triangle(Method method, const Scene& scene, const ScreenTriangle& t) {
    const TriangleNodes nodes = shade_nodes(method, scene, t);
    const PixelIndex origin = centre_pixel({t.vertices[0].point, t.vertices[1].point, t.vertices[2].point});
    return {fit_colour(nodes, t, origin), fit_depth(t, origin), nodes.linear};
}

glm::dvec3 colour_at(const Shading& shading, const SnappedPoint& p) {
    const auto x = static_cast<int>((p.x - 128) / 256);
    const auto y = static_cast<int>((p.y - 128) / 256);
    return {shading.colour[0].at(x, y), shading.colour[1].at(x, y), shading.colour[2].at(x, y)};
}

void expect_near(const glm::dvec3& got, const glm::dvec3& expected, const std::string& what) {
    EXPECT_LT(glm::length(got - expected), 1e-8) << what
                                                 << fmt::format(": expected ({}, {}, {}), got ({}, {}, {})", expected.x,
                                                                expected.y, expected.z, got.x, got.y, got.z);
}

TEST(Method, NamesComeBackAndUnknownOnesAreAnsweredWithTheList) {
    std::set<std::string> names;
    for (const Method method : all_methods()) {
        EXPECT_EQ(parse_method(to_string(method)), method);
        names.insert(to_string(method));
        const bool lit = method == Method::log_quadratic || method == Method::taylor || method == Method::taylor_finite;
        EXPECT_EQ(has_log_channels(method), lit);
        EXPECT_EQ(has_packets(method), lit || method <= Method::quadratic);
    }
    EXPECT_EQ(names, (std::set<std::string>{"flat", "gouraud", "quadratic", "duff", "taylor", "taylor-finite",
                                            "spherical", "recurrence", "log-quadratic", "phong"}));
    try {
        parse_method("Gouraud");
        ADD_FAILURE() << "accepted";
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(),
                     "unknown method 'Gouraud': expected one of flat, gouraud, quadratic, duff, taylor, taylor-finite, "
                     "spherical, recurrence, log-quadratic, phong");
    }
}

TEST(Method, MidpointNormalsAreUnitSymmetricAndNeverUndefined) {
    Rng rng(seed);
    const glm::dvec3 eye(0, 0, 1);
    for (int k = 0; k < 20000; ++k) {
        const glm::dvec3 a = k % 7 == 0 ? eye : random_normal(rng);
        glm::dvec3 b = random_normal(rng);
        if (k % 3 == 0) b = -a;
        if (k % 3 == 1) b = glm::normalize(-a + 1e-7 * b);
        const glm::dvec3 n = midpoint_normal(a, b, eye);
        ASSERT_NEAR(glm::length(n), 1.0, 1e-9) << k;
        ASSERT_EQ(n, midpoint_normal(b, a, eye)) << k;
        if (k % 3 == 2) {
            ASSERT_LT(glm::length(n - glm::normalize(a + b)), 1e-12) << k;
        } else if (k % 7 != 0) {
            ASSERT_LT(std::abs(glm::dot(n, a)), 1e-6) << "opposite normals: " << k;
            ASSERT_GE(glm::dot(n, eye), -1e-6) << k;
        }
    }
}

TEST(Method, QuadraticInterpolatesTheRadianceAtVerticesAndMidpoints) {
    Rng rng(seed + 1);
    const Scene scene = lit_scene();
    for (int k = 0; k < 1000; ++k) {
        const ScreenTriangle t = screen_triangle(rng, scene, triangle_on_centres(rng));
        const Shading shading = shade_triangle(Method::quadratic, scene, t);
        EXPECT_FALSE(shading.linear);
        for (std::size_t n = 0; n < 3; ++n) {
            const ScreenVertex& a = t.vertices[n];
            const ScreenVertex& b = t.vertices[(n + 1) % 3];
            const auto radiance = [&](const glm::dvec3& normal) {
                return shade(scene.material, scene.lights, {glm::dvec3(0.0), normal, {0.0, 0.0, 1.0}});
            };
            expect_near(colour_at(shading, a.point), radiance(a.normal), "vertex");
            expect_near(colour_at(shading, middle(a.point, b.point)), radiance(glm::normalize(a.normal + b.normal)),
                        "midpoint");
        }
        if (HasFailure()) FAIL() << "triangle " << k << " of seed " << seed + 1;
    }
}

TEST(Method, GouraudAndFlatAreLinearAndExactAtTheirNodes) {
    Rng rng(seed + 2);
    const Scene scene = lit_scene();
    for (int k = 0; k < 1000; ++k) {
        const ScreenTriangle t = screen_triangle(rng, scene, triangle_on_centres(rng));
        const Shading gouraud = shade_triangle(Method::gouraud, scene, t);
        const Shading flat = shade_triangle(Method::flat, scene, t);
        EXPECT_TRUE(gouraud.linear && flat.linear);
        const glm::dvec3 face = shade(scene.material, scene.lights, {glm::dvec3(0.0), t.face_normal, {0.0, 0.0, 1.0}});
        for (std::size_t n = 0; n < 3; ++n) {
            const ScreenVertex& a = t.vertices[n];
            const ScreenVertex& b = t.vertices[(n + 1) % 3];
            const glm::dvec3 colour = shade(scene.material, scene.lights, {glm::dvec3(0.0), a.normal, {0.0, 0.0, 1.0}});
            const glm::dvec3 next = shade(scene.material, scene.lights, {glm::dvec3(0.0), b.normal, {0.0, 0.0, 1.0}});
            expect_near(colour_at(gouraud, a.point), colour, "gouraud vertex");
            expect_near(colour_at(gouraud, middle(a.point, b.point)), 0.5 * (colour + next), "gouraud midpoint");
            expect_near(colour_at(flat, a.point), face, "flat");
        }
        for (const ScreenVertex& v : t.vertices) {
            const auto x = static_cast<int>(v.point.x / 256);
            const auto y = static_cast<int>(v.point.y / 256);
            for (const Shading* shading : {&gouraud, &flat}) {
                EXPECT_NEAR(shading->depth.at(x, y), v.depth, 1e-8);
            }
        }
        if (HasFailure()) FAIL() << "triangle " << k << " of seed " << seed + 2;
    }
}

TEST(Method, BrightNodesAreClampedSoThatTheQuadraticFitsTenIntegerBits) {
    Rng rng(seed + 3);
    Scene scene = lit_scene();
    scene.lights[0].colour = glm::dvec3(50.0);
    double highest = 0.0;
    for (int k = 0; k < 300; ++k) {
        const ScreenTriangle t = screen_triangle(rng, scene, random_triangle(rng, 100));
        const auto setups = make_setups(Method::quadratic, scene, {t});
        if (setups.empty()) continue;
        const Shading shading = shade_triangle(Method::quadratic, scene, t);
        for_each_row(setups[0].walk, [&](const WalkRow& row) {
            for (int pixel = 0; pixel < row.length; ++pixel) {
                const int x = row.x + (setups[0].walk.leftward ? -pixel : pixel);
                const double value = shading.colour[0].at(x, row.y);
                highest = std::max(highest, value);
                const double got = colour_of(channel_value(setups[0].colour[0], row.carries + pixel, row.row));
                ASSERT_NEAR(got - 0.5, value, 0.01) << "wrapped at " << x << ", " << row.y;
            }
        });
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(highest, 300.0);
    EXPECT_LT(highest, 511.0);
}

TEST(Method, PhongHasNoPolynomial) {
    Rng rng(seed + 4);
    const Scene scene = lit_scene();
    const ScreenTriangle t = screen_triangle(rng, scene, triangle_on_centres(rng));
    EXPECT_THROW(shade_nodes(Method::phong, scene, t), Error);
    EXPECT_THROW(shade_nodes(Method::log_quadratic, scene, t), Error);
}

/// Whatever lies beside the edge: neighbours have the same colour along it, opposite normals included.
TEST(Method, NeighboursAgreeAlongTheirSharedEdge) {
    Rng rng(seed + 5);
    const Scene scene = lit_scene();
    for (int k = 0; k < 1000; ++k) {
        ScreenTriangle left = screen_triangle(rng, scene, triangle_on_centres(rng));
        if (k % 4 == 0) left.vertices[1].normal = -left.vertices[0].normal;
        ScreenTriangle right = screen_triangle(rng, scene, triangle_on_centres(rng));
        right.vertices[0] = left.vertices[1];
        right.vertices[1] = left.vertices[0];
        if (doubled_area(right.vertices[0].point, right.vertices[1].point, right.vertices[2].point) == 0) continue;
        for (const Method method : {Method::gouraud, Method::quadratic}) {
            const Shading a = shade_triangle(method, scene, left);
            const Shading b = shade_triangle(method, scene, right);
            const SnappedPoint p = left.vertices[0].point;
            const SnappedPoint q = left.vertices[1].point;
            for (const SnappedPoint& point : {p, middle(p, q), q}) {
                expect_near(colour_at(a, point), colour_at(b, point), to_string(method));
            }
        }
        if (HasFailure()) FAIL() << "pair " << k << " of seed " << seed + 5;
    }
}

TEST(Method, SetupsFollowTheWalksInOrder) {
    Rng rng(seed + 6);
    const Scene scene = lit_scene(40, 30);
    std::vector<ScreenTriangle> triangles;
    std::vector<std::pair<int, int>> starts;
    for (int k = 0; k < 500; ++k) {
        Triangle t = random_triangle(rng, 60);
        for (SnappedPoint& p : t) p = {p.x - 2560, p.y - 2560};
        triangles.push_back(screen_triangle(rng, scene, t));
        for (const TriangleWalk& walk : triangles.back().walks) starts.emplace_back(walk.x, walk.y);
    }
    for (const Method method : {Method::flat, Method::gouraud, Method::quadratic}) {
        const auto setups = make_setups(method, scene, triangles);
        ASSERT_EQ(setups.size(), starts.size());
        for (std::size_t k = 0; k < setups.size(); ++k) {
            ASSERT_EQ(std::make_pair(setups[k].walk.x, setups[k].walk.y), starts[k]);
            ASSERT_EQ(setups[k].linear, method != Method::quadratic);
            ASSERT_TRUE(setups[k].depth.has_value());
            ASSERT_TRUE(setups[k].log.empty());
            for (const std::uint64_t word : expected_pixels(setups[k])) {
                const Pixel pixel = decode_pixel(word);
                ASSERT_TRUE(pixel.x < scene.width && pixel.y < scene.height);
            }
            if (!setups[k].linear) continue;
            for (const ChannelWords& channel : setups[k].colour) {
                ASSERT_EQ((std::array{channel.words[3], channel.words[4], channel.words[5]}),
                          (std::array<std::uint32_t, 3>{}));
            }
        }
    }
    EXPECT_GT(starts.size(), 200U);
}

/// The polynomial belongs to the unclipped triangle, its rounding to the walk: a triangle a hundred times the image's
/// size is as exact as a small one.
TEST(Method, HugeTrianglesAreExactWhereTheyAreDrawn) {
    Rng rng(seed + 7);
    const Scene scene = lit_scene(64, 48);
    double worst = 0.0;
    std::size_t pixels = 0;
    for (int k = 0; k < 400; ++k) {
        Triangle t{};
        for (SnappedPoint& p : t) p = {uniform(rng, -1500000, 1500000), uniform(rng, -1500000, 1500000)};
        const ScreenTriangle triangle = screen_triangle(rng, scene, t);
        const Shading shading = shade_triangle(Method::quadratic, scene, triangle);
        for (const TriangleSetup& setup : make_setups(Method::quadratic, scene, {triangle})) {
            for_each_row(setup.walk, [&](const WalkRow& row) {
                for (int pixel = 0; pixel < row.length; ++pixel) {
                    const int x = row.x + (setup.walk.leftward ? -pixel : pixel);
                    for (std::size_t c = 0; c < 3; ++c) {
                        const double got = colour_of(channel_value(setup.colour[c], row.carries + pixel, row.row));
                        worst = std::max(worst, std::abs(got - 0.5 - shading.colour[c].at(x, row.y)));
                        ++pixels;
                    }
                }
            });
        }
    }
    fmt::print("huge triangles on 64x48: max error {:.6f} steps of 8 bits on {} values\n", worst, pixels);
    EXPECT_GT(pixels, 100000U);
    // ½·(1 + X + Y + X² + XY + Y²)·2^−22 for walks of 64×48 pixels, X ≤ 33, Y ≤ 25
    EXPECT_LE(worst, 0.5 * (1 + 33 + 25 + 33 * 33 + 33 * 25 + 25 * 25) / (1 << 22));
}

/// A sliver from far left to far right of a 64×64 image, thinner than a subpixel where it crosses it.
Triangle sliver_across_the_image(Rng& rng) {
    const std::int64_t size = 256 * 64;
    const SnappedPoint a{-uniform(rng, 1, 20) * size, uniform(rng, 0, size)};
    const SnappedPoint b{uniform(rng, 2, 20) * size, uniform(rng, 0, size)};
    Triangle t{a, b, {b.x + uniform(rng, -2, 2), b.y + uniform(rng, 1, 2)}};
    if (uniform(rng, 0, 1) == 1) {
        for (SnappedPoint& p : t) std::swap(p.x, p.y);
    }
    return t;
}

/// Outside a sliver its polynomials soar: what the image leaves of one must stay in it.
TEST(Method, ClippedSliversStayInTheRangeOfTheirNodes) {
    Rng rng(seed + 8);
    const Scene scene = lit_scene(64, 64);
    std::size_t pixels = 0;
    for (int k = 0; k < 20000; ++k) {
        const Triangle t = sliver_across_the_image(rng);
        ScreenTriangle triangle = screen_triangle(rng, scene, t);
        for (ScreenVertex& v : triangle.vertices) v.depth = real(rng, 1, 3);
        for (const Method method : {Method::gouraud, Method::quadratic}) {
            for (const TriangleSetup& setup : make_setups(method, scene, {triangle})) {
                for_each_row(setup.walk, [&](const WalkRow& row) {
                    for (int pixel = 0; pixel < row.length; ++pixel) {
                        const double red = colour_of(channel_value(setup.colour[0], row.carries + pixel, row.row));
                        const std::uint32_t depth = channel_value(*setup.depth, row.carries + pixel, row.row) >> 16;
                        ASSERT_GT(red, method == Method::gouraud ? -12.0 : -200.0) << "sliver " << k;
                        ASSERT_LT(red, method == Method::gouraud ? 280.0 : 450.0) << "sliver " << k;
                        ASSERT_LE(depth, 4U) << "sliver " << k;
                        ++pixels;
                    }
                });
                if (HasFatalFailure()) return;
            }
        }
    }
    EXPECT_GT(pixels, 5000U);
}

}  // namespace
}  // namespace sheen::test
