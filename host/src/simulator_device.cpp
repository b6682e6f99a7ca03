// SPDX-License-Identifier: MIT
#include "sheen/simulator_device.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "child_process.hpp"
#include "sheen/error.hpp"
#include "sheen/framing.hpp"
#include "sheen/packet.hpp"

namespace sheen {
namespace {

namespace fs = std::filesystem;

/// Simulators stand beside the command in a build, and in ../libexec/sheen in an installation.
std::string find_program(const std::string& device) {
    const std::string file = "sheen-device-" + device;
    std::error_code failure;
    const fs::path own = fs::read_symlink("/proc/self/exe", failure).parent_path();
    for (const fs::path& folder : {own, own / ".." / "libexec" / "sheen"}) {
        if (fs::exists(folder / file, failure)) return (folder / file).string();
    }
    throw Error(fmt::format("device '{}' is not built: '{}' is missing from '{}'; run `make build`", device, file,
                            own.string()));
}

/// One line a beat: last, words present, and the words of the whole beat, the highest first, in hexadecimal.
void write_beats(const std::string& path, const std::vector<Beat>& beats, int words_per_beat) {
    fmt::memory_buffer text;
    for (const Beat& beat : beats) {
        fmt::format_to(std::back_inserter(text), "{} {} ", beat.last ? 1 : 0, beat.count);
        for (int k = words_per_beat - 1; k >= 0; --k) {
            fmt::format_to(std::back_inserter(text), "{:08x}", beat.words[static_cast<std::size_t>(k)]);
        }
        text.push_back('\n');
    }
    std::ofstream out(path, std::ios::binary);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.flush();
    if (!out) throw Error(fmt::format("can't write '{}': {}", path, std::strerror(errno)));
}

/// First line: the clock cycles; then one line a word, in hexadecimal.
RunResult read_words(const std::string& path, const std::string& program) {
    std::ifstream in(path);
    RunResult result;
    std::uint64_t cycles = 0;
    if (!(in >> std::dec >> cycles)) throw Error(fmt::format("'{}' wrote no result", program));
    result.cycles = cycles;
    in >> std::hex;
    for (std::uint64_t word = 0; in >> word;) result.words.push_back(word);
    if (!in.eof()) throw Error(fmt::format("'{}' wrote a word that is not hexadecimal", program));
    return result;
}

}  // namespace

SimulatorDevice::SimulatorDevice(std::string name, int words_per_beat, Stalls stalls)
    : name_(std::move(name)), program_(find_program(name_)), words_per_beat_(words_per_beat), stalls_(stalls) {}

RunResult SimulatorDevice::run(const std::vector<std::uint32_t>& packets) {
    // A fence of our own marks the end: when its echo is out, so is everything before it.
    std::vector<Beat> beats = frame_packets(packets, words_per_beat_);
    std::vector<std::uint32_t> end;
    append_fence(end);
    const std::vector<Beat> end_beats = frame_packets(end, words_per_beat_);
    beats.insert(beats.end(), end_beats.begin(), end_beats.end());

    const ScratchFolder scratch;
    const std::string beat_file = scratch.file("beats");
    const std::string word_file = scratch.file("words");
    write_beats(beat_file, beats, words_per_beat_);
    std::string first_line;
    const ProgramEnd program_end = run_program(
        program_,
        {"-gbeat_file=" + beat_file, "-gword_file=" + word_file, fmt::format("-gfences={}", count_fences(packets) + 1),
         fmt::format("-gsource_percent={}", stalls_.source_percent),
         fmt::format("-gsink_percent={}", stalls_.sink_percent), fmt::format("-gseed={}", stalls_.seed)},
        [&first_line](const std::string& line) { first_line += first_line.empty() ? line : std::string(); });
    if (program_end.start_error != 0)
        throw Error(fmt::format("can't start '{}': {}", program_, std::strerror(program_end.start_error)));
    if (!program_end.success()) {
        throw Error(fmt::format("'{}' failed: {}", program_, first_line.empty() ? program_end.error : first_line));
    }
    RunResult result = read_words(word_file, program_);
    if (result.words.empty() || result.words.back() != (std::uint64_t{end.front()} << 32 | 0xfff)) {
        throw Error(fmt::format("'{}' lost the end of the stream", program_));
    }
    result.words.pop_back();
    return result;
}

}  // namespace sheen
