// SPDX-License-Identifier: MIT
/// \file
/// Speed of the host: setups per second of each method that has packets, on the torus knot at 512×512, and the steps
/// around it.
#include <benchmark/benchmark.h>

#include "sheen/compare.hpp"
#include "sheen/render.hpp"

namespace sheen {
namespace {

Scene knot() {
    Scene scene;
    scene.mesh = load_mesh("builtin:torus-knot");
    scene.rotate_degrees = {30, 20, 0};
    scene.lights = measured_lights().front();
    return scene;
}

void project_triangles(benchmark::State& state) {
    const Scene scene = knot();
    for (auto _ : state) benchmark::DoNotOptimize(project(scene));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.mesh.triangles.size()));
}
BENCHMARK(project_triangles)->Unit(benchmark::kMillisecond);

void setups(benchmark::State& state, Method method) {
    const Scene scene = knot();
    const auto triangles = project(scene);
    std::size_t count = 0;
    for (auto _ : state) {
        const auto result = make_setups(method, scene, triangles);
        count += result.size();
        benchmark::DoNotOptimize(result.data());
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(count));
}
BENCHMARK_CAPTURE(setups, flat, Method::flat)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(setups, gouraud, Method::gouraud)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(setups, quadratic, Method::quadratic)->Unit(benchmark::kMillisecond);

void encode_packets(benchmark::State& state) {
    const Scene scene = knot();
    const auto result = make_setups(Method::quadratic, scene, project(scene));
    for (auto _ : state) benchmark::DoNotOptimize(picture_packets(result));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(result.size()));
}
BENCHMARK(encode_packets)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sheen
