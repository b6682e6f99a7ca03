// SPDX-License-Identifier: MIT
#include "ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include "sheen/error.hpp"
#include "statements.hpp"

namespace sheen {
namespace {

constexpr std::array<std::pair<std::string_view, ScalarType>, 16> type_names{{{"char", ScalarType::i8},
                                                                              {"uchar", ScalarType::u8},
                                                                              {"short", ScalarType::i16},
                                                                              {"ushort", ScalarType::u16},
                                                                              {"int", ScalarType::i32},
                                                                              {"uint", ScalarType::u32},
                                                                              {"float", ScalarType::f32},
                                                                              {"double", ScalarType::f64},
                                                                              {"int8", ScalarType::i8},
                                                                              {"uint8", ScalarType::u8},
                                                                              {"int16", ScalarType::i16},
                                                                              {"uint16", ScalarType::u16},
                                                                              {"int32", ScalarType::i32},
                                                                              {"uint32", ScalarType::u32},
                                                                              {"float32", ScalarType::f32},
                                                                              {"float64", ScalarType::f64}}};

class HeaderReader {
 public:
    HeaderReader(const std::string& name, std::string_view bytes) : name_(name), bytes_(bytes) {}

    PlyHeader read() {
        next_line();
        if (words_.size() != 1 || words_[0].text != "ply") {
            fail("a PLY file begins with the line 'ply'");
        }
        while (!ended_) {
            next_line();
            if (!words_.empty()) {
                statement();
            }
        }
        if (!has_format_) {
            fail("the header has no 'format' line");
        }
        check_counts();
        return std::move(header_);
    }

 private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw Error(fmt::format("{}:{}: {}", name_, header_.lines, problem));
    }

    /// Splits the next line into words.
    void next_line() {
        constexpr std::size_t longest = 4096;
        const std::string_view rest = bytes_.substr(header_.size);
        const std::size_t length = rest.substr(0, longest).find_first_of("\r\n");
        ++header_.lines;
        if (length == std::string_view::npos) {
            fail("the PLY header has no end; its last line is 'end_header'");
        }
        words_.clear();
        const std::string_view line = rest.substr(0, length);
        for (std::size_t at = line.find_first_not_of(" \t"); at < line.size();) {
            const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
            words_.push_back({line.substr(at, end - at), header_.lines});
            at = line.find_first_not_of(" \t", end);
        }
        header_.size += length + (rest.substr(length, 2) == "\r\n" ? 2 : 1);
    }

    void statement() {
        const std::string_view keyword = words_[0].text;
        if (keyword == "format") {
            format();
        } else if (keyword == "element") {
            element();
        } else if (keyword == "property") {
            property();
        } else if (keyword == "end_header") {
            ended_ = true;
        } else if (keyword != "comment" && keyword != "obj_info") {
            fail_at(name_, words_[0],
                    "is no line of a PLY header; it has format, comment, element, property and end_header");
        }
    }

    void format() {
        const std::string_view kind = words_.size() == 3 && words_[2].text == "1.0" ? words_[1].text : "";
        if (kind == "binary_little_endian") {
            header_.binary = ByteOrder::little;
        } else if (kind == "binary_big_endian") {
            header_.binary = ByteOrder::big;
        } else if (kind != "ascii") {
            fail_at(name_, words_[0], "needs ascii, binary_little_endian or binary_big_endian, and 1.0");
        }
        has_format_ = true;
    }

    void element() {
        if (words_.size() != 3) {
            fail_at(name_, words_[0], "needs a name and a number of rows");
        }
        PlyElement element;
        element.name = words_[1].text;
        const std::string_view digits = words_[2].text;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), element.count);
        if (error != std::errc() || end != digits.data() + digits.size()) {
            fail_at(name_, words_[2], "is no number of rows");
        }
        for (const PlyElement& other : header_.elements) {
            if (other.name == element.name) {
                fail_at(name_, words_[1], "is an element that the header has already");
            }
        }
        header_.elements.push_back(std::move(element));
        element_lines_.push_back(header_.lines);
    }

    void property() {
        if (header_.elements.empty()) {
            fail_at(name_, words_[0], "stands before the first element");
        }
        const bool is_list = words_.size() == 5 && words_[1].text == "list";
        if (!is_list && words_.size() != 3) {
            fail_at(name_, words_[0], "needs 'TYPE NAME' or 'list TYPE TYPE NAME'");
        }
        PlyProperty property;
        property.name = words_.back().text;
        property.type = type(words_[words_.size() - 2]);
        if (is_list) {
            property.count_type = type(words_[2]);
            if (*property.count_type == ScalarType::f32 || *property.count_type == ScalarType::f64) {
                fail_at(name_, words_[2], "is no type of a list's length; it must be an integer");
            }
        }
        PlyElement& element = header_.elements.back();
        constexpr std::size_t most = 256;
        if (element.find(property.name) || element.properties.size() == most) {
            fail_at(name_, words_.back(), "is a property that the element has already, or one more than 256");
        }
        element.properties.push_back(std::move(property));
    }

    [[nodiscard]] ScalarType type(const Word& word) const {
        for (const auto& [type_name, result] : type_names) {
            if (word.text == type_name) {
                return result;
            }
        }
        fail_at(name_, word, "is no PLY type; they are char, uchar, short, ushort, int, uint, float and double");
    }

    /// Each number takes its size, or as text a digit and a space; the last row of a text needs no line end.
    void check_counts() const {
        const std::size_t body = bytes_.size() - header_.size;
        for (std::size_t i = 0; i < header_.elements.size(); ++i) {
            const PlyElement& element = header_.elements[i];
            std::size_t row = 0;
            for (const PlyProperty& property : element.properties) {
                row += header_.binary ? size_of(property.count_type.value_or(property.type)) : 2;
            }
            if (element.count > (row == 0 ? 0 : (body + 1) / row)) {
                throw Error(
                    fmt::format("{}:{}: element {} announces {} rows, more than the {} bytes behind the header "
                                "can hold",
                                name_, element_lines_[i], in_quotes(element.name), element.count, body));
            }
        }
    }

    const std::string& name_;
    std::string_view bytes_;
    PlyHeader header_;
    std::vector<Word> words_;
    std::vector<std::size_t> element_lines_;
    bool has_format_ = false;
    bool ended_ = false;
};

}  // namespace

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
        if (properties[i].name == property) {
            return i;
        }
    }
    return std::nullopt;
}

PlyHeader read_ply_header(const std::string& name, std::string_view bytes) { return HeaderReader(name, bytes).read(); }

}  // namespace sheen
