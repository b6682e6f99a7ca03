// SPDX-License-Identifier: MIT
/// \file
/// Shading methods: how colour varies over a triangle, as polynomials and as the words of contract 1.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sheen/polynomial.hpp"
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

/// What the host computes per triangle: the red, green and blue polynomials (in 8-bit steps) and depth.
struct TriangleShading {
    std::array<Polynomial, 3> colour;
    Polynomial depth;
    bool linear = false;  ///< the colour polynomials have no second-order term
};

/// The normal in the middle of an edge: the mean of its ends' unit normals, normalised. Where the mean vanishes
/// (opposite normals) every perpendicular is equally near: the one that faces `eye` most is taken, or `eye` itself when
/// the normals lie along it. Symmetric in a and b to the bit, so that neighbours agree.
glm::dvec3 midpoint_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye);

/// Colour and depth of one triangle, from its unclipped, snapped vertices. Nodes are clamped to ±306 and shaded with
/// shade(): `flat` at the centroid with the face normal; `gouraud` at the vertices; `quadratic` (paper `quadratic`,
/// section 3) at the vertices and in the middle of the edges, with midpoint_normal(). \throws Error for `phong`.
TriangleShading shade_triangle(Method method, const Scene& scene, const ScreenTriangle& triangle);

/// A triangle as a device gets it, in fields.
struct TriangleSetup {
    TriangleWalk walk;
    bool linear = false;
    std::array<ChannelWords, 3> colour;
    std::vector<ChannelWords> log;
    std::optional<ChannelWords> depth;
};

/// All setups of a scene, in drawing order: one per clipped piece that covers a pixel. The polynomial is the unclipped
/// triangle's, rounded about the centre of the piece's bounding box; ½ is folded into colour and depth. Only a piece of
/// a sliver so thin that snapping took it out of its triangle gets a polynomial of its own, with nodes at the border.
/// \throws Error for `phong` when a pixel is covered.
std::vector<TriangleSetup> make_setups(Method method, const Scene& scene, const std::vector<ScreenTriangle>& triangles);

}  // namespace sheen
