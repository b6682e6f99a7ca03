// SPDX-License-Identifier: MIT
/// \file
/// The oracle of contracts 1 and 2 for a whole triangle packet: every output word, by the closed form.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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

/// What a device's pixels with log channels are made of: the last material and the last power table, 0 at the start.
class Lighting {
 public:
    /// The whole packet's words.
    void set_material(const std::vector<std::uint32_t>& words) {
        const std::uint64_t low = words[1] | static_cast<std::uint64_t>(words[2]) << 32;
        for (int c = 0; c < 3; ++c)
            ambient_[static_cast<std::size_t>(c)] = static_cast<int>(low >> 12 * c & 4095) * parts / 16;
        kinds_ = static_cast<int>(low >> 36 & 7);
    }
    void set_table(const std::vector<std::uint32_t>& words) {
        for (std::size_t k = 0; k < table_.size(); ++k) {
            table_[k] = static_cast<int>(words[1 + k / 4] >> 8 * (k % 4) & 255);
        }
    }
    /// Highlight of log channel k at this value, in `parts` of an 8-bit step.
    [[nodiscard]] int highlight(std::size_t k, std::uint32_t value) const {
        const int cut = static_cast<int>(static_cast<std::int32_t>(value) >> 18);  // s8.6
        if ((kinds_ >> k & 1) != 0) return parts * table_[static_cast<std::size_t>(std::clamp(cut, 0, 1023))];
        const int z = std::max(cut, 0);
        const auto entry = std::min(255.0, std::round(256.0 * std::exp2(-(z % 64 + 0.5) / 64.0)));
        return static_cast<int>(parts * entry * std::exp2(-z / 64));
    }
    /// Colour of component c: max(0, diffuse) + ambient + highlights.
    [[nodiscard]] int component(std::size_t c, std::uint32_t diffuse, int highlights) const {
        const int cut = std::max(0, static_cast<int>(static_cast<std::int32_t>(diffuse) >>
                                                     (hls::colour_fraction_bits - hls::colour_sum_fraction_bits)));
        return std::min(255, (cut + ambient_[c] + highlights) / parts);
    }

 private:
    static constexpr int parts = 1 << hls::colour_sum_fraction_bits;
    std::array<int, 3> ambient_{};  ///< parts of an 8-bit step
    int kinds_ = 0;
    std::array<int, 1024> table_{};
};

/// The words that a device returns for the setup, in its order.
inline std::vector<std::uint64_t> expected_pixels(const TriangleSetup& setup, const Lighting& lighting = {}) {
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
            int highlights = 0;
            for (std::size_t i = 0; i < setup.log.size(); ++i) highlights += lighting.highlight(i, value(setup.log[i]));
            std::array<int, 3> colour{};
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t diffuse = value(setup.colour[c]);
                colour[c] = setup.log.empty() ? component(diffuse) : lighting.component(c, diffuse, highlights);
            }
            words.push_back(encode_pixel({x, row.y, depth, colour[0], colour[1], colour[2]}));
        }
    });
    return words;
}

}  // namespace sheen::test
