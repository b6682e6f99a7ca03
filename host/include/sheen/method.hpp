// SPDX-License-Identifier: MIT
/// \file
/// Shading methods: how colour varies over a triangle, as polynomials and as the words of contract 1.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sheen/method_options.hpp"
#include "sheen/polynomial.hpp"
#include "sheen/raster.hpp"
#include "sheen/scene.hpp"
#include "sheen/surface.hpp"

namespace sheen {

enum class Method {
    flat,
    gouraud,
    quadratic,
    duff,
    taylor,
    taylor_finite,
    spherical,
    recurrence,
    log_quadratic,
    phong
};

/// All methods, in the order in which they are listed to a user.
const std::vector<Method>& all_methods();
std::string to_string(Method method);
/// \throws UsageError naming the word and the methods that exist.
Method parse_method(const std::string& word);
/// True when devices can draw it (packets exist); false for references such as `phong`.
bool has_packets(Method method);
/// True when it is drawn with log channels: has_packets(), and highlights by table (lit_setup.hpp).
bool has_log_channels(Method method);

/// What a method makes of a triangle: colours at the vertices and, unless linear, in the middle of the edges.
struct TriangleNodes {
    std::array<glm::dvec3, 6> colour{};  ///< 8-bit steps, at vertices 0, 1, 2 and midpoints 01, 12, 20
    bool linear = false;                 ///< the midpoints are not used
    /// The interpolated colour where the vertices have these weights (barycentric coordinates), not clamped.
    [[nodiscard]] glm::dvec3 colour_at(const glm::dvec3& weights) const;
};

/// The nodes of one triangle, clamped to ±306 and shaded with shade(): `flat` at the centroid with the face normal;
/// `gouraud` at the vertices; `quadratic` (paper `quadratic`, section 3) at the vertices and each edge_node(). \throws
/// Error for a method whose colour is no polynomial.
TriangleNodes shade_nodes(Method method, const Scene& scene, const ScreenTriangle& triangle);

/// Red, green and blue through the nodes, over the triangle's snapped vertices, about `origin`.
std::array<Polynomial, 3> fit_colour(const TriangleNodes& nodes, const ScreenTriangle& triangle,
                                     const PixelIndex& origin);

/// Depth in 16-bit steps, linear on the screen, over the triangle's snapped vertices, about `origin`.
Polynomial fit_depth(const ScreenTriangle& triangle, const PixelIndex& origin);

/// What the pixels of triangles with log channels are made of besides their channels.
struct MaterialSetup {
    /// Red, green, blue, 0…4095: u8.4 in 8-bit steps, with the ½ of rounding folded in.
    std::array<int, 3> ambient{};
    int power_channels = 0;  ///< bit k: log channel k is 16·cos, for the power table; else z
    friend bool operator==(const MaterialSetup& a, const MaterialSetup& b) {
        return a.ambient == b.ambient && a.power_channels == b.power_channels;
    }
};

/// What a power table holds: an entry's highlight in 8-bit steps.
using PowerEntries = std::vector<std::uint8_t>;

/// A triangle as a device gets it, in fields. What stands below `depth` goes in packets of its own, and counts only
/// where there are log channels.
struct TriangleSetup {
    TriangleWalk walk;
    bool linear = false;
    std::array<ChannelWords, 3> colour;
    std::vector<ChannelWords> log;
    std::optional<ChannelWords> depth;
    MaterialSetup material;
    std::shared_ptr<const PowerEntries> table;  ///< 1024 entries; none where no log channel is a power channel
};

/// The setup of one of the triangle's walks. The polynomial is the whole triangle's, rounded about the middle of what
/// the walk covers; ½ is folded into colour and depth.
TriangleSetup make_setup(const TriangleNodes& nodes, const ScreenTriangle& triangle, const TriangleWalk& walk);

/// Its depth channel alone: what decides, to the bit, which triangle a device's picture shows at a pixel.
ChannelWords depth_words(const ScreenTriangle& triangle, const TriangleWalk& walk);

/// All setups of a scene, in drawing order: one per walk. \throws Error for a method without packets, and for one with
/// log channels where why_not_on_devices() or a channel can't hold a triangle's nodes (lit_setup.hpp).
std::vector<TriangleSetup> make_setups(Method method, const Scene& scene, const std::vector<ScreenTriangle>& triangles,
                                       const MethodOptions& options = {});

}  // namespace sheen
