// SPDX-License-Identifier: MIT
// The exponent table of paper fast-phong: its entries, how it is addressed, and the sizes that the paper states.
#include "sheen/exponent_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "sheen/error.hpp"

namespace sheen::test {
namespace {

/// The largest |table − cos^n|, at both ends of every cell, where the error of a monotone function is largest.
double worst_error(const ExponentTable& table, double shininess) {
    double worst = 0.0;
    const auto last = static_cast<double>(table.entries().size() - 1);
    for (std::size_t k = 0; k < table.entries().size(); ++k) {
        for (const double side : {-0.5 + 1e-9, 0.0, 0.5 - 1e-9}) {
            const double cosine = std::clamp((static_cast<double>(k) + side) / last, 0.0, 1.0);
            worst = std::max(worst, std::abs(table.read(cosine) - std::pow(cosine, shininess)));
        }
    }
    return worst;
}

TEST(ExponentTable, OneKilobyteServesPowersTo20AndEightServe164WithinOnePercent) {
    const auto greatest_power = [](std::size_t bytes) {
        int n = 1;
        while (ExponentTable::sampling_error(n + 1, bytes) < 0.01) ++n;
        return n;
    };
    EXPECT_EQ(greatest_power(1024), 20);
    EXPECT_EQ(greatest_power(8192), 164);
}

TEST(ExponentTable, ErrorIsTheSamplingErrorAndAtMostHalfAByteStep) {
    constexpr double half_step = 0.5 / 255.0;
    for (const std::size_t bytes : {64U, 256U, 1024U, 8192U}) {
        for (const double shininess : {1.0, 2.0, 5.0, 12.5, 20.0, 50.0, 164.0, 1000.0}) {
            const double sampling = ExponentTable::sampling_error(shininess, bytes);
            const double worst = worst_error(ExponentTable(shininess, bytes), shininess);
            // A power of 1 or more is steepest next to 1: the half cell there is the worst.
            EXPECT_LE(worst, sampling + half_step) << bytes << " bytes, n = " << shininess;
            EXPECT_GE(worst, sampling - half_step) << bytes << " bytes, n = " << shininess;
        }
    }
    const double at_20 = worst_error(ExponentTable(20, 1024), 20);
    const double at_164 = worst_error(ExponentTable(164, 8192), 164);
    std::cout << "with byte entries: n = 20 in 1 KB " << 100 * at_20 << " %, n = 164 in 8 KB " << 100 * at_164
              << " %\n";
}

TEST(ExponentTable, EntriesAreRoundedPowersAndReadsRoundToTheNearest) {
    for (const double shininess : {0.0, 0.5, 3.0, 50.0, 1000.0}) {
        const ExponentTable table(shininess, 300);
        ASSERT_EQ(table.entries().size(), 300U);
        for (std::size_t k = 0; k < 300; ++k) {
            const double cosine = static_cast<double>(k) / 299.0;
            EXPECT_EQ(table.entries()[k], std::lround(255.0 * std::pow(cosine, shininess))) << k;
            for (const double offset : {-0.49, 0.0, 0.49}) {
                EXPECT_EQ(table.read(cosine + offset / 299.0), table.entries()[k] / 255.0) << k;
            }
        }
        EXPECT_EQ(table.read(1.0), 1.0);
        EXPECT_EQ(table.read(7.5), 1.0);
        EXPECT_EQ(table.read(-3.0), table.entries()[0] / 255.0);
    }
}

TEST(ExponentTable, SizesOutOfRangeAreAnsweredWithTheRange) {
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, ExponentTable::most_bytes + 1}) {
        try {
            const ExponentTable table(5.0, bytes);
            ADD_FAILURE() << bytes << " bytes accepted";
        } catch (const UsageError& error) {
            EXPECT_EQ(std::string(error.what()),
                      "exponent table of " + std::to_string(bytes) + " bytes: give 2 to 1048576");
        }
    }
    EXPECT_EQ(ExponentTable(5.0, ExponentTable::least_bytes).entries().back(), 255);
}

}  // namespace
}  // namespace sheen::test
