// SPDX-License-Identifier: MIT
/// \file
/// edge_walker against the host's plain walk (for_each_row), for triangles and for any fields.
#include "sheen/hls/edge_walker.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <string>
#include <vector>

#include "support/kernel_records.hpp"

namespace sheen::test {
namespace {

using hls::bit_t;
using hls::edge_walker;

constexpr unsigned seed = 20251;

struct Span {
    int x, y, length, step;
    bool single, first;
    friend bool operator==(const Span& a, const Span& b) {
        return a.x == b.x && a.y == b.y && a.length == b.length && a.step == b.step && a.single == b.single &&
               a.first == b.first;
    }
    friend std::ostream& operator<<(std::ostream& out, const Span& s) {
        return out << "{x " << s.x << ", y " << s.y << ", length " << s.length << ", step " << s.step
                   << (s.single ? ", single" : "") << (s.first ? ", first" : "") << '}';
    }
};

std::vector<Span> expected_spans(const TriangleWalk& walk) {
    std::vector<Span> spans;
    for_each_span(walk, [&](int x, int y, int length, int step) {
        spans.push_back({x, y, length, step, length == 1, spans.empty()});
    });
    return spans;
}

/// What one clock does besides the walker's own work.
struct Surroundings {
    unsigned no_room_percent = 0;
    unsigned first_waits_percent = 0;
};

/// The walker, clock by clock, with a legal span walker behind it.
class Bench {
 public:
    Bench(Rng& rng, Surroundings around) : rng_(rng), around_(around) {}

    /// One clock with this job offered; true when it is taken. The geometry of the job before stands in the clock after
    /// it was taken, as the decoder sees to.
    bool clock(const hls::job_t& job, const hls::geometry_t& offered) {
        const hls::geometry_t geometry = just_taken_ ? geometry_ : offered;
        const bit_t room = rng_() % 100 >= around_.no_room_percent;
        const bit_t first_taken = first_waits_ && rng_() % 100 >= around_.first_waits_percent;
        const bool taken = edge_walker::taken(state_, job, room) != 0;
        state_ = edge_walker::step(state_, job, geometry, room, first_taken);
        first_waits_ = (first_waits_ && !first_taken) || (state_.push & state_.span.first);
        just_taken_ = taken;
        geometry_ = geometry;
        if (state_.push) {
            const hls::span_t& s = state_.span;
            if (!s.message) {
                spans_.push_back(
                    {s.x.to_int(), s.y.to_int(), s.length.to_int(), s.leftward ? -1 : 1, s.single != 0, s.first != 0});
            }
            order_ += s.message ? 'm' : s.first ? 'T' : 's';
        }
        return taken;
    }

    /// Offers the job until it is taken. As the decoder does, it has geometry and direction ready a clock before.
    void take(const hls::job_t& job, const hls::geometry_t& geometry) {
        if (just_taken_) clock({}, geometry);
        hls::job_t ready = job;
        ready.valid = 0;
        clock(ready, geometry);
        while (!clock(job, geometry)) {
        }
    }

    /// Clocks until the walker is idle and its last span pushed.
    int finish() {
        int clocks = 0;
        for (; state_.walk != edge_walker::idle; ++clocks) clock({}, {});
        clock({}, {});
        return clocks;
    }

    [[nodiscard]] const std::vector<Span>& spans() const { return spans_; }
    [[nodiscard]] const edge_walker::state_t& state() const { return state_; }
    [[nodiscard]] const std::string& order() const { return order_; }

