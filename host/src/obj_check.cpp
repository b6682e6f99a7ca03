// SPDX-License-Identifier: MIT
/// \file
/// The OBJ statements that make geometry, word by word.
#include "obj_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

#include "obj_statements.hpp"
#include "sheen/error.hpp"

namespace sheen {
namespace {

constexpr std::size_t min_corners = 3;
constexpr std::size_t max_corners = 4096;  ///< triangulation takes quadratic time

/// Statements of the OBJ specification that carry no triangles, and those that common exporters add.
constexpr std::array<std::string_view, 42> ignored_statements{
    "vp",       "cstype",   "deg",  "bmat",   "step",   "p",      "l",      "curv",       "curv2",     "surf",  "parm",
    "trim",     "hole",     "scrv", "sp",     "end",    "con",    "g",      "s",          "mg",        "o",     "bevel",
    "c_interp", "d_interp", "lod",  "usemtl", "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj", "ctech", "stech",
    "call",     "csh",      "bsp",  "bzp",    "cdc",    "cdp",    "res",    "vw",         "mtl"};

/// A word as a message shows it: in quotes, short, ASCII.
std::string quoted(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string shown(word.substr(0, longest));
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return "'" + shown + (word.size() > longest ? "...'" : "'");
}

/// Number of v, vt and vn statements.
struct Counts {
    std::int64_t vertices = 0;
    std::int64_t texture_coordinates = 0;
    std::int64_t normals = 0;
    /// True when `keyword` was one of them.
    bool add(std::string_view keyword) {
        if (keyword == "v") {
            ++vertices;
        } else if (keyword == "vt") {
            ++texture_coordinates;
        } else if (keyword == "vn") {
            ++normals;
        } else {
            return false;
        }
        return true;
    }
};

class Checker {
 public:
    Checker(const std::string& name, std::string_view text) : name_(name), text_(text) {}

    std::string check() {
        std::vector<Word> words;
        for (StatementReader reader(name_, text_); reader.next(words);) {
            total_.add(words[0].text);
        }
        for (StatementReader reader(name_, text_); reader.next(words);) {
            statement(words);
        }
        if (faces_ == 0) {
            throw Error(name_ + ": the file has no triangles; at least one 'f' statement is needed");
        }
        return std::move(plain_);
    }

 private:
    [[noreturn]] void fail(const Word& word, const std::string& problem) const {
        throw Error(fmt::format("{}:{}: {} {}", name_, word.line, quoted(word.text), problem));
    }

    void statement(const std::vector<Word>& words) {
        const std::string_view keyword = words[0].text;
        seen_.add(keyword);
        if (keyword == "v") {
            append_vector(words, false);
        } else if (keyword == "vn") {
            append_vector(words, true);
        } else if (keyword == "f" || keyword == "fo") {
            append_face(words);
        } else if (keyword != "vt" && std::find(ignored_statements.begin(), ignored_statements.end(), keyword) ==
                                          ignored_statements.end()) {
            fail(words[0], "is no OBJ statement; Sheen reads Wavefront OBJ text files");
        }
    }

    /// The value of a word; infinite where it is too large for single precision.
    [[nodiscard]] double number(const Word& word) const {
        std::string_view digits = word.text;
        if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') {
            digits.remove_prefix(1);
        }
        double value = 0.0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) {
            fail(word, "is no number");
        }
        if (error == std::errc::result_out_of_range) {
            value = std::strtod(std::string(digits).c_str(), nullptr);
        }
        constexpr double greatest = std::numeric_limits<float>::max();
        return std::abs(value) > greatest ? std::copysign(std::numeric_limits<double>::infinity(), value) : value;
    }

    void append_vector(const std::vector<Word>& words, bool is_normal) {
        if (words.size() < 4) {
            fail(words[0], fmt::format("is followed by {} numbers; it needs 3", words.size() - 1));
        }
        std::array<double, 3> values{};
        bool finite = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            values[axis] = number(words[axis + 1]);
            if (!std::isfinite(values[axis])) {
                finite = false;
                if (!is_normal) {
                    fail(words[axis + 1], "is no coordinate; it must be finite and within single precision");
                }
            }
        }
        if (!finite) {
            values = {};
        }
        fmt::format_to(std::back_inserter(plain_), "{} {} {} {}\n", words[0].text, static_cast<float>(values[0]),
                       static_cast<float>(values[1]), static_cast<float>(values[2]));
    }

    void append_face(const std::vector<Word>& words) {
        const std::size_t corners = words.size() - 1;
        if (corners < min_corners || corners > max_corners) {
            fail(words[0], fmt::format("has {} corners; a face needs {} to {}", corners, min_corners, max_corners));
        }
        plain_ += 'f';
        for (std::size_t corner = 1; corner <= corners; ++corner) {
            append_corner(words[corner]);
        }
        plain_ += '\n';
        ++faces_;
    }

    /// A corner is v, v/vt, v//vn or v/vt/vn.
    void append_corner(const Word& word) {
        std::array<std::string_view, 3> fields{};
        std::string_view rest = word.text;
        for (std::size_t field = 0; field < fields.size(); ++field) {
            const std::size_t slash = field + 1 < fields.size() ? rest.find('/') : std::string_view::npos;
            fields[field] = rest.substr(0, slash);
            if (slash == std::string_view::npos) {
                break;
            }
            rest.remove_prefix(slash + 1);
        }
        const auto vertex = index(word, fields[0], "vertices", seen_.vertices, total_.vertices);
        if (!vertex) {
            fail(word, "is no corner of a face; it needs a vertex index, as in 1, 1/2, 1//3 or 1/2/3");
        }
        index(word, fields[1], "texture coordinates", seen_.texture_coordinates, total_.texture_coordinates);
        const auto normal = index(word, fields[2], "normals", seen_.normals, total_.normals);
        if (normal) {
            fmt::format_to(std::back_inserter(plain_), " {}//{}", *vertex, *normal);
        } else {
            fmt::format_to(std::back_inserter(plain_), " {}", *vertex);
        }
    }

    /// The absolute index that a field means; nothing for an empty field.
    std::optional<std::int64_t> index(const Word& word, std::string_view field, std::string_view what,
                                      std::int64_t seen, std::int64_t total) const {
        if (field.empty()) {
            return std::nullopt;
        }
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
        if (error == std::errc::invalid_argument || end != field.data() + field.size()) {
            fail(word, "is no corner of a face; " + quoted(field) + " is no index");
        }
        if (error == std::errc::result_out_of_range || value == 0 || value > total || value < -seen) {
            fail(word,
                 fmt::format("is out of range; the file has {} {} ({} of them before this line), counted from 1, or "
                             "from -1 backwards",
                             total, what, seen));
        }
        return value > 0 ? value : seen + 1 + value;
    }

    const std::string& name_;
    std::string_view text_;
    Counts total_;
    Counts seen_;
    std::size_t faces_ = 0;
    std::string plain_;
};

}  // namespace

std::string check_obj(const std::string& name, std::string_view text) { return Checker(name, text).check(); }

}  // namespace sheen
