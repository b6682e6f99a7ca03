// SPDX-License-Identifier: MIT
/// \file
/// A span of method `spherical`, over any Real: drawn with double, priced with Counted.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "edge_vectors.hpp"
#include "sheen/bell.hpp"
#include "sheen/spherical.hpp"

namespace sheen {

/// The material's bell. \throws UsageError for a base that is negative or not finite.
inline Bell make_bell(const MethodOptions& options, const Material& material) {
    if (!(options.spherical_base >= 0.0) || !std::isfinite(options.spherical_base)) {
        throw UsageError("base cos^" + std::to_string(options.spherical_base) +
                         " of method 'spherical': give an exponent above 0, or 0 for the material's own");
    }
    return {material.shininess, options.spherical_base, options.spherical_minimax};
}

/// One light's terms along a span: diffuse max(0, A·cos ξ), highlight Aⁿ·bell(ξ), each with an angle ξ of its own,
/// linear in the pixel.
template <typename Real>
struct SphericalLight {
    CosineSpan<Real> diffuse;
    CosineSpan<Real> highlight;
    Real power{0.0};  ///< Aⁿ of the highlight (eq. 18); 0 where there is none
};

/// The triangle's spans: one vector held, the other turned against it (section 3.2).
template <typename Real>
class SphericalSpan {
 public:
    SphericalSpan(const Scene& scene, const ScreenTriangle& triangle, bool as_printed)
        : vectors_(scene, triangle), shininess_(triangle.material.shininess), as_printed_(as_printed) {}

    [[nodiscard]] const SpanFrame& frame() const { return vectors_.frame(); }

    [[nodiscard]] std::vector<SphericalLight<Real>> start(const SpanFrame::Span& span) const {
        using std::pow;
        const SpanEnds<Real> normal = vectors_.normal().ends(span);
        const GreatArc<Real> normal_arc = normal.arc();
        std::vector<SphericalLight<Real>> lights;
        for (const LightVectors<Real>& light : vectors_.lights()) {
            const auto against = [&](const SpanEnds<Real>& u, const GreatArc<Real>& u_arc, const SpanEnds<Real>& v) {
                if (v.fixed) return cosine_span(u_arc, v.left, as_printed_);
                const VectorPair<Real> left{u.left, v.left};
                const VectorPair<Real> right{u.right, v.right};
                return cosine_span(arc_against(left, right, towards_camera()), v.left, as_printed_);
            };
            SphericalLight<Real> terms;
            terms.diffuse = against(normal, normal_arc, light.to_light.ends(span));
            if (light.has_highlight) {
                const SpanEnds<Real> held = light.against.ends(span);
                if (light.mirrored) {
                    const SpanEnds<Real> mirrored = light.mirrored->ends(span);
                    terms.highlight = against(mirrored, mirrored.arc(), held);
                } else {
                    terms.highlight = against(normal, normal_arc, held);
                }
                terms.power = pow(terms.highlight.amplitude, Real(shininess_));
            }
            lights.push_back(terms);
        }
        return lights;
    }

 private:
    TriangleVectors<Real> vectors_;
    double shininess_;
    bool as_printed_;
};

/// The triangle's spans with both vectors of a pair interpolated on their own (section 3.2, "one obvious possibility"):
/// their angle is not linear in the pixel, and is made at each.
template <typename Real>
class SeparateSpan {
 public:
    SeparateSpan(const Scene& scene, const ScreenTriangle& triangle) : vectors_(scene, triangle) {}

    [[nodiscard]] const SpanFrame& frame() const { return vectors_.frame(); }

    void start(const SpanFrame::Span& span) {
        arcs_.clear();
        normal_.emplace(vectors_.normal().ends(span).arc());
        for (const LightVectors<Real>& light : vectors_.lights()) {
            Arcs arcs{light.to_light.ends(span).arc(), std::nullopt, light.against.ends(span).arc(),
                      light.has_highlight};
            if (light.mirrored) arcs.mirrored = light.mirrored->ends(span).arc();
            arcs_.push_back(std::move(arcs));
        }
    }

    /// A light's cosines: N·L, and N·H or R·V; the latter −1 where there is no highlight.
    struct Cosines {
        Real diffuse, highlight;
    };
    /// At the share t of the way along the span.
    [[nodiscard]] std::vector<Cosines> at(Real t) const {
        const Vec3<Real> normal = normal_->at(t);
        std::vector<Cosines> cosines;
        for (const Arcs& arcs : arcs_) {
            const Vec3<Real> u = arcs.mirrored ? arcs.mirrored->at(t) : normal;
            cosines.push_back(
                {dot(normal, arcs.to_light.at(t)), arcs.has_highlight ? dot(u, arcs.against.at(t)) : Real(-1.0)});
        }
        return cosines;
    }

 private:
    struct Arcs {
        GreatArc<Real> to_light;
        std::optional<GreatArc<Real>> mirrored;
        GreatArc<Real> against;
        bool has_highlight;
    };
    TriangleVectors<Real> vectors_;
    std::optional<GreatArc<Real>> normal_;
    std::vector<Arcs> arcs_;
};

}  // namespace sheen
