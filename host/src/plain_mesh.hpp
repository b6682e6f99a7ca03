// SPDX-License-Identifier: MIT
/// \file
/// What every mesh file becomes before assimp sees it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sheen/lighting.hpp"

namespace sheen {

/// A mesh that was checked: a file of its own format, written anew with nothing in it but geometry. assimp trusts
/// what it reads, so counts, indices and sizes in `bytes` are right, coordinates finite, and no other file is named.
/// The k-th material goes by the name "k" in `bytes`; without materials no name means anything.
struct PlainMesh {
    std::string bytes;
    std::vector<Material> materials;
};

/// A polygon has 3 to max_corners corners: triangulation takes quadratic time.
constexpr std::size_t min_corners = 3;
constexpr std::size_t max_corners = 4096;

/// The most materials that the triangles of one file have.
constexpr std::size_t max_materials = 4096;

}  // namespace sheen
