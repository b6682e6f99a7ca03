// SPDX-License-Identifier: MIT
/// \file
/// Packet words to stream beats: where each packet starts and ends on an AXI4-Stream of 1, 2 or 4 words a beat.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sheen {

/// One beat of the setup stream.
struct Beat {
    std::array<std::uint32_t, 4> words{};  ///< word k is bits 32k+31…32k; those past `count` are 0
    int count = 0;                         ///< words present, from word 0
    bool last = false;                     ///< tlast: the packet's last word is in this beat
};

/// Frames a sequence of packets. Only headers frame: a packet is its header and as many words as the header announces,
/// whatever its opcode; each packet starts a beat; `last` stands on its last word and at the end of the sequence.
/// \param words_per_beat 1, 2 or 4
std::vector<Beat> frame_packets(const std::vector<std::uint32_t>& words, int words_per_beat);

/// Number of fence packets in a sequence that a device answers with an echo.
std::size_t count_fences(const std::vector<std::uint32_t>& words);

}  // namespace sheen
