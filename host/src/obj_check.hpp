// SPDX-License-Identifier: MIT
/// \file
/// A strict reading of Wavefront OBJ text, before assimp's lenient one.
#pragma once

#include <string>
#include <string_view>

#include "plain_mesh.hpp"

namespace sheen {

/// Checks every statement of `text` and keeps those that make geometry (v, vn, f), material by material: absolute
/// indices, three numbers a vertex, normals that are not finite as zero. Forward references, negative indices,
/// continued lines and the statements of the OBJ specification that Sheen has no use for are accepted. Faces have
/// materials where one of them follows a usemtl statement; those before the first have Sheen's default then. \throws
/// Error "name:line: …" for the first word that is wrong: an unknown statement, a coordinate that is no finite
///         number (single precision), an index that is 0, malformed or out of range, a face with fewer than 3 corners
///         or more than 4096, a material that no library defines; for bytes that are no text; and for a file without
///         faces.
PlainMesh check_obj(const std::string& name, std::string_view text);

}  // namespace sheen
