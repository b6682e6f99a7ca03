// SPDX-License-Identifier: MIT
// The double-precision reference: coverage, depth, Phong per pixel, polynomials, and the measured quality of the
// methods.
#include "sheen/reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sheen/device.hpp"
#include "sheen/metrics.hpp"
#include "sheen/packet.hpp"
#include "support/coverage_oracle.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 7007;

Scene lit_scene(int width, int height) {
    Scene scene;
    scene.width = width;
    scene.height = height;
    scene.lights = {{glm::normalize(glm::dvec3(-0.4, 0.5, 0.77)), glm::dvec3(1.0)}};
    return scene;
}

std::array<SnappedPoint, 3> points_of(const ScreenTriangle& t) {
    return {t.vertices[0].point, t.vertices[1].point, t.vertices[2].point};
}

void walk(ScreenTriangle& t, const Scene& scene) {
    const auto& v = t.vertices;
    t.walks = walk_in_image(v[0].point, v[1].point, v[2].point, scene.width, scene.height);
}

/// A triangle of random corners inside the image, with random front-facing normals and depths.
ScreenTriangle random_triangle(Rng& random, const Scene& scene) {
    std::uniform_real_distribution<double> tilt(-0.7, 0.7);
    std::uniform_real_distribution<double> depth(1.0, 65534.0);
    ScreenTriangle triangle;
    for (ScreenVertex& vertex : triangle.vertices) {
        vertex.point = {uniform(random, 0, 256 * scene.width), uniform(random, 0, 256 * scene.height)};
        vertex.depth = depth(random);
        vertex.normal = glm::normalize(glm::dvec3(tilt(random), tilt(random), 1.0));
    }
    triangle.face_normal = {0.0, 0.0, 1.0};
    walk(triangle, scene);
    return triangle;
}

/// Weights of the three corners at a pixel's centre by Cramer's rule in long double, independent of the library.
std::array<long double, 3> weights_at(const ScreenTriangle& t, int x, int y) {
    const SnappedPoint p = pixel_centre(x, y);
    const auto& v = t.vertices;
    const auto area = static_cast<long double>(cross(v[0].point, v[1].point, v[2].point));
    return {static_cast<long double>(cross(v[1].point, v[2].point, p)) / area,
            static_cast<long double>(cross(v[2].point, v[0].point, p)) / area,
            static_cast<long double>(cross(v[0].point, v[1].point, p)) / area};
}

template <typename Body>
void for_each_covered(const ReferenceImage& image, Body body) {
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto index = static_cast<std::size_t>(y * image.width + x);
            if (image.covered[index]) {
                body(x, y, image.colour[index]);
            }
        }
    }
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(actual[c], expected[c], tolerance) << "component " << c;
    }
}

TEST(Reference, CoversExactlyThePiecesPixelsAndCountsThem) {
    Rng random(seed);
    const Scene scene = lit_scene(31, 23);
    for (int run = 0; run < 100; ++run) {
        const std::vector<ScreenTriangle> triangles{random_triangle(random, scene), random_triangle(random, scene)};
        const ReferenceImage image = render_reference(Method::phong, scene, triangles);
        std::size_t pixels = 0;
        std::array<std::size_t, 2> each{};
        for (int y = 0; y < scene.height; ++y) {
            for (int x = 0; x < scene.width; ++x) {
                bool covered = false;
                for (std::size_t t = 0; t < 2; ++t) {
                    const bool here = edge_functions_cover(points_of(triangles[t]), x, y);
                    covered = covered || here;
                    each[t] += here ? 1 : 0;
                    pixels += here ? 1 : 0;
                }
                EXPECT_EQ(image.covered[static_cast<std::size_t>(y * scene.width + x)], covered)
                    << "pixel " << x << ", " << y << ", run " << run << ", seed " << seed;
            }
        }
        EXPECT_EQ(image.pixels, pixels);
        EXPECT_EQ(image.triangles, static_cast<std::size_t>((each[0] > 0) + (each[1] > 0)));
    }
}

