// SPDX-License-Identifier: MIT
/// \file
/// From setups to a picture through a device: packets out, words back, framebuffer, figures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sheen/device.hpp"
#include "sheen/image.hpp"
#include "sheen/method.hpp"

namespace sheen {

/// What a device did with a packet stream.
struct Statistics {
    std::size_t pixels = 0;                   ///< pixel words, hidden ones included
    std::size_t triangles = 0;                ///< triangle packets that were accepted
    std::optional<std::uint64_t> cycles;      ///< clock cycles; simulators only
    std::optional<std::size_t> packet_words;  ///< 32-bit words streamed in; nothing for the reference
    /// pixels / cycles; nothing where cycles are not counted.
    [[nodiscard]] std::optional<double> pixels_per_clock() const;
};

/// Figures of a run. Packets are framed by their headers alone, as in a replayed file; a triangle that was answered by
/// an error word does not count.
Statistics statistics_of(const std::vector<std::uint32_t>& packets, const RunResult& result);

/// True for a word by which a device refuses a packet.
bool is_error_word(std::uint64_t word);

/// Why a core can't draw all of the setups: it has too few log channels, no power table or one of another size, linear
/// colour only, or no depth. Nothing where it can.
std::optional<std::string> why_incapable(const Capabilities& core, const std::vector<TriangleSetup>& setups);

/// The packets of a picture: its triangles in order, then a fence, whose echo tells that the picture is complete.
/// Before a triangle with log channels come its material and its power table, unless they are the ones already sent.
std::vector<std::uint32_t> picture_packets(const std::vector<TriangleSetup>& setups);

/// A picture as a device drew it.
struct Drawing {
    RunResult result;
    Framebuffer framebuffer;
};

/// Draws packets that end with a fence (see picture_packets).
/// \throws Error when a packet is refused, when the fence's echo is missing, wrong or not the last word, or when a
/// pixel
///         lies outside the image: the picture would not be what was asked for.
Drawing draw(Device& device, const std::vector<std::uint32_t>& packets, int width, int height);

}  // namespace sheen
