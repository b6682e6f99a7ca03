// SPDX-License-Identifier: MIT
/// \file
/// The contents of every exp2 table: integers, computed by the compiler.
///
/// A table holds one octave of 2^(8 − z) for z in 0…1, in 8-bit steps. Its 2^address_bits bins divide the octave
/// evenly; entry k is the value at the bin's centre, rounded to nearest, with data_bits − 8 fraction bits, and at most
/// 2^data_bits − 1:
///
///     entry(k) = min(2^data_bits − 1, round(2^data_bits · 2^(−(k + ½) / 2^address_bits))).
///
/// hls/tools/make_exp2_rom writes the same arrays to rtl_vhdl/generated/exp2_rom_pkg.vhd, so kernel and VHDL cannot
/// differ. Sheen's own method (docs/methods.md, log-quadratic).
#pragma once

#include <array>
#include <cstdint>

#include "sheen/hls/table_math.hpp"

namespace sheen::hls {

template <int address_bits>
using exp2_table_t = std::array<std::uint16_t, (1U << address_bits)>;

template <int address_bits, int data_bits>
constexpr exp2_table_t<address_bits> make_exp2_table() {
    static_assert(address_bits >= 1 && address_bits <= 10, "an octave has 2 to 1024 bins: 1 <= address_bits <= 10");
    static_assert(data_bits >= 8 && data_bits <= 12, "an entry has 8 <= data_bits <= 12");
    constexpr double ln_2 = 0.69314718055994530942;
    constexpr int greatest = (1U << data_bits) - 1;
    exp2_table_t<address_bits> table{};
    for (std::size_t k = 0; k < table.size(); ++k) {
        const double octaves = (static_cast<double>(k) + 0.5) / (1 << address_bits);
        const double exact = (1 << data_bits) * table_math::exponential(-octaves * ln_2);
        const int below = static_cast<int>(exact);
        const int nearest = exact - below < 0.5 ? below : below + 1;
        table[k] = static_cast<std::uint16_t>(nearest < greatest ? nearest : greatest);
    }
    return table;
}

template <int address_bits, int data_bits>
inline constexpr exp2_table_t<address_bits> exp2_table = make_exp2_table<address_bits, data_bits>();

}  // namespace sheen::hls
