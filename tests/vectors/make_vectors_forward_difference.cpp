// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_forward_difference OUTDIR [seed] [count]: vectors of tb_forward_difference, from the unsliced kernel
/// and a model of the channel's share of the span queue.
///
/// A vector is one clock: commands, words, and the span part's I that they bring. Any order of legal commands occurs: a
/// fetch reads only what was pushed, not before the second clock after the push, a span starts only from a fetched
/// entry, the first step of the start edge comes not before the second clock after a load, and a carry in the clock
/// after another step. The words stay for `held`
/// clocks after a load, as long as the highest slice needs them; otherwise they are noise.
#include <array>
#include <random>
#include <type_traits>

#include "pauses.hpp"
#include "sheen/hls/forward_difference.hpp"
#include "vector_file.hpp"

namespace {

using namespace sheen::hls;
using sheen::test::Pauses;
using sheen::test::VectorFile;
using sheen::test::VectorOptions;

constexpr int held = 3;  ///< slices of the deepest configuration
constexpr int places = 1 << span_queue_log2;

/// What a channel is told in one clock.
struct command_t {
    edge_command_t edge;
    bit_t present = 0;
    span_command_t span;
    bit_t push = 0, fetch = 0;
    ac_int<span_queue_log2, false> push_address = 0, fetch_address = 0;
};

word_t random_word(std::mt19937_64& random) {
    const std::int64_t corners[] = {0, 1, -1, 1LL << 31, (1LL << 31) - 1, 0xFFFF, 0x10000};
    const auto pick = random() % 28;  // one in four a corner
    return pick < 7 ? word_t(corners[pick]) : word_t(random());
}

/// Commands that keep the contract; the first clocks load, push, fetch and start.
class Commands {
 public:
    Commands(unsigned seed, int stall_percent) : random_(seed), pauses_(stall_percent) {}

    command_t next() {
        command_t c = clock_ < 5 ? lead_in() : pauses_.pause(random_) ? command_t{} : any();
        if (c.push != 0) written_[c.push_address.to_uint()] = true;
        pushed_ = c.push != 0 ? c.push_address.to_int() : none;
        since_load_ = c.edge.load != 0 ? 1 : since_load_ + 1;
        stepped_ = c.edge.step != 0;
        ++clock_;
        return c;
    }
    std::mt19937_64& random() { return random_; }

 private:
    command_t lead_in() const {
        command_t c;
        c.edge.load = c.present = clock_ == 0;
        c.push = clock_ == 1;
        c.fetch = clock_ == 3;
        c.span.load = c.span.first = clock_ == 4;
        return c;
    }
    command_t any() {
        command_t c;
        c.edge.load = chance(24);
        c.edge.linear = chance(4);
        c.edge.step = c.edge.load == 0 && since_load_ >= 2 && !chance(3);
        c.edge.carry = c.edge.step != 0 && stepped_ && chance(2);
        c.present = !chance(8);
        c.push = chance(3);
        c.push_address = random_();
        c.fetch_address = random_();
        c.fetch = chance(3) && written_[c.fetch_address.to_uint()] && c.fetch_address.to_int() != pushed_;
        c.span.load = chance(10);
        c.span.first = chance(2);
        c.span.step = !chance(3);
        return c;
    }
    bool chance(unsigned one_in) { return random_() % one_in == 0; }

    static constexpr int none = -1;

    std::mt19937_64 random_;
    Pauses pauses_;
    int clock_ = 0;
    int since_load_ = 0;
    bool stepped_ = false;  ///< in the clock before
    std::array<bool, places> written_{};
    int pushed_ = none;  ///< place written in the clock before
};

template <int width, bool second_order>
void write(const VectorOptions& options, int stall_percent) {
    using value_t = std::conditional_t<second_order, ac_fixed<width, colour_integer_bits, true, AC_TRN, AC_WRAP>,
                                       ac_fixed<width, depth_integer_bits, false, AC_TRN, AC_WRAP>>;
    using unit = forward_difference<value_t, second_order>;
    constexpr int word_count = second_order ? quadratic_words : linear_words;
    VectorFile file(options, "forward_difference",
                    "width=" + std::to_string(width) + ",second_order=" + (second_order ? "true" : "false") +
                        ",stall_percent=" + std::to_string(stall_percent));
    Commands commands(options.seed, stall_percent);
    std::array<word_t, quadratic_words> words;
    std::array<typename unit::start_t, places> queue{};
    typename unit::start_t head;
    typename unit::edge_state_t edge;
    typename unit::span_state_t span;
    bool started = false;
    int loaded = held;  // clocks since the last load
    for (int i = 0; i < options.count; ++i) {
        const command_t c = commands.next();
        for (word_t& word : words) {
            if (loaded >= held) word = random_word(commands.random());
        }
        loaded = c.edge.load != 0 ? 0 : loaded + 1;
        file.word(c.edge.load.to_int(), 1).word(c.edge.linear.to_int(), 1).word(c.edge.step.to_int(), 1);
        file.word(c.edge.carry.to_int(), 1).word(c.present.to_int(), 1);
        file.word(c.span.load.to_int(), 1).word(c.span.first.to_int(), 1).word(c.span.step.to_int(), 1);
        file.word(c.push.to_int(), 1).word(c.push_address.to_int(), span_queue_log2);
        file.word(c.fetch.to_int(), 1).word(c.fetch_address.to_int(), span_queue_log2);
        for (int k = 0; k < word_count; ++k) file.word(words[static_cast<std::size_t>(k)].to_int64(), word_bits);

        span = unit::span_step(span, c.span, head, edge);
        if (c.fetch != 0) head = queue[c.fetch_address.to_uint()];
        if (c.push != 0) queue[c.push_address.to_uint()] = unit::start(edge);
        edge = unit::edge_step(edge, c.edge, c.present, {words[0], words[1], words[2], words[3], words[4], words[5]});
        started = started || c.span.load != 0;
        file.word(started, 1).word(span.i.template slc<width>(0).to_int64(), width).end_vector();
    }
    file.close();
}

template <int width>
void write_both_orders(const VectorOptions& options) {
    for (const int stall_percent : {0, 50}) {
        write<width, false>(options, stall_percent);
        write<width, true>(options, stall_percent);
    }
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        write_both_orders<32>(options);
        write_both_orders<24>(options);
        write_both_orders<18>(options);
    });
}
