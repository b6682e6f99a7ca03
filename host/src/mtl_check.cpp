// SPDX-License-Identifier: MIT
#include "mtl_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <system_error>

#include "mesh_file.hpp"
#include "sheen/error.hpp"

namespace sheen {
namespace {

/// Statements of one MTL file, newmtl by newmtl.
class MtlReader {
 public:
    MtlReader(const std::string& path, std::map<std::string, Material>& materials)
        : path_(path), materials_(materials) {}

    void statement(const std::vector<Word>& words) {
        const std::string_view keyword = words[0].text;
        if (keyword == "newmtl") {
            finish();
            begin(words);
        } else if (keyword == "Ka") {
            current(words).ambient = colour(words);
        } else if (keyword == "Kd") {
            current(words).diffuse = colour(words);
        } else if (keyword == "Ks") {
            const glm::dvec3 specular = colour(words);
            current(words).specular = (specular.r + specular.g + specular.b) / 3.0;
        } else if (keyword == "Ns") {
            current(words).shininess = exponent(words);
        } else if (keyword == "illum") {
            current(words);
            highlight_ = value(words, 1) >= 2.0;
        }
    }

    /// Keeps the material that was begun last. Of two with one name the first counts.
    void finish() {
        if (!name_.empty()) {
            if (!highlight_) {
                material_.specular = 0.0;
            }
            materials_.try_emplace(name_, material_);
        }
    }

 private:
    void begin(const std::vector<Word>& words) {
        name_ = joined_name(words);
        if (name_.empty()) {
            fail_at(path_, words[0], "has no name behind it");
        }
        material_ = Material();
        highlight_ = true;
    }

    Material& current(const std::vector<Word>& words) {
        if (name_.empty()) {
            fail_at(path_, words[0], "stands before the first newmtl");
        }
        return material_;
    }

    double value(const std::vector<Word>& words, std::size_t index) const {
        if (index >= words.size()) {
            fail_at(path_, words[0], "has too few numbers behind it");
        }
        return to_number(path_, words[index]);
    }

    /// One number for all three components, or one each.
    glm::dvec3 colour(const std::vector<Word>& words) const {
        glm::dvec3 result{};
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t index = words.size() == 2 ? 1 : 1 + static_cast<std::size_t>(axis);
            result[axis] = value(words, index);
            if (!(result[axis] >= 0.0 && result[axis] <= 1.0)) {
                fail_at(path_, words[index], fmt::format("is no reflectance; {} needs 0 to 1", words[0].text));
            }
        }
        return result;
    }

    double exponent(const std::vector<Word>& words) const {
        const double result = value(words, 1);
        if (!(result >= 0.0 && std::isfinite(result))) {
            fail_at(path_, words[1], "is no shininess; Ns needs a number from 0 up");
        }
        return result;
    }

    const std::string& path_;
    std::map<std::string, Material>& materials_;
    std::string name_;
    Material material_;
    bool highlight_ = true;
};

}  // namespace

void MaterialLibrary::add(const std::vector<Word>& mtllib) {
    const std::string where = fmt::format("{}:{}", obj_, mtllib[0].line);
    const std::string whole = joined_name(mtllib);
    std::error_code ignored;
    const std::filesystem::path beside = std::filesystem::path(obj_).parent_path() / whole;
    if (mtllib.size() > 2 && !std::filesystem::exists(beside, ignored)) {
        for (std::size_t i = 1; i < mtllib.size(); ++i) {
            add_file(std::string(mtllib[i].text), where);
        }
    } else {
        add_file(whole, where);
    }
}

void MaterialLibrary::add_file(const std::string& reference, const std::string& where) {
    std::string path;
    std::string text;
    try {
        path = path_below(obj_, reference, where);
        if (!files_.insert(path).second) {
            return;
        }
        text = read_mesh_file(path);
    } catch (const Error& error) {
        if (!missing_) {
            const std::string problem = error.what();
            missing_ = path.empty() ? problem
                                    : fmt::format("{}: material library {} can't be read ({})", where,
                                                  in_quotes(reference), problem.substr(0, problem.find(';')));
        }
        return;
    }
    read(path, text);
}

void MaterialLibrary::read(const std::string& path, const std::string& text) {
    MtlReader reader(path, materials_);
    std::vector<Word> words;
    for (StatementReader statements(path, text, "MTL text"); statements.next(words);) {
        reader.statement(words);
    }
    reader.finish();
}

Material MaterialLibrary::find(const std::vector<Word>& usemtl) const {
    const std::string name = joined_name(usemtl);
    if (name.empty()) {
        return {};
    }
    const auto entry = materials_.find(name);
    if (entry == materials_.end()) {
        if (missing_) {
            throw Error(fmt::format("{}, and line {} uses material {}, which no other defines", *missing_,
                                    usemtl[0].line, in_quotes(name)));
        }
        throw Error(fmt::format("{}:{}: {} is no material; no mtllib of the file defines it", obj_, usemtl[0].line,
                                in_quotes(name)));
    }
    return entry->second;
}

}  // namespace sheen
