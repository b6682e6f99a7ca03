// SPDX-License-Identifier: MIT
/// \file
/// Where results go: files checked before the work, standard output, figures as JSON, progress.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sheen/render.hpp"

namespace sheen::command {

/// Adds an option whose value is the path of an output; the caller may require it. The path stays empty when not given.
CLI::Option* add_output(CLI::App& command, const std::string& names, std::string& path, const std::string& word,
                        const std::string& description);

/// The output files of one invocation, by option; an empty path is an output that was not asked for.
class Outputs {
 public:
    /// \throws UsageError when two options name one path, or a path looks like an option; Error when a path can't be
    ///         written. Nothing is there afterwards that was not there before.
    explicit Outputs(std::vector<std::pair<std::string, std::string>> path_of_option);
    /// Prints for people: on standard output, or on standard error where standard output carries a file.
    void print(const std::string& text) const;

 private:
    bool standard_output_taken_ = false;
};

/// The value as JSON; null for nothing and for what JSON can't say (an infinite number).
template <typename Value>
nlohmann::ordered_json json_or_null(const std::optional<Value>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

/// Says on standard error, in one line, what the user should know though the command goes on.
void print_warning(const std::string& text);

nlohmann::ordered_json to_json(const Statistics& statistics);

/// Writes indented JSON whole or not at all.
void write_json(const std::string& path, const nlohmann::ordered_json& json);

/// A bar on standard error, where that is a terminal; silent elsewhere. It is wiped when it goes out of scope.
class ProgressBar {
 public:
    ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ~ProgressBar();
    /// `done` of `total` steps are done; `what` comes now.
    void show(std::size_t done, std::size_t total, const std::string& what) const;

 private:
    bool visible_;
};

}  // namespace sheen::command
