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

constexpr int max_depth = 64;
constexpr std::size_t max_values = std::size_t{1} << 22;

}  // namespace

nlohmann::json parse_gltf_json(const std::string& name, std::string_view text) {
    std::size_t values = 0;
    const auto limit = [&](int depth, nlohmann::json::parse_event_t event, const nlohmann::json& /*parsed*/) {
        if (depth > max_depth) {
            throw Error(fmt::format("{}: the JSON nests deeper than {}, the most that Sheen reads", name, max_depth));
        }
        using Event = nlohmann::json::parse_event_t;
        values += event == Event::array_start || event == Event::object_start || event == Event::value ? 1 : 0;
        if (values > max_values) {
            throw Error(
                fmt::format("{}: the JSON has more than {} values, the most that Sheen reads", name, max_values));
        }
        return true;
    };
    try {
        return nlohmann::json::parse(text.begin(), text.end(), limit);
    } catch (const nlohmann::json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        const auto line = 1 + std::count(text.begin(), end, '\n');
        throw Error(fmt::format("{}:{}: no JSON from byte {} on; glTF files are JSON", name, line, error.byte));
    } catch (const nlohmann::json::exception&) {
        throw Error(name + ": the JSON holds a number beyond double precision");
    }
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
