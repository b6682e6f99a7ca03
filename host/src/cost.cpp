// SPDX-License-Identifier: MIT
#include "sheen/cost.hpp"

namespace sheen {
namespace {

/// `sum` over `count`, less what belongs elsewhere.
MeanCounts mean(const OperationCounts& sum, std::size_t count, const OperationCounts& apart = {}) {
    const auto over = [count](std::uint64_t all, std::uint64_t less) {
        return count == 0 ? 0.0 : static_cast<double>(all - less) / static_cast<double>(count);
    };
    return {over(sum.additions, apart.additions),    over(sum.multiplications, apart.multiplications),
            over(sum.divisions, apart.divisions),    over(sum.roots, apart.roots),
            over(sum.powers, apart.powers),          over(sum.comparisons, apart.comparisons),
            over(sum.table_reads, apart.table_reads)};
}

}  // namespace

std::array<std::pair<const char*, double>, 7> MeanCounts::named() const {
    return {{{"additions", additions},
             {"multiplications", multiplications},
             {"divisions", divisions},
             {"roots", roots},
             {"powers", powers},
             {"comparisons", comparisons},
             {"table_reads", table_reads}}};
}

std::array<std::pair<const char*, MeanCounts>, 4> MethodCost::named() const {
    return {{{"nodes", nodes}, {"triangle", triangle}, {"span", span}, {"pixel", pixel}}};
}

MethodCost method_cost(Method method, const Scene& scene, const std::vector<ScreenTriangle>& triangles,
                       const MethodOptions& options) {
    OperationCounts setup;
    OperationCounts nodes;
    OperationCounts spans;
    OperationCounts pixels;
    std::size_t triangle_count = 0;
    std::size_t span_count = 0;
    std::size_t pixel_count = 0;
    for (const ScreenTriangle& triangle : triangles) {
        if (triangle.walks.empty()) continue;
        ++triangle_count;
        std::unique_ptr<Loop<Counted>> loop;
        {
            const CountingScope scope;
            loop = make_loop<Counted>(method, options, scene, triangle);
            setup += scope.counts();
            nodes += loop->node_counts();
        }
        for (const PixelRow& row : triangle_rows(triangle)) {
            {
                const CountingScope scope;
                loop->start_row(row);
                spans += scope.counts();
            }
            const CountingScope scope;
            for (int i = 0; i < row.length; ++i) (void)loop->next();
            pixels += scope.counts();
            pixel_count += static_cast<std::size_t>(row.length);
            ++span_count;
        }
    }
    return {mean(nodes, triangle_count), mean(setup, triangle_count, nodes), mean(spans, span_count),
            mean(pixels, pixel_count)};
}

}  // namespace sheen
