// SPDX-License-Identifier: MIT
#include "gltf_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "sheen/error.hpp"

namespace sheen {
namespace {

constexpr std::size_t max_depth = 64;
constexpr std::size_t max_values = std::size_t{1} << 22;

/// Counts what is parsed, and builds nothing. (A parser with a callback would take quadratic time.)
class Limits : public nlohmann::json_sax<nlohmann::json> {
 public:
    Limits(const std::string& name, std::string_view text) : name_(name), text_(text) {}
    bool null() override { return count(); }
    bool boolean(bool /*value*/) override { return count(); }
    bool number_integer(number_integer_t /*value*/) override { return count(); }
    bool number_unsigned(number_unsigned_t /*value*/) override { return count(); }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return count(); }
    bool string(string_t& /*value*/) override { return count(); }
    bool binary(binary_t& /*value*/) override { return count(); }
    bool key(string_t& /*value*/) override { return true; }
    bool start_object(std::size_t /*size*/) override { return enter(); }
    bool start_array(std::size_t /*size*/) override { return enter(); }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }

    bool parse_error(std::size_t byte, const std::string& /*token*/,
                     const nlohmann::json::exception& /*error*/) override {
        const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text_.size()));
        const auto line = 1 + std::count(text_.begin(), end, '\n');
        throw Error(
            fmt::format("{}:{}: no JSON from byte {} on; glTF files are JSON in double precision", name_, line, byte));
    }

 private:
    bool count() {
        if (++values_ > max_values) {
            throw Error(
                fmt::format("{}: the JSON has more than {} values, the most that Sheen reads", name_, max_values));
        }
        return true;
    }
    bool enter() {
        if (++depth_ > max_depth) {
            throw Error(fmt::format("{}: the JSON nests deeper than {}, the most that Sheen reads", name_, max_depth));
        }
        return count();
    }
    bool leave() {
        --depth_;
        return true;
    }

    const std::string& name_;
    std::string_view text_;
    std::size_t values_ = 0;
    std::size_t depth_ = 0;
};

}  // namespace

nlohmann::json parse_gltf_json(const std::string& name, std::string_view text) {
    Limits limits(name, text);
    nlohmann::json::sax_parse(text.begin(), text.end(), &limits);
    return nlohmann::json::parse(text.begin(), text.end());
}

void GltfField::fail(const std::string& problem) const {
    throw Error(fmt::format("{}: {}: {}", file_.get(), path_.empty() ? "the JSON" : path_, problem));
}

bool GltfField::has(const char* member) const {
    if (!value_.get().is_object()) {
        fail("is no object");
    }
    return value_.get().contains(member);
}

GltfField GltfField::operator[](const char* member) const {
    if (!has(member)) {
        fail(fmt::format("has no '{}'", member));
    }
    return {file_, value_.get()[member], path_.empty() ? member : path_ + "." + member};
}

GltfField GltfField::operator[](std::size_t index) const {
    if (index >= size()) {
        fail(fmt::format("has {} elements, and index {} is asked for", size(), index));
    }
    return {file_, value_.get()[index], fmt::format("{}[{}]", path_, index)};
}

std::size_t GltfField::size() const {
    if (!value_.get().is_array()) {
        fail("is no array");
    }
    return value_.get().size();
}

std::size_t GltfField::whole() const {
    const nlohmann::json& value = value_;
    const bool fits =
        value.is_number_unsigned() && value.get<std::uint64_t>() <= std::numeric_limits<std::uint32_t>::max();
    if (!fits) {
        fail("is no whole number from 0 to 4294967295");
    }
    return value.get<std::size_t>();
}

std::size_t GltfField::whole(const char* member, std::size_t without) const {
    return has(member) ? (*this)[member].whole() : without;
}

double GltfField::number() const {
    const nlohmann::json& value = value_;
    constexpr double greatest = std::numeric_limits<float>::max();
    if (!value.is_number() || !(std::abs(value.get<double>()) <= greatest)) {
        fail("is no number within single precision");
    }
    return value.get<double>();
}

double GltfField::number(const char* member, double without) const {
    return has(member) ? (*this)[member].number() : without;
}

const std::string& GltfField::text() const {
    if (!value_.get().is_string()) {
        fail("is no string");
    }
    return value_.get().get_ref<const std::string&>();
}

bool GltfField::truth(const char* member) const {
    if (!has(member)) {
        return false;
    }
    const GltfField field = (*this)[member];
    if (!field.value_.get().is_boolean()) {
        field.fail("is neither true nor false");
    }
    return field.value_.get().get<bool>();
}

}  // namespace sheen
