// SPDX-License-Identifier: MIT
/// \file
/// Output files, figures and progress.
#include "output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "sheen/error.hpp"
#include "sheen/image.hpp"

namespace sheen::command {
namespace {

constexpr const char* standard_output = "-";
constexpr std::size_t bar_width = 24;

/// Why nothing can be written to `path`, as an errno; 0 when nothing speaks against it. A new file is made beside the
/// old one, and takes its place when it is whole: so the probe is a file of a fresh name, which goes at once.
int obstacle(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        return EISDIR;
    }
    if (std::filesystem::exists(path, ignored)) {
        if (::access(path.c_str(), W_OK) != 0) {
            return errno;
        }
        if (!std::filesystem::is_regular_file(path, ignored)) {
            return 0;
        }
    }
    std::string probe = path.string() + ".XXXXXX";
    const int descriptor = ::mkstemp(probe.data());
    if (descriptor < 0) {
        return errno;
    }
    ::close(descriptor);
    ::unlink(probe.c_str());
    return 0;
}

}  // namespace

CLI::Option* add_output(CLI::App& command, const std::string& names, std::string& path, const std::string& word,
                        const std::string& description) {
    const auto complain_of_nothing = [](const std::string& value) {
        return value.empty() ? std::string("give a path, or - for standard output") : std::string();
    };
    return command.add_option(names, path, description)->check(complain_of_nothing)->type_name(word)->group("Output");
}

Outputs::Outputs(std::vector<std::pair<std::string, std::string>> path_of_option) {
    for (auto output = path_of_option.begin(); output != path_of_option.end(); ++output) {
        const auto& [option, path] = *output;
        if (path.empty()) {
            continue;
        }
        if (path.front() == '-' && path != standard_output) {
            throw UsageError(
                fmt::format("{} '{}': give a path, or - for standard output (./{} is a file)", option, path, path));
        }
        for (auto other = path_of_option.begin(); other != output; ++other) {
            if (other->second == path) {
                throw UsageError(
                    fmt::format("{} and {} both name '{}': give each its own path", other->first, option, path));
            }
        }
        if (path == standard_output) {
            standard_output_taken_ = true;
        } else if (const int error = obstacle(path); error != 0) {
            throw Error(
                fmt::format("{}: cannot write: {}; give a path in a writable folder", path, std::strerror(error)));
        }
    }
}

void Outputs::print(const std::string& text) const {
    if (standard_output_taken_) {
        std::fputs(text.c_str(), stderr);
    } else {
        write_file_atomically(standard_output, text.data(), text.size());
    }
}

void print_warning(const std::string& text) { std::fputs(("sheen: " + text + "\n").c_str(), stderr); }

nlohmann::ordered_json to_json(const Statistics& statistics) {
    return {{"pixels", statistics.pixels},
            {"cycles", json_or_null(statistics.cycles)},
            {"pixels_per_clock", json_or_null(statistics.pixels_per_clock())},
            {"triangles", statistics.triangles},
            {"packet_words", json_or_null(statistics.packet_words)}};
}

void write_json(const std::string& path, const nlohmann::ordered_json& json) {
    const std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    write_file_atomically(path, text.data(), text.size());
}

ProgressBar::ProgressBar() : visible_(::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (visible_) {
        std::fputs("\r\033[K", stderr);
    }
}

void ProgressBar::show(std::size_t done, std::size_t total, const std::string& what) const {
    if (visible_ && total > 0) {
        const std::size_t filled = bar_width * done / total;
        const std::string bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
        std::fputs(fmt::format("\r\033[K[{}] {}/{} {}", bar, done, total, what).c_str(), stderr);
    }
}

}  // namespace sheen::command
