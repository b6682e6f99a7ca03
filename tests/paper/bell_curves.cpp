// SPDX-License-Identifier: MIT
// Paper `spherical`, section 4: cosⁿ and the bells that stand for it, and the bells in memories.
#include <cmath>

#include "results.hpp"
#include "sheen/bell.hpp"
#include "sheen/hls/bell_table.hpp"

namespace sheen::paper {
namespace {

constexpr int samples = 256;
const double half_pi = std::acos(0.0);

/// f at 0…π/2.
template <typename Function>
ordered_json sampled(const Function& f) {
    ordered_json values = ordered_json::array();
    for (int i = 0; i <= samples; ++i) values.push_back(f(half_pi * i / samples));
    return values;
}

/// ∫cosⁿx·sin x − ∫bell·sin x: what eq. 20 sets to 0, over the first.
double integral_mismatch(double shininess, double scale) {
    const double a2 = scale * scale;
    const double bell_integral = (2.0 * a2 * (1.0 - std::cos(half_pi / scale)) - 1.0) / (4.0 * a2 - 1.0);
    return bell_integral * (shininess + 1.0) - 1.0;
}

/// cos² by a memory of as many address as data bits, both halves of the bell in it, as the paper addresses it.
template <int bits>
ordered_json memory() {
    constexpr const auto& table = hls::whole_bell_table<bits - 1, bits, 20>;
    const auto read = [](double x) {
        const auto bin = std::min(static_cast<std::size_t>(x / half_pi * (1 << (bits - 1))), table.size() / 2 - 1);
        return static_cast<double>(table[bin]) / ((1 << bits) - 1);
    };
    double worst = 0.0;
    constexpr int fine = 1 << 16;
    for (int i = 0; i < fine; ++i) {
        const double x = half_pi * (i + 0.5) / fine;
        worst = std::max(worst, std::abs(read(x) - std::cos(x) * std::cos(x)));
    }
    return {{"bits", bits},
            {"words", table.size()},
            {"memory_bits", table.size() * bits},
            {"largest_error", worst},
            {"values", sampled(read)}};
}

}  // namespace

ordered_json bell_curves() {
    ordered_json rows = ordered_json::array();
    for (const double n : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 500.0}) {
        const double a = equal_integral_scale(n, 2.0);
        const double best = minimax_scale(n, 2.0);
        const double best_of_better = minimax_scale(n, 9.5);
        rows.push_back({{"n", n},
                        {"a", a},
                        {"largest_error", bell_error(n, 2.0, a)},
                        {"minimax_a", best},
                        {"minimax_error", bell_error(n, 2.0, best)},
                        {"cos9_5_error", bell_error(n, 9.5, best_of_better)},
                        {"power", sampled([n](double x) { return cosine_power(x, n); })},
                        {"bell", sampled([a](double x) { return bell(x, 2.0, a); })}});
    }
    ordered_json erratum;
    for (const double a : {1.9745, 1.9845}) {
        erratum.push_back(
            {{"a", a}, {"integral_mismatch", integral_mismatch(10.0, a)}, {"largest_error", bell_error(10.0, 2.0, a)}});
    }
    return {{"table", rows},
            {"figure_10_misprint", erratum},
            {"cos2", sampled([](double x) { return std::cos(x) * std::cos(x); })},
            {"memories", {memory<4>(), memory<6>()}}};
}

}  // namespace sheen::paper
