// SPDX-License-Identifier: MIT
#include "gltf_buffers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

#include "mesh_file.hpp"
#include "sheen/error.hpp"
#include "statements.hpp"

namespace sheen {
namespace {

/// The bytes of base64 text with or without padding; nothing where it is none.
std::optional<std::string> decode_base64(std::string_view text) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int padding = 0; padding < 2 && !text.empty() && text.back() == '='; ++padding) {
        text.remove_suffix(1);
    }
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    unsigned bits = 0;
    unsigned count = 0;
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit == std::string_view::npos) {
            return std::nullopt;
        }
        bits = (bits << 6U) | static_cast<unsigned>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<char>(static_cast<unsigned char>(bits >> count)));
            bits &= (1U << count) - 1U;
        }
    }
    return count == 6 ? std::nullopt : std::optional<std::string>(std::move(bytes));
}

/// The text with %XX as bytes; nothing where a % has no two hexadecimal digits behind it.
std::optional<std::string> decode_percent(std::string_view text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded.push_back(text[i]);
            continue;
        }
        const std::string_view digits = text.substr(i + 1, 2);
        unsigned char value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
        if (digits.size() != 2 || error != std::errc() || end != digits.data() + digits.size()) {
            return std::nullopt;
        }
        decoded.push_back(static_cast<char>(value));
        i += 2;
    }
    return decoded;
}

ScalarType component_type(const GltfField& field) {
    switch (field.whole()) {
        case 5120:
            return ScalarType::i8;
        case 5121:
            return ScalarType::u8;
        case 5122:
            return ScalarType::i16;
        case 5123:
            return ScalarType::u16;
        case 5125:
            return ScalarType::u32;
        case 5126:
            return ScalarType::f32;
        default:
            field.fail("is no component type; they are 5120 to 5123, 5125 and 5126");
    }
}

}  // namespace

double GltfElements::value(std::size_t i, std::size_t c) const {
    const double value = load_scalar(bytes_, i * stride_ + c * size_of(type_), type_);
    if (!normalized_) {
        return value;
    }
    switch (type_) {
        case ScalarType::i8:
            return std::max(value / 127.0, -1.0);
        case ScalarType::u8:
            return value / 255.0;
        case ScalarType::i16:
            return std::max(value / 32767.0, -1.0);
        case ScalarType::u16:
            return value / 65535.0;
        default:
            return value;
    }
}

GltfElements GltfBuffers::elements(const GltfField& index, std::string_view kind) {
    const GltfField accessor = root_["accessors"][index.whole()];
    if (accessor["type"].text() != kind) {
        accessor["type"].fail(fmt::format("is {}; it must be '{}'", in_quotes(accessor["type"].text()), kind));
    }
    if (accessor.has("sparse")) {
        accessor["sparse"].fail("Sheen reads no sparse accessors");
    }
    GltfElements result;
    result.count_ = accessor["count"].whole();
    result.type_ = component_type(accessor["componentType"]);
    result.normalized_ = accessor.truth("normalized");
    const std::size_t element_size = size_of(result.type_) * (kind == "VEC3" ? 3 : 1);
    result.stride_ = element_size;
    const std::string_view bytes = view(accessor["bufferView"], result.stride_);
    const std::size_t offset = accessor.whole("byteOffset", 0);
    if (result.count_ == 0 || result.stride_ < element_size || offset > bytes.size() ||
        bytes.size() - offset < element_size ||
        (result.count_ - 1) > (bytes.size() - offset - element_size) / result.stride_) {
        accessor["count"].fail(
            fmt::format("{} elements of {} bytes, {} apart, from byte {} on: they must lie within "
                        "the {} bytes of the buffer view, and be at least 1",
                        result.count_, element_size, result.stride_, offset, bytes.size()));
    }
    result.bytes_ = bytes.substr(offset);
    return result;
}

/// The bytes of the view that `index` names. `stride` becomes the view's, if it has one.
std::string_view GltfBuffers::view(const GltfField& index, std::size_t& stride) {
    const GltfField view = root_["bufferViews"][index.whole()];
    const std::string_view bytes = buffer(view["buffer"]);
    const std::size_t offset = view.whole("byteOffset", 0);
    const std::size_t length = view["byteLength"].whole();
    if (offset > bytes.size() || length > bytes.size() - offset) {
        view["byteLength"].fail(
            fmt::format("bytes {} to {} lie outside the buffer, which has {}", offset, offset + length, bytes.size()));
    }
    stride = view.whole("byteStride", stride);
    return bytes.substr(offset, length);
}

std::string_view GltfBuffers::buffer(const GltfField& index) {
    const GltfField field = root_["buffers"][index.whole()];
    const std::size_t length = field["byteLength"].whole();
    std::string_view bytes;
    if (field.has("uri")) {
        const auto [entry, added] = buffers_.try_emplace(index.whole());
        if (added) {
            entry->second = read(field["uri"]);
            read_bytes_ += entry->second.size();
            if (read_bytes_ > max_file_size) {
                field.fail("the buffers together have more than 1 GiB, the most that Sheen reads");
            }
        }
        bytes = entry->second;
    } else if (chunk_ && index.whole() == 0) {
        bytes = *chunk_;
    } else {
        field.fail("has no 'uri', and is not the binary chunk of a .glb file");
    }
    if (length > bytes.size()) {
        field["byteLength"].fail(fmt::format("is {}; the buffer has {} bytes", length, bytes.size()));
    }
    return bytes.substr(0, length);
}

std::string GltfBuffers::read(const GltfField& uri) const {
    const std::string& text = uri.text();
    constexpr std::string_view data_scheme = "data:";
    if (text.compare(0, data_scheme.size(), data_scheme) == 0) {
        constexpr std::string_view mark = ";base64,";
        const std::size_t at = text.substr(0, 256).find(mark);
        if (at == std::string::npos) {
            uri.fail("is a data URI without ';base64,', which glTF needs");
        }
        if (auto bytes = decode_base64(std::string_view(text).substr(at + mark.size()))) {
            return std::move(*bytes);
        }
        uri.fail("is a data URI that holds no base64 text");
    }
    const std::optional<std::string> reference = decode_percent(text);
    if (!reference || reference->find("://") != std::string::npos) {
        uri.fail(in_quotes(text) + " is neither a data URI nor a relative path of a file");
    }
    const std::string where = fmt::format("{}: {}", file_, uri.path());
    try {
        return read_mesh_file(path_below(file_, *reference, where));
    } catch (const Error& error) {
        const std::string problem = error.what();
        if (problem.compare(0, where.size(), where) == 0) {
            throw;
        }
        uri.fail(in_quotes(text) + " can't be read (" + problem.substr(0, problem.find(';')) + ")");
    }
}

}  // namespace sheen
