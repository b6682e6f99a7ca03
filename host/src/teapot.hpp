// SPDX-License-Identifier: MIT
/// \file
/// The teapot as a mesh.
#pragma once

#include "sheen/mesh.hpp"

namespace sheen {

/// Newell's teapot, y up, spout towards +x, each patch cut into 10×10 cells, with the surface's own normals. The lid is
/// widened to meet the rim and the spout is capped, so that no viewer outside sees its inside.
Mesh make_teapot();

}  // namespace sheen
