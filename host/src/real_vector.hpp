// SPDX-License-Identifier: MIT
/// \file
/// Vectors of any Real (double or Counted): what glm offers for its own floating-point types only.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "sheen/counted.hpp"

namespace sheen {

template <typename Real>
using Vec3 = glm::vec<3, Real>;

/// Three multiplications, two additions.
template <typename Real>
Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Whether there is no length to divide by: zero, or so short that its square is. A guard, not arithmetic of a method:
/// free.
template <typename Real>
bool is_zero(const Vec3<Real>& v) {
    const double x = value_of(v.x);
    const double y = value_of(v.y);
    const double z = value_of(v.z);
    return x * x + y * y + z * z == 0.0;
}

/// 1/|v|: three multiplications, two additions, a root, a division. Infinite for the zero vector.
template <typename Real>
Real inverse_length(const Vec3<Real>& v) {
    using std::sqrt;
    return Real{1.0} / sqrt(dot(v, v));
}

/// v/|v| by inverse_length(): three multiplications more. Not a number for the zero vector.
template <typename Real>
Vec3<Real> normalised(const Vec3<Real>& v) {
    return v * inverse_length(v);
}

}  // namespace sheen
