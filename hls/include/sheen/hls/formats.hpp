// SPDX-License-Identifier: MIT
/// \file
/// Every width, format, opcode and table size of Sheen, stated once.
///
/// The kernels, the host library and the tests include this header; the VHDL package
/// rtl_vhdl/generated/sheen_constants_pkg.vhd is generated from it (`make generate`) and checked for freshness
/// by `make test`. Formats are written <W,I>: W bits of which I are integer bits (sign included).
#pragma once

namespace sheen::hls {

// ---- Protocol -----------------------------------------------------------------------------------------------
/// Version of the packet protocol, as a core reports it to a query.
inline constexpr int protocol_version = 1;
/// Version of the cores: major · 2^16 + minor · 2^8 + patch.
inline constexpr int core_version = 0x000100;
/// A stream word; word k of a beat is bits 32k+31…32k.
inline constexpr int word_bits = 32;
/// A pixel or message word on the output stream.
inline constexpr int pixel_bits = 64;

inline constexpr int opcode_query = 0;
inline constexpr int opcode_table = 1;
inline constexpr int opcode_material = 2;
inline constexpr int opcode_triangle = 3;
inline constexpr int opcode_spans = 4;
inline constexpr int opcode_fence = 5;

/// Header fields: opcode in bits 31–24, flags in 23–16, number of payload words in 15–0.
inline constexpr int header_opcode_lsb = 24;
inline constexpr int header_flags_lsb = 16;
inline constexpr int header_length_bits = 16;
/// Triangle flags, as header bit numbers.
inline constexpr int flag_leftward_bit = 16;
inline constexpr int flag_linear_bit = 17;
inline constexpr int flag_depth_bit = 18;
inline constexpr int flag_log_channels_lsb = 19;
inline constexpr int flag_log_channels_bits = 2;
/// Material flag, as a header bit number: the packet's tints count.
inline constexpr int flag_tinted_bit = 16;

/// A word whose x equals this is a message, not a pixel; its y is the kind.
inline constexpr int message_x = 4095;
inline constexpr int message_fence = 0;
inline constexpr int message_error = 1;
inline constexpr int message_query = 2;
/// Error codes, in bits 31–24 of an error word; its bits 63–32 are the offending header.
inline constexpr int error_unknown_opcode = 1;
inline constexpr int error_bad_length = 2;
inline constexpr int error_unsupported = 3;
/// Words in the reply to a query.
inline constexpr int query_reply_words = 4;

// ---- Geometry -----------------------------------------------------------------------------------------------
/// x, y, row counts, span lengths and their steps: 12-bit fields, modulo 2^12.
inline constexpr int coordinate_bits = 12;
/// Greatest width and height of a triangle that the full formats serve, in pixels.
inline constexpr int max_extent = 4095;
/// Fraction bits of a snapped vertex coordinate: 1/256 pixel.
inline constexpr int subpixel_bits = 8;
/// Phase accumulators of the edge walker; 32 serve 4095 rows (docs/number-formats.md).
inline constexpr int phase_bits = 32;
/// The nine geometry fields (x, y, rows above, rows below, κ, L, m, L reloaded, m below) fill four words.
inline constexpr int geometry_fields = 9;
inline constexpr int geometry_words = 4;
/// (P, step) of the long, the upper and the lower edge.
inline constexpr int phase_words = 6;

// ---- Channels -----------------------------------------------------------------------------------------------
/// Words of a quadratic channel {I, D, E, h, dD, dE}, and of a linear one {I, D, E}.
inline constexpr int quadratic_words = 6;
inline constexpr int linear_words = 3;
inline constexpr int colour_channels = 3;
inline constexpr int max_log_channels = 3;
/// Colour: signed <32,10>, in 8-bit steps; nodes stay within ±306 (the quadratic overshoots by 5/3).
inline constexpr int colour_integer_bits = 10;
inline constexpr int colour_fraction_bits = word_bits - colour_integer_bits;
inline constexpr int colour_node_limit = 306;
/// Log-specular: signed <32,8>.
inline constexpr int log_integer_bits = 8;
inline constexpr int log_fraction_bits = word_bits - log_integer_bits;
/// Depth: unsigned <32,16>.
inline constexpr int depth_integer_bits = 16;
inline constexpr int depth_fraction_bits = word_bits - depth_integer_bits;

// ---- Highlights -----------------------------------------------------------------------------------------------
/// A material packet: fields of 12 bits, contiguous from bit 0: ambient red, green, blue; the log channels' kinds;
/// three tints a log channel.
inline constexpr int material_field_bits = 12;
inline constexpr int material_fields = 13;
inline constexpr int material_words = 5;
/// Ambient: unsigned <12,8>, in 8-bit steps, with the ½ of rounding folded in.
inline constexpr int ambient_fraction_bits = 4;
/// Tint: unsigned <12,4>, added to z.
inline constexpr int tint_fraction_bits = 8;
/// Fraction bits of the sum of diffuse, ambient and highlights, before it is cut to 8 bits.
inline constexpr int colour_sum_fraction_bits = 4;
/// The table of exp2_rom: one octave of 2^address_bits entries.
inline constexpr int exp2_address_bits = 6;
inline constexpr int exp2_data_bits = 8;
/// The table of power_rom: 2^address_bits entries of 8 bits; the paper's 1 KB. Its argument is 16·cos.
inline constexpr int power_address_bits = 10;
inline constexpr int power_integer_bits = 4;
/// Four entries a word; a table packet holds 2^power_word_bits words.
inline constexpr int power_word_bits = power_address_bits - 2;
inline constexpr int power_words = 1 << power_word_bits;

/// Clocks of highlight_stage, and one more for each log channel.
inline constexpr int highlight_latency = 4;

// ---- Pixel word, from bit 0 up --------------------------------------------------------------------------------
inline constexpr int pixel_x_lsb = 0;
inline constexpr int pixel_y_lsb = 12;
inline constexpr int pixel_depth_lsb = 24;
inline constexpr int pixel_red_lsb = 40;
inline constexpr int pixel_green_lsb = 48;
inline constexpr int pixel_blue_lsb = 56;
inline constexpr int component_bits = 8;
inline constexpr int depth_bits = 16;

// ---- Queues ---------------------------------------------------------------------------------------------------
/// Spans that the edge walker may be ahead of the span walker (log₂).
inline constexpr int span_queue_log2 = 4;
/// Places kept free for what the edge walker has under way when it sees the queue full.
inline constexpr int span_queue_reserve = 2;
/// Pixels between the colour stage and the output stream (log₂).
inline constexpr int pixel_queue_log2 = 5;
/// Places kept free for the fragments under way when the span walker is stopped.
inline constexpr int pixel_queue_reserve = 10;

// ---- Paper `spherical`: line interpolator and bell ROM, preset `paper` ------------------------------------------
inline constexpr int paper_phase_bits = 12;
inline constexpr int paper_rom_address_bits = 6;
inline constexpr int paper_rom_data_bits = 6;

}  // namespace sheen::hls
