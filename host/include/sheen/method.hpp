// SPDX-License-Identifier: MIT
/// \file
/// Shading methods: how colour varies over a triangle, as a polynomial in double precision and as the six integers
/// per channel of contract 1.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sheen/raster.hpp"
#include "sheen/scene.hpp"

namespace sheen {

enum class Method { flat, gouraud, quadratic, phong };

/// All methods, in the order in which they are listed to a user.
const std::vector<Method>& all_methods();
std::string to_string(Method method);
/// \throws UsageError naming the word and the methods that exist.
Method parse_method(const std::string& word);
/// True when devices can draw it (packets exist); false for references such as `phong`.
bool has_packets(Method method);

/// A two-variate quadratic T₅X² + T₄XY + T₃Y² + T₂X + T₁Y + T₀ (paper `quadratic`, eq. 4) in whole pixels relative to
/// pixel (origin_x, origin_y), sampled at pixel centres: X = x − origin_x gives the value at the centre of pixel x.
/// Coefficients are quadruple precision where a sliver needs it (see docs/number-formats.md).
struct Polynomial {
    std::array<long double, 6> t{};
    int origin_x = 0;
    int origin_y = 0;
    /// Value at the centre of pixel (x, y).
    [[nodiscard]] double at(int x, int y) const;
};

/// The six words {I, D, E, h, dD, dE} of a channel, modulo 2^32.
struct ChannelWords {
    std::array<std::uint32_t, 6> words{};
    friend bool operator==(const ChannelWords& a, const ChannelWords& b) { return a.words == b.words; }
};

/// Closed form of contract 1: I + u·D + j·E + C(u,2)·h + u·j·dD + C(j,2)·dE modulo 2^32, u counted from κ·j on row j.
std::uint32_t channel_value(const ChannelWords& channel, std::int64_t u, std::int64_t j);

/// Rounds a polynomial once to `fraction_bits`, adds ½ when `round_half`, and derives the six words at the walk's start pixel exactly.
ChannelWords channel_words(const Polynomial& polynomial, const TriangleWalk& walk, int fraction_bits, bool round_half);

/// What the host computes per triangle: the red, green and blue polynomials (in 8-bit steps) and depth.
struct TriangleShading {
    std::array<Polynomial, 3> colour;
    Polynomial depth;
    bool linear = false;  ///< the colour polynomials have no second-order term
};

/// Setup of a packet-capable method for one triangle (paper `quadratic`, section 3, in barycentric form). \throws Error for `phong`.
TriangleShading shade_triangle(Method method, const Scene& scene, const ScreenTriangle& triangle);

/// A triangle as a device gets it, in fields.
struct TriangleSetup {
    TriangleWalk walk;
    bool linear = false;
    std::array<ChannelWords, 3> colour;
    std::vector<ChannelWords> log;
    std::optional<ChannelWords> depth;
};

/// All setups of a scene, in drawing order: one per clipped piece that covers a pixel.
std::vector<TriangleSetup> make_setups(Method method, const Scene& scene, const std::vector<ScreenTriangle>& triangles);

}  // namespace sheen
