// SPDX-License-Identifier: MIT
/// \file
/// The contents of every bell table: integers, computed by the compiler.
///
/// A bell table holds one quadrant of cos^p. Its 2^quadrant_bits bins divide 0…π/2 evenly, entry k is the value at the
/// bin's centre, rounded to nearest, and the full scale 2^data_bits − 1 stands for 1:
///
///     entry(k) = round((2^data_bits − 1) · cos^p((k + ½)·(π/2) / 2^quadrant_bits)),    p = exponent_tenths / 10.
///
/// Real numbers exist here only while the compiler works; a kernel sees an array of integers. hls/tools/make_bell_rom
/// writes the same arrays to rtl_vhdl/generated/bell_rom_pkg.vhd, so kernel and VHDL cannot differ.
///
/// Paper `spherical`: figure 11 and eq. 19 (p = 2); the diffuse part reads p = 1; any p ≥ 1 may be asked for.
#pragma once

#include <array>
#include <cstdint>

#include "sheen/hls/table_math.hpp"

namespace sheen::hls {

template <int quadrant_bits>
using bell_table_t = std::array<std::uint16_t, (1U << quadrant_bits)>;

/// The quadrant 0…π/2 of cos^p, p = exponent_tenths / 10.
template <int quadrant_bits, int data_bits, int exponent_tenths>
constexpr bell_table_t<quadrant_bits> make_bell_table() {
    static_assert(quadrant_bits >= 1 && quadrant_bits <= 12, "a quadrant has 2 to 4096 bins: 1 <= quadrant_bits <= 12");
    static_assert(data_bits >= 1 && data_bits <= 16, "an entry has 1 <= data_bits <= 16");
    static_assert(exponent_tenths >= 10 && exponent_tenths <= 1000, "the base is cos to cos^100: 10 to 1000 tenths");
    bell_table_t<quadrant_bits> table{};
    for (std::size_t k = 0; k < table.size(); ++k) {
        const double centre = (static_cast<double>(k) + 0.5) * table_math::half_pi / (1 << quadrant_bits);
        const double log_cosine = table_math::logarithm(table_math::cosine(centre));
        const double value = table_math::exponential(log_cosine * exponent_tenths / 10.0);
        const double exact = ((1 << data_bits) - 1) * value;
        const int below = static_cast<int>(exact);
        table[k] = static_cast<std::uint16_t>(exact - below < 0.5 ? below : below + 1);
    }
    return table;
}

template <int quadrant_bits, int data_bits, int exponent_tenths>
inline constexpr bell_table_t<quadrant_bits> bell_table = make_bell_table<quadrant_bits, data_bits, exponent_tenths>();

/// Both halves −π/2…π/2 in the order of a two's complement address: 0…π/2 first, then −π/2…0. cos is even and bins
/// lie symmetrically about 0, so bin −1 − k, which is NOT k, repeats bin k.
template <int quadrant_bits, int data_bits, int exponent_tenths>
constexpr bell_table_t<quadrant_bits + 1> make_whole_bell_table() {
    constexpr const auto& quadrant = bell_table<quadrant_bits, data_bits, exponent_tenths>;
    bell_table_t<quadrant_bits + 1> table{};
    for (std::size_t k = 0; k < quadrant.size(); ++k) {
        table[k] = quadrant[k];
        table[table.size() - 1 - k] = quadrant[k];
    }
    return table;
}

template <int quadrant_bits, int data_bits, int exponent_tenths>
inline constexpr bell_table_t<quadrant_bits + 1> whole_bell_table =
    make_whole_bell_table<quadrant_bits, data_bits, exponent_tenths>();

}  // namespace sheen::hls
