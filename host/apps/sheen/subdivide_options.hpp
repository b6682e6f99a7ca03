// SPDX-License-Identifier: MIT
/// \file
/// The options that ask for subdivision, shared by render and compare.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "sheen/subdivide.hpp"

namespace sheen::command {

/// What the user says of subdivision.
class SubdivideOptions {
 public:
    /// Adds the options to a subcommand, whose parsing this must outlive.
    explicit SubdivideOptions(CLI::App& command);
    SubdivideOptions(const SubdivideOptions&) = delete;
    SubdivideOptions& operator=(const SubdivideOptions&) = delete;

    /// Nothing where --subdivide was not given. \throws UsageError when --subdivide-test stands alone.
    [[nodiscard]] std::optional<Subdivision> subdivision() const;

 private:
    std::optional<double> tolerance_;
    std::optional<SubdivisionTest> test_;
};

}  // namespace sheen::command
