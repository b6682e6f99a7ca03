// SPDX-License-Identifier: MIT
#include "mesh_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "sheen/error.hpp"
#include "statements.hpp"

namespace sheen {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& problem) {
    throw Error(path + ": cannot read: " + problem + "; give a mesh file (OBJ, PLY, STL or glTF) or a built-in mesh");
}

/// An open file, which is closed at the end of its scope.
class Descriptor {
 public:
    explicit Descriptor(const std::string& path)
        : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
        if (number_ < 0) {
            fail(path, std::strerror(errno));
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { ::close(number_); }
    [[nodiscard]] int number() const { return number_; }

 private:
    int number_;
};

}  // namespace

std::string read_mesh_file(const std::string& path) {
    const Descriptor file(path);
    struct stat status {};
    if (::fstat(file.number(), &status) != 0) {
        fail(path, std::strerror(errno));
    }
    if (S_ISDIR(status.st_mode)) {
        fail(path, "it is a directory");
    }
    if (!S_ISREG(status.st_mode)) {
        fail(path, "it is a pipe, a socket or a device, not a file");
    }
    std::string bytes;
    std::array<char, 1 << 16> buffer{};
    while (const ssize_t count = ::read(file.number(), buffer.data(), buffer.size())) {
        if (count < 0) {
            fail(path, std::strerror(errno));
        }
        bytes.append(buffer.data(), static_cast<std::size_t>(count));
        if (bytes.size() > max_file_size) {
            throw Error(path + ": the file is larger than 1 GiB, the most that Sheen reads");
        }
    }
    if (bytes.empty()) {
        throw Error(path + ": the file is empty; a mesh has at least one triangle");
    }
    return bytes;
}

std::string path_below(const std::string& model, std::string_view reference, const std::string& where) {
    namespace fs = std::filesystem;
    const bool plain = !reference.empty() && std::all_of(reference.begin(), reference.end(), [](char c) {
        return static_cast<unsigned char>(c) >= ' ' && c != '\x7f';
    });
    const fs::path relative(reference);
    if (!plain || relative.is_absolute()) {
        throw Error(where + ": " + in_quotes(reference) + " is no relative path of a file");
    }
    std::error_code error;
    const fs::path folder = fs::canonical(fs::absolute(model).parent_path(), error);
    const fs::path target = error ? fs::path() : fs::weakly_canonical(folder / relative, error);
    if (error) {
        throw Error(where + ": " + in_quotes(reference) + " cannot be found: " + error.message());
    }
    const auto [in_folder, in_target] = std::mismatch(folder.begin(), folder.end(), target.begin(), target.end());
    if (in_folder != folder.end() || in_target == target.end()) {
        throw Error(where + ": " + in_quotes(reference) + " lies outside the folder of the mesh file; move it below");
    }
    return target.string();
}

}  // namespace sheen
