// SPDX-License-Identifier: MIT
#include "sheen/packet.hpp"

#include <algorithm>
#include <array>

#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"

namespace sheen {
namespace {

constexpr int geometry_words_total = hls::geometry_words + hls::phase_words;
constexpr std::uint32_t coordinate_mask = (1U << hls::coordinate_bits) - 1;

constexpr int flag(int header_bit) { return 1 << (header_bit - hls::header_flags_lsb); }
constexpr int log_channels_shift = hls::flag_log_channels_lsb - hls::header_flags_lsb;
constexpr int known_flags = flag(hls::flag_leftward_bit) | flag(hls::flag_linear_bit) | flag(hls::flag_depth_bit) |
                            ((1 << hls::flag_log_channels_bits) - 1) << log_channels_shift;

int log_channels(int flags) { return flags >> log_channels_shift & ((1 << hls::flag_log_channels_bits) - 1); }

/// Words of a colour or log channel under these flags.
int channel_length(int flags) {
    return (flags & flag(hls::flag_linear_bit)) != 0 ? hls::linear_words : hls::quadratic_words;
}

/// Payload words of a triangle packet with these flags.
int triangle_payload(int flags) {
    const int depth = (flags & flag(hls::flag_depth_bit)) != 0 ? hls::linear_words : 0;
    return geometry_words_total + (hls::colour_channels + log_channels(flags)) * channel_length(flags) + depth;
}

std::uint32_t encode_header(int opcode, int flags, int length) {
    return static_cast<std::uint32_t>(opcode) << hls::header_opcode_lsb |
           static_cast<std::uint32_t>(flags) << hls::header_flags_lsb | static_cast<std::uint32_t>(length);
}

std::string hex(std::uint32_t word) {
    constexpr const char* digits = "0123456789abcdef";
    std::string text = "0x";
    for (int shift = hls::word_bits - 4; shift >= 0; shift -= 4) text += digits[word >> shift & 15];
    return text;
}

/// The nine geometry fields in packet order.
std::array<int, hls::geometry_fields> geometry_fields(const TriangleWalk& w) {
    return {w.x, w.y, w.rows_above, w.rows_below, w.kappa, w.length, w.m, w.length_reload, w.m_below};
}

/// Fields of 12 bits, contiguous from bit 0.
template <std::size_t count>
void append_fields(std::vector<std::uint32_t>& words, const std::array<int, count>& fields) {
    std::uint64_t pending = 0;  // bits not yet written, from bit 0
    int bits = 0;
    for (const int value : fields) {
        pending |= static_cast<std::uint64_t>(static_cast<std::uint32_t>(value) & coordinate_mask) << bits;
        bits += hls::coordinate_bits;
        if (bits >= hls::word_bits) {
            words.push_back(static_cast<std::uint32_t>(pending));
            pending >>= hls::word_bits;
            bits -= hls::word_bits;
        }
    }
    if (bits > 0) words.push_back(static_cast<std::uint32_t>(pending));
}

void append_geometry(std::vector<std::uint32_t>& words, const TriangleWalk& walk) {
    append_fields(words, geometry_fields(walk));
    for (const EdgePhase& edge : {walk.long_edge, walk.upper, walk.lower}) {
        words.push_back(edge.phase);
        words.push_back(edge.step);
    }
}

/// Field `index` of those that append_fields() put into `count` words.
int packed_field(const std::uint32_t* words, int count, int index) {
    const int bit = index * hls::coordinate_bits;
    const int word = bit / hls::word_bits;
    const std::uint64_t low = words[word];
    const std::uint64_t high = word + 1 < count ? words[word + 1] : 0;
    return static_cast<int>((low | high << hls::word_bits) >> bit % hls::word_bits & coordinate_mask);
}

int sign_extended(int field) {
    constexpr int sign = 1 << (hls::coordinate_bits - 1);
    return (field ^ sign) - sign;
}

TriangleWalk decode_geometry(const std::uint32_t* words) {
    TriangleWalk walk;
    walk.x = packed_field(words, hls::geometry_words, 0);
    walk.y = packed_field(words, hls::geometry_words, 1);
    walk.rows_above = packed_field(words, hls::geometry_words, 2);
    walk.rows_below = packed_field(words, hls::geometry_words, 3);
    walk.kappa = sign_extended(packed_field(words, hls::geometry_words, 4));
    walk.length = packed_field(words, hls::geometry_words, 5);
    walk.m = sign_extended(packed_field(words, hls::geometry_words, 6));
    walk.length_reload = packed_field(words, hls::geometry_words, 7);
    walk.m_below = sign_extended(packed_field(words, hls::geometry_words, 8));
    const std::uint32_t* phase = words + hls::geometry_words;
    for (EdgePhase* edge : {&walk.long_edge, &walk.upper, &walk.lower}) {
        *edge = {phase[0], phase[1]};
        phase += 2;
    }
    return walk;
}

void append_channel(std::vector<std::uint32_t>& words, const ChannelWords& channel, int length) {
    words.insert(words.end(), channel.words.begin(), channel.words.begin() + length);
}

ChannelWords take_channel(const std::uint32_t*& words, int length) {
    ChannelWords channel;
    for (std::size_t k = 0; k < static_cast<std::size_t>(length); ++k) channel.words[k] = *words++;
    return channel;
}

}  // namespace

void append_triangle(std::vector<std::uint32_t>& words, const TriangleSetup& setup) {
    if (setup.log.size() > hls::max_log_channels) {
        throw Error("triangle setup with " + std::to_string(setup.log.size()) +
                    " log channels: a packet holds at most " + std::to_string(hls::max_log_channels));
    }
    int flags = static_cast<int>(setup.log.size()) << log_channels_shift;
    if (setup.walk.leftward) flags |= flag(hls::flag_leftward_bit);
    if (setup.linear) flags |= flag(hls::flag_linear_bit);
    if (setup.depth) flags |= flag(hls::flag_depth_bit);

    words.push_back(encode_header(hls::opcode_triangle, flags, triangle_payload(flags)));
    append_geometry(words, setup.walk);
    for (const ChannelWords& channel : setup.colour) append_channel(words, channel, channel_length(flags));
    for (const ChannelWords& channel : setup.log) append_channel(words, channel, channel_length(flags));
    if (setup.depth) append_channel(words, *setup.depth, hls::linear_words);
}

void append_material(std::vector<std::uint32_t>& words, const MaterialSetup& material) {
    std::array<int, hls::material_fields> fields{};
    std::copy(material.ambient.begin(), material.ambient.end(), fields.begin());
    fields[hls::colour_channels] = material.power_channels;
    for (const int field : fields) {
        if (field < 0 || field >= 1 << hls::material_field_bits) {
            throw Error("material field " + std::to_string(field) + ": expected 0…" +
                        std::to_string((1 << hls::material_field_bits) - 1));
        }
    }
    if (material.power_channels >= 1 << hls::max_log_channels) {
        throw Error("material for power channels " + std::to_string(material.power_channels) + ": expected 0…" +
                    std::to_string((1 << hls::max_log_channels) - 1) + ", a bit a log channel");
    }
    words.push_back(encode_header(hls::opcode_material, 0, hls::material_words));
    append_fields(words, fields);
}

MaterialSetup decode_material(const std::uint32_t* words, std::size_t count) {
    constexpr std::size_t expected = hls::material_words + 1;
    if (count != expected || words[0] != encode_header(hls::opcode_material, 0, hls::material_words)) {
        throw Error("packet of " + std::to_string(count) + " words, header " + (count > 0 ? hex(words[0]) : "none") +
                    ": expected a material, " + std::to_string(expected) + " words, header " +
                    hex(encode_header(hls::opcode_material, 0, hls::material_words)));
    }
    MaterialSetup material;
    for (int k = 0; k < hls::colour_channels; ++k) {
        material.ambient[static_cast<std::size_t>(k)] = packed_field(words + 1, hls::material_words, k);
    }
    material.power_channels = packed_field(words + 1, hls::material_words, hls::colour_channels);
    return material;
}

void append_table(std::vector<std::uint32_t>& words, const std::vector<std::uint8_t>& entries) {
    constexpr std::size_t expected = std::size_t{1} << hls::power_address_bits;
    if (entries.size() != expected) {
        throw Error("power table of " + std::to_string(entries.size()) + " entries, expected " +
                    std::to_string(expected));
    }
    words.push_back(encode_header(hls::opcode_table, 0, hls::power_words));
    for (std::size_t k = 0; k < expected; k += 4) {
        words.push_back(static_cast<std::uint32_t>(entries[k]) | static_cast<std::uint32_t>(entries[k + 1]) << 8 |
                        static_cast<std::uint32_t>(entries[k + 2]) << 16 |
                        static_cast<std::uint32_t>(entries[k + 3]) << 24);
    }
}

void append_fence(std::vector<std::uint32_t>& words, int tag) {
    if (tag < 0 || tag > 255) throw UsageError("fence tag " + std::to_string(tag) + ": expected 0…255");
    words.push_back(encode_header(hls::opcode_fence, tag, 0));
}

void append_query(std::vector<std::uint32_t>& words) { words.push_back(encode_header(hls::opcode_query, 0, 0)); }

PacketHeader decode_header(std::uint32_t word) {
    return {static_cast<int>(word >> hls::header_opcode_lsb), static_cast<int>(word >> hls::header_flags_lsb & 0xff),
            static_cast<int>(word & ((1U << hls::header_length_bits) - 1))};
}

TriangleSetup decode_triangle(const std::uint32_t* words, std::size_t count) {
    if (count == 0) throw Error("triangle packet without words: expected a header");
    const PacketHeader header = decode_header(words[0]);
    const std::string culprit = "packet header " + hex(words[0]) + ": ";
    if (header.opcode != hls::opcode_triangle) {
        throw Error(culprit + "opcode " + std::to_string(header.opcode) + ", expected " +
                    std::to_string(hls::opcode_triangle) + " (triangle)");
    }
    if ((header.flags & ~known_flags) != 0)
        throw Error(culprit + "flags " + hex(words[0] & 0xff0000U) + " set bits 21–23, expected 0");
    const int payload = triangle_payload(header.flags);
    if (header.length != payload) {
        throw Error(culprit + "length " + std::to_string(header.length) + ", expected " + std::to_string(payload) +
                    " payload words for its flags");
    }
    if (count != static_cast<std::size_t>(payload) + 1) {
        throw Error(culprit + "packet of " + std::to_string(count) + " words, expected " + std::to_string(payload + 1));
    }

    TriangleSetup setup;
    setup.walk = decode_geometry(words + 1);
    setup.walk.leftward = (header.flags & flag(hls::flag_leftward_bit)) != 0;
    setup.linear = (header.flags & flag(hls::flag_linear_bit)) != 0;
    const std::uint32_t* next = words + 1 + geometry_words_total;
    for (ChannelWords& channel : setup.colour) channel = take_channel(next, channel_length(header.flags));
    setup.log.resize(static_cast<std::size_t>(log_channels(header.flags)));
    for (ChannelWords& channel : setup.log) channel = take_channel(next, channel_length(header.flags));
    if ((header.flags & flag(hls::flag_depth_bit)) != 0) setup.depth = take_channel(next, hls::linear_words);
    return setup;
}

}  // namespace sheen
