// SPDX-License-Identifier: MIT
/// \file
/// `log-quadratic`, Sheen's own method: quadratics of the unclamped diffuse colour and of each highlight's logarithm.
///
/// A pixel's colour in 8-bit steps, per component c, over the log channels l:
///
///     max(0, D_c) + ambient_c + Σ_l min(2^8, tint_lc·2^(8 − z_l))
///
/// D (three quadratics) and z (one a highlight) go through six nodes each: the vertices and the edges' middles. What a
/// node holds depends on the node alone, so neighbours agree along their common edge.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sheen/method.hpp"
#include "sheen/method_options.hpp"
#include "sheen/scene.hpp"

namespace sheen {

/// The highlight of one light, or of several of one tint: z = 8 − log₂(its brightest component in 8-bit steps).
struct LogHighlight {
    std::array<double, 6> z{};  ///< at vertices 0, 1, 2 and midpoints 01, 12, 20
    glm::dvec3 tint{1.0};       ///< the components over the brightest of them: 0…1, one of them 1
    /// The highlight in 8-bit steps where the interpolated channel has this value; at most 256 a component, since the
    /// datapath's z plus −log₂ tint stops at 0.
    [[nodiscard]] glm::dvec3 colour(double interpolated_z) const;
};

/// What the method makes of a triangle. Everything but z is in 8-bit steps.
struct LogNodes {
    TriangleNodes diffuse;    ///< unclamped below, within ±306; with the highlights that have no log channel
    glm::dvec3 ambient{0.0};  ///< added after the clamp at 0
    std::vector<LogHighlight> highlights;
    /// The colour where the vertices have these weights, not clamped above.
    [[nodiscard]] glm::dvec3 colour_at(const glm::dvec3& weights) const;
};

/// Why the scene's highlights have no channel: a material whose model is no power of a cosine.
std::optional<std::string> why_not_logarithmic(const Scene& scene);

/// −n·log₂ cos θ up to θ₀ = min(arccos 2^(−7/n), 72°); beyond, continued by its tangent in θ², which keeps clear of
/// the logarithm's singularity at 90°. `angle` in radians, taken as 2.6 above that; `shininess` n ≥ 0.
double log_bell(double angle, double shininess);

/// The unclamped diffuse colour of a point, 8-bit steps: per component Σ max(0, cᵢ) where that is positive, else the
/// largest cᵢ, over the lights that reach the component (cᵢ = 255·kd·(N·Lᵢ)·colourᵢ); 0 where none does. Summed
/// unclamped, a light from behind would put out the others.
glm::dvec3 unclamped_diffuse(const Material& material, const std::vector<Light>& lights, const SurfacePoint& point);

/// The nodes of one triangle. The lights with the brightest component get the `options.log_channels` log channels, the
/// earlier one first where they are equal. A further light joins the last channel of its own tint, or, when there is
/// none, the colour nodes. A light that makes no highlight (black, or ks = 0) takes no channel. Each z is at most
/// `options.log_node_limit`.
/// The triangle's material is one that why_not_logarithmic() has nothing against.
LogNodes shade_log_nodes(const MethodOptions& options, const Scene& scene, const ScreenTriangle& triangle);

}  // namespace sheen
