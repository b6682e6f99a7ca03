// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_uart_core OUTDIR [seed] [count]: vectors of tb_uart_core, from the kernel.
///
/// Vector k holds word k of a packet file, the number of answers that a patient host waits for before it sends that
/// word (all those of the packets before), and word k of the kernel's answer; a bit before each says whether there is
/// one. Packets are triangles, fences, queries and packets with wrong headers; fences fill up what remains, so that the
/// longer of the two files has exactly `count` words.
#include <algorithm>

#include "../support/core_run.hpp"
#include "vector_file.hpp"

namespace {

using sheen::test::CoreShape;
using sheen::test::Rng;
using sheen::test::VectorFile;
using sheen::test::VectorOptions;

template <int words_per_beat, bool has_depth, bool has_quadratic>
class SerialVectors {
 public:
    explicit SerialVectors(const VectorOptions& options) : options_(options), rng_(options.seed) {}

    void write() {
        const CoreShape shape{words_per_beat, has_depth, has_quadratic};
        for (bool fits = true; fits;) fits = append(random_words(shape));
        const std::uint32_t fence = sheen::hls::opcode_fence << sheen::hls::header_opcode_lsb;
        while (std::max(sent_.size(), answers_.size()) < count()) append_pair({fence}, answer({fence}));
        const auto word = [](bool value) { return value ? "true" : "false"; };
        VectorFile file(options_, "uart_core",
                        "words_per_beat=" + std::to_string(words_per_beat) + ",has_depth=" + word(has_depth) +
                            ",has_quadratic=" + word(has_quadratic));
        for (std::size_t k = 0; k < count(); ++k) {
            const bool sends = k < sent_.size();
            const bool answered = k < answers_.size();
            file.word(sends, 1).word(sends ? sent_[k] : 0, 32).word(sends ? due_[k] : 0, 32);
            file.word(answered, 1).word(answered ? static_cast<std::int64_t>(answers_[k]) : 0, 64).end_vector();
        }
        file.close();
    }

 private:
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(options_.count); }

    std::vector<std::uint32_t> random_words(const CoreShape& shape) {
        std::vector<std::uint32_t> triangle =
            sheen::test::triangle_words(rng_, sheen::test::covering_walk(rng_, 16), shape);
        std::vector<std::uint32_t> words;
        switch (sheen::test::uniform(rng_, 0, 5)) {
            case 0:
                sheen::append_fence(words, static_cast<int>(sheen::test::uniform(rng_, 0, 255)));
                return words;
            case 1:
                sheen::append_query(words);
                return words;
            case 2:
                return sheen::test::wrong_header(rng_, triangle);
            default:
                return triangle;
        }
    }

    std::vector<std::uint64_t> answer(const std::vector<std::uint32_t>& words) {
        using config = sheen::hls::core_config<words_per_beat, has_depth, has_quadratic>;
        return sheen::test::run_core<config>({sheen::test::framed(words, words_per_beat)}, rng_, 0, 1000000);
    }

    void append_pair(const std::vector<std::uint32_t>& words, const std::vector<std::uint64_t>& answer) {
        due_.insert(due_.end(), words.size(), static_cast<std::int64_t>(answers_.size()));
        sent_.insert(sent_.end(), words.begin(), words.end());
        answers_.insert(answers_.end(), answer.begin(), answer.end());
    }

    /// Appends the packet and its answer if that leaves room for a fence.
    bool append(const std::vector<std::uint32_t>& words) {
        const std::vector<std::uint64_t> reply = answer(words);
        if (std::max(sent_.size() + words.size(), answers_.size() + reply.size()) >= count()) return false;
        append_pair(words, reply);
        return true;
    }

    VectorOptions options_;
    Rng rng_;
    std::vector<std::uint32_t> sent_;
    std::vector<std::int64_t> due_;
    std::vector<std::uint64_t> answers_;
};

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        SerialVectors<2, true, true>(options).write();
        SerialVectors<1, true, true>(options).write();
        SerialVectors<1, true, false>(options).write();
    });
}
