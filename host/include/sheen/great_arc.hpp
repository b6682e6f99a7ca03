// SPDX-License-Identifier: MIT
/// \file
/// Spherical interpolation between two unit vectors: papers `spherical`, section 3.1, and `recurrence`, eq. 2 to 5.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "sheen/counted.hpp"

namespace sheen {

/// A unit vector perpendicular to the unit vector `from`, as near to `towards` as can be.
glm::dvec3 perpendicular(const glm::dvec3& from, const glm::dvec3& towards);

/// The great arc from one unit vector to another, the shorter way round; Real is double, or Counted to price it.
///
/// Eq. 11 of `spherical`, u(t) = u₁·sin((1−t)γ)/sin γ + u₂·sin(tγ)/sin γ, divides by sin γ. Here it is in the form of
/// eq. 5 of `recurrence`, u(t) = u₁·cos(tγ) + w·sin(tγ), with w the unit vector perpendicular to u₁ towards u₂: the
/// same vectors, and no division. Equal vectors give u₁ everywhere.
template <typename Real>
class GreatArc {
 public:
    using Vector = glm::vec<3, Real>;

    /// Both unit. Opposite vectors have no shortest arc: the one that passes nearest to the unit vector `towards` is
    /// taken.
    GreatArc(const Vector& from, const Vector& to, const glm::dvec3& towards) : start_(from) {
        using std::atan2;
        using std::sqrt;
        constexpr double vanishing = 1e-9;  // sin γ below which the direction of w is rounding noise
        const Real cosine = product(from, to);
        const Vector across = to - from * cosine;
        const Real sine = sqrt(product(across, across));
        if (value_of(sine) > vanishing) {
            tangent_ = across * (Real(1.0) / sine);
            angle_ = atan2(sine, cosine);
        } else if (value_of(cosine) < 0.0) {
            tangent_ = Vector(perpendicular({value_of(from.x), value_of(from.y), value_of(from.z)}, towards));
            angle_ = Real(std::acos(-1.0));
        }
    }

    [[nodiscard]] const Vector& start() const { return start_; }
    /// w; (0, 0, 0) where the vectors are equal.
    [[nodiscard]] const Vector& tangent() const { return tangent_; }
    /// γ in 0…π.
    [[nodiscard]] Real angle() const { return angle_; }
    /// u at `radians` from the start, unit.
    [[nodiscard]] Vector at_angle(Real radians) const {
        using std::cos;
        using std::sin;
        return start_ * cos(radians) + tangent_ * sin(radians);
    }
    /// u(t), t = 0 at the start and 1 at the end, unit.
    [[nodiscard]] Vector at(Real t) const { return at_angle(t * angle_); }
    /// `vector` turned by the inverse of the rotation that takes the arc's start to its end. Section 3.2 of `spherical`
    /// writes it with a quaternion, which divides by 1 + cos γ.
    [[nodiscard]] Vector turned_back(const Vector& vector) const {
        using std::cos;
        using std::sin;
        const Real along = product(vector, start_);
        const Real across = product(vector, tangent_);
        const Real less = cos(angle_) - Real(1.0);
        const Real s = sin(angle_);
        return vector + start_ * (less * along + s * across) + tangent_ * (less * across - s * along);
    }

 private:
    static Real product(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

    Vector start_;
    Vector tangent_{Real(0.0)};
    Real angle_{0.0};
};

}  // namespace sheen
