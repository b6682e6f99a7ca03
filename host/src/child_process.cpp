// SPDX-License-Identifier: MIT
#include "child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>

#include "sheen/error.hpp"

extern char** environ;

namespace sheen {
namespace {

namespace fs = std::filesystem;

/// What a program writes to its standard output, as we read it.
class Pipe {
 public:
    Pipe() {
        if (::pipe2(ends_.data(), O_CLOEXEC) != 0) {
            throw Error(fmt::format("can't make a pipe: {}", std::strerror(errno)));
        }
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        ::close(ends_[0]);
        close_writer();
    }
    [[nodiscard]] int writer() const { return ends_[1]; }
    void close_writer() {
        if (ends_[1] >= 0) ::close(ends_[1]);
        ends_[1] = -1;
    }
    /// Calls `on_line` for each line until the writer is gone; the last one may lack its end.
    void read_lines(const std::function<void(const std::string&)>& on_line) const {
        std::string pending;
        std::array<char, 4096> buffer{};
        for (;;) {
            const ssize_t got = ::read(ends_[0], buffer.data(), buffer.size());
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) break;
            pending.append(buffer.data(), static_cast<std::size_t>(got));
            for (std::size_t end = pending.find('\n'); end != std::string::npos; end = pending.find('\n')) {
                on_line(pending.substr(0, end));
                pending.erase(0, end + 1);
            }
        }
        if (!pending.empty()) on_line(pending);
    }

 private:
    std::array<int, 2> ends_{-1, -1};
};

/// A started program; it is waited for in any case.
class Child {
 public:
    Child(const std::string& program, const std::vector<std::string>& arguments, int output,
          const std::string& error_file) {
        std::vector<char*> argv{const_cast<char*>(program.c_str())};
        for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, error_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                         0600);
        start_error_ = posix_spawnp(&id_, program.c_str(), &actions, nullptr, argv.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() { wait(); }
    [[nodiscard]] int start_error() const { return start_error_; }
    /// Its exit status, −1 where it did not exit by itself.
    int wait() {
        if (start_error_ == 0 && !waited_) {
            int status = 0;
            while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
            }
            waited_ = true;
            exit_status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        }
        return exit_status_;
    }

 private:
    pid_t id_ = 0;
    int start_error_ = 0;
    int exit_status_ = -1;
    bool waited_ = false;
};

}  // namespace

ScratchFolder::ScratchFolder() {
    std::string pattern = (fs::temp_directory_path() / "sheen-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
        throw Error(fmt::format("can't make a folder like '{}': {}; set TMPDIR to one that is writable", pattern,
                                std::strerror(errno)));
    }
    path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

ProgramEnd run_program(const std::string& program, const std::vector<std::string>& arguments,
                       const std::function<void(const std::string&)>& on_line) {
    const ScratchFolder scratch;
    const std::string error_file = scratch.file("errors");
    ProgramEnd end;
    {
        // The child outlives the pipe: when on_line throws, its next write ends it, and the wait for it.
        std::optional<Child> child;
        Pipe pipe;
        child.emplace(program, arguments, pipe.writer(), error_file);
        pipe.close_writer();
        pipe.read_lines(on_line);
        end.start_error = child->start_error();
        end.exit_status = child->wait();
    }
    std::ifstream errors(error_file);
    std::getline(errors, end.error);
    return end;
}

}  // namespace sheen
