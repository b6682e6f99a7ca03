// SPDX-License-Identifier: MIT
// Highlights: independent formulas, reciprocity, energy, and no value that isn't a number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "sheen/lighting.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 7103;
const double pi = std::acos(-1.0);

class Directions {
 public:
    explicit Directions(unsigned offset) : random_(seed + offset) {}
    glm::dvec3 operator()() { return glm::normalize(glm::dvec3(normal_(random_), normal_(random_), normal_(random_))); }
    /// On the side of N that is lit and seen.
    glm::dvec3 before(const glm::dvec3& normal) {
        const glm::dvec3 v = (*this)();
        return glm::dot(v, normal) < 0.0 ? -v : v;
    }

 private:
    std::mt19937 random_;
    std::normal_distribution<double> normal_;
};

Material shiny(Brdf brdf) {
    Material material;
    material.ambient = material.diffuse = glm::dvec3(0.0);
    material.specular = 1.0;
    material.brdf = brdf;
    return material;
}

/// The highlight alone, 1 for a full one.
double highlight(const Material& material, const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v) {
    return shade(material, {{l, glm::dvec3(1.0)}}, {glm::dvec3(0.0), n, v}).x / 255.0;
}

/// (sin a, 0, cos a): in one plane with N = (0, 0, 1).
glm::dvec3 at_angle(double a) { return {std::sin(a), 0.0, std::cos(a)}; }

/// Reflectance of a dielectric by Snell's law and the two polarisations; index n against 1.
double snell_reflectance(double index, double angle) {
    const double inside = std::asin(std::sin(angle) / index);
    const double s = (std::cos(angle) - index * std::cos(inside)) / (std::cos(angle) + index * std::cos(inside));
    const double p = (std::cos(inside) - index * std::cos(angle)) / (std::cos(inside) + index * std::cos(angle));
    return 0.5 * (s * s + p * p);
}

TEST(Brdf, PhongsHighlightIsThePowerOfTheMirroredLightsCosine) {
    Directions direction(0);
    Material material = shiny(Brdf::phong);
    std::size_t seen = 0;
    for (int k = 0; k < 4000; ++k) {
        material.shininess = k % 60;
        const glm::dvec3 n = direction(), l = direction(), v = direction();
        const double cosine = std::max(0.0, glm::dot(glm::reflect(-l, n), v));
        EXPECT_NEAR(highlight(material, n, l, v), std::pow(cosine, material.shininess), 1e-12) << k;
        seen += cosine > 0.5 ? 1 : 0;
        // In the mirror's direction it is full, however large n.
        EXPECT_NEAR(highlight(material, n, l, glm::reflect(-l, n)), 1.0, 1e-12) << k;
    }
    EXPECT_GT(seen, 500U);
}

TEST(Brdf, PhongsLobeIsBlinnsOfAFourthTheExponentNearTheMirrorDirection) {
    Material phong = shiny(Brdf::phong);
    Material blinn = shiny(Brdf::blinn);
    phong.shininess = 100.0;
    blinn.shininess = 400.0;
    for (double offset = -0.1; offset <= 0.1; offset += 0.01) {
        const double expected = highlight(blinn, {0, 0, 1}, at_angle(0.3), at_angle(-0.3 + offset));
        EXPECT_NEAR(highlight(phong, {0, 0, 1}, at_angle(0.3), at_angle(-0.3 + offset)), expected, 0.005);
    }
}

TEST(Brdf, IsReciprocal) {
    Directions direction(1);
    for (const Brdf brdf : {Brdf::blinn, Brdf::phong, Brdf::cook_torrance}) {
        const Material material = shiny(brdf);
        for (int k = 0; k < 2000; ++k) {
            const glm::dvec3 n = direction();
            const glm::dvec3 l = direction.before(n), v = direction.before(n);
            // The first two are factors of the light itself, the third of what falls on the surface.
            const bool of_surface = brdf == Brdf::cook_torrance;
            const double there = highlight(material, n, l, v) / (of_surface ? glm::dot(n, l) : 1.0);
            const double back = highlight(material, n, v, l) / (of_surface ? glm::dot(n, v) : 1.0);
            EXPECT_NEAR(there, back, 1e-9 * std::max(1.0, there)) << static_cast<int>(brdf) << ", " << k;
        }
    }
}

