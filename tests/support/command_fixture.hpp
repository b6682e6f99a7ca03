// SPDX-License-Identifier: MIT
/// \file
/// Runs the built command in a folder of its own, with good and faulty inputs in it.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace sheen::test {

using Words = std::vector<std::string>;

inline std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Outcome {
    int status = -1;
    std::string out;
    std::string err;
};

/// A folder of inputs in which the command runs; gone at the end of the test.
class CommandTest : public testing::Test {
 protected:
    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "sheen_command_XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        root_ = name;
        folder_ = root_ / "work";
        std::filesystem::create_directory(folder_);
        write("good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write("broken.obj", "this is no mesh\n\x01\x02\n");
        write("empty.obj", "");
        write("points.obj", "v 0 0 0\nv 1 0 0\n");
        write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
        write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
        write("odd.packets", std::string(7, '\0'));
        std::filesystem::create_directory(folder_ / "folder");
        inputs_ = listing();
    }
    void TearDown() override { std::filesystem::remove_all(root_); }

    void write(const std::string& name, const std::string& content) const {
        std::ofstream(folder_ / name, std::ios::binary) << content;
    }
    [[nodiscard]] std::string read(const std::string& name) const { return content_of(folder_ / name); }
    [[nodiscard]] std::set<std::string> listing() const {
        std::set<std::string> names;
        for (const std::filesystem::directory_entry& entry : std::filesystem::recursive_directory_iterator(folder_)) {
            names.insert(entry.path().string());
        }
        return names;
    }
    [[nodiscard]] const std::set<std::string>& inputs() const { return inputs_; }

    /// Runs `sheen words…` in the folder.
    [[nodiscard]] Outcome sheen(const Words& words) const {
        const std::filesystem::path out = root_ / "out";
        const std::filesystem::path err = root_ / "err";
        const pid_t child = ::fork();
        if (child == 0) {
            Words all = {SHEEN_COMMAND};
            all.insert(all.end(), words.begin(), words.end());
            std::vector<char*> arguments;
            std::transform(all.begin(), all.end(), std::back_inserter(arguments),
                           [](std::string& w) { return w.data(); });
            arguments.push_back(nullptr);
            constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
            const bool ready = ::dup2(::open(out.c_str(), flags, 0600), STDOUT_FILENO) >= 0 &&
                               ::dup2(::open(err.c_str(), flags, 0600), STDERR_FILENO) >= 0 &&
                               ::chdir(folder_.c_str()) == 0;
            if (ready) {
                ::execv(SHEEN_COMMAND, arguments.data());
            }
            ::_exit(127);
        }
        int status = 0;
        EXPECT_EQ(::waitpid(child, &status, 0), child);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
    }

    /// The command must fail with `status`, say so in one line that holds `culprit`, and leave nothing behind.
    void expect_refusal(const Words& words, int status, const std::string& culprit) const {
        std::string line = "sheen";
        for (const std::string& word : words) {
            line += " '" + word + "'";
        }
        SCOPED_TRACE(line);
        const Outcome outcome = sheen(words);
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err.rfind("sheen: ", 0), 0U) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(culprit), std::string::npos) << "no '" << culprit << "' in: " << outcome.err;
        EXPECT_EQ(listing(), inputs());
    }

 private:
    std::filesystem::path root_;
    std::filesystem::path folder_;
    std::set<std::string> inputs_;
};

}  // namespace sheen::test
