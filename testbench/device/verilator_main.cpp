// SPDX-License-Identifier: MIT
/// \file
/// The core as a device of the host library, on Verilator: the twin of device_bench.vhd, with the same generics as
/// arguments (-gname=value), the same files and the same meaning of a cycle.
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "Vshading_core.h"
#include "verilated.h"

namespace {

constexpr std::uint64_t idle_limit = 1'000'000;  // clocks without a beat or a word
constexpr int words_per_beat = SHEEN_WORDS_PER_BEAT;

struct Beat {
    bool last = false;
    int count = 0;
    std::uint32_t words[words_per_beat] = {};
};

std::vector<Beat> read_beats(const std::string& path) {
    std::ifstream in(path);
    if (!in) throw std::runtime_error("can't read the beats in '" + path + "'");
    std::vector<Beat> beats;
    int last = 0;
    int count = 0;
    std::string data;
    while (in >> last >> count >> data) {
        if (data.size() != 8U * words_per_beat) throw std::runtime_error("'" + path + "': a beat of the wrong width");
        Beat beat;
        beat.last = last != 0;
        beat.count = count;
        for (int k = 0; k < words_per_beat; ++k) {
            const std::string digits = data.substr(8U * static_cast<unsigned>(words_per_beat - 1 - k), 8);
            beat.words[k] = static_cast<std::uint32_t>(std::stoul(digits, nullptr, 16));
        }
        beats.push_back(beat);
    }
    return beats;
}

/// The wide port's bits, whatever type Verilator gives a port of that width.
template <typename port_t>
void set_data(port_t& port, const Beat& beat) {
    if constexpr (words_per_beat == 1) {
        port = beat.words[0];
    } else if constexpr (words_per_beat == 2) {
        port = static_cast<std::uint64_t>(beat.words[1]) << 32 | beat.words[0];
    } else {
        for (int k = 0; k < words_per_beat; ++k) port[k] = beat.words[k];
    }
}

class Bench {
 public:
    explicit Bench(std::map<std::string, std::string> options) : options_(std::move(options)) {}

    void run() {
        const std::vector<Beat> beats = read_beats(option("beat_file"));
        const auto fences = static_cast<std::size_t>(std::stoull(option("fences")));
        const int source_percent = std::stoi(option("source_percent"));
        const int sink_percent = std::stoi(option("sink_percent"));
        std::mt19937 random(static_cast<std::mt19937::result_type>(std::stoul(option("seed"))));
        std::uniform_int_distribution<int> percent(0, 99);

        core_.rst = 1;
        for (int i = 0; i < 4; ++i) tick();
        core_.rst = 0;
        std::size_t next = 0;
        std::size_t echoes = 0;
        std::uint64_t busy_cycle = cycle_;
        std::uint64_t last_cycle = 0;
        std::uint64_t before_last = 0;
        std::uint64_t first_cycle = 0;
        while (echoes < fences) {
            // A word once offered stays until it is taken.
            if (!core_.s_axis_tvalid && next < beats.size() && percent(random) >= source_percent) offer(beats[next]);
            if (core_.s_axis_tvalid && first_cycle == 0) first_cycle = cycle_;
            core_.m_axis_tready = percent(random) >= sink_percent;
            core_.eval();
            const bool beat_taken = core_.s_axis_tvalid && core_.s_axis_tready;
            const bool word_taken = core_.m_axis_tvalid && core_.m_axis_tready;
            if (word_taken) {
                words_.push_back(core_.m_axis_tdata);
                if (core_.m_axis_tlast) ++echoes;
                before_last = last_cycle;
                last_cycle = cycle_;
            }
            if (beat_taken || word_taken) busy_cycle = cycle_;
            if (cycle_ - busy_cycle >= idle_limit) {
                throw std::runtime_error("no beat was taken and no word came for " + std::to_string(idle_limit) +
                                         " clocks");
            }
            tick();
            if (beat_taken) {
                core_.s_axis_tvalid = 0;
                ++next;
            }
        }
        write(before_last > first_cycle ? before_last - first_cycle + 1 : 0);
    }

 private:
    const std::string& option(const std::string& name) const {
        const auto found = options_.find(name);
        if (found == options_.end()) throw std::runtime_error("missing -g" + name + "=…");
        return found->second;
    }

    void offer(const Beat& beat) {
        set_data(core_.s_axis_tdata, beat);
        core_.s_axis_tkeep = static_cast<std::remove_reference_t<decltype(core_.s_axis_tkeep)>>(
            (std::uint32_t{1} << 4 * beat.count) - 1);
        core_.s_axis_tlast = beat.last;
        core_.s_axis_tvalid = 1;
    }

    void tick() {
        core_.clk = 1;
        core_.eval();
        core_.clk = 0;
        core_.eval();
        ++cycle_;
    }

    void write(std::uint64_t cycles) const {
        const std::string& path = option("word_file");
        std::FILE* out = std::fopen(path.c_str(), "w");
        if (out == nullptr) throw std::runtime_error("can't write the words to '" + path + "'");
        std::fprintf(out, "%llu\n", static_cast<unsigned long long>(cycles));
        for (const std::uint64_t word : words_) std::fprintf(out, "%016llx\n", static_cast<unsigned long long>(word));
        if (std::fclose(out) != 0) throw std::runtime_error("can't write the words to '" + path + "'");
    }

    std::map<std::string, std::string> options_;
    VerilatedContext context_;
    Vshading_core core_{&context_};
    std::vector<std::uint64_t> words_;
    std::uint64_t cycle_ = 1;
};

}  // namespace

int main(int argc, char** argv) {
    try {
        std::map<std::string, std::string> options;
        for (int i = 1; i < argc; ++i) {
            const std::string argument = argv[i];
            const std::size_t equals = argument.find('=');
            if (argument.compare(0, 2, "-g") != 0 || equals == std::string::npos) {
                throw std::runtime_error("'" + argument + "' is no -gname=value");
            }
            options[argument.substr(2, equals - 2)] = argument.substr(equals + 1);
        }
        Bench(std::move(options)).run();
        return 0;
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << '\n';
        return 1;
    }
}
