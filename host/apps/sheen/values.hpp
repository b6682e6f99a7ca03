// SPDX-License-Identifier: MIT
/// \file
/// The values of options. Each function throws UsageError naming the option, the word, and what would be right.
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <vector>

namespace sheen::command {

/// A closed range of real numbers.
struct Range {
    double least;
    double greatest;
};

inline constexpr Range any_number = {-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
inline constexpr Range not_negative = {0.0, std::numeric_limits<double>::max()};
inline constexpr Range zero_to_one = {0.0, 1.0};

/// A finite number within `range`.
double parse_number(const std::string& option, const std::string& word, const Range& range);

/// Three of them, as in -.4,.5,.77
glm::dvec3 parse_vector(const std::string& option, const std::string& word, const Range& range);

/// As parse_vector, of any finite components that are not all zero, scaled to length 1.
glm::dvec3 parse_direction(const std::string& option, const std::string& word);

struct Size {
    int width;
    int height;
};

/// WxH, each from 1 to 4095.
Size parse_size(const std::string& option, const std::string& word);

/// The words between commas; none may be empty or stand twice.
std::vector<std::string> parse_list(const std::string& option, const std::string& word);

}  // namespace sheen::command
