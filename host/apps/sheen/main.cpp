// SPDX-License-Identifier: MIT
/// \file
/// sheen: draws meshes with the kernels, with simulated hardware or in double precision, and compares them.
///
/// Exit status: 0 done; 1 a file's content or the system is the cause; 2 the request itself is malformed.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

#include "commands.hpp"
#include "sheen/error.hpp"

namespace {

constexpr int status_failed = 1;
constexpr int status_usage = 2;

/// Prints a complaint as one line, whatever a file's name holds.
int complain(std::string message, int status) {
    std::replace_if(
        message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
    std::fprintf(stderr, "sheen: %s\n", message.c_str());
    return status;
}

/// The parser only says that a subcommand is required; name the word that is none.
void require_known_subcommand(const CLI::App& app, int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') {
        return;
    }
    const std::string word = argv[1];
    if (app.get_subcommands([&word](const CLI::App* command) { return command->check_name(word); }).empty()) {
        throw sheen::UsageError("unknown subcommand '" + word + "': give render, run, compare or info");
    }
}

/// The parser names the culprit only; this is where its user finds what would be right.
std::string remedy(int argc, char** argv) {
    const bool named = argc > 1 && argv[1][0] != '-';
    return std::string("; `sheen ") + (named ? std::string(argv[1]) + " " : "") + "--help` lists what it takes";
}

int run(int argc, char** argv) {
    CLI::App app("Phong-quality shading at the price of Gouraud shading: kernels, VHDL and reference, side by side.",
                 "sheen");
    app.set_version_flag("--version", "sheen " SHEEN_VERSION, "Print the version");
    app.require_subcommand(1);
    app.footer(
        "Examples:\n"
        "  sheen render builtin:teapot -o teapot.png\n"
        "  sheen render mine.obj --light -.4,.5,.77 --shininess 80 --device verilator -o mine.png\n"
        "  sheen compare builtin:sphere-168 --lights measured -o sheet.png\n"
        "`sheen SUBCOMMAND --help` lists a subcommand's options.");
    sheen::command::add_render(app);
    sheen::command::add_run(app);
    sheen::command::add_compare(app);
    sheen::command::add_info(app);
    require_known_subcommand(app, argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        // Help and version arrive as parse errors of status 0.
        return error.get_exit_code() == 0 ? app.exit(error) : complain(error.what() + remedy(argc, argv), status_usage);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const sheen::UsageError& error) {
        return complain(error.what(), status_usage);
    } catch (const std::bad_alloc&) {
        return complain("out of memory: give a smaller mesh or --size", status_failed);
    } catch (const std::exception& error) {
        return complain(error.what(), status_failed);
    }
}
