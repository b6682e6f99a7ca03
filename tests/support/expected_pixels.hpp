// SPDX-License-Identifier: MIT
/// \file
/// The oracle of contracts 1 and 2 for a whole triangle packet: every output word, by the closed form.
#pragma once

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "sheen/hls/formats.hpp"
#include "sheen/method.hpp"
#include "sheen/packet.hpp"

namespace sheen::test {

/// 8-bit colour of a channel word: its integer part as a signed number, saturated to 0…255.
inline int component(std::uint32_t word) {
    const int fraction = hls::colour_fraction_bits;
    const int integer = static_cast<int>(static_cast<std::int32_t>(word) >> fraction);
    return std::clamp(integer, 0, 255);
}

/// The words that a device returns for the setup, in its order. Setups with log channels have no oracle here.
inline std::vector<std::uint64_t> expected_pixels(const TriangleSetup& setup) {
    if (!setup.log.empty()) throw std::invalid_argument("expected_pixels: log channels are not drawn by this core");
    std::vector<std::uint64_t> words;
    const int step = setup.walk.leftward ? -1 : 1;
    const int coordinates = 1 << hls::coordinate_bits;
    for_each_row(setup.walk, [&](const WalkRow& row) {
        for (int k = 0; k < row.length; ++k) {
            const int x = (row.x + step * k + coordinates) % coordinates;
            if (x == hls::message_x) continue;
            const auto value = [&](const ChannelWords& channel) {
                return channel_value(channel, row.carries + k, row.row);
            };
            const int depth =
                setup.depth ? static_cast<int>(value(*setup.depth) >> (hls::word_bits - hls::depth_bits)) : 0;
            words.push_back(encode_pixel({x, row.y, depth, component(value(setup.colour[0])),
                                          component(value(setup.colour[1])), component(value(setup.colour[2]))}));
        }
    });
    return words;
}

}  // namespace sheen::test
