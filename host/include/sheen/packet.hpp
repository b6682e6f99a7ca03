// SPDX-License-Identifier: MIT
/// \file
/// The packet protocol (docs/packet-protocol.md): setups to 32-bit words, 64-bit words to pixels and messages, and both
/// as files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sheen/method.hpp"

namespace sheen {

/// Appends one triangle packet (header and payload).
void append_triangle(std::vector<std::uint32_t>& words, const TriangleSetup& setup);
/// Appends a material packet. \throws Error when a field is out of range.
void append_material(std::vector<std::uint32_t>& words, const MaterialSetup& material);
/// Reads a material packet back. `words` starts at the header. \throws Error when it isn't one.
MaterialSetup decode_material(const std::uint32_t* words, std::size_t count);
/// Appends a table packet: what the power tables hold from then on. \throws Error unless there are 1024 entries.
void append_table(std::vector<std::uint32_t>& words, const std::vector<std::uint8_t>& entries);

/// Appends a fence packet; its header comes back in the echo. `tag` (0…255) travels in the flags.
void append_fence(std::vector<std::uint32_t>& words, int tag = 0);
/// Appends a query packet.
void append_query(std::vector<std::uint32_t>& words);

/// Fields of a packet header.
struct PacketHeader {
    int opcode = 0;
    int flags = 0;
    int length = 0;  ///< payload words
};
PacketHeader decode_header(std::uint32_t word);

/// Reads a triangle packet back (the inverse of append_triangle). `words` starts at the header.
/// \throws Error when opcode, flags or length do not fit together.
TriangleSetup decode_triangle(const std::uint32_t* words, std::size_t count);

/// A word of the output stream, in fields.
struct Pixel {
    int x = 0;
    int y = 0;
    int depth = 0;
    int red = 0;
    int green = 0;
    int blue = 0;
};
Pixel decode_pixel(std::uint64_t word);
std::uint64_t encode_pixel(const Pixel& pixel);
/// True for a word that is no pixel (x = 4095).
bool is_message(std::uint64_t word);
/// A message in words: "error 2 (bad length) for header 0x03010001", "fence 7", "query reply …".
std::string describe_message(std::uint64_t word);

/// Reads a packet file: little-endian 32-bit words. \throws Error naming the file when it is missing, unreadable or its
/// size is no multiple of 4.
std::vector<std::uint32_t> read_packet_file(const std::string& path);
/// Writes whole or not at all (temporary name, then rename). \throws Error naming the file.
void write_packet_file(const std::string& path, const std::vector<std::uint32_t>& words);
/// Little-endian 64-bit words. \throws Error as above.
std::vector<std::uint64_t> read_pixel_file(const std::string& path);
void write_pixel_file(const std::string& path, const std::vector<std::uint64_t>& words);

}  // namespace sheen
