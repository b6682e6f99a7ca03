// SPDX-License-Identifier: MIT
/// \file
/// Co-simulation of packet streams that no picture has: arbitrary words, malformed packets, queries and fences between
/// triangles, on every core configuration that is built, at full speed and with random pauses on both streams.
#pragma once

#include <cstdint>
#include <vector>

#include "support/packet_stream.hpp"

namespace sheen::test {

/// Packets of every kind in random order.
inline std::vector<std::uint32_t> random_stream(Rng& rng, int packets) {
    std::vector<std::uint32_t> words;
    for (int i = 0; i < packets; ++i) {
        switch (uniform(rng, 0, 11)) {
            case 0:
                append_fence(words, static_cast<int>(uniform(rng, 0, 255)));
                break;
            case 1:
                append_query(words);
                break;
            case 2: {  // any header with a short payload
                const auto length = static_cast<std::uint32_t>(uniform(rng, 0, 40));
                words.push_back((random_word(rng) & 0xffff0000U) | length);
                for (std::uint32_t k = 0; k < length; ++k) words.push_back(random_word(rng));
                break;
            }
            case 3: {
                const auto material = material_packet(rng);
                words.insert(words.end(), material.begin(), material.end());
                break;
            }
            case 4: {
                const auto table = table_packet(rng);
                words.insert(words.end(), table.begin(), table.end());
                break;
            }
            default:
                TriangleSetup setup = random_setup(rng, 12);
                setup.log.resize(static_cast<std::size_t>(uniform(rng, 0, hls::max_log_channels)));
                for (ChannelWords& channel : setup.log) channel = random_log_channel(rng, setup.linear);
                append_triangle(words, setup);
        }
    }
    return words;
}

}  // namespace sheen::test
