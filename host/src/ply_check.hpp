// SPDX-License-Identifier: MIT
/// \file
/// A strict reading of PLY files.
#pragma once

#include <string>
#include <string_view>

#include "plain_mesh.hpp"

namespace sheen {

/// Checks the header and every row of a PLY file (text or binary, either byte order) and keeps x, y, z, nx, ny, nz of
/// element `vertex` and the list `vertex_indices` (or `vertex_index`) of element `face`. Other elements and properties
/// are skipped. Normals that are not finite become zero.
/// \throws Error that names the file, and the line or the element's row: a header that is none, more rows than the file
///         has, a row with too few or too many numbers, a coordinate that is no finite number (single precision), a
///         face with fewer than 3 corners or more than 4096, an index out of range; a file without faces.
PlainMesh check_ply(const std::string& name, std::string_view bytes);

}  // namespace sheen
