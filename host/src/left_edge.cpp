// SPDX-License-Identifier: MIT
#include "left_edge.hpp"

#include <algorithm>

namespace sheen {
namespace {

int floor_divide(int a, int b) { return a / b - (a % b < 0 ? 1 : 0); }

}  // namespace

std::vector<LeftEdge> left_edges(const ScreenTriangle& triangle) {
    const std::vector<PixelRow> rows = triangle_rows(triangle);
    std::vector<LeftEdge> edges;
    std::size_t row = 0;
    for (const TriangleWalk& walk : triangle.walks) {
        const int middle = walk.leftward ? walk.y + walk.rows_above : walk.y;
        const int end = walk.y + walk.rows_above + walk.rows_below;
        for (const int below : {middle, end}) {
            const std::size_t first = row;
            while (row < rows.size() && rows[row].y < below) ++row;
            if (row == first) continue;
            LeftEdge edge{first, rows[first], 0};
            for (std::size_t r = first + 1; r < row; ++r) {
                const int slope = floor_divide(rows[r].x - rows[r - 1].x, rows[r].y - rows[r - 1].y);
                edge.kappa = r == first + 1 ? slope : std::min(edge.kappa, slope);
            }
            edges.push_back(edge);
        }
    }
    return edges;
}

}  // namespace sheen
