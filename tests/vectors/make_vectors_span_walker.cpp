// SPDX-License-Identifier: MIT
/// \file
/// make_vectors_span_walker OUTDIR [seed] [count]: vectors of tb_span_walker, from the kernel.
///
/// A vector is one clock: the queue's head, go, and all that the unit shows in that clock. Spans start anywhere, run
/// both ways over the wrap of x, and are mostly short, one pixel often; one head in eight is a message, one in sixteen
/// a query. A valid head stays until it is taken; a head that is not valid is noise.
#include <random>

#include "pauses.hpp"
#include "sheen/hls/span_walker.hpp"
#include "vector_file.hpp"

namespace {

using sheen::hls::coordinate_bits;
using sheen::hls::coordinate_t;
using sheen::hls::span_t;
using sheen::test::Pauses;
using sheen::test::VectorFile;
using sheen::test::VectorOptions;
using unit = sheen::hls::span_walker;

span_t random_span(std::mt19937_64& random) {
    span_t span;
    span.x = random();
    span.y = random();
    span.leftward = random() % 2;
    span.first = random() % 2;
    const auto kind = random() % 16;
    if (kind < 2) {
        span.message = 1;
        span.single = 1;
        span.length = random();
    } else if (kind == 2) {
        span.message = 1;
        span.length = sheen::hls::query_reply_words;
    } else {
        const unsigned longest[] = {1, 2, 4, 16, 100};
        span.length = 1 + random() % longest[random() % 5];
        span.single = span.length == 1;
    }
    return span;
}

void write(const VectorOptions& options, int stall_percent) {
    VectorFile file(options, "span_walker", "stall_percent=" + std::to_string(stall_percent));
    std::mt19937_64 random(options.seed);
    Pauses source(stall_percent);
    Pauses sink(stall_percent);
    unit::state_t state;
    span_t head;
    bool head_valid = false;
    for (int i = 0; i < options.count; ++i) {
        if (!head_valid) {
            head = random_span(random);
            head_valid = !source.pause(random);
        }
        const bool go = !sink.pause(random);
        const bool taken = unit::taken(state, head_valid, go) != 0;
        file.word(head_valid, 1).word(head.x.to_int(), coordinate_bits).word(head.y.to_int(), coordinate_bits);
        file.word(head.length.to_int(), coordinate_bits).word(head.single.to_int(), 1);
        file.word(head.leftward.to_int(), 1).word(head.first.to_int(), 1).word(head.message.to_int(), 1).word(go, 1);
        const auto& [load, first, step] = state.command;
        const sheen::hls::fragment_t& fragment = state.fragment;
        file.word(taken, 1).word(load.to_int(), 1).word(first.to_int(), 1).word(step.to_int(), 1);
        file.word(fragment.valid.to_int(), 1).word(fragment.message.to_int(), 1).word(fragment.query.to_int(), 1);
        file.word(fragment.x.to_int(), coordinate_bits).word(fragment.y.to_int(), coordinate_bits);
        file.word(fragment.tail.to_int(), coordinate_bits).end_vector();
        state = unit::step(state, head, head_valid, go);
        head_valid = head_valid && !taken;
    }
    file.close();
}

}  // namespace

int main(int argc, char** argv) {
    return sheen::test::write_vectors(argc, argv, [](const VectorOptions& options) {
        write(options, 0);
        write(options, 50);
    });
}
