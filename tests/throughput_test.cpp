// SPDX-License-Identifier: MIT
/// \file
/// Pixels per clock that the core must reach, setup stream included, on Verilator: quadratic RGB with depth,
/// equilateral triangles at random rotation and position.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sheen/simulator_device.hpp"
#include "support/shaped_triangles.hpp"

namespace sheen {
namespace {

struct Demand {
    const char* device;
    int words_per_beat;
    int area;  ///< pixels
    double pixels_per_clock;
};

class Throughput : public testing::TestWithParam<Demand> {};

TEST_P(Throughput, OfEquilateralTrianglesAtRandomRotation) {
    const Demand& demand = GetParam();
    test::Rng rng(20262);
    const int count = std::max(200, 40'000 / demand.area);
    const auto packets = test::shaped_packets(rng, test::Shape::equilateral, demand.area, count, {});
    const RunResult result = SimulatorDevice(demand.device, demand.words_per_beat).run(packets);
    const double measured = static_cast<double>(result.words.size()) / static_cast<double>(result.cycles.value());
    fmt::print("{} triangles of {} px, {}-bit stream: {:.4f} pixels per clock, {} demanded\n", count, demand.area,
               32 * demand.words_per_beat, measured, demand.pixels_per_clock);
    EXPECT_GE(measured, demand.pixels_per_clock);
    EXPECT_LE(measured, 1) << "one lane gives one pixel a clock";
}

INSTANTIATE_TEST_SUITE_P(Equilateral, Throughput,
                         testing::Values(Demand{"verilator", 2, 10, 0.60}, Demand{"verilator", 2, 50, 0.98},
                                         Demand{"verilator", 2, 200, 0.99}, Demand{"verilator", 2, 1000, 0.99},
                                         Demand{"verilator-w128", 4, 10, 0.95}),
                         [](const auto& test) {
                             return fmt::format("{}pxOn{}Bits", test.param.area, 32 * test.param.words_per_beat);
                         });

}  // namespace
}  // namespace sheen
