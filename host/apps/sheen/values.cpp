// SPDX-License-Identifier: MIT
/// \file
/// Words to values, without regard to the locale.
#include "values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"

namespace sheen::command {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& word, const std::string& right) {
    throw UsageError(fmt::format("{} '{}': give {}", option, word, right));
}

/// The whole word as a number; nothing when it isn't one.
template <typename Number>
std::optional<Number> to_number(const std::string& word) {
    const std::size_t sign = word.rfind('+', 0) == 0 && word.rfind("+-", 0) != 0 ? 1 : 0;
    Number value{};
    const char* end = word.data() + word.size();
    const auto [stopped, error] = std::from_chars(word.data() + sign, end, value);
    return error == std::errc() && stopped == end ? std::optional<Number>(value) : std::nullopt;
}

bool lies_in(double value, const Range& range) {
    return std::isfinite(value) && value >= range.least && value <= range.greatest;
}

std::string describe(const Range& range) {
    if (range.least == any_number.least) {
        return "finite";
    }
    return range.greatest == any_number.greatest ? fmt::format("finite and at least {}", range.least)
                                                 : fmt::format("from {} to {}", range.least, range.greatest);
}

/// The pieces between separators; one more than there are separators.
std::vector<std::string> split(const std::string& word, char separator) {
    std::vector<std::string> pieces(1);
    for (const char character : word) {
        if (character == separator) {
            pieces.emplace_back();
        } else {
            pieces.back() += character;
        }
    }
    return pieces;
}

}  // namespace

double parse_number(const std::string& option, const std::string& word, const Range& range) {
    const std::optional<double> value = to_number<double>(word);
    if (!value || !lies_in(*value, range)) {
        refuse(option, word, "one number, " + describe(range));
    }
    return *value;
}

glm::dvec3 parse_vector(const std::string& option, const std::string& word, const Range& range) {
    const std::vector<std::string> pieces = split(word, ',');
    glm::dvec3 vector(0.0);
    bool valid = pieces.size() == 3;
    for (int i = 0; valid && i < 3; ++i) {
        const std::optional<double> value = to_number<double>(pieces[static_cast<std::size_t>(i)]);
        valid = value && lies_in(*value, range);
        vector[i] = value.value_or(0.0);
    }
    if (!valid) {
        refuse(option, word, fmt::format("three numbers separated by commas, each {}", describe(range)));
    }
    return vector;
}

glm::dvec3 parse_direction(const std::string& option, const std::string& word) {
    const glm::dvec3 vector = parse_vector(option, word, any_number);
    const glm::dvec3 sizes = glm::abs(vector);
    const double greatest = std::max({sizes.x, sizes.y, sizes.z});
    if (greatest == 0.0) {
        refuse(option, word, "a direction that is not zero");
    }
    // Scaled first: the square of a large or small component would overflow or vanish.
    return glm::normalize(vector / greatest);
}

Size parse_size(const std::string& option, const std::string& word) {
    const std::vector<std::string> pieces = split(word, 'x');
    const auto side = [&](std::size_t i) {
        const std::optional<int> value = to_number<int>(pieces[i]);
        // Coordinate 4095 marks a message (contract 3), so that it is also the greatest size.
        return value && *value >= 1 && *value <= hls::message_x ? *value : 0;
    };
    const Size size = pieces.size() == 2 ? Size{side(0), side(1)} : Size{0, 0};
    if (size.width == 0 || size.height == 0) {
        refuse(option, word, fmt::format("WxH, each from 1 to {}, as in 512x512", hls::message_x));
    }
    return size;
}

std::vector<std::string> parse_list(const std::string& option, const std::string& word) {
    std::vector<std::string> pieces = split(word, ',');
    for (auto piece = pieces.begin(); piece != pieces.end(); ++piece) {
        if (piece->empty() || std::find(pieces.begin(), piece, *piece) != piece) {
            refuse(option, word, "words separated by commas, none of them empty or twice");
        }
    }
    return pieces;
}

}  // namespace sheen::command