TEST(Reference, PhongIsTheNormalisedLinearNormalShaded) {
    Rng random(seed);
    const Scene scene = lit_scene(40, 30);
    for (int run = 0; run < 40; ++run) {
        const ScreenTriangle triangle = random_triangle(random, scene);
        for_each_covered(render_reference(Method::phong, scene, {triangle}), [&](int x, int y, const glm::dvec3& got) {
            const auto w = weights_at(triangle, x, y);
            glm::dvec3 normal(0.0);
            for (std::size_t k = 0; k < 3; ++k) {
                normal += static_cast<double>(w[k]) * triangle.vertices[k].normal;
            }
            const glm::dvec3 colour =
                shade(scene.material, scene.lights, {glm::dvec3(0.0), glm::normalize(normal), {0.0, 0.0, 1.0}});
            expect_near(got, glm::clamp(colour, 0.0, 255.0), 1e-8);
        });
    }
}

TEST(Reference, GouraudIsTheLinearColourAndFlatTheFacesColour) {
    Rng random(seed);
    const Scene scene = lit_scene(40, 30);
    for (int run = 0; run < 40; ++run) {
        const ScreenTriangle triangle = random_triangle(random, scene);
        const auto colour_of = [&](const glm::dvec3& n) {
            return shade(scene.material, scene.lights, {glm::dvec3(0.0), n, {0.0, 0.0, 1.0}});
        };
        for_each_covered(render_reference(Method::gouraud, scene, {triangle}),
                         [&](int x, int y, const glm::dvec3& got) {
                             const auto w = weights_at(triangle, x, y);
                             glm::dvec3 expected(0.0);
                             for (std::size_t k = 0; k < 3; ++k) {
                                 expected += static_cast<double>(w[k]) * colour_of(triangle.vertices[k].normal);
                             }
                             expect_near(got, glm::clamp(expected, 0.0, 255.0), 1e-6);
                         });
        for_each_covered(render_reference(Method::flat, scene, {triangle}), [&](int, int, const glm::dvec3& got) {
            expect_near(got, glm::clamp(colour_of(triangle.face_normal), 0.0, 255.0), 1e-6);
        });
    }
}

TEST(Reference, TheUnclippedTriangleShadesWhatClippingLeaves) {
    // The same mesh in a frame that cuts it and in one that doesn't: equal colours where both have pixels.
    Scene wide = lit_scene(200, 100);
    wide.mesh = make_builtin_mesh("builtin:sphere-168");
    Scene narrow = wide;
    narrow.width = 40;
    for (const Method method : all_methods()) {
        const ReferenceImage whole = render_reference(method, wide, project(wide));
        int compared = 0;
        for_each_covered(render_reference(method, narrow, project(narrow)), [&](int x, int y, const glm::dvec3& got) {
            const auto index = static_cast<std::size_t>(y * wide.width + x + (wide.width - narrow.width) / 2);
            ASSERT_TRUE(whole.covered[index]) << to_string(method) << " pixel " << x << ", " << y;
            expect_near(got, whole.colour[index], 1e-6);
            ++compared;
        });
        EXPECT_GT(compared, 40 * 80) << to_string(method);
    }
}

