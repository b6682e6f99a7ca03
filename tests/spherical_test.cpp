// SPDX-License-Identifier: MIT
// Method spherical: the angle along a span against explicit rotations, its shader against an oracle, quality.
#include "sheen/spherical.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>

#include "sheen/error.hpp"
#include "support/spherical_cases.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 20000412;
const glm::dvec3 camera(0.0, 0.0, 1.0);
const double pi = std::acos(-1.0);

CosineSpan<double> span_between(const VectorPair<double>& left, const VectorPair<double>& right, bool as_printed) {
    return cosine_span(arc_against(left, right, camera), left.v, as_printed);
}

double cosine_at(const CosineSpan<double>& span, double t) { return span.amplitude * std::cos(span.angle(t)); }

VectorPair<double> random_pair(Rng& rng) { return {random_unit(rng), random_unit(rng)}; }

/// Section 3.2 by rotations: u turned back to where v was, then interpolated against v.
TEST(Spherical, AngleAlongASpanIsThatOfTheExplicitRotations) {
    Rng rng(seed);
    for (int run = 0; run < 5000; ++run) {
        const VectorPair<double> left = random_pair(rng);
        const VectorPair<double> right = random_pair(rng);
        const glm::dvec3 axis = glm::cross(left.v, right.v);
        if (glm::length(axis) < 1e-2) continue;
        const double turn = std::atan2(glm::length(axis), glm::dot(left.v, right.v));
        const glm::dvec3 u_end = rotated(right.u, glm::normalize(axis), -turn);
        if (glm::length(glm::cross(left.u, u_end)) < 1e-2) continue;
        const CosineSpan<double> span = span_between(left, right, false);
        for (const double t : {0.0, 0.2, 0.7, 1.0}) {
            ASSERT_NEAR(cosine_at(span, t), glm::dot(between(left.u, u_end, t), left.v), 1e-10)
                << "run " << run << ", t = " << t << ", seed " << seed;
        }
        ASSERT_NEAR(cosine_at(span, 0.0), glm::dot(left.u, left.v), 1e-12);
        ASSERT_NEAR(cosine_at(span, 1.0), glm::dot(right.u, right.v), 1e-10) << "the rotation keeps θ₂";
    }
}

/// Erratum, eq. 15: the printed last term has the wrong sign. The right one reaches cos θ₂ at the span's end.
TEST(Spherical, EquationFifteenAsPrintedMissesTheSpansEnd) {
    Rng rng(seed + 1);
    double printed_worst = 0.0;
    for (int run = 0; run < 2000; ++run) {
        const VectorPair<double> left{random_unit(rng), random_unit(rng)};
        const VectorPair<double> right{random_unit(rng), left.v};
        const double gamma = std::acos(glm::dot(left.u, right.u));
        if (std::sin(gamma) < 0.05) continue;
        const double c1 = glm::dot(left.u, left.v);
        const double c2 = glm::dot(right.u, right.v);
        const CosineSpan<double> right_span = span_between(left, right, false);
        const CosineSpan<double> printed_span = span_between(left, right, true);
        for (const double t : {0.25, 0.5, 1.0}) {
            const double term = std::sin(t * gamma) * (c1 * std::cos(gamma) - c2) / std::sin(gamma);
            ASSERT_NEAR(cosine_at(right_span, t), std::cos(t * gamma) * c1 - term, 1e-9);
            ASSERT_NEAR(cosine_at(printed_span, t), std::cos(t * gamma) * c1 + term, 1e-9);
        }
        ASSERT_NEAR(cosine_at(right_span, 1.0), c2, 1e-9);
        printed_worst = std::max(printed_worst, std::abs(cosine_at(printed_span, 1.0) - c2));
    }
    EXPECT_GT(printed_worst, 1.0);
}

