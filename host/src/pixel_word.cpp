// SPDX-License-Identifier: MIT
// Words of the output stream: pixels and messages (packet.hpp).
#include <fmt/format.h>

#include "sheen/hls/formats.hpp"
#include "sheen/packet.hpp"

namespace sheen {
namespace {

// A message's 8-bit code (error code, index of a reply word) follows its y; its data are the upper 32 bits.
constexpr int message_code_lsb = hls::pixel_depth_lsb;
constexpr int message_code_bits = 8;

int field(std::uint64_t word, int lsb, int bits) {
    return static_cast<int>(word >> lsb & ((std::uint64_t{1} << bits) - 1));
}

std::uint64_t placed(int value, int lsb, int bits) {
    return (static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << bits) - 1)) << lsb;
}

std::string error_name(int code) {
    switch (code) {
        case hls::error_unknown_opcode:
            return "unknown opcode";
        case hls::error_bad_length:
            return "bad length or framing";
        case hls::error_unsupported:
            return "not supported by this core";
        default:
            return "unknown code";
    }
}

}  // namespace

Pixel decode_pixel(std::uint64_t word) {
    return {
        field(word, hls::pixel_x_lsb, hls::coordinate_bits),    field(word, hls::pixel_y_lsb, hls::coordinate_bits),
        field(word, hls::pixel_depth_lsb, hls::depth_bits),     field(word, hls::pixel_red_lsb, hls::component_bits),
        field(word, hls::pixel_green_lsb, hls::component_bits), field(word, hls::pixel_blue_lsb, hls::component_bits)};
}

std::uint64_t encode_pixel(const Pixel& pixel) {
    return placed(pixel.x, hls::pixel_x_lsb, hls::coordinate_bits) |
           placed(pixel.y, hls::pixel_y_lsb, hls::coordinate_bits) |
           placed(pixel.depth, hls::pixel_depth_lsb, hls::depth_bits) |
           placed(pixel.red, hls::pixel_red_lsb, hls::component_bits) |
           placed(pixel.green, hls::pixel_green_lsb, hls::component_bits) |
           placed(pixel.blue, hls::pixel_blue_lsb, hls::component_bits);
}

bool is_message(std::uint64_t word) { return field(word, hls::pixel_x_lsb, hls::coordinate_bits) == hls::message_x; }

std::string describe_message(std::uint64_t word) {
    if (!is_message(word)) {
        const Pixel pixel = decode_pixel(word);
        return fmt::format("pixel ({}, {})", pixel.x, pixel.y);
    }
    const int kind = field(word, hls::pixel_y_lsb, hls::coordinate_bits);
    const int code = field(word, message_code_lsb, message_code_bits);
    const auto data = static_cast<std::uint32_t>(word >> hls::word_bits);
    switch (kind) {
        case hls::message_fence:
            return fmt::format("fence {}", decode_header(data).flags);
        case hls::message_error:
            return fmt::format("error {} ({}) for header 0x{:08x}", code, error_name(code), data);
        case hls::message_query:
            return fmt::format("query reply word {}: 0x{:08x}", code, data);
        default:
            return fmt::format("message of unknown kind {}: 0x{:016x}", kind, word);
    }
}

}  // namespace sheen