TEST(Reference, TheNearestPixelWinsAfterRoundingAndTheFirstOneWinsTies) {
    Rng random(seed);
    const Scene scene = lit_scene(24, 24);
    int ties = 0;
    for (int run = 0; run < 60; ++run) {
        ScreenTriangle first = random_triangle(random, scene);
        ScreenTriangle second = random_triangle(random, scene);
        // Nearly the same plane of few depth steps, so that ties are common; distinct constant colours.
        for (std::size_t k = 0; k < 3; ++k) {
            first.vertices[k].depth = 100.0 + static_cast<double>(uniform(random, 0, 30)) / 10.0;
            second.vertices[k].depth = 100.0 + static_cast<double>(uniform(random, 0, 30)) / 10.0;
            first.vertices[k].normal = {0.0, 0.0, 1.0};
            second.vertices[k].normal = {0.6, 0.0, 0.8};
        }
        const glm::dvec3 first_colour =
            shade(scene.material, scene.lights, {glm::dvec3(0.0), {0, 0, 1}, {0.0, 0.0, 1.0}});
        const ReferenceImage image = render_reference(Method::phong, scene, {first, second});
        for_each_covered(image, [&](int x, int y, const glm::dvec3& got) {
            if (!edge_functions_cover(points_of(first), x, y) || !edge_functions_cover(points_of(second), x, y)) {
                return;
            }
            const auto depth = [&](const ScreenTriangle& t) {
                const auto w = weights_at(t, x, y);
                long double sum = 0.5L;
                for (std::size_t k = 0; k < 3; ++k) {
                    sum += w[k] * t.vertices[k].depth;
                }
                return sum;
            };
            const long double a = depth(first);
            const long double b = depth(second);
            if (std::abs(a - std::round(a)) < 1e-3L || std::abs(b - std::round(b)) < 1e-3L) {
                return;  // a device's depth is within 4e-4 of a step in an image of this size
            }
            ties += std::floor(a) == std::floor(b) ? 1 : 0;
            EXPECT_EQ(glm::distance(got, first_colour) < 1e-6, std::floor(a) <= std::floor(b))
                << "pixel " << x << ", " << y << ", run " << run << ", seed " << seed;
        });
    }
    EXPECT_GT(ties, 100);
}

/// Any triangle or sliver in or across the image, with any front-facing normals; depths close enough for ties.
ScreenTriangle crossing_triangle(Rng& rng, const Scene& scene) {
    ScreenTriangle triangle = random_triangle(rng, scene);
    auto& v = triangle.vertices;
    const auto around = [&](int side) { return uniform(rng, -256 * side, 512 * side); };
    for (ScreenVertex& vertex : v) vertex.point = {around(scene.width), around(scene.height)};
    if (uniform(rng, 0, 1) == 0) {
        // A line through a pixel's centre, with corners up to a unit off.
        const SnappedPoint c = pixel_centre(uniform(rng, 0, scene.width - 1), uniform(rng, 0, scene.height - 1));
        const SnappedPoint along{uniform(rng, -3000, 3000), uniform(rng, -3000, 3000)};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t steps = std::array<std::int64_t, 3>{-4, 3, 1}[k];
            v[k].point = {c.x + steps * along.x + uniform(rng, -1, 1), c.y + steps * along.y + uniform(rng, -1, 1)};
        }
    }
    for (ScreenVertex& vertex : v) vertex.depth = static_cast<double>(uniform(rng, 30000, 30400)) / 100.0;
    walk(triangle, scene);
    return triangle;
}

/// What everything rests on: reference and kernels show the same triangle at every pixel, within a step of colour.
TEST(Reference, TheHlsDevicesPictureIsWithinOneStepWithEqualCoverage) {
    Rng rng(seed + 1);
    Scene scene = lit_scene(24, 20);
    scene.material.shininess = 50.0;
    scene.lights.push_back({glm::normalize(glm::dvec3(0.6, 0.3, 0.74)), glm::dvec3(2.0, 0.5, 0.1)});
    const auto device = make_device("hls");
    std::size_t compared = 0;
    for (int run = 0; run < 150; ++run) {
        std::vector<ScreenTriangle> triangles;
        for (int k = 0; k < 20; ++k) triangles.push_back(crossing_triangle(rng, scene));
        for (const Method method : {Method::flat, Method::gouraud, Method::quadratic}) {
            std::vector<std::uint32_t> packets;
            for (const TriangleSetup& setup : make_setups(method, scene, triangles)) append_triangle(packets, setup);
            Framebuffer framebuffer(scene.width, scene.height);
            std::size_t pixels = 0;
            for (const std::uint64_t word : device->run(packets).words) {
                framebuffer.write(decode_pixel(word));
                ++pixels;
            }
            const ReferenceImage reference = render_reference(method, scene, triangles);
            ASSERT_EQ(pixels, reference.pixels) << "run " << run << ", " << to_string(method);
            ASSERT_EQ(framebuffer.covered(), reference.covered) << "run " << run << ", " << to_string(method);
            const Image expected = reference.image();
            for (std::size_t k = 0; k < expected.rgb.size(); ++k, ++compared) {
                ASSERT_NEAR(framebuffer.image().rgb[k], expected.rgb[k], 1)
                    << to_string(method) << " pixel " << k / 3 % 24 << ", " << k / 3 / 24 << ", run " << run
                    << ", seed " << seed + 1;
            }
        }
    }
    EXPECT_GT(compared, 100000U);
}

