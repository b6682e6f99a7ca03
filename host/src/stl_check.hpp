// SPDX-License-Identifier: MIT
/// \file
/// A strict reading of STL files.
#pragma once

#include <string>
#include <string_view>

#include "plain_mesh.hpp"

namespace sheen {

/// Checks an STL file, binary or text, and keeps its triangles as binary STL. A file whose size is the one that its
/// number of triangles asks for is binary; else one that begins with "solid" is text. Facet normals are those of flat
/// triangles, not of vertices: they are skipped, and the corners' order counts.
/// \throws Error that names the file, and the line or the triangle: a size that isn't that of the announced triangles,
///         a word out of its place, a coordinate that is no finite number (single precision), a file without triangles.
PlainMesh check_stl(const std::string& name, std::string_view bytes);

}  // namespace sheen
