// SPDX-License-Identifier: MIT
#include "sheen/framing.hpp"

#include <algorithm>

#include "sheen/hls/formats.hpp"
#include "sheen/packet.hpp"

namespace sheen {

std::vector<Beat> frame_packets(const std::vector<std::uint32_t>& words, int words_per_beat) {
    std::vector<Beat> beats;
    const auto width = static_cast<std::size_t>(words_per_beat);
    beats.reserve(words.size() / width + 1);
    std::size_t start = 0;
    while (start < words.size()) {
        const auto announced = static_cast<std::size_t>(decode_header(words[start]).length) + 1;
        const std::size_t end = std::min(words.size(), start + announced);
        for (std::size_t i = start; i < end; i += width) {
            Beat beat;
            beat.count = static_cast<int>(std::min(width, end - i));
            std::copy_n(words.begin() + static_cast<std::ptrdiff_t>(i), beat.count, beat.words.begin());
            beat.last = i + width >= end;
            beats.push_back(beat);
        }
        start = end;
    }
    return beats;
}

std::size_t count_fences(const std::vector<std::uint32_t>& words) {
    std::size_t fences = 0;
    for (std::size_t i = 0; i < words.size();) {
        const PacketHeader header = decode_header(words[i]);
        if (header.opcode == hls::opcode_fence && header.length == 0) ++fences;
        i += static_cast<std::size_t>(header.length) + 1;
    }
    return fences;
}

}  // namespace sheen
