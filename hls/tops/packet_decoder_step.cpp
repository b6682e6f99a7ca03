// SPDX-License-Identifier: MIT
/// \file
/// Top for an HLS tool: one clock of packet_decoder, for a 64-bit stream and linear colour without depth, the instance
/// with the fewest registers. Scalar ports only: the state's words in and out, the registers stand around it. Two words
/// share a port, the lower one in bits 31–0; narrow fields share one from bit 0 up, in the order of the record.
#include <cstdint>

#include "sheen/hls/packet_decoder.hpp"

namespace {

using namespace sheen::hls;
using decoder = packet_decoder<2, false, false>;
using port_t = ac_int<64, false>;

bit_t flag(const port_t& port, unsigned index) { return port[index]; }

/// Control: phase, beat_index, framing, verdict, the job's fields but its header, and when the held-back write goes
/// where.
void take_control(decoder::state_t& s, const port_t& control) {
    s.phase = control.slc<2>(0);
    s.beat_index = control.slc<6>(2);
    s.broken = flag(control, 8);
    s.verdict.age = control.slc<2>(9);
    s.verdict.triangle = flag(control, 11);
    s.framed = flag(control, 12);
    s.verdict.known = flag(control, 13);
    s.verdict.served = flag(control, 14);
    s.verdict.expected = control.slc<16>(15);
    s.verdict.final_index = control.slc<6>(31);
    s.verdict.final_keep = control.slc<2>(37);
    s.verdict.code = control.slc<2>(39);
    s.job.valid = flag(control, 41);
    s.job.message = flag(control, 42);
    s.job.leftward = flag(control, 43);
    s.job.linear = flag(control, 44);
    s.job.depth = flag(control, 45);
    s.job.code = control.slc<2>(46);
    s.verdict.at_final = flag(control, 48);
    s.write.valid = flag(control, 49);
    s.write_index = control.slc<6>(50);
    s.last_keep = control.slc<2>(56);
    s.settled = flag(control, 58);
}

port_t control_of(const decoder::state_t& s) {
    port_t control = 0;
    control.set_slc(0, s.phase);
    control.set_slc(2, s.beat_index);
    control.set_slc(8, s.broken);
    control.set_slc(9, s.verdict.age);
    control.set_slc(11, s.verdict.triangle);
    control.set_slc(12, s.framed);
    control.set_slc(13, s.verdict.known);
    control.set_slc(14, s.verdict.served);
    control.set_slc(15, s.verdict.expected);
    control.set_slc(31, s.verdict.final_index);
    control.set_slc(37, s.verdict.final_keep);
    control.set_slc(39, s.verdict.code);
    control.set_slc(41, s.job.valid);
    control.set_slc(42, s.job.message);
    control.set_slc(43, s.job.leftward);
    control.set_slc(44, s.job.linear);
    control.set_slc(45, s.job.depth);
    control.set_slc(46, s.job.code);
    control.set_slc(48, s.verdict.at_final);
    control.set_slc(49, s.write.valid);
    control.set_slc(50, s.write_index);
    control.set_slc(56, s.last_keep);
    control.set_slc(58, s.settled);
    return control;
}

void take_pair(word_t* words, const port_t& port) {
    words[0] = port.slc<word_bits>(0);
    words[1] = port.slc<word_bits>(word_bits);
}

std::uint64_t pair_of(const word_t& low, const word_t& high) {
    port_t port = 0;
    port.set_slc(0, low);
    port.set_slc(word_bits, high);
    return port.to_uint64();
}

}  // namespace

/// control, headers (of the packet under way, of the message), held, write and words_*: the state; flags: valid, last,
/// keep.
extern "C" void packet_decoder_step(std::uint64_t control, std::uint64_t headers, std::uint64_t held,
                                    std::uint64_t write, std::uint64_t words_0_1, std::uint64_t words_2_3,
                                    std::uint64_t words_4_5, std::uint64_t words_6_7, std::uint64_t words_8_9,
                                    std::uint64_t words_10_11, std::uint64_t words_12_13, std::uint64_t words_14_15,
                                    std::uint64_t words_16_17, std::uint32_t words_18, std::uint8_t beat_flags,
                                    std::uint64_t beat_words, bool job_taken, std::uint64_t* next_control,
                                    std::uint64_t* next_headers, std::uint64_t* next_held, std::uint64_t* next_write,
                                    std::uint64_t* next_words_0_1, std::uint64_t* next_words_2_3,
                                    std::uint64_t* next_words_4_5, std::uint64_t* next_words_6_7,
                                    std::uint64_t* next_words_8_9, std::uint64_t* next_words_10_11,
                                    std::uint64_t* next_words_12_13, std::uint64_t* next_words_14_15,
                                    std::uint64_t* next_words_16_17, std::uint32_t* next_words_18, bool* beat_ready) {
    static_assert(decoder::register_count == 19, "one port for each pair of registers");
    decoder::state_t state;
    take_control(state, control);
    state.header = port_t(headers).slc<word_bits>(0);
    state.job.header = port_t(headers).slc<word_bits>(word_bits);
    take_pair(state.held, held);
    take_pair(state.write.words, write);
    take_pair(state.words, words_0_1);
    take_pair(state.words + 2, words_2_3);
    take_pair(state.words + 4, words_4_5);
    take_pair(state.words + 6, words_6_7);
    take_pair(state.words + 8, words_8_9);
    take_pair(state.words + 10, words_10_11);
    take_pair(state.words + 12, words_12_13);
    take_pair(state.words + 14, words_14_15);
    take_pair(state.words + 16, words_16_17);
    state.words[18] = words_18;
    decoder::beat_t beat;
    const port_t flags = beat_flags;
    beat.valid = flag(flags, 0);
    beat.last = flag(flags, 1);
    beat.keep = flags.slc<2>(2);
    take_pair(beat.words, beat_words);

    *beat_ready = decoder::ready(state) != 0;
    const decoder::state_t next = decoder::step(state, beat, job_taken);
    *next_control = control_of(next).to_uint64();
    *next_headers = pair_of(next.header, next.job.header);
    *next_held = pair_of(next.held[0], next.held[1]);
    *next_write = pair_of(next.write.words[0], next.write.words[1]);
    *next_words_0_1 = pair_of(next.words[0], next.words[1]);
    *next_words_2_3 = pair_of(next.words[2], next.words[3]);
    *next_words_4_5 = pair_of(next.words[4], next.words[5]);
    *next_words_6_7 = pair_of(next.words[6], next.words[7]);
    *next_words_8_9 = pair_of(next.words[8], next.words[9]);
    *next_words_10_11 = pair_of(next.words[10], next.words[11]);
    *next_words_12_13 = pair_of(next.words[12], next.words[13]);
    *next_words_14_15 = pair_of(next.words[14], next.words[15]);
    *next_words_16_17 = pair_of(next.words[16], next.words[17]);
    *next_words_18 = next.words[18].to_uint();
}
