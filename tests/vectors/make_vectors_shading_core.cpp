// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_shading_core OUTDIR [seed] [count]: vectors of tb_shading_core, from the kernel.
///
/// Vector k holds beat k of the setup stream and word k of the kernel's answer, each with a bit that says whether there
/// is one. The kernel answers each packet in a core of its own: whatever stands before must not show. Packets are
/// triangles of many shapes with arbitrary words, fences, queries and malformed packets of every kind; fences fill up
/// what remains, so that the longer of the two streams has exactly `count` entries.
#include <algorithm>

#include "../support/core_run.hpp"
#include "vector_file.hpp"

namespace {

using sheen::test::CoreShape;
using sheen::test::Rng;
using sheen::test::StreamBeat;
using sheen::test::StreamPacket;
using sheen::test::VectorFile;
using sheen::test::VectorOptions;

template <int words_per_beat, bool has_depth, bool has_quadratic, int log_channels = 0, bool has_power = false>
class CoreVectors {
 public:
    explicit CoreVectors(const VectorOptions& options) : options_(options), rng_(options.seed) {}

    void write() {
        fill();
        const auto word = [](bool value) { return value ? "true" : "false"; };
        VectorFile file(options_, "shading_core",
                        "words_per_beat=" + std::to_string(words_per_beat) + ",has_depth=" + word(has_depth) +
                            ",has_quadratic=" + word(has_quadratic) + ",log_channels=" + std::to_string(log_channels) +
                            ",has_power=" + word(has_power));
        for (std::size_t k = 0; k < count(); ++k) {
            write_beat(file, k < beats_.size() ? beats_[k] : StreamBeat{}, k < beats_.size());
            file.word(k < words_.size(), 1);
            file.word(k < words_.size() ? static_cast<std::int64_t>(words_[k]) : 0, 64).end_vector();
        }
        file.close();
    }

 private:
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(options_.count); }
    [[nodiscard]] std::size_t size() const { return std::max(beats_.size(), words_.size()); }

    /// Appends the packet and its answer if that leaves room for a fence. Materials and tables answer nothing; they
    /// stand before every packet that the kernel is asked for.
    bool append(const StreamPacket& packet) {
        using config =
            sheen::hls::core_config<words_per_beat, has_depth, has_quadratic, 32, 32, log_channels, has_power>;
        std::vector<StreamPacket> packets = lighting_;
        packets.push_back(packet);
        const std::vector<std::uint64_t> answer = sheen::test::run_core<config>(packets, rng_, 0, 1000000);
        if (std::max(beats_.size() + packet.size(), words_.size() + answer.size()) >= count()) return false;
        if (answer.empty() && !sheen::test::is_triangle(packet)) keep(packet);
        beats_.insert(beats_.end(), packet.begin(), packet.end());
        words_.insert(words_.end(), answer.begin(), answer.end());
        return true;
    }

    /// A material or a table takes the place of the one before.
    void keep(const StreamPacket& packet) {
        const auto opcode = [](const StreamPacket& p) { return sheen::decode_header(p[0].words[0]).opcode; };
        for (StreamPacket& kept : lighting_) {
            if (opcode(kept) == opcode(packet)) {
                kept = packet;
                return;
            }
        }
        lighting_.push_back(packet);
    }

    /// A triangle's walk, or two rows of arbitrary fields, which may wrap round the image.
    sheen::TriangleWalk random_walk() {
        if (rng_() % 20 != 0) return sheen::test::covering_walk(rng_, 24);
        sheen::TriangleWalk walk = sheen::test::random_walk(rng_, 1);
        walk.length &= 63;
        walk.length_reload &= 63;
        return walk;
    }

    void fill() {
        const CoreShape shape{words_per_beat, has_depth, has_quadratic, log_channels, has_power};
        for (bool fits = true; fits;) fits = append(sheen::test::random_packet(rng_, random_walk(), shape));
        const std::uint32_t fence = sheen::hls::opcode_fence << sheen::hls::header_opcode_lsb;
        while (size() < count()) {
            beats_.push_back(sheen::test::framed({fence}, words_per_beat)[0]);
            words_.push_back(static_cast<std::uint64_t>(fence) << 32 | sheen::hls::message_x);
        }
    }

    static void write_beat(VectorFile& file, const StreamBeat& beat, bool present) {
        file.word(present, 1).word(beat.last, 1).word(beat.keep, words_per_beat);
        for (std::size_t k = 0; k < words_per_beat; ++k) file.word(beat.words[k], 32);
    }

    VectorOptions options_;
    Rng rng_;
    std::vector<StreamPacket> lighting_;  ///< the last material and the last table
    std::vector<StreamBeat> beats_;
    std::vector<std::uint64_t> words_;
};

template <int words_per_beat>
void write(const VectorOptions& options) {
    CoreVectors<words_per_beat, false, false>(options).write();
    CoreVectors<words_per_beat, false, true>(options).write();
    CoreVectors<words_per_beat, true, false>(options).write();
    CoreVectors<words_per_beat, true, true>(options).write();
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        write<1>(options);
        write<2>(options);
        write<4>(options);
        CoreVectors<1, true, true, 1, true>(options).write();
        CoreVectors<2, false, true, 1, false>(options).write();
        CoreVectors<2, true, true, 3, true>(options).write();
        CoreVectors<4, true, true, 2, true>(options).write();
    });
}
