// SPDX-License-Identifier: MIT
/// \file
/// Output files that appear whole or not at all.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

#include "sheen/error.hpp"
#include "sheen/image.hpp"

namespace sheen {
namespace {

[[noreturn]] void fail(const std::string& path, int error_number) {
    throw Error(path + ": cannot write: " + std::strerror(error_number) + "; give a path in a writable folder");
}

/// Closes its descriptor and removes its file, unless told to keep it.
class TemporaryFile {
 public:
    /// Creates a file of a fresh name beside `target`, with the permissions that a new file of this process gets.
    explicit TemporaryFile(const std::filesystem::path& target) : name_(target.string() + ".XXXXXX") {
        descriptor_ = ::mkstemp(name_.data());
        if (descriptor_ < 0) {
            fail(target.string(), errno);
        }
        const mode_t mask = ::umask(0);
        ::umask(mask);
        ::fchmod(descriptor_, static_cast<mode_t>(0666) & ~mask);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
        if (!renamed_) {
            ::unlink(name_.c_str());
        }
    }
    [[nodiscard]] int descriptor() const { return descriptor_; }
    /// Gives the file its final name. Returns 0 or an errno.
    int rename_to(const std::filesystem::path& target) {
        const int closed = ::close(descriptor_);
        descriptor_ = -1;
        if (closed != 0 || ::rename(name_.c_str(), target.c_str()) != 0) {
            return errno;
        }
        renamed_ = true;
        return 0;
    }

 private:
    std::string name_;
    int descriptor_ = -1;
    bool renamed_ = false;
};

/// Writes all bytes; returns 0 or an errno.
int write_all(int descriptor, const void* data, std::size_t size) {
    // POSIX leaves writes above SSIZE_MAX to the system, and Linux stops at 2 GiB: write in chunks.
    constexpr std::size_t chunk = std::size_t{1} << 30;
    const char* next = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = ::write(descriptor, next, std::min(size, chunk));
        if (written < 0) {
            if (errno == EINTR) {
                continue;
            }
            return errno;
        }
        next += written;
        size -= static_cast<std::size_t>(written);
    }
    return 0;
}

}  // namespace

void write_file_atomically(const std::string& path, const void* data, std::size_t size) {
    if (path == "-") {
        if (const int error = write_all(STDOUT_FILENO, data, size)) {
            throw Error(std::string("standard output: cannot write: ") + std::strerror(error));
        }
        return;
    }
    // A link keeps pointing at its file, and a pipe or terminal is written to, not replaced.
    std::error_code ignored;
    std::filesystem::path target = path;
    if (std::filesystem::exists(target, ignored)) {
        target = std::filesystem::canonical(target, ignored);
        if (std::filesystem::is_directory(target, ignored)) {
            fail(path, EISDIR);
        }
        if (!std::filesystem::is_regular_file(target, ignored)) {
            const int descriptor = ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
            const int error = descriptor < 0 ? errno : write_all(descriptor, data, size);
            if (descriptor >= 0) {
                ::close(descriptor);
            }
            if (error != 0) {
                fail(path, error);
            }
            return;
        }
        if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) {
            fail(path, errno);
        }
    }
    TemporaryFile temporary(target);
    int error = write_all(temporary.descriptor(), data, size);
    if (error == 0) {
        error = temporary.rename_to(target);
    }
    if (error != 0) {
        fail(path, error);
    }
}

}  // namespace sheen
