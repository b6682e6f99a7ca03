// SPDX-License-Identifier: MIT
/// \file
/// Powers by table, paper `fast-phong`: cos^n from a memory that a scaled series addresses directly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sheen {

/// N bytes: entry k holds 255·(k/(N−1))^n, rounded. A cosine is rounded to the nearest entry, so that 1 reads 255
/// exactly; below 0 and above 1 the end entries answer. The cells next to 1 are the worst: without the rounding to a
/// byte (at most 1/510 more) the error is sampling_error().
class ExponentTable {
 public:
    static constexpr std::size_t least_bytes = 2;
    static constexpr std::size_t most_bytes = std::size_t{1} << 20;

    /// \throws UsageError unless `bytes` is in least_bytes…most_bytes. `shininess` n ≥ 0.
    ExponentTable(double shininess, std::size_t bytes);
    /// cos^n, 0…1.
    [[nodiscard]] double read(double cosine) const;
    [[nodiscard]] const std::vector<std::uint8_t>& entries() const { return entries_; }

    /// 1 − (1 − ½/(N−1))^n: half a cell below 1, for n ≥ 1. Below 1 % for N = 1024 up to n = 20 and for N = 8192 up to
    /// n = 164, the two figures that the paper states.
    static double sampling_error(double shininess, std::size_t bytes);

 private:
    std::vector<std::uint8_t> entries_;
};

}  // namespace sheen
