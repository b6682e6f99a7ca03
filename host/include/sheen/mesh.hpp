// SPDX-License-Identifier: MIT
/// \file
/// Triangle meshes: from files, or built in.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "sheen/lighting.hpp"

namespace sheen {

/// A triangle mesh in its own units. `normals` has one unit vector per position; triangles index both. A mesh with
/// materials of its own has an index into them per triangle; one without takes the scene's.
struct Mesh {
    std::string name;
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Material> materials;
    std::vector<std::uint32_t> triangle_materials;  ///< as many as triangles, or none
};

/// The mesh's bounding sphere: centre of the axis-aligned box, radius to the farthest vertex used by a triangle.
struct BoundingSphere {
    glm::dvec3 centre{0.0};
    double radius = 0.0;
};

/// Loads `source`: a file, or one of builtin_mesh_names(). The file's extension, in capitals or not, tells its format:
/// .obj (or none) Wavefront OBJ, .ply, .stl, .gltf and .glb (glTF 2.0); docs/mesh-files.md says what is taken of each.
/// Vertices without normals in the file get area-weighted smooth ones. `materials` is empty for a file that uses none.
/// \throws Error naming the file and what is wrong (missing, unreadable, no triangles, a coordinate that is not
///         finite, an index out of range); UsageError for an unknown `builtin:` name.
Mesh load_mesh(const std::string& source);

/// `builtin:sphere-168`, `builtin:sphere-374`, `builtin:sphere-690`, `builtin:torus-knot`, `builtin:teapot`.
std::vector<std::string> builtin_mesh_names();

/// Makes a built-in mesh by its full name (`builtin:…`). \throws UsageError for an unknown one.
Mesh make_builtin_mesh(const std::string& name);

/// Centre 0 and radius 0 without triangles; an infinite radius when a used coordinate is not finite.
BoundingSphere bounding_sphere(const Mesh& mesh);

/// Area-weighted smooth unit normals, one per position: the normalised sum of the (doubled) area vectors of the
/// triangles around it. (0, 0, 1) where that sum has no direction.
std::vector<glm::dvec3> smooth_normals(const std::vector<glm::dvec3>& positions,
                                       const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace sheen