TEST(Reference, ColoursSaturateAndTheImageIsRoundedToNearest) {
    Scene scene = lit_scene(64, 64);
    scene.mesh = make_builtin_mesh("builtin:sphere-690");
    scene.lights[0].colour = glm::dvec3(4.0, 1.0, 1.0);
    for (const Method method : all_methods()) {
        const ReferenceImage picture = render_reference(method, scene, project(scene));
        const Image image = picture.image();
        double brightest = 0.0;
        for_each_covered(picture, [&](int x, int y, const glm::dvec3& colour) {
            for (int c = 0; c < 3; ++c) {
                EXPECT_GE(colour[c], 0.0);
                EXPECT_LE(colour[c], 255.0);
                EXPECT_LE(std::abs(image.at(x, y)[c] - colour[c]), 0.5);
                brightest = std::max(brightest, colour[c]);
            }
        });
        EXPECT_EQ(brightest, 255.0) << to_string(method);
    }
}

/// Error against Phong over four lights, each alone: two from the front, one from below, one from the side.
ErrorMeter measure(Method method, Scene scene) {
    ErrorMeter meter;
    for (const glm::dvec3& direction :
         {glm::dvec3(-0.4, 0.5, 0.77), {0.6, 0.3, 0.74}, {0.2, -0.55, 0.8}, {0.85, 0.45, 0.15}}) {
        scene.lights = {{glm::normalize(direction), glm::dvec3(1.0)}};
        const auto triangles = project(scene);
        const ReferenceImage phong = render_reference(Method::phong, scene, triangles);
        meter.add(phong.colour, render_reference(method, scene, triangles).colour, phong.covered);
    }
    return meter;
}

TEST(Reference, MethodsHaveTheirMeasuredQualityOnTheSphere) {
    Scene scene;
    scene.mesh = make_builtin_mesh("builtin:sphere-168");
    scene.rotate_degrees = {23.0, 0.0, 11.0};
    const ErrorMeter gouraud = measure(Method::gouraud, scene);
    const ErrorMeter quadratic = measure(Method::quadratic, scene);
    RecordProperty("gouraud_db", std::to_string(gouraud.psnr()));
    RecordProperty("quadratic_db", std::to_string(quadratic.psnr()));
    EXPECT_NEAR(gouraud.psnr(), 29.2, 0.5);
    EXPECT_NEAR(gouraud.max_error(), 90.0, 2.0);
    EXPECT_NEAR(quadratic.psnr(), 37.4, 0.3);
    EXPECT_NEAR(quadratic.max_error(), 42.0, 2.0);
    EXPECT_LT(measure(Method::flat, scene).psnr(), gouraud.psnr());
    EXPECT_TRUE(std::isinf(measure(Method::phong, scene).psnr()));
}

TEST(Reference, MethodsHaveTheirMeasuredQualityOnTheKnot) {
    Scene scene;
    scene.mesh = make_builtin_mesh("builtin:torus-knot");
    scene.rotate_degrees = {30.0, 0.0, 0.0};
    // Measured turned about y first, then about x; the scene turns about x, then y.
    const double angle = 20.0 * std::acos(-1.0) / 180.0;
    for (auto* vectors : {&scene.mesh.positions, &scene.mesh.normals}) {
        for (glm::dvec3& v : *vectors) {
            v = {v.x * std::cos(angle) + v.z * std::sin(angle), v.y, v.z * std::cos(angle) - v.x * std::sin(angle)};
        }
    }
    EXPECT_NEAR(measure(Method::gouraud, scene).psnr(), 29.9, 0.3);
    EXPECT_NEAR(measure(Method::quadratic, scene).psnr(), 37.3, 0.3);
}

}  // namespace
}  // namespace sheen::test
