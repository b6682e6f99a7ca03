// SPDX-License-Identifier: MIT
#include "sheen/exponent_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sheen/error.hpp"

namespace sheen {
namespace {

constexpr double full_scale = 255.0;  // of a byte

}  // namespace

ExponentTable::ExponentTable(double shininess, std::size_t bytes) {
    if (bytes < least_bytes || bytes > most_bytes) {
        throw UsageError(fmt::format("exponent table of {} bytes: give {} to {}", bytes, least_bytes, most_bytes));
    }
    entries_.assign(bytes, 0);
    const auto last = static_cast<double>(bytes - 1);
    // From the top down, until the power is too small for a byte.
    for (std::size_t k = bytes; k-- > 0;) {
        const double power = std::pow(static_cast<double>(k) / last, shininess);
        entries_[k] = static_cast<std::uint8_t>(std::lround(full_scale * power));
        if (entries_[k] == 0) break;
    }
}

double ExponentTable::read(double cosine) const {
    const double address = std::clamp(cosine, 0.0, 1.0) * static_cast<double>(entries_.size() - 1) + 0.5;
    return entries_[static_cast<std::size_t>(address)] / full_scale;
}

double ExponentTable::sampling_error(double shininess, std::size_t bytes) {
    return 1.0 - std::pow(1.0 - 0.5 / static_cast<double>(bytes - 1), shininess);
}

}  // namespace sheen
