// SPDX-License-Identifier: MIT
/// \file
/// The kernels as a device: shading_core's steps, one call a clock, in this process.
#pragma once

#include "sheen/device.hpp"

namespace sheen {

class HlsDevice : public Device {
 public:
    [[nodiscard]] std::string name() const override { return "hls"; }
    /// Untimed: the result has no cycles.
    RunResult run(const std::vector<std::uint32_t>& packets) override;
};

}  // namespace sheen