/// The angle is reduced so that a bell around 0 is the only one.
TEST(Spherical, CosineIsPositiveOnlyWhereTheAngleIsWithinAQuadrantOfZero) {
    Rng rng(seed + 2);
    for (int run = 0; run < 20000; ++run) {
        const VectorPair<double> left = random_pair(rng);
        const VectorPair<double> right = run % 4 == 0 ? VectorPair<double>{-left.u, left.v} : random_pair(rng);
        const CosineSpan<double> span = span_between(left, right, run % 2 == 1);
        ASSERT_GE(span.amplitude, 0.0);
        ASSERT_LE(span.amplitude, 1.0 + 1e-9);
        for (int i = 0; i <= 40; ++i) {
            const double angle = span.angle(i / 40.0);
            ASSERT_LE(std::abs(angle), 1.5 * pi + 1e-9);
            ASSERT_EQ(std::cos(angle) > 1e-9 && std::abs(angle) > 0.5 * pi, false)
                << "run " << run << ", angle " << angle << ", seed " << seed;
        }
    }
}

/// With cosⁿ itself for a bell, a far light and a far eye the shader is the reflection model of the rotated normal.
TEST(Spherical, ShaderIsTheReflectionModelOfTheRotatedNormal) {
    Rng rng(seed + 3);
    MethodOptions options;
    options.spherical_base = 0.0;
    std::size_t compared = 0;
    for (int run = 0; run < 400; ++run) {
        Scene scene;
        scene.width = scene.height = 60;
        scene.material.shininess = real(rng, 1.0, 80.0);
        for (int i = 0; i < 2; ++i) {
            Light light;
            light.vector = random_unit(rng);
            light.colour = {real(rng, 0.0, 1.0), real(rng, 0.0, 1.0), 1.0};
            scene.lights.push_back(light);
        }
        const ScreenTriangle triangle = normal_triangle(rng, scene, plump_triangle(rng));
        options.spherical_separate = run % 2 == 1;
        shade_pixels(Method::spherical, options, scene, triangle, [&](int x, int y, const glm::dvec3& colour) {
            const SurfacePoint point{glm::dvec3(0.0), spherical_normal(triangle, x, y), camera};
            ASSERT_LT(glm::length(colour - shade(scene.material, scene.lights, point)), 1e-6)
                << "run " << run << ", pixel " << x << ", " << y << ", seed " << seed;
            ++compared;
        });
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(compared, 50000U);
}

TEST(Spherical, ColoursAreFiniteAndWithinTheMaterialsRange) {
    Rng rng(seed + 4);
    for (int run = 0; run < 3000; ++run) {
        Scene scene;
        scene.width = scene.height = 40;
        scene.material.shininess = run % 7 == 0 ? 0.0 : std::exp(real(rng, 0.0, std::log(1000.0)));
        scene.material.brdf = run % 3 == 0 ? Brdf::phong : Brdf::blinn;
        if (run % 5 == 0) scene.field_of_view = 40.0;
        Light light;
        light.vector = run % 11 == 0 ? -camera : random_unit(rng);
        if (run % 2 == 1) {
            light.kind = Light::Kind::positional;
            light.vector = {real(rng, -1.0, 1.0), real(rng, -1.0, 1.0), real(rng, -5.0, -3.0)};
        }
        scene.lights = {light};
        ScreenTriangle triangle = normal_triangle(rng, scene, random_triangle(rng, 40));
        if (run % 4 == 0) triangle.vertices[1].normal = -triangle.vertices[0].normal;
        if (run % 6 == 0) triangle.vertices[2].normal = triangle.vertices[0].normal;
        if (run % 13 == 0) triangle.vertices[0].position = light.vector;
        if (triangle.walks.empty()) continue;
        MethodOptions options;
        options.spherical_separate = run % 8 == 3;
        options.spherical_base = run % 16 < 8 ? 2.0 : 9.5;
        shade_pixels(Method::spherical, options, scene, triangle, [&](int x, int y, const glm::dvec3& colour) {
            const glm::dvec3 most = 255.0 * (scene.material.ambient + scene.material.diffuse + scene.material.specular);
            for (int c = 0; c < 3; ++c) {
                ASSERT_GE(colour[c], 255.0 * scene.material.ambient[c] - 1e-9) << "run " << run << ", seed " << seed;
                ASSERT_LE(colour[c], most[c] + 1e-6) << "run " << run << ", pixel " << x << ", " << y;
            }
        });
        if (HasFatalFailure()) return;
    }
}

/// The image's border cuts rows, but changes no colour.
TEST(Spherical, ABorderChangesNoColour) {
    Rng rng(seed + 5);
    Scene whole;
    whole.lights = measured_lights()[0];
    whole.width = whole.height = 60;
    Scene part = whole;
    part.width = part.height = 30;
    std::size_t compared = 0;
    for (int run = 0; run < 300; ++run) {
        ScreenTriangle triangle =
            normal_triangle(rng, whole, run % 2 == 0 ? random_triangle(rng, 60) : plump_triangle(rng));
        const ReferenceImage expected = render_reference(Method::spherical, whole, {triangle});
        const auto& v = triangle.vertices;
        triangle.walks = walk_in_image(v[0].point, v[1].point, v[2].point, part.width, part.height);
        shade_pixels(Method::spherical, {}, part, triangle, [&](int x, int y, const glm::dvec3& colour) {
            ASSERT_EQ(expected.colour[static_cast<std::size_t>(y * whole.width + x)], colour) << x << ", " << y;
            ++compared;
        });
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(compared, 10000U);
}

/// Two triangles of a sphere with an edge through pixel centres: both shade those, and differ by the bell alone.
TEST(Spherical, NeighboursMeetAtTheirEdgeUpToTheBell) {
    Rng rng(seed + 6);
    constexpr double radius = 232.0;  // of the documents' sphere, pixels
    Scene scene;
    scene.width = scene.height = 512;
    std::array<double, 3> jump{};
    for (int run = 0; run < 400; ++run) {
        scene.lights = measured_lights()[static_cast<std::size_t>(run % 4)];
        const std::int64_t dx = uniform(rng, -5, 5);
        const SnappedPoint a = pixel_centre(uniform(rng, 150, 360), uniform(rng, 120, 320));
        const SnappedPoint b{a.x + 256 * 12 * dx, a.y + 256 * 60};
        const Triangle left{a, b, {std::min(a.x, b.x) - 256 * uniform(rng, 20, 60), (a.y + b.y) / 2}};
        const Triangle right{a, b, {std::max(a.x, b.x) + 256 * uniform(rng, 20, 60), (a.y + b.y) / 2}};
        const auto on_sphere = [&](const Triangle& points) {
            ScreenTriangle triangle = normal_triangle(rng, scene, points);
            for (ScreenVertex& vertex : triangle.vertices) {
                const double x = (static_cast<double>(vertex.point.x) / 256.0 - 256.0) / radius;
                const double y = (256.0 - static_cast<double>(vertex.point.y) / 256.0) / radius;
                vertex.normal = {x, y, std::sqrt(std::max(0.0, 1.0 - x * x - y * y))};
                vertex.normal = glm::normalize(vertex.normal);
            }
            return triangle;
        };
        const ScreenTriangle one = on_sphere(left);
        const ScreenTriangle other = on_sphere(right);
        for (std::size_t k = 0; k < jump.size(); ++k) {
            MethodOptions options;
            options.spherical_base = std::array<double, 3>{0.0, 2.0, 9.5}.at(k);
            options.spherical_minimax = true;
            const auto shader = make_shader(Method::spherical, options, scene, one);
            const auto neighbour = make_shader(Method::spherical, options, scene, other);
            for (int i = 5; i < 60; i += 5) {
                const PixelRow row{static_cast<int>((a.x + (b.x - a.x) * i / 60) / 256),
                                   static_cast<int>(a.y / 256) + i, 1};
                shader->start_row(row);
                neighbour->start_row(row);
                const glm::dvec3 step = shader->colour(row.x, {}) - neighbour->colour(row.x, {});
                for (int c = 0; c < 3; ++c) jump.at(k) = std::max(jump.at(k), std::abs(step[c]));
            }
        }
    }
    std::cout << fmt::format("jump across edges, 8-bit steps: cosⁿ {:.1e}, cos² {:.2f}, cos^9.5 {:.2f}\n", jump[0],
                             jump[1], jump[2]);
    EXPECT_LT(jump[0], 1e-9);
    EXPECT_GT(jump[1], 1e-3);
    EXPECT_LT(jump[1], 2.0);
    EXPECT_LT(jump[2], 0.5);
}

struct Quality {
    double shininess, base, least_psnr;
};

class SphericalQuality : public testing::TestWithParam<Quality> {};

TEST_P(SphericalQuality, OnTheSphereOf168Triangles) {
    MethodOptions options;
    options.spherical_base = GetParam().base;
    options.spherical_minimax = GetParam().base > 2.0;
    const ErrorMeter meter = measured_error(Method::spherical, options, measured_sphere(GetParam().shininess));
    std::cout << fmt::format("spherical, cos^{}, n = {}: {:.2f} dB, max {:.2f}\n", options.spherical_base,
                             GetParam().shininess, meter.psnr(), meter.max_error());
    EXPECT_GE(meter.psnr(), GetParam().least_psnr);
}

INSTANTIATE_TEST_SUITE_P(Bases, SphericalQuality,
                         testing::Values(Quality{50, 2.0, 48.0}, Quality{20, 9.5, 61.0}, Quality{50, 9.5, 61.0},
                                         Quality{50, 0.0, 63.0}));

/// Section 6: "visually indistinguishable". They differ only where light or eye are near.
TEST(Spherical, TurningOneVectorAgainstTheOtherIsNearBothInterpolated) {
    Scene scene = measured_sphere(50.0);
    scene.width = scene.height = 256;
    Light lamp;
    lamp.kind = Light::Kind::positional;
    const std::vector<ScreenTriangle> triangles = project(scene);
    lamp.vector = glm::dvec3(-1.5, 1.5, -2.0) * bounding_sphere(scene.mesh).radius;  // the sphere's centre: 0, 0, −4
    scene.lights = {lamp};
    MethodOptions options;
    options.spherical_base = 0.0;
    const ReferenceImage phong = render_reference(Method::phong, scene, triangles);
    const ReferenceImage turned = render_reference(Method::spherical, scene, triangles, options);
    options.spherical_separate = true;
    const ReferenceImage separate = render_reference(Method::spherical, scene, triangles, options);
    ErrorMeter apart;
    apart.add(turned.colour, separate.colour, phong.covered);
    ErrorMeter error;
    error.add(phong.colour, turned.colour, phong.covered);
    ErrorMeter separate_error;
    separate_error.add(phong.colour, separate.colour, phong.covered);
    std::cout << fmt::format(
        "near light: turned and separate {:.1f} dB, max {:.2f} apart; against Phong {:.1f} and {:.1f} dB\n",
        apart.psnr(), apart.max_error(), error.psnr(), separate_error.psnr());
    EXPECT_GE(apart.psnr(), 50.0);
    EXPECT_GT(apart.max_error(), 1e-3);
    EXPECT_GE(error.psnr(), 45.0);
}

TEST(Spherical, RefusesWhatIsNoPowerOfACosine) {
    Scene scene = measured_sphere(50.0);
    scene.lights = measured_lights()[0];
    for (const Brdf brdf : {Brdf::blinn, Brdf::phong}) {
        scene.material.brdf = brdf;
        EXPECT_EQ(why_inexpressible(Method::spherical, scene), std::nullopt);
    }
    scene.material.brdf = Brdf::cook_torrance;
    ASSERT_TRUE(why_inexpressible(Method::spherical, scene));
    EXPECT_NE(why_inexpressible(Method::spherical, scene)->find("Cook"), std::string::npos);
    EXPECT_THROW(render_reference(Method::spherical, scene, project(scene)), Error);
    scene.material.brdf = Brdf::blinn;
    MethodOptions options;
    for (const double base : {-1.0, std::nan(""), HUGE_VAL}) {
        options.spherical_base = base;
        EXPECT_THROW(render_reference(Method::spherical, scene, project(scene), options), UsageError) << base;
    }
}

}  // namespace
}  // namespace sheen::test