TEST(Brdf, CookTorranceIsFTimesDTimesGOverFourTimesTheCosineToTheEye) {
    Directions direction(2);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.05, 0.95);
    std::size_t bright = 0;
    for (int k = 0; k < 4000; ++k) {
        Material material = shiny(Brdf::cook_torrance);
        material.roughness = uniform(random);
        material.normal_reflectance = uniform(random);
        const glm::dvec3 n = direction();
        const glm::dvec3 l = direction.before(n), v = direction.before(n);
        const glm::dvec3 h = glm::normalize(l + v);
        const double m = material.roughness;
        const double alpha = std::acos(std::min(1.0, glm::dot(n, h)));
        const double slopes = std::exp(-std::pow(std::tan(alpha) / m, 2.0)) / (m * m * std::pow(std::cos(alpha), 4.0));
        const double root = std::sqrt(material.normal_reflectance);
        const double fresnel = snell_reflectance((1.0 + root) / (1.0 - root), std::acos(glm::dot(v, h)));
        const double shadowed = 2.0 * glm::dot(n, h) * glm::dot(n, l) / glm::dot(v, h);
        const double masked = 2.0 * glm::dot(n, h) * glm::dot(n, v) / glm::dot(v, h);
        const double expected = fresnel * slopes * std::min({1.0, shadowed, masked}) / (4.0 * glm::dot(n, v));
        EXPECT_NEAR(highlight(material, n, l, v), expected, 1e-7 * std::max(1.0, expected)) << k;
        bright += expected > 0.1 ? 1 : 0;
    }
    EXPECT_GT(bright, 300U);
}

TEST(Brdf, CookTorranceStraightOnIsTheReflectanceOverFourTimesTheSquaredRoughness) {
    const glm::dvec3 z(0.0, 0.0, 1.0);
    for (const double m : {0.01, 0.2, 1.0}) {
        for (const double reflectance : {0.0, 0.04, 0.5, 1.0}) {
            Material material = shiny(Brdf::cook_torrance);
            material.roughness = m;
            material.normal_reflectance = reflectance;
            EXPECT_NEAR(highlight(material, z, z, z), reflectance / (4.0 * m * m), 1e-6 / (m * m));
        }
    }
}

/// ∫ highlight dω / π is the share of light that leaves towards V; a mirror of facets gives back at most all of it.
TEST(Brdf, CookTorranceReflectsAtMostTheLightThatFallsIn) {
    constexpr int steps = 400;
    for (const double m : {0.1, 0.2, 0.5}) {
        Material material = shiny(Brdf::cook_torrance);
        material.roughness = m;
        material.normal_reflectance = 1.0;
        for (const double angle : {0.0, 0.5, 1.0}) {
            double sum = 0.0;
            for (int i = 0; i < steps; ++i) {
                const double theta = (i + 0.5) * 0.5 * pi / steps;
                for (int j = 0; j < steps; ++j) {
                    const double phi = (j + 0.5) * 2.0 * pi / steps;
                    const glm::dvec3 l(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                       std::cos(theta));
                    sum += highlight(material, {0, 0, 1}, l, at_angle(angle)) * std::sin(theta);
                }
            }
            const double albedo = sum * (0.5 * pi / steps) * (2.0 * pi / steps) / pi;
            EXPECT_LE(albedo, 1.001) << "m " << m << ", angle " << angle;
            EXPECT_GE(albedo, m < 0.3 && angle < 0.6 ? 0.97 : 0.5) << "m " << m << ", angle " << angle;
        }
    }
}

TEST(Brdf, CookTorranceHasNoEdgeAtTheSilhouette) {
    Material material = shiny(Brdf::cook_torrance);
    for (double light = -1.5; light <= 1.5; light += 0.1) {
        const double before = highlight(material, {0, 0, 1}, at_angle(light), at_angle(0.5 * pi - 1e-9));
        const double behind = highlight(material, {0, 0, 1}, at_angle(light), at_angle(0.5 * pi + 1e-9));
        EXPECT_NEAR(before, behind, 1e-5 * std::max(1.0, before)) << light;
    }
}

TEST(Brdf, NoDirectionAndNoParameterGivesAnythingButANumber) {
    Directions direction(3);
    const double tiny = 1e-300;
    for (int k = 0; k < 4000; ++k) {
        const glm::dvec3 n = direction();
        const glm::dvec3 across = glm::normalize(glm::cross(n, direction()));
        const glm::dvec3 l = direction();
        const glm::dvec3 nearly = glm::normalize(-l + 1e-16 * across);
        for (const auto& [to_light, to_eye] :
             {std::pair{l, -l},
              {l, nearly},
              {l, l},
              {across, n},
              {across, -across},
              {-n, n},
              {n, n},
              {n, across},
              {l, direction()},
              {glm::normalize(across + 1e-12 * n), glm::normalize(-across + 1e-12 * n)}}) {
            for (const double extreme : {0.0, tiny, 1.0, 50.0, 1000.0, 1e300}) {
                for (Material material : {shiny(Brdf::blinn), shiny(Brdf::phong), shiny(Brdf::cook_torrance)}) {
                    material.shininess = extreme;
                    material.roughness = std::clamp(extreme, 0.01, 1.0);
                    material.normal_reflectance = std::min(extreme, 1.0);
                    const double value = highlight(material, n, to_light, to_eye);
                    ASSERT_TRUE(std::isfinite(value) && value >= 0.0)
                        << static_cast<int>(material.brdf) << ", parameter " << extreme << ", case " << k << ": "
                        << value;
                }
            }
        }
    }
}

}  // namespace
}  // namespace sheen::test
