// SPDX-License-Identifier: MIT
/// \file
/// From mesh to screen: camera, visibility of faces, snapping and clipping.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "sheen/lighting.hpp"
#include "sheen/mesh.hpp"
#include "sheen/raster.hpp"

namespace sheen {

/// Everything that a picture depends on. Conventions: right-handed eye space in mesh units, the eye at 0 looking along
/// −Z, +Y up, front faces counter-clockwise.
/// - Orthographic: the mesh's bounding sphere (radius r) is moved to (0, 0, −4r) and fills 0.9 of the image's height;
///   depth maps −3r…−5r to [1, 65534].
/// - Perspective: the sphere is moved to (0, 0, −d·r), d = `distance`, by default where it fills 0.9. Triangles are
///   clipped at the near plane, max(1/256, f/2^20)·r before the eye, f = height/(2·tan(field_of_view/2)) pixels; it
///   never reaches the sphere at the default distance, and keeps every vertex within ±2^20 px of the image's middle.
///   Depth is linear in 1/z, and so on the screen, from the nearer of sphere and near plane (1) to the sphere's far
///   side.
struct Scene {
    Mesh mesh;
    Material material;  ///< of triangles whose mesh brings none
    std::vector<Light> lights;
    glm::dvec3 rotate_degrees{0.0};       ///< about x, then y, then z, about the bounding sphere's centre
    int width = 512;                      ///< 1…4095
    int height = 512;                     ///< 1…4095
    bool two_sided = false;               ///< keep back faces, with their normals flipped
    std::optional<double> field_of_view;  ///< perspective: vertical, degrees, 1…170; none: orthographic
    std::optional<double> distance;       ///< perspective: of the sphere's centre, in radii, 0…1000; none: fills 0.9
};

/// A vertex on the screen with what shading needs.
struct ScreenVertex {
    SnappedPoint point;        ///< 1/256 px, y down
    double depth = 0.0;        ///< 16-bit depth, 1…65534, 0 would be nearest; linear on screen
    glm::dvec3 position{0.0};  ///< eye space
    glm::dvec3 normal{0.0};    ///< eye space, unit
};

/// A front-facing triangle (or a flipped back face) with its pixels in the image; at the near plane one or two pieces
/// of it, each fitted anew. `vertices` define the shading polynomial and, by the top-left rule, the coverage; `walks`
/// are the covered pixels in the image.
struct ScreenTriangle {
    std::array<ScreenVertex, 3> vertices;
    glm::dvec3 face_normal{0.0};  ///< eye space, unit, on the visible side
    Material material;
    std::vector<TriangleWalk> walks;
};

/// What becomes of triangles that cover no pixel.
enum class Uncovered { drop, keep };

/// Projects, clips, snaps and culls; drops or keeps the triangles that cover no pixel. The order is the mesh's.
/// \throws UsageError for an impossible size, field of view or distance, or a distance without a field of view; Error
///         for a mesh whose radius is 0 or not finite.
std::vector<ScreenTriangle> project(const Scene& scene, Uncovered uncovered = Uncovered::drop);

/// Unit vector from a surface point towards the eye: (0, 0, 1) for the orthographic camera and for a point in the eye.
glm::dvec3 to_eye(const Scene& scene, const glm::dvec3& position);

}  // namespace sheen
