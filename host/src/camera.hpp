// SPDX-License-Identifier: MIT
/// \file
/// Mesh units to eye space to 1/256 pixel, orthographic or in perspective. Lengths are in radii of the mesh's bounding
/// sphere, so that neither tiny nor huge meshes lose precision.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "sheen/mesh.hpp"
#include "sheen/scene.hpp"

namespace sheen {

/// A vertex in eye space.
struct EyeVertex {
    glm::dvec3 position{0.0};  ///< radii
    glm::dvec3 normal{0.0};    ///< unit
};

/// A scene's camera, with its mesh in front of it.
class Camera {
 public:
    /// \throws UsageError for an impossible image size, field of view or distance; Error for a mesh whose radius is 0
    ///         or not finite.
    explicit Camera(const Scene& scene);

    /// A vertex of the mesh.
    [[nodiscard]] EyeVertex vertex(std::uint32_t index) const;

    /// Whether the vertex can be projected: always by the orthographic camera, else at the near plane or behind it.
    [[nodiscard]] bool sees(const EyeVertex& vertex) const { return !perspective_ || -vertex.position.z >= near_; }

    /// Where the edge from a vertex that the camera sees to one that it doesn't meets the near plane. Always computed
    /// in this direction, so that the triangles on both sides of the edge get the same point to the bit. The normal is
    /// interpolated and normalised.
    [[nodiscard]] EyeVertex near_crossing(const EyeVertex& seen, const EyeVertex& unseen) const;

    /// On the screen, within ±2^29: |x| and |y| are at most a radius, and no nearer than focal_/2^20 radii.
    [[nodiscard]] ScreenVertex to_screen(const EyeVertex& vertex) const;

    /// Unit normal of a triangle's plane, on the side that faces the eye; towards the eye where rounding leaves the
    /// triangle without one.
    [[nodiscard]] glm::dvec3 visible_normal(const EyeVertex& a, const EyeVertex& b, const EyeVertex& c) const;

 private:
    const Scene& scene_;
    BoundingSphere sphere_;
    glm::dmat3 rotation_;
    bool perspective_;
    double focal_ = 0.0;           ///< pixels per radius (orthographic), or per unit of x/w
    double distance_ = 0.0;        ///< of the sphere's centre from the eye
    double near_ = 0.0;            ///< perspective: the clipping plane
    double nearest_depth_ = 0.0;   ///< where depth is 1
    double farthest_depth_ = 0.0;  ///< where it is 65534
};

}  // namespace sheen
