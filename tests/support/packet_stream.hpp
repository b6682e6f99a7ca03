// SPDX-License-Identifier: MIT
/// \file
/// Random packets as beats of the setup stream, good and malformed, and what the protocol says of each: the rules of
/// docs/packet-protocol.md in plain arithmetic, sharing no line with packet_decoder.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "random_triangles.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/packet.hpp"

namespace sheen::test {

/// What a core is built with, as far as packets show it.
struct CoreShape {
    int words_per_beat = 2;
    bool depth = true;
    bool quadratic = true;
    int log_channels = 0;
    bool power = false;
};

struct StreamBeat {
    std::array<std::uint32_t, 4> words{};
    unsigned keep = 0;  ///< bit k: word k is present
    bool last = false;
};

/// The beats of one packet: `last` stands on the last one and on no other.
using StreamPacket = std::vector<StreamBeat>;

/// The words as one packet, framed as they are, whatever the header announces.
inline StreamPacket framed(const std::vector<std::uint32_t>& words, int words_per_beat) {
    StreamPacket packet;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::size_t lane = i % static_cast<std::size_t>(words_per_beat);
        if (lane == 0) packet.emplace_back();
        packet.back().words[lane] = words[i];
        packet.back().keep |= 1U << lane;
    }
    packet.back().last = true;
    return packet;
}

/// Error code that the header deserves by itself; 0: none.
inline int header_error(std::uint32_t word, const CoreShape& shape) {
    const PacketHeader header = decode_header(word);
    if (header.opcode > hls::opcode_fence) return hls::error_unknown_opcode;
    if (header.opcode == hls::opcode_query || header.opcode == hls::opcode_fence) {
        return header.length == 0 ? 0 : hls::error_bad_length;
    }
    if (header.opcode == hls::opcode_spans) return hls::error_unsupported;
    if (header.opcode == hls::opcode_material || header.opcode == hls::opcode_table) {
        const bool material = header.opcode == hls::opcode_material;
        if (header.length != (material ? 5 : 256)) return hls::error_bad_length;
        const bool has_it = material ? shape.log_channels > 0 : shape.power;
        return has_it && header.flags == 0 ? 0 : hls::error_unsupported;
    }
    const bool linear = (header.flags & 2) != 0;
    const bool depth = (header.flags & 4) != 0;
    const int log_channels = header.flags >> 3 & 3;
    if (header.length != 10 + (3 + log_channels) * (linear ? 3 : 6) + (depth ? 3 : 0)) return hls::error_bad_length;
    const bool served = header.flags < 32 && log_channels <= shape.log_channels && (shape.depth || !depth) &&
                        (shape.quadratic || linear);
    return served ? 0 : hls::error_unsupported;
}

/// The words of a packet that has no error.
inline std::vector<std::uint32_t> words_of(const StreamPacket& packet) {
    std::vector<std::uint32_t> words;
    for (const StreamBeat& beat : packet) {
        for (std::size_t k = 0; k < beat.words.size(); ++k) {
            if ((beat.keep >> k & 1U) != 0) words.push_back(beat.words[k]);
        }
    }
    return words;
}

/// Error code that the packet deserves; 0: it is a triangle to draw, a material, a table, a fence or a query.
inline int packet_error(const StreamPacket& packet, const CoreShape& shape) {
    const std::uint32_t header = packet[0].words[0];
    if (const int code = header_error(header, shape); code != 0) return code;
    const auto width = static_cast<std::size_t>(shape.words_per_beat);
    const std::size_t words = static_cast<std::size_t>(decode_header(header).length) + 1;
    bool whole = packet.size() == (words + width - 1) / width;
    for (std::size_t i = 0; whole && i < packet.size(); ++i) {
        const std::size_t present = std::min(width, words - i * width);
        whole = packet[i].keep == (1U << present) - 1;
    }
    if (!whole) return hls::error_bad_length;
    const bool wants_power = header >> 24 == hls::opcode_material && (words_of(packet)[2] >> 4 & 7) != 0;
    return wants_power && !shape.power ? hls::error_unsupported : 0;
}

inline bool is_triangle(const StreamPacket& packet) {
    return decode_header(packet[0].words[0]).opcode == hls::opcode_triangle;
}

/// Words whose values mostly lie where highlights show.
inline ChannelWords random_log_channel(Rng& rng, bool linear) {
    ChannelWords channel = random_channel(rng, linear);
    if (uniform(rng, 0, 3) == 0) return channel;
    channel.words[0] = static_cast<std::uint32_t>(uniform(rng, -(1 << 26), 20 << 24));
    for (std::size_t k = 1; k < channel.words.size(); ++k) {
        channel.words[k] = channel.words[k] == 0 ? 0 : static_cast<std::uint32_t>(uniform(rng, -(1 << 22), 1 << 22));
    }
    return channel;
}

/// A material packet with any fields; its unused bits are noise.
inline std::vector<std::uint32_t> material_packet(Rng& rng) {
    MaterialSetup material;
    for (int& field : material.ambient) field = static_cast<int>(uniform(rng, 0, 4095));
    material.power_channels = static_cast<int>(uniform(rng, 0, 7));
    std::vector<std::uint32_t> words;
    append_material(words, material);
    words[2] |= static_cast<std::uint32_t>(rng()) << 16;
    for (std::size_t k = 3; k < words.size(); ++k) words[k] = static_cast<std::uint32_t>(rng());
    return words;
}

