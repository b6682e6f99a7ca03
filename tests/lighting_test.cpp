// SPDX-License-Identifier: MIT
// Reflected radiance: limits and symmetries of paper `spherical`, eq. 8.
#include "sheen/lighting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace sheen {
namespace {

constexpr unsigned seed = 7002;
constexpr int cases = 2000;
const glm::dvec3 to_eye_direction(0.0, 0.0, 1.0);

class Directions {
 public:
    glm::dvec3 operator()() {
        const glm::dvec3 v(normal_(random_), normal_(random_), normal_(random_));
        return glm::normalize(v);
    }

 private:
    std::mt19937 random_{seed};
    std::normal_distribution<double> normal_;
};

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(actual[c], expected[c], 1e-9) << "component " << c << ", seed " << seed;
    }
}

TEST(Lighting, WithoutLightsOnlyAmbientRemains) {
    const Material material;
    expect_near(shade(material, {}, {glm::dvec3(0.0), to_eye_direction, to_eye_direction}), 255.0 * material.ambient);
}

TEST(Lighting, WithoutSpecularItIsLambert) {
    Directions direction;
    Material material;
    material.specular = 0.0;
    for (int i = 0; i < cases; ++i) {
        const glm::dvec3 normal = direction();
        const Light light{direction(), {1.0, 0.5, 0.25}};
        const double cosine = std::max(0.0, glm::dot(normal, light.vector));
        expect_near(shade(material, {light}, {glm::dvec3(0.0), normal, to_eye_direction}),
                    255.0 * (material.ambient + cosine * light.colour * material.diffuse));
    }
}

TEST(Lighting, BlinnsHighlightIsThePowerOfHalfTheAngleBetweenLightAndMirror) {
    // In the plane of light and eye, N at angle a from H: (N·H)^n = cos^n a, also where N·L < 0.
    Material material;
    material.ambient = material.diffuse = glm::dvec3(0.0);
    for (int degrees = -89; degrees <= 89; degrees += 2) {
        const double angle = degrees * std::acos(-1.0) / 180.0;
        const double half = 0.6;  // of the angle between light and eye
        const Light light{{std::sin(2.0 * half), 0.0, std::cos(2.0 * half)}, glm::dvec3(1.0)};
        const glm::dvec3 normal(std::sin(half + angle), 0.0, std::cos(half + angle));
        expect_near(shade(material, {light}, {glm::dvec3(0.0), normal, to_eye_direction}),
                    glm::dvec3(255.0 * material.specular * std::pow(std::cos(angle), material.shininess)));
    }
}

TEST(Lighting, LightsAdd) {
    Directions direction;
    const Material material;
    for (int i = 0; i < cases; ++i) {
        const glm::dvec3 normal = direction();
        const Light a{direction(), {1.0, 0.2, 0.4}};
        const Light b{direction(), {0.3, 0.9, 0.1}};
        const glm::dvec3 ambient = 255.0 * material.ambient;
        expect_near(shade(material, {a, b}, {glm::dvec3(0.0), normal, to_eye_direction}) - ambient,
                    shade(material, {a}, {glm::dvec3(0.0), normal, to_eye_direction}) +
                        shade(material, {b}, {glm::dvec3(0.0), normal, to_eye_direction}) - 2.0 * ambient);
    }
}

TEST(Lighting, ALightStraightBehindGivesNoHighlightAndNoNan) {
    for (const double shininess : {0.0, 50.0}) {
        Material material;
        material.shininess = shininess;
        const Light behind{-to_eye_direction, glm::dvec3(1.0)};
        expect_near(shade(material, {behind}, {glm::dvec3(0.0), to_eye_direction, to_eye_direction}),
                    255.0 * material.ambient);
    }
}

Light positional(const glm::dvec3& place) {
    Light light;
    light.kind = Light::Kind::positional;
    light.vector = place;
    return light;
}

TEST(Lighting, APositionalLightShinesFromItsPlaceAndDistanceDoesNotDimIt) {
    Directions direction;
    const Material material;
    for (int i = 0; i < cases; ++i) {
        const glm::dvec3 normal = direction();
        const glm::dvec3 position = 5.0 * direction();
        const glm::dvec3 towards = direction();
        const SurfacePoint point{position, normal, to_eye_direction};
        const glm::dvec3 expected = shade(material, {{towards, glm::dvec3(1.0)}}, point);
        for (const double distance : {1e-3, 1.0, 1e6}) {
            const Light light = positional(position + distance * towards);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(shade(material, {light}, point)[c], expected[c], 1e-8) << "seed " << seed;
                EXPECT_NEAR(light.direction_from(position)[c], towards[c], 1e-11) << "seed " << seed;
            }
        }
    }
}

TEST(Lighting, APositionalLightAnywhereGivesNumbers) {
    Directions direction;
    for (int i = 0; i < cases; ++i) {
        const glm::dvec3 unit = direction();
        for (const double size : {0.0, 1e-320, 1e-200, 1e-160, 1e-30, 1.0, 1e30, 1e100}) {
            for (const glm::dvec3& place : {size * unit, glm::dvec3(size, 0.0, 0.0), glm::dvec3(0.0)}) {
                for (const glm::dvec3& position : {glm::dvec3(0.0), place, size * direction()}) {
                    const Light light = positional(place);
                    const glm::dvec3 colour = shade(Material(), {light}, {position, unit, to_eye_direction});
                    const glm::dvec3 towards = light.direction_from(position);
                    for (int c = 0; c < 3; ++c) {
                        ASSERT_TRUE(std::isfinite(colour[c]) && colour[c] >= 0.0) << size << ", case " << i;
                        ASSERT_TRUE(std::isfinite(towards[c])) << size << ", case " << i;
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace sheen
