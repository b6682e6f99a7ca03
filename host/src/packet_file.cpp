// SPDX-License-Identifier: MIT
// Packet and pixel files: streams of little-endian words (packet.hpp).
#include <cerrno>
#include <fstream>
#include <system_error>

#include "sheen/error.hpp"
#include "sheen/image.hpp"
#include "sheen/packet.hpp"

namespace sheen {
namespace {

std::vector<std::uint8_t> read_bytes(const std::string& path, const std::string& kind) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error("cannot open " + kind + " '" + path + "': " + std::generic_category().message(errno));
    std::vector<std::uint8_t> bytes;
    constexpr std::size_t chunk = 1 << 16;
    while (file) {
        const std::size_t old = bytes.size();
        bytes.resize(old + chunk);
        file.read(reinterpret_cast<char*>(bytes.data() + old), static_cast<std::streamsize>(chunk));
        bytes.resize(old + static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) throw Error("cannot read " + kind + " '" + path + "': " + std::generic_category().message(errno));
    return bytes;
}

template <typename Word>
std::vector<Word> read_words(const std::string& path, const std::string& kind) {
    const std::vector<std::uint8_t> bytes = read_bytes(path, kind);
    if (bytes.size() % sizeof(Word) != 0) {
        throw Error(kind + " '" + path + "' has " + std::to_string(bytes.size()) +
                    " bytes: its size must be a multiple of " + std::to_string(sizeof(Word)));
    }
    std::vector<Word> words(bytes.size() / sizeof(Word));
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        words[k / sizeof(Word)] |= static_cast<Word>(bytes[k]) << 8 * (k % sizeof(Word));
    }
    return words;
}

template <typename Word>
void write_words(const std::string& path, const std::vector<Word>& words) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(words.size() * sizeof(Word));
    for (const Word word : words) {
        for (std::size_t k = 0; k < sizeof(Word); ++k) bytes.push_back(static_cast<std::uint8_t>(word >> 8 * k));
    }
    write_file_atomically(path, bytes.data(), bytes.size());
}

}  // namespace

std::vector<std::uint32_t> read_packet_file(const std::string& path) {
    return read_words<std::uint32_t>(path, "packet file");
}

void write_packet_file(const std::string& path, const std::vector<std::uint32_t>& words) { write_words(path, words); }

std::vector<std::uint64_t> read_pixel_file(const std::string& path) {
    return read_words<std::uint64_t>(path, "pixel file");
}

void write_pixel_file(const std::string& path, const std::vector<std::uint64_t>& words) { write_words(path, words); }

}  // namespace sheen
