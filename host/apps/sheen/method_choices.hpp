// SPDX-License-Identifier: MIT
/// \file
/// The options that tell a method how, shared by render and compare.
#pragma once

#include <CLI/CLI.hpp>

#include "sheen/method_options.hpp"

namespace sheen::command {

/// What the user says of how methods are computed.
class MethodChoices {
 public:
    /// Adds the options to a subcommand, whose parsing this must outlive.
    explicit MethodChoices(CLI::App& command);
    MethodChoices(const MethodChoices&) = delete;
    MethodChoices& operator=(const MethodChoices&) = delete;

    [[nodiscard]] const MethodOptions& options() const { return options_; }

 private:
    MethodOptions options_;
};

}  // namespace sheen::command
