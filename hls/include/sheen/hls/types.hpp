// SPDX-License-Identifier: MIT
/// \file
/// The named records that flow between units, and their number types. One name in C++, VHDL and docs.
#pragma once

#include "sheen/hls/formats.hpp"
#include "sheen/hls/select.hpp"

namespace sheen::hls {

using bit_t = ac_int<1, false>;
using word_t = ac_int<word_bits, false>;
using phase_t = ac_int<phase_bits, false>;
/// x, y, lengths, row counts and their steps: modulo 2^12.
using coordinate_t = ac_int<coordinate_bits, false>;
using pixel_word_t = ac_int<pixel_bits, false>;
using component_t = ac_int<component_bits, false>;

/// Channel values, in 8-bit steps (colour), octaves or 16ths of a cosine (log) and 16-bit steps (depth); all sums wrap,
/// as contract 1 wants.
using colour_value_t = ac_fixed<word_bits, colour_integer_bits, true, AC_TRN, AC_WRAP>;
using log_value_t = ac_fixed<word_bits, log_integer_bits, true, AC_TRN, AC_WRAP>;
using depth_value_t = ac_fixed<word_bits, depth_integer_bits, false, AC_TRN, AC_WRAP>;

/// What the packet decoder hands over per job: a triangle, or a message that keeps its place between triangles.
struct job_t {
    bit_t valid = 0;
    bit_t message = 0;   ///< no triangle: answer with a message word
    bit_t leftward = 0;  ///< triangle flags
    bit_t linear = 0;
    bit_t depth = 0;
    ac_int<flag_log_channels_bits, false> log = 0;  ///< number of log channels
    ac_int<2, false> code = 0;                      ///< message: error code, 0 for the answer to a fence or a query
    word_t header = 0;                              ///< message: the header it answers
};

/// The geometry fields of a triangle packet.
struct geometry_t {
    coordinate_t x = 0, y = 0, rows_above = 0, rows_below = 0, kappa = 0, length = 0, m = 0, length_reload = 0,
                 m_below = 0;
    phase_t long_phase = 0, long_step = 0, upper_phase = 0, upper_step = 0, lower_phase = 0, lower_step = 0;
};

/// A span, or a message on its way through the span queue.
///
/// A message carries header bits 11–0 in x and 23–12 in y; its length is 4 for a query (whose x then counts the words
/// of the reply) and {opcode, 00, code} for the one word of an error or a fence echo.
struct span_t {
    coordinate_t x = 0, y = 0, length = 0;
    bit_t single = 0;    ///< one word long
    bit_t leftward = 0;  ///< x decreases
    bit_t first = 0;     ///< first span of its triangle: the span part takes over the triangle's constants
    bit_t message = 0;
};

/// Commands of the edge walker to the start-edge part of every forward difference. A carry comes in the clock after its
/// step, the first step not before the second clock after a load.
struct edge_command_t {
    bit_t load = 0;    ///< take over the six words
    bit_t linear = 0;  ///< with load: h, dD, dE are 0
    bit_t depth = 0;   ///< with load: the packet has a depth channel (else its value is 0)
    bit_t step = 0;    ///< one row down: I += E, E += dE, D += dD
    bit_t carry = 0;   ///< with step, one pixel along instead: I += D, D += h, E += dD
};

/// Commands of the span walker to the span part of every forward difference.
struct span_command_t {
    bit_t load = 0;   ///< start the span at the head of the queue
    bit_t first = 0;  ///< with load: take over h (and a linear channel's D)
    bit_t step = 0;   ///< I += D, D += h
};

/// A word of a power table on its way into the bank that is not read: four entries u8.0, the first in the low bits.
struct table_write_t {
    bit_t valid = 0;
    bit_t bank = 0;
    ac_int<power_word_bits, false> address = 0;
    word_t data = 0;
};

/// What a material packet says, cut to what the datapath keeps.
struct material_t {
    ac_int<component_bits + colour_sum_fraction_bits, false> red = 0, green = 0, blue = 0;  ///< ambient, u8.4
    ac_int<max_log_channels, false> power = 0;  ///< bit k: log channel k is a cosine, for power_rom
};

/// A pixel position or a message word on its way to the colour stage.
struct fragment_t {
    bit_t valid = 0;
    bit_t message = 0;
    bit_t query = 0;                                ///< message: word x of a query reply
    ac_int<flag_log_channels_bits, false> log = 0;  ///< pixel: log channels of its triangle
    coordinate_t x = 0, y = 0;
    coordinate_t tail = 0;  ///< message: {opcode, 00, code}
};

}  // namespace sheen::hls
