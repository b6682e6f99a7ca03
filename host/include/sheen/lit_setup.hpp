// SPDX-License-Identifier: MIT
/// \file
/// Methods whose highlights a device looks up: `log-quadratic`, `taylor`, `taylor-finite`, as nodes and as setups.
///
/// A core adds at every pixel, per component, in 8-bit steps (docs/packet-protocol.md)
///
///     ⌊max(0, diffuse) + ambient + ½ + Σ_k highlight_k⌋,     highlight_k = 2^(8 − z), or a power table's entry
///
/// Diffuse has three quadratics, and each highlight one: of z, or of 16·cos, which addresses the table. Highlights are
/// grey: a core adds the same to all three components.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sheen/method.hpp"
#include "sheen/method_options.hpp"
#include "sheen/scene.hpp"

namespace sheen {

/// Greatest and least node of z that a log channel holds: the quadratic overshoots their range by a third of it on both
/// sides, to 126 and −52 of a channel's ±128. At 16 a highlight is gone; at −16 it is 2^16 times white.
inline constexpr double greatest_z_node = 90.0;
inline constexpr double least_z_node = -16.0;
/// Greatest magnitude of a node of 16·cos: the quadratic overshoots it by 5/3, to 127. Cosines to 4.75 fit.
inline constexpr double greatest_power_node = 76.0;

/// What such a method makes of a triangle, for a device.
struct LitNodes {
    TriangleNodes diffuse;                   ///< a device clamps it at 0, after interpolation
    std::vector<std::array<double, 6>> log;  ///< at vertices 0, 1, 2 and midpoints 01, 12, 20; at least one channel
    MaterialSetup material;
    std::shared_ptr<const PowerEntries> table;  ///< as in TriangleSetup
};

/// Why devices can't draw a scene that the method itself can express, in words that say what would be right; nothing
/// where they can, and for methods without log channels.
/// - All of them: a highlight of a coloured light.
/// - `log-quadratic`: more than three log channels in use.
/// - `taylor`, `taylor-finite`: several lights, since a device clamps the sum of their diffuse terms where the method
///   clamps each; an exponent table of another size than the core's 1024 bytes.
std::optional<std::string> why_not_on_devices(Method method, const MethodOptions& options, const Scene& scene);

/// A power table: entry k is strength·(k/1023)^n in 8-bit steps, rounded, at most 255. `strength` is 255·ks·light.
PowerEntries power_entries(double strength, double shininess);

/// Makes nodes and setups of a scene's triangles; triangles of one material share a table.
class LitSetups {
 public:
    /// The scene must outlive it. \throws Error where why_inexpressible() or why_not_on_devices(), or when the method
    /// has no log channels.
    LitSetups(Method method, const MethodOptions& options, const Scene& scene);
    ~LitSetups();
    LitSetups(const LitSetups&) = delete;
    LitSetups& operator=(const LitSetups&) = delete;

    /// `log-quadratic`: the nodes of shade_log_nodes(), z at most greatest_z_node. `taylor`, `taylor-finite`: the
    /// series' values at the nodes, which fix the same quadratics. A triangle without a highlight gets a log channel
    /// that is dark everywhere, since only with one a device clamps diffuse before it adds ambient.
    /// \throws Error naming the triangle's place when a channel can't hold its nodes.
    [[nodiscard]] LitNodes nodes(const ScreenTriangle& triangle) const;
    /// The setup of one of the triangle's walks, rounded about the middle of what it covers. Nothing is folded into
    /// colour and log channels; ½ of rounding is in the material's ambient.
    [[nodiscard]] static TriangleSetup setup(const LitNodes& nodes, const ScreenTriangle& triangle,
                                             const TriangleWalk& walk);

 private:
    class Tables;
    [[nodiscard]] LitNodes log_quadratic_nodes(const ScreenTriangle& triangle) const;
    [[nodiscard]] LitNodes taylor_nodes(const ScreenTriangle& triangle) const;

    Method method_;
    MethodOptions options_;
    const Scene& scene_;
    std::unique_ptr<Tables> tables_;
};

}  // namespace sheen
