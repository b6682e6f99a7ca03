// SPDX-License-Identifier: MIT
// Contract 2: coverage is exact. Walks are judged by oracles that share no code with them
// (support/coverage_oracle.hpp).
#include "sheen/raster.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "sheen/error.hpp"
#include "support/coverage_oracle.hpp"

namespace sheen::test {
namespace {

constexpr std::uint64_t seed = 20240607;

/// Pixels left…right−1 of a row.
struct Interval {
    int left = 0;
    int right = 0;
    [[nodiscard]] bool holds(std::int64_t x) const { return left <= x && x < right; }
};
using Rows = std::map<int, Interval>;

Rows covered_rows(const Triangle& t) {
    Rows rows;
    const auto walk = walk_triangle(t[0], t[1], t[2]);
    if (!walk) return rows;
    for_each_span(*walk, [&](int x, int y, int length, int step) {
        EXPECT_EQ(rows.count(y), 0U) << "row " << y << " twice";
        rows[y] = step > 0 ? Interval{x, x + length} : Interval{x - length + 1, x + 1};
    });
    return rows;
}

bool covers(const Rows& rows, std::int64_t x, std::int64_t y) {
    const auto row = rows.find(static_cast<int>(y));
    return row != rows.end() && row->second.holds(x);
}

std::string text(const Triangle& t) {
    return fmt::format("({}, {}) ({}, {}) ({}, {}) in 1/256 px", t[0].x, t[0].y, t[1].x, t[1].y, t[2].x, t[2].y);
}

/// Pixels of row y around each crossing of the outline, where coverage can change: a span's ends are among them.
std::vector<std::int64_t> candidates(const std::vector<SnappedPoint>& polygon, std::int64_t y) {
    std::vector<std::int64_t> xs;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const SnappedPoint& a = polygon[k];
        const SnappedPoint& b = polygon[(k + 1) % polygon.size()];
        const std::int64_t row = 256 * y + 128;
        if (a.y == b.y || row < std::min(a.y, b.y) || row > std::max(a.y, b.y)) continue;
        const std::int64_t crossing = a.x + (b.x - a.x) * (row - a.y) / (b.y - a.y);
        for (std::int64_t x = crossing / 256 - 2; x <= crossing / 256 + 2; ++x) xs.push_back(x);
    }
    return xs;
}

std::vector<SnappedPoint> outline(const Triangle& t) { return {t.begin(), t.end()}; }

std::pair<std::int64_t, std::int64_t> row_range(const std::vector<SnappedPoint>& points) {
    const auto [top, bottom] =
        std::minmax_element(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
    return {top->y / 256 - 1, bottom->y / 256 + 1};
}

TEST(Raster, EveryPixelAgreesWithEdgeFunctionsAndWithTheMovedSample) {
    Rng rng(seed);
    std::size_t pixels = 0;
    for (int k = 0; k < 20000; ++k) {
        const Triangle t = random_triangle(rng, k % 2 == 0 ? 8 : 40);
        const Rows rows = covered_rows(t);
        for (int y = -1; y <= 40; ++y) {
            for (int x = -1; x <= 40; ++x) {
                const bool expected = edge_functions_cover(t, x, y);
                ASSERT_EQ(moved_sample_covers(t, x, y), expected) << text(t) << " pixel " << x << ", " << y;
                ASSERT_EQ(covers(rows, x, y), expected) << text(t) << " pixel " << x << ", " << y << ", case " << k;
                pixels += expected;
            }
        }
    }
    EXPECT_GT(pixels, 100000U);
    fmt::print("seed {}: 20000 triangles, {} pixels covered\n", seed, pixels);
}

TEST(Raster, LargeTrianglesAreExactAtEverySpanEnd) {
    Rng rng(seed + 1);
    std::size_t spans = 0;
    for (int k = 0; k < 3000; ++k) {
        const Triangle t = random_triangle(rng, 4095);
        const Rows rows = covered_rows(t);
        spans += rows.size();
        const auto [top, bottom] = row_range(outline(t));
        for (const auto& [y, span] : rows) ASSERT_TRUE(top <= y && y <= bottom) << text(t) << " row " << y;
        for (std::int64_t y = top; y <= bottom; ++y) {
            for (const std::int64_t x : candidates(outline(t), y)) {
                ASSERT_EQ(covers(rows, x, y), edge_functions_cover(t, x, y)) << text(t) << " pixel " << x << ", " << y;
                ASSERT_EQ(covers(rows, x, y), moved_sample_covers(t, x, y)) << text(t) << " pixel " << x << ", " << y;
            }
        }
    }
    fmt::print("seed {}: 3000 triangles up to 4095 px, {} spans\n", seed + 1, spans);
}

/// True when edge a→b passes within 1/256 of its own slope of a pixel centre in a low row: where an inexact phase,
/// after thousands of steps, would carry a row too early or too late.
bool grazes_a_late_centre(const SnappedPoint& a, const SnappedPoint& b) {
    const std::int64_t dy = b.y - a.y;
    for (std::int64_t y = 2048; y < 4095; ++y) {
        const std::int64_t n = (a.x - 128) * dy + (b.x - a.x) * (256 * y + 128 - a.y);
        const std::int64_t remainder = (n % (256 * dy) + 256 * dy) % (256 * dy);
        if (remainder <= 256 || remainder >= 256 * (dy - 1)) return true;
    }
    return false;
}

/// The most rows and the tallest edge there can be: rows·dy = 4095²·256, just below the 2^32 where phases stop being
/// exact. Only edges that would show an error of half a unit a row are taken.
TEST(Raster, TheTallestTrianglesKeepExactPhases) {
    Rng rng(seed + 2);
    constexpr std::int64_t limit = 4095 * 256;
    for (int k = 0; k < 60;) {
        const SnappedPoint top{uniform(rng, 0, limit), uniform(rng, 0, 100)};
        const SnappedPoint bottom{uniform(rng, 0, limit), limit - uniform(rng, 0, 100)};
        if (!grazes_a_late_centre(top, bottom)) continue;
        ++k;
        const Triangle t{top, bottom, SnappedPoint{k % 2 == 0 ? 0 : limit, uniform(rng, 0, limit)}};
        const Rows rows = covered_rows(t);
        for (std::int64_t y = 0; y < 4095; ++y) {
            for (const std::int64_t x : candidates(outline(t), y)) {
                ASSERT_EQ(covers(rows, x, y), edge_functions_cover(t, x, y)) << text(t) << " pixel " << x << ", " << y;
            }
        }
    }
}

TEST(Raster, TrianglesSharingAnEdgeNeverDoubleOrMissAPixel) {
    Rng rng(seed + 3);
    int pairs = 0;
    std::size_t checked = 0;
    while (pairs < 100000) {
        const int max_px = pairs % 50 == 0 ? 4095 : pairs % 5 == 0 ? 256 : 32;
        const Triangle t = random_triangle(rng, max_px);
        // A fourth vertex on the other side of edge 0–1: by chance, or the third one mirrored about the edge's middle.
        SnappedPoint other = random_triangle(rng, max_px)[0];
        if (uniform(rng, 0, 1) == 0) other = {t[0].x + t[1].x - t[2].x, t[0].y + t[1].y - t[2].y};
        if (std::min(other.x, other.y) < 0 || std::max(other.x, other.y) > 256 * max_px) continue;
        const std::int64_t side = cross(t[0], t[1], t[2]);
        const std::int64_t other_side = cross(t[0], t[1], other);
        if (side == 0 || other_side == 0 || (side > 0) == (other_side > 0)) continue;
        ++pairs;

        const Rows first = covered_rows(t);
        const Rows second = covered_rows({t[1], other, t[0]});
        const std::vector<SnappedPoint> quad{t[0], other, t[1], t[2]};
        const std::vector<SnappedPoint> all_edges{t[0], other, t[1], t[2], t[0], t[1]};
        const auto [top, bottom] = row_range(quad);
        for (std::int64_t y = top; y <= bottom; ++y) {
            for (const std::int64_t x : candidates(all_edges, y)) {
                const int times = covers(first, x, y) + covers(second, x, y);
                ASSERT_EQ(times, polygon_covers(quad, x, y) ? 1 : 0)
                    << text(t) << " and (" << other.x << ", " << other.y << "): pixel " << x << ", " << y;
                ++checked;
            }
        }
    }
    fmt::print("seed {}: {} pairs, {} pixels at their edges checked\n", seed + 3, pairs, checked);
}

TEST(Raster, FansOfConvexPolygonsCoverEachPixelOnce) {
    Rng rng(seed + 4);
    for (int k = 0; k < 1500; ++k) {
        // Corners on an ellipse, snapped; a fan about an inner point, or about a corner.
        const int size = 3 + k % 60;
        const auto corners = static_cast<std::size_t>(uniform(rng, 3, 12));
        std::vector<SnappedPoint> polygon;
        const double start = static_cast<double>(uniform(rng, 0, 6283)) / 1000;
        const double grid = k % 4 == 0 ? 128.0 : 1.0;
        for (std::size_t c = 0; c < corners; ++c) {
            const double angle = start + 6.283185307 * static_cast<double>(c) / static_cast<double>(corners);
            const auto place = [&](double v) {
                return static_cast<std::int64_t>(grid * std::round(128.0 * size * (1.0 + v) / grid));
            };
            polygon.push_back({place(std::cos(angle)), place(0.7 * std::sin(angle))});
        }
        const bool about_corner = k % 2 == 0;
        const SnappedPoint hub = about_corner ? polygon[0] : SnappedPoint{128 * size + 3, 128 * size - 7};
        std::vector<Rows> fan;
        for (std::size_t c = 0; c < corners; ++c) {
            fan.push_back(covered_rows({hub, polygon[c], polygon[(c + 1) % corners]}));
        }
        for (int y = 0; y <= size; ++y) {
            for (int x = 0; x <= size; ++x) {
                int times = 0;
                for (const Rows& rows : fan) times += covers(rows, x, y);
                ASSERT_EQ(times, polygon_covers(polygon, x, y) ? 1 : 0)
                    << "polygon " << k << " pixel " << x << ", " << y;
            }
        }
    }
}

/// Any closed mesh, however folded, covers each pixel as often facing as turned away.
TEST(Raster, ClosedMeshesSumToZeroBySignedWinding) {
    Rng rng(seed + 5);
    constexpr int rings = 5;
    constexpr int sides = 4;
    constexpr int size = 40;
    std::size_t touched = 0;
    for (int k = 0; k < 400; ++k) {
        std::array<std::array<SnappedPoint, sides>, rings> grid;  // a torus of quads with arbitrary vertices
        for (auto& ring : grid) {
            for (SnappedPoint& p : ring) p = random_triangle(rng, size)[0];
        }
        std::map<std::pair<int, int>, int> winding;
        const auto add = [&](const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c) {
            const int sign = doubled_area(a, b, c) > 0 ? 1 : -1;
            for (const auto& [y, span] : covered_rows({a, b, c})) {
                for (int x = span.left; x < span.right; ++x) winding[{x, y}] += sign;
            }
        };
        for (std::size_t i = 0; i < rings; ++i) {
            for (std::size_t j = 0; j < sides; ++j) {
                const std::size_t next_i = (i + 1) % rings;
                const std::size_t next_j = (j + 1) % sides;
                add(grid[i][j], grid[next_i][j], grid[next_i][next_j]);
                add(grid[i][j], grid[next_i][next_j], grid[i][next_j]);
            }
        }
        touched += winding.size();
        for (const auto& [pixel, sum] : winding) {
            ASSERT_EQ(sum, 0) << "mesh " << k << " pixel " << pixel.first << ", " << pixel.second;
        }
    }
    EXPECT_GT(touched, 100000U);
}

TEST(Raster, WalksStartAndEndWithPixelsAndLeaveUnusedPartsEmpty) {
    Rng rng(seed + 6);
    int trimmed_middle = 0;
    for (int k = 0; k < 50000; ++k) {
        const Triangle t = random_triangle(rng, k % 10 == 0 ? 1000 : 20);
        const auto walk = walk_triangle(t[0], t[1], t[2]);
        if (!walk) continue;
        std::vector<WalkRow> rows;
        for_each_row(*walk, [&](const WalkRow& row) { rows.push_back(row); });
        ASSERT_EQ(rows.size(), static_cast<std::size_t>(walk->rows_above + walk->rows_below)) << text(t);
        ASSERT_GT(rows.front().length, 0) << text(t);
        ASSERT_GT(rows.back().length, 0) << text(t);
        if (walk->rows_above == 0) {
            ASSERT_EQ(walk->length, 0);
            const std::int64_t middle = std::max(std::min(t[0].y, t[1].y), std::min(std::max(t[0].y, t[1].y), t[2].y));
            trimmed_middle += middle > std::min({t[0].y, t[1].y, t[2].y}) + 256;
        }
        if (walk->rows_below == 0) {
            ASSERT_EQ(walk->length_reload, 0);
        }
    }
    EXPECT_GT(trimmed_middle, 10) << "no case trims the whole upper part";
}

TEST(Raster, TheOrderOfTheVerticesDoesNotMatter) {
    Rng rng(seed + 7);
    for (int k = 0; k < 5000; ++k) {
        const Triangle t = random_triangle(rng, 64);
        const Rows rows = covered_rows(t);
        for (const Triangle& turned : {Triangle{t[1], t[2], t[0]}, Triangle{t[2], t[1], t[0]}}) {
            const Rows again = covered_rows(turned);
            ASSERT_EQ(again.size(), rows.size()) << text(t);
            for (const auto& [y, span] : rows) {
                ASSERT_EQ(again.at(y).left, span.left) << text(t);
                ASSERT_EQ(again.at(y).right, span.right) << text(t);
            }
        }
    }
}

/// The device's registers, written out plainly: 12-bit and 32-bit unsigned arithmetic and nothing else.
std::vector<std::array<int, 4>> device_spans(const TriangleWalk& w) {
    constexpr std::uint64_t field = 0xfff;
    constexpr std::uint64_t word = 0xffffffff;
    const auto reg = [](int v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(v)) & 0xfff; };
    std::vector<std::array<int, 4>> spans;
    std::uint64_t u = (w.leftward ? 4096 - reg(w.x) : reg(w.x)) & field;
    std::uint64_t y = reg(w.y);
    std::uint64_t above = reg(w.rows_above);
    std::uint64_t below = reg(w.rows_below);
    std::uint64_t p_long = w.long_edge.phase;
    std::uint64_t length = above > 0 ? reg(w.length) : reg(w.length_reload);
    std::uint64_t m = above > 0 ? reg(w.m) : reg(w.m_below);
    std::uint64_t p_end = above > 0 ? w.upper.phase : w.lower.phase;
    std::uint64_t step_end = above > 0 ? w.upper.step : w.lower.step;
    while (above + below > 0) {
        const std::uint64_t x = (w.leftward ? 4096 - u : u) & field;
        if (length > 0) {
            spans.push_back({static_cast<int>(x), static_cast<int>(y), static_cast<int>(length), w.leftward ? -1 : 1});
        }
        p_long += w.long_edge.step;
        const std::uint64_t carry_long = p_long >> 32;
        p_long &= word;
        u = (u + reg(w.kappa) + carry_long) & field;
        y = (y + 1) & field;
        if (above == 1) {
            length = reg(w.length_reload);
            m = reg(w.m_below);
            p_end = w.lower.phase;
            step_end = w.lower.step;
        } else {
            p_end += step_end;
            length = (length + m + (p_end >> 32) + 4096 - carry_long) & field;
            p_end &= word;
        }
        if (above > 0) {
            --above;
        } else {
            --below;
        }
    }
    return spans;
}

TEST(Raster, ArbitraryWalksFollowTheDevicesRegisters) {
    Rng rng(seed + 8);
    for (int k = 0; k < 20000; ++k) {
        const TriangleWalk walk = random_walk(rng, k % 100 == 0 ? 4095 : 12);
        std::vector<std::array<int, 4>> spans;
        for_each_span(walk, [&](int x, int y, int length, int step) { spans.push_back({x, y, length, step}); });
        ASSERT_EQ(spans, device_spans(walk)) << "walk " << k << " of seed " << seed + 8;
    }
}

TEST(Raster, DoubledAreaIsPositiveClockwiseOnScreen) {
    EXPECT_EQ(doubled_area({0, 0}, {256, 0}, {0, 512}), 256 * 512);
    EXPECT_EQ(doubled_area({0, 0}, {0, 512}, {256, 0}), -256 * 512);
    EXPECT_EQ(doubled_area({0, 0}, {100, 100}, {300, 300}), 0);
}

TEST(Raster, PointsOutsideTheImageAreRefusedByName) {
    for (const SnappedPoint& p : {SnappedPoint{-1, 5}, SnappedPoint{5, -1}, SnappedPoint{4095 * 256 + 1, 5}}) {
        try {
            walk_triangle({0, 0}, p, {256, 256});
            ADD_FAILURE() << "accepted " << p.x << ", " << p.y;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(std::to_string(p.x)), std::string::npos) << error.what();
        }
    }
    EXPECT_TRUE(walk_triangle({0, 0}, {4095 * 256, 0}, {0, 4095 * 256}).has_value());
}

}  // namespace
}  // namespace sheen::test
