// SPDX-License-Identifier: MIT
/// \file
/// make_bell_rom OUTDIR: writes OUTDIR/bell_rom_pkg.vhd, the tables of bell_rom for the VHDL side.
///
/// The entries are the constexpr arrays of bell_table.hpp, which the kernel reads too. A new table is one more line in
/// `write_package`. Each is headed by its two error figures in units of the entry's last place (LSB): the bound that
/// follows from the formula, and the largest error found over 64 angles a bin, both ends included.
/// Exit status: 0 written, 1 the file could not be written, 2 wrong arguments.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "sheen/hls/bell_table.hpp"
#include "sheen/hls/formats.hpp"

namespace {

constexpr double half_pi = 1.57079632679489661923;

struct Table {
    int quadrant_bits;
    int data_bits;
    int exponent_tenths;
    std::vector<int> entries;
    std::string purpose;

    std::string name() const {
        return "table_q" + std::to_string(quadrant_bits) + "_d" + std::to_string(data_bits) + "_p" +
               std::to_string(exponent_tenths);
    }
    double full_scale() const { return std::exp2(data_bits) - 1.0; }
    double exponent() const { return exponent_tenths / 10.0; }
};

template <int quadrant_bits, int data_bits, int exponent_tenths>
Table make_table(std::string purpose) {
    const auto& entries = sheen::hls::bell_table<quadrant_bits, data_bits, exponent_tenths>;
    return {quadrant_bits, data_bits, exponent_tenths, {entries.begin(), entries.end()}, std::move(purpose)};
}

/// ½ LSB of rounding and half a bin at the steepest slope of cos^p, √p·((p−1)/p)^((p−1)/2), in LSB.
double error_bound(const Table& table) {
    const double p = table.exponent();
    const double slope = std::sqrt(p) * std::pow((p - 1.0) / p, (p - 1.0) / 2.0);
    return 0.5 + table.full_scale() * slope * (half_pi / 2.0) / std::exp2(table.quadrant_bits);
}

/// The largest |entry − full scale · cos^p ξ| over the bins, ends included, in LSB.
double measured_error(const Table& table) {
    constexpr int samples = 64;
    double worst = 0.0;
    for (std::size_t bin = 0; bin < table.entries.size(); ++bin) {
        for (int i = 0; i <= samples; ++i) {
            const double bins = static_cast<double>(bin) + static_cast<double>(i) / samples;
            const double cosine = std::max(0.0, std::cos(bins * half_pi / std::exp2(table.quadrant_bits)));
            const double exact = table.full_scale() * std::pow(cosine, table.exponent());
            worst = std::max(worst, std::abs(table.entries[bin] - exact));
        }
    }
    return worst;
}

std::string decimals(double value, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

void write_table(std::ostream& out, const Table& table) {
    constexpr std::size_t per_line = 16;
    out << "\n  -- cos^" << decimals(table.exponent(), 1) << ", " << table.entries.size() << " bins a quadrant, "
        << table.data_bits << " bits: " << table.purpose << ".\n  -- Error over each bin: bound "
        << decimals(error_bound(table), 3) << " LSB, measured " << decimals(measured_error(table), 3)
        << " LSB.\n  constant " << table.name() << " : bell_table_t(0 to " << table.entries.size() - 1 << ") := (";
    for (std::size_t k = 0; k < table.entries.size(); ++k) {
        out << (k % per_line == 0 ? "\n    " : " ") << table.entries[k] << (k + 1 < table.entries.size() ? "," : "");
    }
    out << "\n  );\n";
}

void write_selection(std::ostream& out, const std::vector<Table>& tables) {
    out << "\n  function bell_table(quadrant_bits, data_bits, exponent_tenths : positive) return bell_table_t is\n"
        << "  begin\n";
    const char* keyword = "    if ";
    for (const Table& table : tables) {
        out << keyword << "quadrant_bits = " << table.quadrant_bits << " and data_bits = " << table.data_bits
            << " and exponent_tenths = " << table.exponent_tenths << " then\n      return " << table.name() << ";\n";
        keyword = "    elsif ";
    }
    out << "    end if;\n"
        << "    assert false\n"
        << "      report \"bell_table: no table of quadrant_bits=\" & integer'image(quadrant_bits) & \", data_bits=\" "
           "&\n"
        << "        integer'image(data_bits) & \", exponent_tenths=\" & integer'image(exponent_tenths) &\n"
        << "        \"; add it to hls/tools/make_bell_rom.cpp\"\n"
        << "      severity failure;\n"
        << "    return (0 to 2 ** quadrant_bits - 1 => 0);\n"
        << "  end function;\n";
}

void write_package(std::ostream& out) {
    namespace hls = sheen::hls;
    constexpr int paper_quadrant_bits = hls::paper_rom_address_bits - 1;  // its ROM holds both halves
    const std::vector<Table> tables = {
        make_table<paper_quadrant_bits, hls::paper_rom_data_bits, 20>("preset paper, specular, 6x6 with both halves"),
        make_table<paper_quadrant_bits, hls::paper_rom_data_bits, 10>("preset paper, diffuse, 6x6 with both halves"),
        make_table<3, 4, 20>("preset 4-bit (figure 15), specular, 4x4 with both halves"),
        make_table<3, 4, 10>("preset 4-bit (figure 15), diffuse, 4x4 with both halves"),
        make_table<8, 8, 95>("specular, 8x8 folded"),
        make_table<8, 8, 10>("diffuse, 8x8 folded"),
    };
    out << "-- SPDX-License-Identifier: MIT\n"
        << "-- Generated by `make_bell_rom rtl_vhdl/generated`; do not edit: change hls/tools/make_bell_rom.cpp.\n"
        << "--\n"
        << "-- The tables of bell_rom: one quadrant of cos^p each, p = exponent_tenths / 10. Entry k is\n"
        << "-- round((2**data_bits - 1) * cos^p((k + 1/2) * (pi/2) / 2**quadrant_bits)), so that the full scale\n"
        << "-- 2**data_bits - 1 stands for 1. One LSB is 1 / (2**data_bits - 1).\n\n"
        << "package bell_rom_pkg is\n\n"
        << "  type bell_table_t is array (natural range <>) of natural;\n\n"
        << "  -- The quadrant 0 to pi/2 of cos^(exponent_tenths/10); a failure names a table that does not exist.\n"
        << "  function bell_table(quadrant_bits, data_bits, exponent_tenths : positive) return bell_table_t;\n\n"
        << "end package;\n\n"
        << "package body bell_rom_pkg is\n";
    for (const Table& table : tables) {
        write_table(out, table);
    }
    write_selection(out, tables);
    out << "\nend package body;\n";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: make_bell_rom OUTDIR\n";
        return 2;
    }
    const std::string path = std::string(argv[1]) + "/bell_rom_pkg.vhd";
    std::ofstream file(path);
    write_package(file);
    file.close();
    if (!file) {
        std::cerr << "make_bell_rom: cannot write " << path << "; OUTDIR must be a writable folder\n";
        return 1;
    }
    return 0;
}
