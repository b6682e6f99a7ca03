// SPDX-License-Identifier: MIT
/// \file
/// Options of single methods, checked where they are read.
#include "method_choices.hpp"

#include <cmath>
#include <string>

#include "sheen/error.hpp"
#include "sheen/exponent_table.hpp"
#include "values.hpp"

namespace sheen::command {
namespace {

constexpr Range bases = {1.0, 100.0};
constexpr int most_log_channels = 64;

/// A whole number in least…greatest. \throws UsageError.
std::size_t parse_count(const std::string& option, const std::string& word, double least, double greatest) {
    const double value = parse_number(option, word, {least, greatest});
    if (value != std::floor(value)) throw UsageError(option + " '" + word + "': give a whole number");
    return static_cast<std::size_t>(value);
}

}  // namespace

MethodChoices::MethodChoices(CLI::App& command) {
    constexpr const char* group = "Methods";
    const auto add = [&command](const char* name, const char* words, const char* description, auto store) {
        command.add_option_function<std::string>(name, store, description)->type_name(words)->group(group);
    };
    const auto flag = [&command](const char* name, bool& value, const char* description) {
        command.add_flag(name, value, description)->group(group);
    };
    MethodOptions& options = options_;
    add("--log-channels", "N", "log-quadratic: channels for highlights, 0 to 64 [3]",
        [&options](const std::string& word) {
            options.log_channels = parse_count("--log-channels", word, 0, most_log_channels);
        });
    add("--taylor-table", "BYTES", "taylor, taylor-finite: size of the exponent table [1024]",
        [&options](const std::string& word) {
            options.taylor_table_bytes = parse_count("--taylor-table", word, ExponentTable::least_bytes,
                                                     static_cast<double>(ExponentTable::most_bytes));
        });
    add("--spherical-base", "K", "spherical: cos^K stands for cos^n, K from 1 to 100; 0: cos^n itself [2]",
        [&options](const std::string& word) {
            const bool exact = word == "0";
            options.spherical_base = exact ? 0.0 : parse_number("--spherical-base", word, bases);
        });
    flag("--spherical-minimax", options.spherical_minimax, "spherical: the base's scale has the least largest error");
    flag("--spherical-separate", options.spherical_separate, "spherical: both vectors are interpolated");
    add("--recurrence-pixels", "N", "recurrence: pixels a step, 1 or 4 [1]", [&options](const std::string& word) {
        if (word != "1" && word != "4") throw UsageError("--recurrence-pixels '" + word + "': give 1 or 4");
        options.recurrence_pixels = word == "1" ? 1 : 4;
    });
    flag("--recurrence-integer-index", options.recurrence_integer_index,
         "recurrence: sampled by the paper's integer index, off the pixel centres");
    flag("--as-printed", options.as_printed, "taylor, spherical, recurrence: the paper's formula with its misprints");
}

}  // namespace sheen::command
