// SPDX-License-Identifier: MIT
/// \file
/// Method `spherical`: the angle between two vectors along a span (paper `spherical`, section 3.2).
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>

#include "sheen/great_arc.hpp"
#include "sheen/shader.hpp"

namespace sheen {

/// Two unit vectors whose angle shading asks for, as N and L.
template <typename Real>
struct VectorPair {
    glm::vec<3, Real> u;
    glm::vec<3, Real> v;
};

/// cos θ(t) = amplitude·cos(start + t·rate) along a span, t = 0 at its left end and 1 at its right one.
///
/// In the paper's words (eq. 17) A = amplitude, −α = start, γ = rate. The start is reduced so that the cosine is
/// positive nowhere but between −π/2 and π/2: with rate ≤ π a span reaches one such stretch at most, and whoever reads
/// a bell there sees no second one. Angles lie in −3π/2…3π/2.
template <typename Real>
struct CosineSpan {
    Real amplitude{0.0};  ///< A in 0…1
    Real start{0.0};      ///< −α
    Real rate{0.0};       ///< γ in 0…π
    [[nodiscard]] Real angle(Real t) const { return start + t * rate; }
};

/// The arc of u against v: v is held at its left vector, and u turned against it, from u_left to u′, which is u_right
/// turned back by the rotation from v_left to v_right (section 3.2, figure 8).
/// \param towards which way an arc between opposite vectors takes
template <typename Real>
GreatArc<Real> arc_against(const VectorPair<Real>& left, const VectorPair<Real>& right, const glm::dvec3& towards) {
    return {left.u, GreatArc<Real>(left.v, right.v, towards).turned_back(right.u), towards};
}

/// Eq. 15 to 17 for u on the arc and v held. With w the arc's tangent, A·cos α = u_left·v = cos θ₁ and A·sin α = w·v,
/// which is (cos θ₂ − cos θ₁·cos γ)/sin γ without the division.
///
/// Erratum: the last term of eq. 15 is printed with the opposite sign, which eq. 16 and 17 don't follow; `as_printed`
/// has it.
template <typename Real>
CosineSpan<Real> cosine_span(const GreatArc<Real>& arc, const glm::vec<3, Real>& v, bool as_printed) {
    using std::atan2;
    using std::sqrt;
    constexpr double pi = 3.14159265358979323846;
    const auto against_v = [&](const glm::vec<3, Real>& u) { return u.x * v.x + u.y * v.y + u.z * v.z; };
    const Real along = against_v(arc.start());
    const Real across = as_printed ? -against_v(arc.tangent()) : against_v(arc.tangent());
    CosineSpan<Real> span{sqrt(along * along + across * across), -atan2(across, along), arc.angle()};
    if (value_of(span.start) + value_of(span.rate) > 1.5 * pi) span.start -= Real(2.0 * pi);
    return span;
}

/// Why `spherical` can't express the scene, if it can't: its highlight must be a power of one cosine, as Blinn's and
/// Phong's are. Any light and any camera will do.
std::optional<std::string> why_not_spherical(const Scene& scene);

/// \throws UsageError for a base that is negative or not finite.
std::unique_ptr<Shader> make_spherical_shader(const MethodOptions& options, const Scene& scene,
                                              const ScreenTriangle& triangle);

}  // namespace sheen
