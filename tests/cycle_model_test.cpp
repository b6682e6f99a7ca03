// SPDX-License-Identifier: MIT
/// \file
/// The cycle model against the VHDL on Verilator, every stream width. Clocks are counted, not timed: the same
/// everywhere.
#include "sheen/cycle_model.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "sheen/error.hpp"
#include "sheen/render.hpp"
#include "support/shaped_triangles.hpp"

namespace sheen {
namespace {

/// Where streams pause, the model draws other pauses than the bench.
constexpr double bound_percent = 1;
constexpr double bound_percent_of_pauses = 2;
constexpr std::uint64_t seed = 20261;

struct Width {
    const char* device;
    int words_per_beat;
};
constexpr Width widths[] = {{"verilator-w32", 1}, {"verilator", 2}, {"verilator-w128", 4}};

/// Compares model and simulation, and keeps the worst.
class Comparison {
 public:
    explicit Comparison(Stalls stalls = {})
        : stalls_(stalls),
          bound_(stalls.source_percent + stalls.sink_percent == 0 ? bound_percent : bound_percent_of_pauses) {}

    void compare(const std::string& what, const std::vector<std::uint32_t>& packets) {
        for (const Width& width : widths) {
            const auto simulated = static_cast<double>(
                SimulatorDevice(width.device, width.words_per_beat, stalls_).run(packets).cycles.value());
            const auto predicted = static_cast<double>(predict_cycles(packets, width.words_per_beat, stalls_));
            const double percent = 100 * (predicted / simulated - 1);
            const std::string where = fmt::format("{}, {} bits", what, 32 * width.words_per_beat);
            EXPECT_LE(std::abs(percent), bound_)
                << where << ": " << predicted << " clocks predicted, " << simulated << " simulated";
            if (std::abs(percent) >= std::abs(worst_)) {
                worst_ = percent;
                worst_where_ = where;
            }
        }
    }

    ~Comparison() {
        fmt::print("worst deviation of the cycle model: {:+.3f} % ({}); bound {} %\n", worst_, worst_where_, bound_);
    }
    Comparison(const Comparison&) = delete;
    Comparison& operator=(const Comparison&) = delete;

 private:
    Stalls stalls_;
    double bound_;
    double worst_ = 0;
    std::string worst_where_;
};

void compare_shapes(Comparison& comparison, int pixels_a_run) {
    test::Rng rng(seed);
    for (const bool linear : {false, true}) {
        for (const test::Shape shape : {test::Shape::equilateral, test::Shape::right, test::Shape::random}) {
            for (const int area : {10, 50, 200, 1000, 5000}) {
                const auto packets =
                    test::shaped_packets(rng, shape, area, std::max(40, pixels_a_run / area), {linear, !linear});
                comparison.compare(fmt::format("{} {} px{}", to_string(shape), area, linear ? " linear" : ""), packets);
            }
        }
        comparison.compare("sliver 50 px",
                           test::shaped_packets(rng, test::Shape::sliver, 50, pixels_a_run / 50, {linear, true}));
    }
}

TEST(CycleModel, AgreesOnTrianglesOfEachShapeAndSize) {
    Comparison comparison;
    compare_shapes(comparison, 10'000);
}

TEST(CycleModel, AgreesOnStallingSources) {
    Comparison comparison({25, 0, 3});
    compare_shapes(comparison, 20'000);
}

TEST(CycleModel, AgreesOnStallingSinks) {
    Comparison comparison({0, 25, 3});
    compare_shapes(comparison, 20'000);
}

TEST(CycleModel, AgreesOnShapesSizesAndMessagesMixed) {
    Comparison comparison;
    test::Rng rng(seed);
    std::vector<std::uint32_t> packets;
    for (int i = 0; i < 600; ++i) {
        const auto shape = static_cast<test::Shape>(test::uniform(rng, 0, 3));
        const double area = std::pow(10.0, 3 * test::uniform_real(rng));
        const test::PacketForm form{test::uniform(rng, 0, 1) == 1, test::uniform(rng, 0, 1) == 1};
        const auto triangle = test::shaped_packets(rng, shape, area, 1, form);
        packets.insert(packets.end(), triangle.begin(), triangle.end());
        if (test::uniform(rng, 0, 19) == 0) append_fence(packets, 1);
        if (test::uniform(rng, 0, 19) == 0) append_query(packets);
    }
    comparison.compare("mixed", packets);
}

TEST(CycleModel, AgreesOnMeshes) {
    Comparison comparison;
    for (const char* mesh : {"builtin:sphere-168", "builtin:sphere-690", "builtin:torus-knot", "builtin:teapot"}) {
        Scene scene;
        scene.mesh = load_mesh(mesh);
        scene.width = scene.height = 512;
        const auto triangles = project(scene);
        for (const Method method : {Method::flat, Method::quadratic}) {
            comparison.compare(fmt::format("{} {}", mesh, to_string(method)),
                               picture_packets(make_setups(method, scene, triangles)));
        }
    }
}

TEST(CycleModel, NoStreamIsFasterThanItsBusiestStage) {
    test::Rng rng(seed);
    double worst = 0;
    for (const test::Shape shape :
         {test::Shape::equilateral, test::Shape::right, test::Shape::random, test::Shape::sliver}) {
        for (const int area : {10, 50, 200}) {
            const auto packets = test::shaped_packets(rng, shape, area, 300, {});
            for (const Width& width : widths) {
                const CycleBounds bounds = cycle_bounds(packets, width.words_per_beat);
                const std::uint64_t cycles = predict_cycles(packets, width.words_per_beat);
                EXPECT_GE(cycles, bounds.lower()) << to_string(shape) << ' ' << area << " px";
                worst = std::max(worst, static_cast<double>(cycles) / static_cast<double>(bounds.serial));
            }
        }
    }
    fmt::print("at most {:.4f} times the sum of each triangle's greatest stage\n", worst);
    EXPECT_LE(worst, 1.1);
}

TEST(CycleModel, RefusesWhatTheCoreRefuses) {
    EXPECT_THROW(predict_cycles({0x09000000U}, 2), Error);
    EXPECT_THROW(predict_cycles({0x03000001U, 0U}, 2), Error);
}

TEST(CycleModel, NothingTakesNoClock) { EXPECT_EQ(predict_cycles({}, 2), 0U); }

}  // namespace
}  // namespace sheen
