// SPDX-License-Identifier: MIT
/// \file
/// Materials of Wavefront OBJ files: MTL libraries.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sheen/lighting.hpp"
#include "statements.hpp"

namespace sheen {

/// The materials that an OBJ file's mtllib statements define and its usemtl statements name. Of MTL it takes Ka, Kd, Ks
/// and Ns: the specular reflectance is the mean of Ks, 0 where illum says that there is no highlight (0 or 1); what a
/// material doesn't state is Sheen's default.
class MaterialLibrary {
 public:
    /// `obj` names the OBJ file and must outlive the library.
    explicit MaterialLibrary(const std::string& obj) : obj_(obj) {}

    /// Reads what an mtllib statement names: one file whose name has spaces, or several. A file that can't be read is
    /// no fault until a material is missed.
    /// \throws Error "library:line: …" for one that can be read and is wrong.
    void add(const std::vector<Word>& mtllib);

    /// The material that a usemtl statement names; Sheen's default without a name.
    /// \throws Error "obj:line: …" for a name that no library defines.
    Material find(const std::vector<Word>& usemtl) const;

 private:
    void add_file(const std::string& reference, const std::string& where);
    void read(const std::string& path, const std::string& text);

    const std::string& obj_;
    std::map<std::string, Material> materials_;
    std::set<std::string> files_;
    std::optional<std::string> missing_;  ///< what is wrong with the first library that can't be read
};

}  // namespace sheen
