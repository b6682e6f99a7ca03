// SPDX-License-Identifier: MIT
/// \file
/// The JSON of glTF files, with limits and with a name for each value.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace sheen {

/// \throws Error "name:line: …" for text that is no JSON, nests deeper than 64 or has more than 2^22 values.
nlohmann::json parse_gltf_json(const std::string& name, std::string_view text);

/// A value of the JSON and where it stands, as in "accessors[3].count". Every step checks what it steps on; the file's
/// name and the JSON must outlive the field.
class GltfField {
 public:
    GltfField(const std::string& file, const nlohmann::json& root) : file_(file), value_(root) {}

    /// \throws Error "file: path: problem".
    [[noreturn]] void fail(const std::string& problem) const;
    [[nodiscard]] const std::string& path() const { return path_; }

    /// True for a member of this name. \throws Error when this is no object.
    [[nodiscard]] bool has(const char* member) const;
    /// \throws Error when there is none.
    [[nodiscard]] GltfField operator[](const char* member) const;
    /// \throws Error when this is no array or `index` is out of its range.
    [[nodiscard]] GltfField operator[](std::size_t index) const;
    /// Length of an array. \throws Error when it is none.
    [[nodiscard]] std::size_t size() const;

    /// A whole number from 0 to 2^32 − 1.
    [[nodiscard]] std::size_t whole() const;
    /// Like whole(), of a member that may be missing.
    [[nodiscard]] std::size_t whole(const char* member, std::size_t without) const;
    /// A number within single precision.
    [[nodiscard]] double number() const;
    [[nodiscard]] double number(const char* member, double without) const;
    [[nodiscard]] const std::string& text() const;
    [[nodiscard]] bool truth(const char* member) const;  ///< false without

 private:
    GltfField(const std::string& file, const nlohmann::json& value, std::string path)
        : file_(file), value_(value), path_(std::move(path)) {}

    std::reference_wrapper<const std::string> file_;
    std::reference_wrapper<const nlohmann::json> value_;
    std::string path_;
};

}  // namespace sheen
