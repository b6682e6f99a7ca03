// SPDX-License-Identifier: MIT
/// \file
/// Vector files: what a make_vectors_* program writes and a testbench reads.
///
/// Name: unit.generics.txt, the generics being `name=value` with commas between. First line: unit, `count=`, `seed=`,
/// the generics, one blank between. The testbench builds the line it expects from its own generics and refuses any
/// other, so a file of another unit, count, seed or width does not pass. Then exactly `count` lines of blank-separated
/// hexadecimal words, each as wide as its port.
#pragma once

#include <cstdint>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace sheen::test {

/// The command line of a vector program: OUTDIR [seed] [count].
struct VectorOptions {
    std::string folder;
    unsigned seed = 1;
    int count = 10000;
};

/// \throws std::invalid_argument naming the word that is wrong
inline VectorOptions parse_vector_options(int argc, char** argv) {
    if (argc < 2 || argc > 4) {
        throw std::invalid_argument("usage: " + std::string(argv[0]) + " OUTDIR [seed] [count]");
    }
    const auto number = [](const std::string& word, const char* name) {
        std::size_t used = 0;
        long value = -1;
        try {
            value = std::stol(word, &used);
        } catch (const std::logic_error&) {
            used = 0;
        }
        if (used != word.size() || value < 1 || value > 100000000) {
            throw std::invalid_argument(std::string(name) + " '" + word + "' must be a number from 1 to 100000000");
        }
        return static_cast<int>(value);
    };
    VectorOptions options{argv[1]};
    options.seed = argc > 2 ? static_cast<unsigned>(number(argv[2], "seed")) : options.seed;
    options.count = argc > 3 ? number(argv[3], "count") : options.count;
    return options;
}

/// One vector file being written; close() tells whether it is whole.
class VectorFile {
 public:
    /// \param generics the configuration, `name=value` with commas between; also names the file
    VectorFile(const VectorOptions& options, const std::string& unit, const std::string& generics)
        : path_(options.folder + "/" + unit + "." + generics + ".txt"), out_(path_) {
        out_ << unit << " count=" << options.count << " seed=" << options.seed << ' ' << generics << '\n';
    }

    /// Appends a word of the given width, as many hex digits as it needs, followed by a blank.
    VectorFile& word(std::int64_t value, int bits) {
        static constexpr char digit[] = "0123456789abcdef";
        for (int lsb = (bits - 1) / 4 * 4; lsb >= 0; lsb -= 4) {
            const int kept = bits - lsb < 4 ? (1 << (bits - lsb)) - 1 : 15;
            out_ << digit[(value >> lsb) & kept];
        }
        out_ << ' ';
        return *this;
    }

    void end_vector() { out_ << '\n'; }

    /// \throws std::runtime_error if anything could not be written
    void close() {
        out_.close();
        if (!out_) {
            throw std::runtime_error("cannot write " + path_ + "; OUTDIR must be a writable folder");
        }
    }

 private:
    std::string path_;
    std::ofstream out_;
};

/// main() of a vector program: runs it, and turns an error into one line and an exit status.
template <typename Write>
int write_vectors(int argc, char** argv, Write write) {
    try {
        write(parse_vector_options(argc, argv));
        return 0;
    } catch (const std::invalid_argument& error) {
        std::cerr << error.what() << '\n';
        return 2;
    } catch (const std::runtime_error& error) {
        std::cerr << argv[0] << ": " << error.what() << '\n';
        return 1;
    }
}

}  // namespace sheen::test
