// SPDX-License-Identifier: MIT
/// \file
/// A strict reading of glTF 2.0 files.
#pragma once

#include <string>
#include <string_view>

#include "plain_mesh.hpp"

namespace sheen {

/// Checks a glTF 2.0 file, JSON (.gltf) or binary (.glb; told apart by its first bytes), and keeps the scene's nodes
/// that have meshes, with their transforms and their primitives' triangles, as binary glTF. Buffers may be embedded or
/// files below the folder of `name`. Textures, cameras, skins, morph targets and animations are skipped.
/// \throws Error that names the file and the field: JSON that is none or too deep, another version, an extension that
///         the file requires and Sheen hasn't, an index, offset or length out of range, a cycle of nodes, a coordinate
///         that isn't finite, more than 2^21 triangles with all instances, a file without triangles.
PlainMesh check_gltf(const std::string& name, std::string_view bytes);

}  // namespace sheen
