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
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "mtl_check.hpp"
#include "sheen/error.hpp"
#include "statements.hpp"

namespace sheen {
namespace {

/// Statements of the OBJ specification that carry no triangles, and those that common exporters add.
constexpr std::array<std::string_view, 40> ignored_statements{
    "vp",    "cstype", "deg",      "bmat",     "step", "p",      "l",      "curv",       "curv2",     "surf",
    "parm",  "trim",   "hole",     "scrv",     "sp",   "end",    "con",    "g",          "s",         "mg",
    "o",     "bevel",  "c_interp", "d_interp", "lod",  "usemap", "maplib", "shadow_obj", "trace_obj", "ctech",
    "stech", "call",   "csh",      "bsp",      "bzp",  "cdc",    "cdp",    "res",        "vw",        "mtl"};

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
    Checker(const std::string& name, std::string_view text) : name_(name), text_(text), library_(name) {}

    PlainMesh check() {
        std::vector<Word> words;
        for (StatementReader reader = statements(); reader.next(words);) {
            total_.add(words[0].text);
            if (words[0].text == "mtllib") {
                library_.add(words);
            }
        }
        for (StatementReader reader = statements(); reader.next(words);) {
            statement(words);
        }
        return take();
    }

 private:
    /// Faces of one material, as plain statements.
    struct Group {
        Material material;
        std::string faces;
    };

    [[nodiscard]] StatementReader statements() const { return {name_, text_, "Wavefront OBJ text"}; }

    [[noreturn]] void fail(const Word& word, const std::string& problem) const { fail_at(name_, word, problem); }

    void statement(const std::vector<Word>& words) {
        const std::string_view keyword = words[0].text;
        seen_.add(keyword);
        if (keyword == "v") {
            append_vector(words, false);
        } else if (keyword == "vn") {
            append_vector(words, true);
        } else if (keyword == "f" || keyword == "fo") {
            append_face(words);
        } else if (keyword == "usemtl") {
            use_material(words);
        } else if (keyword != "vt" && keyword != "mtllib" &&
                   std::find(ignored_statements.begin(), ignored_statements.end(), keyword) ==
                       ignored_statements.end()) {
            fail(words[0], "is no OBJ statement; Sheen reads Wavefront OBJ text files");
        }
    }

    /// The plain file: vertices, then faces, material by material.
    PlainMesh take() {
        PlainMesh plain;
        for (const Group& group : groups_) {
            if (group.faces.empty()) {
                continue;
            }
            if (has_materials_) {
                fmt::format_to(std::back_inserter(plain_), "usemtl {}\n", plain.materials.size());
                plain.materials.push_back(group.material);
            }
            plain_ += group.faces;
        }
        if (faces_ == 0) {
            throw Error(name_ + ": the file has no triangles; at least one 'f' statement is needed");
        }
        plain.bytes = std::move(plain_);
        return plain;
    }

    void use_material(const std::vector<Word>& words) {
        const Material material = library_.find(words);
        const auto [entry, added] = group_index_.try_emplace(joined_name(words), groups_.size());
        if (added) {
            if (groups_.size() > max_materials) {
                fail(words[0], fmt::format("names one material more than {}, the most of a file", max_materials));
            }
            groups_.push_back({material, {}});
        }
        group_ = entry->second;
    }

    void append_vector(const std::vector<Word>& words, bool is_normal) {
        if (words.size() < 4) {
            fail(words[0], fmt::format("is followed by {} numbers; it needs 3", words.size() - 1));
        }
        std::array<double, 3> values{};
        bool finite = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            values[axis] = to_number(name_, words[axis + 1]);
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
        if (!budget_.take(corners)) {
            fail(words[0],
                 fmt::format("has {} corners, too many with the large faces before it; divide them into faces "
                             "of at most {}",
                             corners, TriangulationBudget::free_corners));
        }
        std::string& faces = groups_[group_].faces;
        faces += 'f';
        for (std::size_t corner = 1; corner <= corners; ++corner) {
            append_corner(words[corner], faces);
        }
        faces += '\n';
        ++faces_;
        has_materials_ = has_materials_ || group_ != 0;
    }

    /// A corner is v, v/vt, v//vn or v/vt/vn.
    void append_corner(const Word& word, std::string& faces) const {
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
            fmt::format_to(std::back_inserter(faces), " {}//{}", *vertex, *normal);
        } else {
            fmt::format_to(std::back_inserter(faces), " {}", *vertex);
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
            fail(word, "is no corner of a face; " + in_quotes(field) + " is no index");
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
    MaterialLibrary library_;
    std::vector<Group> groups_{1};  ///< the first: faces before any usemtl
    std::map<std::string, std::size_t> group_index_;
    std::size_t group_ = 0;
    TriangulationBudget budget_;
    bool has_materials_ = false;
    std::size_t faces_ = 0;
    std::string plain_;
};

}  // namespace

PlainMesh check_obj(const std::string& name, std::string_view text) { return Checker(name, text).check(); }

}  // namespace sheen
