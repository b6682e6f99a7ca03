// SPDX-License-Identifier: MIT
/// \file
/// Stream top for an HLS tool: the whole core with a 64-bit setup stream, depth and quadratic colour.
///
/// One call runs until the setup stream has no beat waiting and nothing is under way: not a pixel, and not a packet. An
/// idle core holds nothing that the next packet needs, so it does not matter where calls begin and end.
///
/// Formats: a beat is {last, keep, words}, 1 + 2 + 64 bits, the words lowest; a pixel is {fence, word}, 1 + 64 bits.
#include "sheen/hls/shading_core.hpp"

#include <cstdint>

#include "sheen/hls/channel.hpp"

namespace {

using namespace sheen::hls;
using core_t = shading_core<core_config<>>;
using beat_t = core_t::decoder::beat_t;

constexpr int beat_words = core_config<>::words_per_beat;
constexpr int beat_bits = beat_words * word_bits + beat_words + 1;
using beat_bits_t = ac_int<beat_bits, false>;
using pixel_bits_t = ac_int<pixel_bits + 1, false>;

/// Clocks of one call at most: 20 s at 100 MHz, and more than any packet takes.
constexpr std::uint32_t max_clocks = std::uint32_t{1} << 31;

beat_t unpack(const beat_bits_t& bits, bit_t valid) {
    beat_t beat;
    beat.valid = valid;
    beat.words[0] = bits.slc<word_bits>(0);
    beat.words[1] = bits.slc<word_bits>(word_bits);
    beat.keep = bits.slc<beat_words>(beat_words * word_bits);
    beat.last = bits[beat_bits - 1];
    return beat;
}

}  // namespace

extern "C" void shading_core_top(channel<beat_bits_t>& setup, channel<pixel_bits_t>& pixels) {
    core_t core;
    beat_bits_t bits = 0;
    bool waiting = false;  // bits hold a beat that the core has not taken
    bool working = true;
    for (std::uint32_t clock = 0; clock < max_clocks && working; ++clock) {
        if (!waiting) waiting = setup.nb_read(bits);
        const bool taken = waiting && core.ready();
        core.clock(unpack(bits, waiting), 1);
        if (core.stage_state.valid) {
            pixel_bits_t pixel = 0;
            pixel.set_slc(0, core.stage_state.word);
            pixel.set_slc(pixel_bits, core.stage_state.fence);
            pixels.write(pixel);
        }
        waiting = waiting && !taken;
        working = waiting || core.busy() || core.decoder_state.phase != core_t::decoder::expect_header;
    }
}
