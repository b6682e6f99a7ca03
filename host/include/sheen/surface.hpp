// SPDX-License-Identifier: MIT
/// \file
/// The surface under a point of the screen: what the camera makes of barycentric coordinates, and the nodes of edges.
#pragma once

#include <glm/vec3.hpp>

#include "sheen/lighting.hpp"
#include "sheen/scene.hpp"

namespace sheen {

/// A triangle's barycentric coordinates on the surface, from those on the screen: the same for the orthographic camera;
/// in perspective λ_k/w_k over their sum, w = −z the vertices' distance before the eye.
glm::dvec3 surface_weights(const Scene& scene, const ScreenTriangle& triangle, const glm::dvec3& screen_weights);

/// The triangle's surface under a point of the screen, given by its barycentric coordinates there: position and normal
/// interpolated linearly on the surface. Where opposite normals cancel, the normal is the face's.
SurfacePoint surface_point(const Scene& scene, const ScreenTriangle& triangle, const glm::dvec3& screen_weights);

/// The normal on an edge at a·(1 + lean)/2 + b·(1 − lean)/2, normalised: in the middle unless `lean`, −1…1, says
/// otherwise. Where that vanishes (opposite normals) every perpendicular is equally near: the one that faces `eye` most
/// is taken, or `eye` itself when the normals lie along it. Unit, and the same to the bit for (b, a, −lean).
glm::dvec3 midpoint_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye, double lean = 0.0);

/// A vertex as shading sees it.
SurfacePoint vertex_node(const Scene& scene, const ScreenVertex& vertex);

/// Where the middle of the edge on the screen meets the surface, with midpoint_normal() there: half-way for the
/// orthographic camera, nearer to the nearer end in perspective. The same to the bit in a and b, so that neighbours
/// agree.
SurfacePoint edge_node(const Scene& scene, const ScreenVertex& a, const ScreenVertex& b);

}  // namespace sheen
