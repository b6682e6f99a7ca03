// SPDX-License-Identifier: MIT
/// \file
/// The header of PLY files.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scalars.hpp"

namespace sheen {

/// A number, or a list of numbers behind their count.
struct PlyProperty {
    std::string name;
    ScalarType type = ScalarType::f32;
    std::optional<ScalarType> count_type;  ///< of a list
};

/// `count` rows, each of which has all properties in their order.
struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
    /// The index of the property of this name; nothing where there is none.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
    std::optional<ByteOrder> binary;  ///< nothing: the body is text
    std::vector<PlyElement> elements;
    std::size_t size = 0;   ///< bytes before the body
    std::size_t lines = 0;  ///< lines before the body
};

/// \throws Error "name:line: …" for a line that is no PLY header, and for an element of more rows than the rest of the
///         file can hold.
PlyHeader read_ply_header(const std::string& name, std::string_view bytes);

}  // namespace sheen
