// SPDX-License-Identifier: MIT
/// \file
/// Measures and draws what the papers show.
///
/// Usage: paper_results FOLDER. Writes FOLDER/results.json and the single pictures, FOLDER/*.png, from which
/// scripts/paper makes docs/paper-results.md. Exit status: 0 all is there, 1 a failure, 2 not one folder.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <iostream>
#include <utility>
#include <vector>

#include "output.hpp"
#include "results.hpp"

namespace {

using namespace sheen::paper;

void run(const std::string& folder) {
    std::filesystem::create_directories(folder);
    const Album album(folder);
    const std::vector<std::pair<const char*, std::function<ordered_json()>>> parts = {
        {"bells", bell_curves},
        {"spherical", [&album] { return spherical_pictures(album); }},
        {"quadratic", [&album] { return quadratic_pictures(album); }},
        {"taylor", [&album] { return taylor_limits(album); }},
        {"misprints", [&album] { return misprints(album); }},
        {"counts", operation_counts},
        {"times", times},
        {"break_even", break_even},
    };
    const auto start = std::chrono::steady_clock::now();
    ordered_json results = {{"compiler", __VERSION__}};
    {
        const sheen::command::ProgressBar progress;
        for (std::size_t part = 0; part < parts.size(); ++part) {
            progress.show(part, parts.size(), parts[part].first);
            results[parts[part].first] = parts[part].second();
        }
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    results["seconds"] = seconds;
    sheen::command::write_json(folder + "/results.json", results);
    fmt::print("paper_results: {}/results.json, {:.0f} s\n", folder, seconds);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: paper_results FOLDER\n";
        return 2;
    }
    try {
        run(argv[1]);
        return 0;
    } catch (const std::exception& failure) {
        std::cerr << "paper_results: " << failure.what() << '\n';
        return 1;
    }
}
