// SPDX-License-Identifier: MIT
/// \file
/// Buffers, buffer views and accessors of glTF files.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "gltf_json.hpp"
#include "scalars.hpp"

namespace sheen {

/// Elements of an accessor, all of which lie within their buffer.
class GltfElements {
 public:
    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] ScalarType type() const { return type_; }
    [[nodiscard]] bool normalized() const { return normalized_; }
    /// Component `c` of element `i`; integers as a fraction of their greatest value if normalized. \pre i < size()
    [[nodiscard]] double value(std::size_t i, std::size_t c) const;

 private:
    friend class GltfBuffers;
    std::string_view bytes_;  ///< from the first element on
    std::size_t count_ = 0;
    std::size_t stride_ = 0;
    ScalarType type_ = ScalarType::f32;
    bool normalized_ = false;
};

/// Reads buffers when an accessor needs them: the binary chunk of a .glb file, data URIs, and files below the folder of
/// the glTF file. Together they have at most max_file_size bytes.
class GltfBuffers {
 public:
    /// `chunk` is the binary chunk, if any. The arguments must outlive the buffers.
    GltfBuffers(const std::string& file, const GltfField& root, std::optional<std::string_view> chunk)
        : file_(file), root_(root), chunk_(chunk) {}

    /// The accessor that `index` names, which must be of `kind`: "SCALAR" or "VEC3".
    /// \throws Error that names the field: something out of range, of another type, or sparse.
    GltfElements elements(const GltfField& index, std::string_view kind);

 private:
    std::string_view view(const GltfField& index, std::size_t& stride);
    std::string_view buffer(const GltfField& index);
    std::string read(const GltfField& uri) const;

    const std::string& file_;
    const GltfField& root_;
    std::optional<std::string_view> chunk_;
    std::map<std::size_t, std::string> buffers_;  ///< those that were read
    std::size_t read_bytes_ = 0;
};

}  // namespace sheen
