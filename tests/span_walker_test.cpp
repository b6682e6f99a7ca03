// SPDX-License-Identifier: MIT
/// \file
/// span_walker: the pixels of a span, its commands, messages in their place, and no clock lost between spans.
#include "sheen/hls/span_walker.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace {

using namespace sheen::hls;
using unit = span_walker;

/// What the fragments of spans and messages must be, one an output word.
struct Expected {
    int x, y;
    bool message, query;
    int tail;  ///< of messages that are no query
};

struct Head {
    span_t span;
    std::vector<Expected> words;
};

rc::Gen<Head> pixels() {
    return rc::gen::map(rc::gen::tuple(rc::gen::inRange(0, 4096), rc::gen::inRange(0, 4096),
                                       rc::gen::oneOf(rc::gen::inRange(1, 4), rc::gen::inRange(1, 60)),
                                       rc::gen::arbitrary<bool>(), rc::gen::arbitrary<bool>()),
                        [](const std::tuple<int, int, int, bool, bool>& drawn) {
                            const auto& [x, y, length, leftward, first] = drawn;
                            Head head;
                            head.span = {x, y, length, length == 1, leftward, first, 0};
                            for (int k = 0; k < length; ++k) {
                                head.words.push_back({(x + (leftward ? -k : k)) & 4095, y, false, false, 0});
                            }
                            return head;
                        });
}

rc::Gen<Head> message() {
    return rc::gen::map(rc::gen::tuple(rc::gen::inRange(0, 4096), rc::gen::inRange(0, 4096), rc::gen::inRange(0, 4096)),
                        [](const std::tuple<int, int, int>& drawn) {
                            const auto& [x, y, tail] = drawn;
                            return Head{{x, y, tail, 1, 0, 0, 1}, {{x, y, true, false, tail}}};
                        });
}

rc::Gen<Head> query() {
    return rc::gen::map(rc::gen::inRange(0, 4096), [](int y) {
        Head head{{0, y, query_reply_words, 0, 0, 0, 1}, {}};
        for (int k = 0; k < query_reply_words; ++k) head.words.push_back({k, y, true, true, 0});
        return head;
    });
}

rc::Gen<std::vector<Head>> heads() {
    return rc::gen::container<std::vector<Head>>(
        rc::gen::weightedOneOf<Head>({{8, pixels()}, {2, message()}, {1, query()}}));
}

void expect_word(const fragment_t& fragment, const Expected& expected) {
    RC_ASSERT(fragment.x.to_int() == expected.x);
    RC_ASSERT(fragment.y.to_int() == expected.y);
    RC_ASSERT((fragment.message != 0) == expected.message);
    RC_ASSERT((fragment.query != 0) == expected.query);
    if (expected.message && !expected.query) RC_ASSERT(fragment.tail.to_int() == expected.tail);
}

/// Feeds the heads, `go` and the queue pausing by the bits of `pauses`. \returns the clocks that it took
std::size_t expect_all_words(const std::vector<Head>& spans, const std::vector<bool>& goes,
                             const std::vector<bool>& empties) {
    std::vector<Expected> words;
    for (const Head& head : spans) words.insert(words.end(), head.words.begin(), head.words.end());
    unit::state_t state;
    std::size_t next_span = 0;
    std::size_t next_word = 0;
    std::size_t clock = 0;
    bool offered = false;
    for (; next_word < words.size(); ++clock) {
        RC_ASSERT(clock < 4 * (words.size() + spans.size() + 8) + 4 * (goes.size() + empties.size()));
        offered = offered || clock >= empties.size() || !empties[clock];  // what is offered stays
        const bool head_valid = offered && next_span < spans.size();
        const span_t head = head_valid ? spans[next_span].span : span_t{};
        const bool go = clock >= goes.size() || goes[clock];
        const bool taken = unit::taken(state, head_valid, go) != 0;
        RC_ASSERT(!taken || (head_valid && go));
        const unit::state_t before = state;
        state = unit::step(state, head, head_valid, go);
        RC_ASSERT((state.command.load != 0) == taken);
        if (taken) {
            RC_ASSERT((state.command.first != 0) == (head.first != 0));
            ++next_span;
            offered = false;
        }
        // A pixel and the step to the next one leave in a clock of `go`, and in no other.
        RC_ASSERT((state.fragment.valid != 0) == (go && before.active != 0));
        RC_ASSERT(state.command.step == 0 || state.fragment.valid != 0);
        if (state.fragment.valid != 0) expect_word(state.fragment, words[next_word++]);
    }
    RC_ASSERT(next_span == spans.size());
    RC_ASSERT(state.active == 0);
    return clock;
}

RC_GTEST_PROP(span_walker, words_are_those_of_the_spans_in_order_whatever_the_pauses,
              (const std::vector<bool>& goes, const std::vector<bool>& empties)) {
    expect_all_words(*heads(), goes, empties);
}

RC_GTEST_PROP(span_walker, back_to_back_spans_lose_no_clock, ()) {
    const std::vector<Head> spans = *rc::gen::nonEmpty(heads());
    std::size_t words = 0;
    for (const Head& head : spans) words += head.words.size();
    RC_ASSERT(expect_all_words(spans, {}, {}) == words + 1);  // the first head's way into the position register
}

RC_GTEST_PROP(span_walker, a_span_is_one_load_and_a_step_for_each_further_pixel, ()) {
    const Head head = *pixels();
    unit::state_t state;
    int loads = 0;
    int steps = 0;
    for (std::size_t clock = 0; clock < head.words.size() + 5; ++clock) {
        state = unit::step(state, head.span, clock == 0, 1);
        loads += state.command.load.to_int();
        steps += state.command.step.to_int();
        RC_ASSERT(state.command.load == 0 || state.command.step == 0);
    }
    RC_ASSERT(loads == 1);
    RC_ASSERT(steps == static_cast<int>(head.words.size()) - 1);
}

TEST(span_walker, the_longest_span_goes_once_around_the_image) {
    unit::state_t state;
    const span_t head = {7, 9, max_extent, 0, 1, 1, 0};
    state = unit::step(state, head, 1, 1);
    for (int pixel = 0; pixel < max_extent; ++pixel) {
        state = unit::step(state, head, 0, 1);
        ASSERT_EQ(state.fragment.valid.to_int(), 1) << pixel;
        ASSERT_EQ(state.fragment.x.to_int(), (7 - pixel) & 4095) << pixel;
    }
    state = unit::step(state, head, 0, 1);
    EXPECT_EQ(state.fragment.valid.to_int(), 0);
}

}  // namespace