inline std::vector<std::uint32_t> table_packet(Rng& rng) {
    std::vector<std::uint8_t> entries(1024);
    for (std::uint8_t& entry : entries) entry = static_cast<std::uint8_t>(rng());
    std::vector<std::uint32_t> words;
    append_table(words, entries);
    return words;
}

/// A triangle packet of arbitrary channel words over the walk, which the core serves.
inline std::vector<std::uint32_t> triangle_words(Rng& rng, const TriangleWalk& walk, const CoreShape& shape) {
    TriangleSetup setup = random_channels(rng, walk);
    if (!shape.quadratic && !setup.linear) {
        setup.linear = true;
        for (ChannelWords& channel : setup.colour) channel = random_channel(rng, true);
    }
    if (!shape.depth) setup.depth.reset();
    setup.log.resize(static_cast<std::size_t>(uniform(rng, 0, shape.log_channels)));
    for (ChannelWords& channel : setup.log) channel = random_log_channel(rng, setup.linear);
    std::vector<std::uint32_t> words;
    append_triangle(words, setup);
    return words;
}

/// The walk of a random triangle that covers a pixel.
inline TriangleWalk covering_walk(Rng& rng, int max_px) {
    for (;;) {
        const Triangle t = random_triangle(rng, max_px);
        if (const auto walk = walk_triangle(t[0], t[1], t[2])) return *walk;
    }
}

/// The packet's words with one thing wrong in the header, and a payload as long as the header then says.
inline std::vector<std::uint32_t> wrong_header(Rng& rng, const std::vector<std::uint32_t>& triangle) {
    const auto pick = [&](int low, int high) { return static_cast<std::uint32_t>(uniform(rng, low, high)); };
    std::uint32_t header = triangle[0];
    switch (pick(0, 4)) {
        case 0:
            header = pick(6, 255) << 24 | pick(0, 255) << 16 | pick(0, 40);
            break;
        case 1:
            header = (pick(0, 1) == 0 ? pick(1, 2) : 4U) << 24 | (pick(0, 1) == 0 ? pick(0, 255) : 0U) << 16 |
                     (pick(0, 1) == 0 ? pick(0, 40) : pick(4, 6));
            break;
        case 2:
            header = (header & 0xffff0000U) | pick(0, 60);
            break;
        case 3: {  // any flags, with the length that goes with them
            const std::uint32_t flags = pick(0, 255);
            const std::uint32_t length = 10 + (3 + (flags >> 3 & 3)) * ((flags & 2) != 0 ? 3 : 6) + (flags & 4) / 4 * 3;
            header = (header & 0xff000000U) | flags << 16 | length;
            break;
        }
        default:
            header = (pick(0, 1) == 0 ? 0U : 5U) << 24 | pick(0, 255) << 16 | pick(0, 5);
            break;
    }
    std::vector<std::uint32_t> words = triangle;
    words[0] = header;
    words.resize((header & 0xffffU) + 1, static_cast<std::uint32_t>(rng()));
    return words;
}

/// The beats with their framing broken: cut short, drawn out, or with words missing from one beat.
inline void break_framing(Rng& rng, StreamPacket& packet, int words_per_beat) {
    const auto length = static_cast<std::int64_t>(packet.size());
    switch (uniform(rng, 0, 2)) {
        case 0:
            packet.resize(static_cast<std::size_t>(uniform(rng, 1, length)));
            break;
        case 1:
            packet.resize(static_cast<std::size_t>(length + uniform(rng, 1, 70)), packet[0]);
            break;
        default:
            packet[static_cast<std::size_t>(uniform(rng, 0, length - 1))].keep =
                static_cast<unsigned>(uniform(rng, 0, (1 << words_per_beat) - 1));
            break;
    }
    for (StreamBeat& beat : packet) beat.last = false;
    packet.back().last = true;
}

/// Any packet: a triangle over the walk, a fence, a query, what the core has of materials and tables, or one of these
/// gone wrong.
inline StreamPacket random_packet(Rng& rng, const TriangleWalk& walk, const CoreShape& shape) {
    std::vector<std::uint32_t> words = triangle_words(rng, walk, shape);
    const std::int64_t kind = uniform(rng, 0, 9);
    if (kind >= 8) {
        words.clear();
        kind == 8 ? append_fence(words, static_cast<int>(uniform(rng, 0, 255))) : append_query(words);
    } else if (kind >= 6) {
        words = wrong_header(rng, words);
    }
    if (shape.log_channels > 0 && uniform(rng, 0, 4) == 0) words = material_packet(rng);
    if (shape.power && uniform(rng, 0, 19) == 0) words = table_packet(rng);
    StreamPacket packet = framed(words, shape.words_per_beat);
    if (uniform(rng, 0, 5) == 0) break_framing(rng, packet, shape.words_per_beat);
    return packet;
}

}  // namespace sheen::test
