// SPDX-License-Identifier: MIT
/// \file
/// Speed of the kernels, compiled for this machine: items per second are pixels (or, for a walker, clocks) of one unit.
#include <benchmark/benchmark.h>

#include <memory>

#include "sheen/framing.hpp"
#include "sheen/hls/bell_rom.hpp"
#include "sheen/hls/line_interpolator.hpp"
#include "sheen/hls/shading_core.hpp"
#include "support/shaped_triangles.hpp"

namespace sheen {
namespace {

using core_t = hls::shading_core<hls::core_config<>>;
constexpr int steps = 4096;

template <bool second_order>
void forward_difference_span(benchmark::State& state) {
    using unit = hls::forward_difference<hls::colour_value_t, second_order>;
    const hls::span_command_t step{0, 0, 1};
    typename unit::span_state_t span;
    span.i = 17.25;
    span.d = 0.125;
    span.h = -0.0009765625;
    for (auto _ : state) {
        for (int i = 0; i < steps; ++i) span = unit::span_step(span, step, {}, {});
        benchmark::DoNotOptimize(span);
    }
    state.SetItemsProcessed(state.iterations() * steps);
}
BENCHMARK_TEMPLATE(forward_difference_span, false);
BENCHMARK_TEMPLATE(forward_difference_span, true);

void colour_stage(benchmark::State& state) {
    core_t::stage::state_t stage;
    core_t::stage::values_t values;
    values.red = 100.5;
    values.green = -3;
    values.blue = 300;
    const hls::core_description_t description = hls::core_config<>::description();
    hls::fragment_t fragment;
    fragment.valid = 1;
    for (auto _ : state) {
        for (int x = 0; x < steps - 1; ++x) {
            fragment.x = x;
            stage = core_t::stage::step(stage, fragment, values, description);
        }
        benchmark::DoNotOptimize(stage);
    }
    state.SetItemsProcessed(state.iterations() * (steps - 1));
}
BENCHMARK(colour_stage);

/// The whole core on triangles of state.range(0) pixels: pixels per second, and clocks as a counter.
void shading_core(benchmark::State& state) {
    test::Rng rng(20264);
    const auto area = static_cast<double>(state.range(0));
    const auto packets =
        test::shaped_packets(rng, test::Shape::equilateral, area, static_cast<int>(std::max(10.0, 5000 / area)), {});
    const std::vector<Beat> beats = frame_packets(packets, 2);
    std::int64_t clocks = 0;
    std::int64_t pixels = 0;
    for (auto _ : state) {
        const auto core = std::make_unique<core_t>();
        const auto clock = [&](const core_t::decoder::beat_t& beat) {
            core->clock(beat, 1);
            ++clocks;
            if (core->stage_state.valid) ++pixels;
        };
        for (const Beat& beat : beats) {
            core_t::decoder::beat_t offered;
            offered.valid = 1;
            offered.last = beat.last;
            offered.keep = (1 << beat.count) - 1;
            for (std::size_t k = 0; k < 2; ++k) offered.words[k] = beat.words[k];
            for (bool taken = false; !taken;) {
                taken = core->ready() != 0;
                clock(offered);
            }
        }
        while (core->busy()) clock({});
        benchmark::DoNotOptimize(*core);
    }
    state.SetItemsProcessed(pixels);
    state.counters["clocks_per_second"] = benchmark::Counter(static_cast<double>(clocks), benchmark::Counter::kIsRate);
}
BENCHMARK(shading_core)->Arg(10)->Arg(200)->Arg(5000);

}  // namespace
}  // namespace sheen
