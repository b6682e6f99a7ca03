// SPDX-License-Identifier: MIT
/// \file
/// Reflected radiance, paper `spherical`, eq. 8, over any Real: drawn with double, priced with Counted.
#pragma once

#include <algorithm>
#include <glm/vec3.hpp>
#include <string>

#include "brdf.hpp"
#include "real_vector.hpp"
#include "sheen/error.hpp"
#include "sheen/lighting.hpp"

namespace sheen {

/// Radiance of full intensity in 8-bit steps.
inline constexpr double full_scale = 255.0;

/// A light as one point sees it: unit vectors towards the light and the eye, and halfway between (paper `spherical`,
/// eq. 6); `half` is 0 where the two are opposite.
template <typename Real>
struct Incidence {
    Vec3<Real> to_light;
    Vec3<Real> to_eye;
    Vec3<Real> half;
};

/// `to_eye` is a unit vector.
template <typename Real>
Incidence<Real> incidence(const Light& light, const Vec3<Real>& position, const Vec3<Real>& to_eye) {
    Vec3<Real> to_light(light.vector);
    if (light.kind == Light::Kind::positional) {
        to_light -= position;
        // A point in the light's own place: any direction will do.
        to_light = is_zero(to_light) ? Vec3<Real>(0.0, 0.0, 1.0) : normalised(to_light);
    }
    const Vec3<Real> sum = to_light + to_eye;
    return {to_light, to_eye, is_zero(sum) ? sum : normalised(sum)};
}

/// The material's highlight, `specular` and the light's colour left out; 0 where H has no direction.
template <typename Real>
Real highlight(const Material& material, const Incidence<Real>& at, const Vec3<Real>& normal) {
    if (is_zero(at.half)) return Real(0.0);
    switch (material.brdf) {
        case Brdf::blinn:
            return blinn_highlight(material, dot(normal, at.half));
        case Brdf::phong:
            return phong_highlight(material, dot(normal, at.to_light), dot(normal, at.to_eye),
                                   dot(at.to_light, at.to_eye));
        case Brdf::cook_torrance:
            return cook_torrance_highlight(material, dot(normal, at.half), dot(normal, at.to_light),
                                           dot(normal, at.to_eye), dot(at.to_eye, at.half));
    }
    throw Error("reflection model number " + std::to_string(static_cast<int>(material.brdf)) + " does not exist");
}

/// What the surface reflects of one light, in 8-bit steps; the products of the material's and the light's constants
/// are made once for all points, and so are free.
template <typename Real>
Vec3<Real> reflected(const Material& material, const Light& light, const Incidence<Real>& at,
                     const Vec3<Real>& normal) {
    const Real lambert = std::max(Real(0.0), dot(normal, at.to_light));
    const Real highlight_factor = highlight(material, at, normal);
    return Vec3<Real>(full_scale * light.colour * material.diffuse) * lambert +
           Vec3<Real>(full_scale * light.colour * material.specular) * highlight_factor;
}

}  // namespace sheen
