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

/// What triangulation may cost in all: seconds. Faces of up to free_corners corners cost nothing here.
class TriangulationBudget {
 public:
    static constexpr std::size_t free_corners = 16;
    /// Takes a face's share, the square of its corners; false when too little is left.
    bool take(std::size_t corners) {
        if (corners > free_corners) spent_ += corners * corners;
        return spent_ <= std::size_t{1} << 25;
    }

 private:
    std::size_t spent_ = 0;
};

/// The most materials that the triangles of one file have.
constexpr std::size_t max_materials = 4096;

}  // namespace sheen
