// SPDX-License-Identifier: MIT
/// \file
/// A device that is a simulator: a program beside the command that plays beats into the VHDL core and writes what comes
/// out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sheen/device.hpp"

namespace sheen {

/// How a simulator's streams pause. The data that comes out never depends on it.
struct Stalls {
    int source_percent = 0;  ///< clocks in which no beat is offered, 0…99
    int sink_percent = 0;    ///< clocks in which no word is taken, 0…99
    std::uint32_t seed = 1;
};

class SimulatorDevice : public Device {
 public:
    /// \param name           `ghdl`, `verilator`, or either followed by `-` and a core configuration that is built
    /// \param words_per_beat the setup stream of that configuration: 1, 2 or 4
    /// \throws Error when the program isn't there.
    SimulatorDevice(std::string name, int words_per_beat, Stalls stalls = {});
    [[nodiscard]] std::string name() const override { return name_; }
    RunResult run(const std::vector<std::uint32_t>& packets) override;

 private:
    std::string name_;
    std::string program_;
    int words_per_beat_;
    Stalls stalls_;
};

}  // namespace sheen
