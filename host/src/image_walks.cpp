// SPDX-License-Identifier: MIT
/// \file
/// Clipping without new vertices. The rows of a triangle in the image are cut where one of its edges passes a vertical
/// side of the image; between two cuts the covered pixels of every row run from an edge or the left side to an edge or
/// the right side. A walk steps such boundaries as well as a triangle's, so that no crossing is ever rounded: the
/// pixels are those of the whole triangle that lie in the image, and edges that triangles share stay shared.
#include <algorithm>
#include <tuple>

#include "edge.hpp"

namespace sheen {
namespace {

/// Rows first…end−1, each covered from `left` to `right`.
struct Section {
    std::int64_t first = 0, end = 0;
    Edge left, right;
};

/// The side x = column of the image as an edge.
Edge vertical_side(int column) { return {{subpixels * column, 0}, {subpixels * column, 1}}; }

/// The triangle's two sides: the left and the right edge of every row.
struct Outline {
    Edge long_edge, upper, lower;
    std::int64_t first = 0, middle = 0, end = 0;
    bool long_on_left = false;

    [[nodiscard]] const Edge& other(std::int64_t row) const { return row < middle ? upper : lower; }
    [[nodiscard]] const Edge& left(std::int64_t row) const { return long_on_left ? long_edge : other(row); }
    [[nodiscard]] const Edge& right(std::int64_t row) const { return long_on_left ? other(row) : long_edge; }
};

/// Adds the row of first…end at which the edge's boundary passes the given column: it moves one way only.
void add_crossing(std::vector<std::int64_t>& cuts, const Edge& edge, std::int64_t first, std::int64_t end, int column) {
    const auto beyond = [&](std::int64_t row) { return edge.boundary(row) >= column; };
    if (first >= end || beyond(first) == beyond(end - 1)) return;
    const bool before = beyond(first);
    while (end - first > 1) {
        const std::int64_t row = first + (end - first) / 2;
        (beyond(row) == before ? first : end) = row;
    }
    cuts.push_back(end);
}

/// The rows between which nothing changes but positions along edges, in order.
std::vector<std::int64_t> cut_rows(const Outline& outline, int width) {
    std::vector<std::int64_t> cuts{outline.first, outline.middle, outline.end};
    // Left of the image a boundary is below 0, right of it above `width`.
    for (const int column : {0, width + 1}) {
        add_crossing(cuts, outline.long_edge, outline.first, outline.end, column);
        add_crossing(cuts, outline.upper, outline.first, outline.middle, column);
        add_crossing(cuts, outline.lower, outline.middle, outline.end, column);
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

/// Sections in the image, cut further where stepping an edge on would lose its exactness.
std::vector<Section> make_sections(const Outline& outline, int width) {
    std::vector<Section> sections;
    const std::vector<std::int64_t> cuts = cut_rows(outline, width);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        std::int64_t row = cuts[k];
        if (row == cuts[k + 1]) continue;
        const std::int64_t start = outline.left(row).boundary(row);
        const std::int64_t stop = outline.right(row).boundary(row);
        if (start > width || stop < 0) continue;
        const Edge left = start < 0 ? vertical_side(0) : outline.left(row);
        const Edge right = stop > width ? vertical_side(width) : outline.right(row);
        const std::int64_t most_rows = std::min(left.exact_rows(), right.exact_rows());
        for (; row < cuts[k + 1]; row += most_rows) {
            sections.push_back({row, std::min(row + most_rows, cuts[k + 1]), left, right});
        }
    }
    return sections;
}

/// The side (+1 left, −1 right) on which `below` goes on stepping the same edge right behind `section`, else 0.
int shared_side(const Section& section, const Section& below) {
    const std::int64_t rows = below.end - section.first;
    if (section.end != below.first) return 0;
    if (section.left == below.left && rows <= section.left.exact_rows()) return 1;
    if (section.right == below.right && rows <= section.right.exact_rows()) return -1;
    return 0;
}

/// The shape of two sections that share the edge on side `s` (of one section: the same one twice).
EdgeWalk joined(const Section& section, const Section& below, int s) {
    const auto& [long_edge, upper, lower] =
        s > 0 ? std::tie(section.left, section.right, below.right) : std::tie(section.right, section.left, below.left);
    return {long_edge, upper, lower, section.first, section.end, below.end, s};
}

}  // namespace

std::vector<TriangleWalk> walk_in_image(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c, int width,
                                        int height) {
    std::array<SnappedPoint, 3> v{a, b, c};
    std::sort(v.begin(), v.end(),
              [](const SnappedPoint& p, const SnappedPoint& q) { return p.y != q.y ? p.y < q.y : p.x < q.x; });
    const std::int64_t area = doubled_area(v[0], v[1], v[2]);
    if (area == 0) return {};
    const auto row_in_image = [&](std::int64_t y) { return std::clamp<std::int64_t>(first_row(y), 0, height); };
    const Outline outline{Edge(v[0], v[2]),     Edge(v[0], v[1]),     Edge(v[1], v[2]), row_in_image(v[0].y),
                          row_in_image(v[1].y), row_in_image(v[2].y), area > 0};

    std::vector<TriangleWalk> walks;
    const std::vector<Section> sections = make_sections(outline, width);
    for (std::size_t k = 0; k < sections.size();) {
        const int side = k + 1 < sections.size() ? shared_side(sections[k], sections[k + 1]) : 0;
        const std::size_t used = side == 0 ? 1 : 2;
        const auto walk = make_walk(joined(sections[k], sections[k + used - 1], side < 0 ? -1 : 1));
        if (walk) walks.push_back(*walk);
        k += used;
    }
    return walks;
}

}  // namespace sheen
