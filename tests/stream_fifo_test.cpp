// SPDX-License-Identifier: MIT
/// \file
/// stream_fifo: order, no overflow or underflow, the reserve, full throughput and the latency, under random traffic.
#include "sheen/hls/stream_fifo.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <deque>
#include <vector>

namespace {

/// A queue with its memory, driven clock by clock, beside the entries that it must hold.
template <int depth_log2, int reserve>
class Queue {
 public:
    using unit = sheen::hls::stream_fifo<depth_log2, reserve>;
    static constexpr std::size_t depth = std::size_t{1} << depth_log2;

    [[nodiscard]] bool ready() const { return unit::ready(state_) != 0; }
    [[nodiscard]] bool valid() const { return state_.valid != 0; }
    [[nodiscard]] int output() const { return output_; }
    [[nodiscard]] std::size_t in_memory() const { return in_memory_; }
    [[nodiscard]] const std::deque<int>& expected() const { return expected_; }

    void clock(bool write, int data, bool taken) {
        if (taken) expected_.pop_front();
        if (unit::fetches(state_, taken) != 0) {
            ASSERT_GT(in_memory_, 0U) << "an entry is fetched that was never written";
            output_ = memory_[state_.read_address.to_uint()];
            --in_memory_;
        }
        if (write) {
            memory_[state_.write_address.to_uint()] = data;
            expected_.push_back(data);
            ASSERT_LE(++in_memory_, depth) << "an entry is overwritten";
        }
        state_ = unit::step(state_, write, taken);
    }

 private:
    typename unit::state_t state_;
    std::array<int, depth> memory_{};
    int output_ = 0;
    std::size_t in_memory_ = 0;
    std::deque<int> expected_;
};

/// One clock's wishes: each side wants to act, the writer even after ready has fallen.
struct Wish {
    bool write;
    bool into_reserve;
    bool take;
};

rc::Gen<std::vector<Wish>> wishes() {
    // Stretches in which a side is busy or idle, so that the queue runs full and empty.
    const auto stretch =
        rc::gen::map(rc::gen::tuple(rc::gen::inRange(0, 5), rc::gen::inRange(0, 5),
                                    rc::gen::container<std::vector<unsigned>>(40, rc::gen::inRange(0U, 1U << 12))),
                     [](const std::tuple<int, int, std::vector<unsigned>>& drawn) {
                         const auto& [writer, reader, noise] = drawn;
                         std::vector<Wish> clocks;
                         for (const unsigned bits : noise) {
                             clocks.push_back({static_cast<int>(bits % 4) < writer, (bits >> 4) % 2 == 0,
                                               static_cast<int>((bits >> 8) % 4) < reader});
                         }
                         return clocks;
                     });
    return rc::gen::map(rc::gen::container<std::vector<std::vector<Wish>>>(8, stretch), [](const auto& stretches) {
        std::vector<Wish> all;
        for (const auto& clocks : stretches) all.insert(all.end(), clocks.begin(), clocks.end());
        return all;
    });
}

template <int depth_log2, int reserve>
void expect_every_entry_once_and_in_order() {
    Queue<depth_log2, reserve> queue;
    int next = 0;
    for (const Wish& wish : *wishes()) {
        const bool room = queue.ready() || (wish.into_reserve && queue.in_memory() < queue.depth);
        RC_ASSERT(queue.ready() == (queue.in_memory() + reserve < queue.depth));
        if (queue.valid()) {
            RC_ASSERT(!queue.expected().empty());
            RC_ASSERT(queue.output() == queue.expected().front());
        }
        queue.clock(wish.write && room, next, wish.take && queue.valid());
        next += static_cast<int>(wish.write && room);
        RC_ASSERT(!testing::Test::HasFatalFailure());
    }
    for (std::size_t clock = 0; !queue.expected().empty(); ++clock) {
        RC_ASSERT(clock < queue.depth + 3);  // all that was written comes out
        if (queue.valid()) RC_ASSERT(queue.output() == queue.expected().front());
        queue.clock(false, 0, queue.valid());
    }
    RC_ASSERT(!queue.valid());
}

RC_GTEST_PROP(stream_fifo, every_entry_comes_out_once_and_in_order, ()) {
    expect_every_entry_once_and_in_order<1, 0>();
    expect_every_entry_once_and_in_order<2, 0>();
    expect_every_entry_once_and_in_order<2, 2>();
    expect_every_entry_once_and_in_order<4, 2>();
    expect_every_entry_once_and_in_order<5, 10>();
}

/// Writes while ready; \returns how many entries went in before it fell, the output register's included.
template <int depth_log2, int reserve>
int entries_until_not_ready() {
    Queue<depth_log2, reserve> queue;
    int entries = 0;
    for (; queue.ready() && entries < 1000; ++entries) queue.clock(true, entries, false);
    return entries;
}

TEST(stream_fifo, ready_falls_when_exactly_the_reserve_is_left) {
    EXPECT_EQ((entries_until_not_ready<2, 0>()), 4 + 1);
    EXPECT_EQ((entries_until_not_ready<2, 2>()), 4 - 2 + 1);
    EXPECT_EQ((entries_until_not_ready<4, 2>()), 16 - 2 + 1);
    EXPECT_EQ((entries_until_not_ready<5, 0>()), 32 + 1);
    EXPECT_EQ((entries_until_not_ready<5, 10>()), 32 - 10 + 1);
}

template <int depth_log2, int reserve>
void expect_an_entry_every_clock() {
    Queue<depth_log2, reserve> queue;
    constexpr int latency = 2;
    for (int clock = 0; clock < 200; ++clock) {
        ASSERT_TRUE(queue.ready()) << "clock " << clock;
        ASSERT_EQ(queue.valid(), clock >= latency) << "clock " << clock;
        if (queue.valid()) {
            ASSERT_EQ(queue.output(), clock - latency);
        }
        queue.clock(true, clock, queue.valid());
    }
}

TEST(stream_fifo, a_reader_that_keeps_up_gets_an_entry_every_clock_two_clocks_late) {
    expect_an_entry_every_clock<2, 0>();
    expect_an_entry_every_clock<2, 2>();
    expect_an_entry_every_clock<4, 10>();
    expect_an_entry_every_clock<5, 10>();
}

}  // namespace
