// SPDX-License-Identifier: MIT
/// \file
/// Programs that the library runs, and the folder in which it leaves files for them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace sheen {

/// A folder for one run's files; it goes with its owner.
class ScratchFolder {
 public:
    /// \throws Error where none can be made.
    ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder();
    [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
    std::filesystem::path path_;
};

/// How a program ended.
struct ProgramEnd {
    int start_error = 0;   ///< errno where it could not be started
    int exit_status = -1;  ///< −1 where it did not exit by itself
    std::string error;     ///< first line of its standard error
    [[nodiscard]] bool success() const { return start_error == 0 && exit_status == 0; }
};

/// Runs a program to its end, without a shell: found in PATH where it is a plain name. Each line of its standard output
/// goes to `on_line` as it comes; its standard input is empty. \throws Error when the system fails it.
ProgramEnd run_program(const std::string& program, const std::vector<std::string>& arguments,
                       const std::function<void(const std::string& line)>& on_line);

}  // namespace sheen
