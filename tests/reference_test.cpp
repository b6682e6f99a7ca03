// SPDX-License-Identifier: MIT
// The double-precision reference: coverage, depth, Phong per pixel, polynomials, and the measured quality of the
// methods.
#include "sheen/reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>

#include "sheen/metrics.hpp"
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

/// A triangle of random corners inside the image, with random front-facing normals and depths.
ScreenTriangle random_triangle(std::mt19937_64& random, const Scene& scene) {
    std::uniform_real_distribution<double> tilt(-0.7, 0.7);
    std::uniform_real_distribution<double> depth(1.0, 65534.0);
    ScreenTriangle triangle;
    for (ScreenVertex& vertex : triangle.vertices) {
        vertex.point = {uniform(random, 0, 256 * scene.width), uniform(random, 0, 256 * scene.height)};
        vertex.depth = depth(random);
        vertex.normal = glm::normalize(glm::dvec3(tilt(random), tilt(random), 1.0));
    }
    triangle.face_normal = {0.0, 0.0, 1.0};
    triangle.pieces = {{triangle.vertices[0].point, triangle.vertices[1].point, triangle.vertices[2].point}};
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
    std::mt19937_64 random(seed);
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
                    const bool here = edge_functions_cover(triangles[t].pieces[0], x, y);
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
    std::mt19937_64 random(seed);
    const Scene scene = lit_scene(40, 30);
    for (int run = 0; run < 40; ++run) {
        const ScreenTriangle triangle = random_triangle(random, scene);
        for_each_covered(render_reference(Method::phong, scene, {triangle}), [&](int x, int y, const glm::dvec3& got) {
            const auto w = weights_at(triangle, x, y);
            glm::dvec3 normal(0.0);
            for (std::size_t k = 0; k < 3; ++k) {
                normal += static_cast<double>(w[k]) * triangle.vertices[k].normal;
            }
            const glm::dvec3 colour = shade(scene.material, scene.lights, glm::normalize(normal), {0.0, 0.0, 1.0});
            expect_near(got, glm::clamp(colour, 0.0, 255.0), 1e-8);
        });
    }
}

TEST(Reference, GouraudIsTheLinearColourAndFlatTheFacesColour) {
    std::mt19937_64 random(seed);
    const Scene scene = lit_scene(40, 30);
    for (int run = 0; run < 40; ++run) {
        const ScreenTriangle triangle = random_triangle(random, scene);
        const auto colour_of = [&](const glm::dvec3& n) {
            return shade(scene.material, scene.lights, n, {0.0, 0.0, 1.0});
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
    std::mt19937_64 random(seed);
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
        const glm::dvec3 first_colour = shade(scene.material, scene.lights, {0, 0, 1}, {0, 0, 1});
        const ReferenceImage image = render_reference(Method::phong, scene, {first, second});
        for_each_covered(image, [&](int x, int y, const glm::dvec3& got) {
            if (!edge_functions_cover(first.pieces[0], x, y) || !edge_functions_cover(second.pieces[0], x, y)) {
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
            if (std::abs(a - std::round(a)) < 1e-9L || std::abs(b - std::round(b)) < 1e-9L) {
                return;  // on a rounding boundary double and long double may differ
            }
            ties += std::floor(a) == std::floor(b) ? 1 : 0;
            EXPECT_EQ(glm::distance(got, first_colour) < 1e-6, std::floor(a) <= std::floor(b))
                << "pixel " << x << ", " << y << ", run " << run << ", seed " << seed;
        });
    }
    EXPECT_GT(ties, 100);
}

TEST(Reference, SliversThatSnappingMovesAtTheBorderKeepTheirColours) {
    // Lines through a pixel's centre with a third corner a unit off: where clipping moves such a sliver by half a unit,
    // its pixels lie outside it by up to many times its width.
    Rng random(seed);
    const Scene scene = lit_scene(24, 24);
    int outside = 0;
    for (int run = 0; run < 40000; ++run) {
        ScreenTriangle triangle = random_triangle(random, scene);
        const SnappedPoint centre = pixel_centre(uniform(random, 0, 23), uniform(random, 0, 23));
        const SnappedPoint along{uniform(random, -3000, 3000), uniform(random, -3000, 3000)};
        auto& v = triangle.vertices;
        v[0].point = {centre.x - 4 * along.x, centre.y - 4 * along.y};
        v[1].point = {centre.x + 3 * along.x, centre.y + 3 * along.y};
        v[2].point = {centre.x + along.x + uniform(random, -1, 1), centre.y + along.y + uniform(random, -1, 1)};
        if (cross(v[0].point, v[1].point, v[2].point) == 0) {
            continue;
        }
        triangle.pieces = clip_to_image({v[0].point, v[1].point, v[2].point}, scene.width, scene.height);
        glm::dvec3 low(255.0);
        glm::dvec3 high(0.0);
        for (const ScreenVertex& vertex : v) {
            const glm::dvec3 colour = shade(scene.material, scene.lights, vertex.normal, {0.0, 0.0, 1.0});
            low = glm::min(low, colour);
            high = glm::max(high, colour);
        }
        const glm::dvec3 margin = 0.1 * (high - low) + 1e-6;
        for_each_covered(render_reference(Method::gouraud, scene, {triangle}),
                         [&](int x, int y, const glm::dvec3& got) {
                             const auto w = weights_at(triangle, x, y);
                             outside += *std::min_element(w.begin(), w.end()) < -0.1L ? 1 : 0;
                             for (int c = 0; c < 3; ++c) {
                                 EXPECT_GE(got[c], low[c] - margin[c]) << "run " << run << ", seed " << seed;
                                 EXPECT_LE(got[c], high[c] + margin[c]) << "run " << run << ", seed " << seed;
                             }
                         });
    }
    EXPECT_GT(outside, 20);
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
