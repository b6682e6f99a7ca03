// SPDX-License-Identifier: MIT
/// \file
/// The subcommands. Each adds itself to the command line, and does its work as the parser's callback.
/// \throws UsageError (exit status 2) or Error (exit status 1) out of the parsing.
#pragma once

#include <CLI/CLI.hpp>

namespace sheen::command {

void add_render(CLI::App& app);
void add_run(CLI::App& app);
void add_compare(CLI::App& app);
void add_info(CLI::App& app);

}  // namespace sheen::command
