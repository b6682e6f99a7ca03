// SPDX-License-Identifier: MIT
#include "stl_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

#include "scalars.hpp"
#include "sheen/error.hpp"
#include "statements.hpp"

namespace sheen {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t triangle_size = 50;  ///< 12 numbers in single precision and 2 bytes of attributes
constexpr std::size_t floats_of_normal = 3;
constexpr std::size_t floats_of_corners = 9;

/// Number of triangles that a binary file announces.
std::size_t announced(std::string_view bytes) {
    return bytes.size() < header_size + 4 ? 0
                                          : static_cast<std::size_t>(load_scalar(bytes, header_size, ScalarType::u32));
}

bool begins_with_solid(std::string_view bytes) {
    constexpr std::string_view solid = "solid";
    const std::size_t start = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    const std::string_view word = bytes.substr(start, solid.size());
    return std::equal(word.begin(), word.end(), solid.begin(), solid.end(),
                      [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// Triangles as binary STL, with normals and attributes of zero.
class PlainStl {
 public:
    void begin_triangle() { body_.append(floats_of_normal * sizeof(float), '\0'); }
    void add(float coordinate) { append_f32(body_, coordinate); }
    void end_triangle() { body_.append(2, '\0'); }

    PlainMesh take(const std::string& name) const {
        if (body_.empty()) {
            throw Error(name + ": the file has no triangles; an STL file needs at least one facet");
        }
        PlainMesh plain;
        plain.bytes.assign(header_size, '\0');
        append_u32(plain.bytes, static_cast<std::uint32_t>(body_.size() / triangle_size));
        plain.bytes += body_;
        return plain;
    }

 private:
    std::string body_;
};

PlainMesh check_binary(const std::string& name, std::string_view bytes) {
    PlainStl plain;
    for (std::size_t triangle = 0; triangle < announced(bytes); ++triangle) {
        plain.begin_triangle();
        for (std::size_t i = 0; i < floats_of_corners; ++i) {
            const std::size_t at = header_size + 4 + triangle_size * triangle + sizeof(float) * (floats_of_normal + i);
            const double value = load_scalar(bytes, at, ScalarType::f32);
            if (!std::isfinite(value)) {
                throw Error(fmt::format("{}: triangle {}, corner {}: '{}' is no coordinate; it must be finite", name,
                                        triangle + 1, i / 3 + 1, value));
            }
            plain.add(static_cast<float>(value));
        }
        plain.end_triangle();
    }
    return plain.take(name);
}

/// Statements of a text file, each on its line.
class TextReader {
 public:
    TextReader(const std::string& name, std::string_view text) : name_(name), reader_(name, text, "STL text") {}

    PlainMesh check() {
        PlainStl plain;
        while (reader_.next(words_)) {
            require({"solid"}, false);
            while (next("'facet' or 'endsolid'"), !is("endsolid", 0)) {
                require({"facet", "normal"}, true);
                facet(plain);
            }
        }
        return plain.take(name_);
    }

 private:
    void facet(PlainStl& plain) {
        next("'outer loop'");
        require({"outer", "loop"}, false);
        plain.begin_triangle();
        for (int corner = 0; corner < 3; ++corner) {
            next("'vertex'");
            require({"vertex"}, true);
            for (std::size_t axis = 1; axis <= 3; ++axis) {
                plain.add(to_coordinate(name_, words_[axis]));
            }
        }
        plain.end_triangle();
        next("'endloop'");
        require({"endloop"}, false);
        next("'endfacet'");
        require({"endfacet"}, false);
    }

    /// Reads the next statement, which is to be `expected`.
    void next(std::string_view expected) {
        if (!reader_.next(words_)) {
            throw Error(fmt::format("{}: the file ends where {} is needed", name_, expected));
        }
    }

    [[nodiscard]] bool is(std::string_view keyword, std::size_t position) const {
        return position < words_.size() &&
               std::equal(words_[position].text.begin(), words_[position].text.end(), keyword.begin(), keyword.end(),
                          [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
    }

    /// The statement must begin with these words, and with three numbers behind them where it has a vector.
    void require(const std::vector<std::string_view>& keywords, bool has_vector) const {
        for (std::size_t i = 0; i < keywords.size(); ++i) {
            if (!is(keywords[i], i)) {
                fail_at(name_, words_[std::min(i, words_.size() - 1)],
                        fmt::format("stands where '{}' is needed", keywords[i]));
            }
        }
        if (has_vector && words_.size() != keywords.size() + 3) {
            fail_at(name_, words_[0], fmt::format("has {} numbers; it needs 3", words_.size() - keywords.size()));
        }
    }

    const std::string& name_;
    StatementReader reader_;
    std::vector<Word> words_;
};

}  // namespace

PlainMesh check_stl(const std::string& name, std::string_view bytes) {
    const std::size_t needed = header_size + 4 + triangle_size * announced(bytes);
    if (bytes.size() >= header_size + 4 && bytes.size() == needed) {
        return check_binary(name, bytes);
    }
    if (begins_with_solid(bytes)) {
        return TextReader(name, bytes).check();
    }
    if (bytes.size() < header_size + 4) {
        throw Error(fmt::format("{}: the file has {} bytes; binary STL has at least 84, text begins with 'solid'", name,
                                bytes.size()));
    }
    throw Error(fmt::format("{}: announces {} triangles, which take {} bytes; the file has {}", name, announced(bytes),
                            needed, bytes.size()));
}

}  // namespace sheen
