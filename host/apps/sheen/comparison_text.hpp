// SPDX-License-Identifier: MIT
/// \file
/// A comparison as text: tables for people, JSON and CSV for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sheen/compare.hpp"

namespace sheen::command {

/// A line for each row, and one for each method's cost.
std::string comparison_table(const Comparison& comparison);

/// An array of the rows. What isn't known is null, as is an infinite PSNR.
nlohmann::ordered_json comparison_json(const Comparison& comparison);

/// A line of names and one for each row (RFC 4180, lines end in \n). What isn't known is empty; an infinite PSNR is
/// inf. The columns are the JSON's keys, those of `cost` as cost_<part>_<operation>.
std::string comparison_csv(const Comparison& comparison);

}  // namespace sheen::command
