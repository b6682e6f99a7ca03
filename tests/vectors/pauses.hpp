// SPDX-License-Identifier: MIT
/// \file
/// Random pauses for vector programs: stretches of 1 to 64 clocks in which a side never, sometimes or always pauses, so
/// that queues run empty and full.
#pragma once

#include <algorithm>
#include <array>
#include <random>

namespace sheen::test {

class Pauses {
 public:
    /// \param percent chance of a pause, on average where it is at most 50; 0: never
    explicit Pauses(int percent) : chances_{0, percent, std::min(2 * percent, 100)} {}

    /// True when the side pauses in this clock.
    bool pause(std::mt19937_64& random) {
        if (left_ == 0) {
            left_ = 1 + static_cast<int>(random() % 64);
            chance_ = chances_[random() % chances_.size()];
        }
        --left_;
        return static_cast<int>(random() % 100) < chance_;
    }

 private:
    std::array<int, 3> chances_;
    int chance_ = 0;
    int left_ = 0;
};

}  // namespace sheen::test
