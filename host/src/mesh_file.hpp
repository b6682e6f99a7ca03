// SPDX-License-Identifier: MIT
/// \file
/// The bytes of mesh files and of the files they name.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sheen {

/// The most that Sheen reads of one file, in bytes.
constexpr std::size_t max_file_size = std::size_t{1} << 30;

/// All bytes of a regular file. A pipe or a device isn't waited for.
/// \throws Error "path: …" for what is no regular file, can't be read, is empty or larger than max_file_size.
std::string read_mesh_file(const std::string& path);

/// The path of a file that `model` names as `reference`: relative, and below the folder of `model` after links are
/// followed. The file need not exist.
/// \throws Error "where: …" for a reference that leaves the folder or is no plain path.
std::string path_below(const std::string& model, std::string_view reference, const std::string& where);

}  // namespace sheen
