// SPDX-License-Identifier: MIT
#include "sheen/picture_metrics.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "child_process.hpp"
#include "sheen/error.hpp"

namespace sheen {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int package_missing = 3;  ///< exit status of the program

/// In an installation beside the command, ../share/sheen/metrics; else the source folder's, as built.
std::string find_script() {
    const fs::path name = "picture_metrics.py";
    std::error_code failure;
    const fs::path own = fs::read_symlink("/proc/self/exe", failure).parent_path();
    const fs::path installed = own / ".." / "share" / "sheen" / "metrics" / name;
    return (fs::exists(installed, failure) ? installed : fs::path(SHEEN_SOURCE_FOLDER) / "scripts" / "metrics" / name)
        .string();
}

std::string find_interpreter() {
    if (const char* chosen = std::getenv("SHEEN_PYTHON"); chosen != nullptr && *chosen != '\0') return chosen;
    const fs::path own = fs::path(SHEEN_SOURCE_FOLDER) / "build" / "venv" / "bin" / "python";
    std::error_code failure;
    return fs::exists(own, failure) ? own.string() : "python3";
}

std::optional<double> number_or_nothing(const json& value) {
    return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

/// \throws Error for a line that is none of the program's.
PictureMetrics parse_line(const std::string& line) {
    try {
        const json object = json::parse(line);
        return {number_or_nothing(object.at("ssim")), number_or_nothing(object.at("flip"))};
    } catch (const json::exception&) {
        throw Error(
            fmt::format("the picture metrics' program wrote '{}'; it must write an object with ssim and flip", line));
    }
}

}  // namespace

struct PictureMeter::Files {
    ScratchFolder folder;
    json pairs = json::array();
    std::size_t expectations = 0;
    int width = 0;
    int height = 0;
    std::string mask;
    std::string expected;
};

PictureMeter::PictureMeter() : files_(std::make_unique<Files>()) {}
PictureMeter::~PictureMeter() = default;

void PictureMeter::expect(const Image& expected, const std::vector<bool>& mask) {
    if (3 * mask.size() != expected.rgb.size()) {
        throw Error(fmt::format("a mask of {} pixels doesn't fit a picture of {}x{}", mask.size(), expected.width,
                                expected.height));
    }
    Files& files = *files_;
    files.width = expected.width;
    files.height = expected.height;
    files.mask = files.folder.file(fmt::format("mask{}.png", files.expectations));
    files.expected = files.folder.file(fmt::format("expected{}.png", files.expectations));
    ++files.expectations;
    Image mask_image(expected.width, expected.height);
    for (std::size_t i = 0; i < mask_image.rgb.size(); ++i) mask_image.rgb[i] = mask[i / 3] ? 255 : 0;
    write_png(files.mask, mask_image);
    write_png(files.expected, expected);
}

std::size_t PictureMeter::add(const Image& actual) {
    Files& files = *files_;
    if (files.expectations == 0 || actual.width != files.width || actual.height != files.height) {
        throw Error(fmt::format("a picture of {}x{} is held against one of {}x{}; both must be of one size",
                                actual.width, actual.height, files.width, files.height));
    }
    const std::size_t number = files.pairs.size();
    const std::string path = files.folder.file(fmt::format("actual{}.png", number));
    write_png(path, actual);
    files.pairs.push_back({{"mask", files.mask}, {"expected", files.expected}, {"actual", path}});
    return number;
}

PictureMeter::Result PictureMeter::measure(const std::function<void(std::size_t, std::size_t)>& progress) const {
    Result result;
    const std::size_t total = files_->pairs.size();
    if (total == 0) return result;
    const std::string list = files_->folder.file("pairs.json");
    const std::string text = files_->pairs.dump();
    write_file_atomically(list, text.data(), text.size());
    if (progress) progress(0, total);
    const std::string interpreter = find_interpreter();
    const std::string script = find_script();
    const ProgramEnd end = run_program(interpreter, {script, list}, [&](const std::string& line) {
        result.pairs.push_back(parse_line(line));
        if (progress && result.pairs.size() < total) progress(result.pairs.size(), total);
    });
    if (end.start_error != 0) {
        return {{},
                fmt::format("can't start '{}': {}; let SHEEN_PYTHON name a Python with scikit-image and flip-evaluator",
                            interpreter, std::strerror(end.start_error))};
    }
    if (end.exit_status == package_missing) return {{}, fmt::format("'{}': {}", interpreter, end.error)};
    if (!end.success()) {
        throw Error(
            fmt::format("'{} {}' failed: {}", interpreter, script, end.error.empty() ? "it said nothing" : end.error));
    }
    if (result.pairs.size() != total) {
        throw Error(
            fmt::format("'{} {}' answered for {} pictures of {}", interpreter, script, result.pairs.size(), total));
    }
    return result;
}

}  // namespace sheen