 private:
    Rng& rng_;
    Surroundings around_;
    edge_walker::state_t state_;
    bool first_waits_ = false;
    bool just_taken_ = false;
    hls::geometry_t geometry_;
    std::vector<Span> spans_;
    std::string order_;
};

hls::job_t triangle_job(const TriangleWalk& walk) {
    hls::job_t job;
    job.valid = 1;
    job.leftward = walk.leftward;
    return job;
}

hls::job_t message_job(std::uint32_t header, int code) {
    hls::job_t job;
    job.valid = 1;
    job.message = 1;
    job.header = header;
    job.code = code;
    return job;
}

std::vector<Span> walked_spans(Rng& rng, const TriangleWalk& walk, Surroundings around) {
    Bench bench(rng, around);
    bench.take(triangle_job(walk), geometry_of(walk));
    bench.finish();
    return bench.spans();
}

/// Triangles of many shapes, and any fields, parts without rows among them.
TriangleWalk any_walk(Rng& rng) { return rng() % 2 == 0 ? covering_walk(rng, 200) : random_walk(rng, 12); }

class EdgeWalker : public testing::Test {
 protected:
    void SetUp() override { std::cout << "seed " << seed << '\n'; }
    Rng rng_{seed};
};

TEST_F(EdgeWalker, PushesTheSpansOfEveryTriangleInOrder) {
    for (int i = 0; i < 3000; ++i) {
        const TriangleWalk walk = covering_walk(rng_, i % 10 == 0 ? 4095 : 200);
        ASSERT_EQ(walked_spans(rng_, walk, {}), expected_spans(walk)) << "triangle " << i;
    }
}

TEST_F(EdgeWalker, PushesTheSpansOfAnyFieldsModulo4096) {
    for (int i = 0; i < 20000; ++i) {
        const TriangleWalk walk = random_walk(rng_, i % 100 == 0 ? 4095 : 12);
        ASSERT_EQ(walked_spans(rng_, walk, {}), expected_spans(walk)) << "walk " << i;
    }
}

TEST_F(EdgeWalker, PushesTheSameSpansWheneverThereIsRoom) {
    for (int i = 0; i < 5000; ++i) {
        const TriangleWalk walk = any_walk(rng_);
        const auto percent = static_cast<unsigned>(uniform(rng_, 1, 95));
        ASSERT_EQ(walked_spans(rng_, walk, {percent, percent}), expected_spans(walk)) << "walk " << i;
    }
}

TEST_F(EdgeWalker, TakesOneClockARowOneACarryAndOneAPart) {
    for (int i = 0; i < 5000; ++i) {
        const TriangleWalk walk = any_walk(rng_);
        int carries = 0;  // those that lead to another row
        bool carry_at_middle = false;
        for_each_row(walk, [&](const WalkRow& row) {
            if (row.row == walk.rows_above && row.row > 0) carry_at_middle = row.carries > carries;
            carries = row.carries;
        });
        const bool has_rows = walk.rows_above + walk.rows_below > 0;
        const int skip = walk.rows_above == 0 && has_rows ? 1 : 0;
        const int middle = walk.rows_below > 0 && !carry_at_middle ? 1 : 0;
        const int rows = walk.rows_above + walk.rows_below;
        Bench bench(rng_, {});
        bench.take(triangle_job(walk), geometry_of(walk));
        ASSERT_EQ(bench.finish(), (has_rows ? 1 : 0) + rows + carries + middle + skip) << "walk " << i;
    }
}

TEST_F(EdgeWalker, KeepsTrianglesAndMessagesInOrderUnderAnyStalls) {
    for (int i = 0; i < 300; ++i) {
        const auto percent = static_cast<unsigned>(uniform(rng_, 0, 80));
        Bench bench(rng_, {percent, percent});
        std::vector<Span> expected;
        std::string order;
        for (int job = 0; job < 20; ++job) {
            if (rng_() % 3 == 0) {
                bench.take(message_job(0x05000000U, 0), geometry_of(any_walk(rng_)));
                order += 'm';
                continue;
            }
            const TriangleWalk walk = any_walk(rng_);
            for (const Span& span : expected_spans(walk)) {
                expected.push_back(span);
                order += span.first ? 'T' : 's';
            }
            bench.take(triangle_job(walk), geometry_of(walk));
        }
        bench.finish();
        ASSERT_EQ(bench.spans(), expected) << "sequence " << i;
        ASSERT_EQ(bench.order(), order) << "sequence " << i;
    }
}

TEST_F(EdgeWalker, TakesNoTriangleWhileTheFirstSpanOfTheOneBeforeWaits) {
    for (int i = 0; i < 1000; ++i) {
        const TriangleWalk walk = covering_walk(rng_, 30);
        Bench bench(rng_, {0, 100});
        bench.take(triangle_job(walk), geometry_of(walk));
        for (int clock = 0; clock < 200; ++clock) {
            ASSERT_FALSE(bench.clock(triangle_job(walk), geometry_of(walk))) << "triangle " << i << ", clock " << clock;
        }
        ASSERT_EQ(bench.spans(), expected_spans(walk));
    }
}

TEST_F(EdgeWalker, SendsOneCommandARowAndOneACarryBetweenRows) {
    for (int i = 0; i < 2000; ++i) {
        const TriangleWalk walk = any_walk(rng_);
        Bench bench(rng_, {30, 30});
        bench.take(triangle_job(walk), geometry_of(walk));
        int rows = 0;
        int carries = 0;
        int carries_at_last_row = 0;
        for (int last = 0; last < 2; last += bench.state().walk == edge_walker::idle ? 1 : 0) {
            bench.clock({}, {});
            rows += (bench.state().command.step & ~bench.state().command.carry).to_int();
            carries += bench.state().command.carry.to_int();
        }
        for_each_row(walk, [&](const WalkRow& row) { carries_at_last_row = row.carries; });
        ASSERT_EQ(rows, walk.rows_above + walk.rows_below) << "walk " << i;
        ASSERT_EQ(carries, carries_at_last_row) << "walk " << i;
    }
}

TEST_F(EdgeWalker, CarriesAMessageInTheFieldsOfASpan) {
    for (int i = 0; i < 1000; ++i) {
        const auto header = static_cast<std::uint32_t>(rng_() & 0xffffffU) | static_cast<std::uint32_t>(i % 7) << 24;
        const int code = static_cast<int>(uniform(rng_, 0, 3));
        edge_walker::state_t state;
        state = edge_walker::step(state, message_job(header, code), {}, 1, 0);
        ASSERT_EQ(state.push, 1);
        ASSERT_EQ(state.span.message, 1);
        ASSERT_EQ(state.span.first, 0);
        ASSERT_EQ(state.span.x.to_uint() | state.span.y.to_uint() << 12, header & 0xffffffU);
        const bool query = code == 0 && header >> 24 == 0;
        ASSERT_EQ(state.span.length.to_uint(), query ? 4U : header >> 24 << 4 | static_cast<std::uint32_t>(code));
        ASSERT_EQ(state.span.single != 0, !query);
    }
}

}  // namespace
}  // namespace sheen::test
