// SPDX-License-Identifier: MIT
/// \file
/// Primitives of glTF files as lists of triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "gltf_buffers.hpp"
#include "gltf_json.hpp"

namespace sheen {

/// The corners of a primitive's triangles, three by three; none for points and lines.
struct GltfCorners {
    std::size_t count = 0;
    bool has_normals = false;
    std::string positions;  ///< x, y, z of each corner, single precision
    std::string normals;    ///< likewise, or empty; zero where the file has no direction
};

/// Reads a primitive: triangles, a strip or a fan, with indices or without.
/// \throws Error that names the field: no positions, an accessor that is wrong, an index out of range, a coordinate
/// that
///         is not finite, a number of corners that makes no triangles, more triangles than `max_triangles`.
GltfCorners read_gltf_primitive(const GltfField& primitive, GltfBuffers& buffers, std::size_t max_triangles);

}  // namespace sheen
