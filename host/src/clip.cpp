// SPDX-License-Identifier: MIT
/// \file
/// Clipping to the image without cracks. The polygon triangle ∩ rectangle is computed exactly (Sutherland and Hodgman's
/// method in rational coordinates) and its vertices are rounded once, at the end. A vertex is then a function of one
/// edge and one side of the rectangle alone, so that two triangles sharing an edge clip it to the same point.
#include <algorithm>
#include <utility>
#include <vector>

#include "sheen/hls/formats.hpp"
#include "sheen/scene.hpp"

namespace sheen {
namespace {

/// Enough for coordinates up to 2^29: reduced vertices have 59 bits over 30, a distance 60, their products 120.
__extension__ using Wide = __int128;

/// The point (x/w, y/w), w > 0, in lowest terms.
struct RationalPoint {
    Wide x = 0;
    Wide y = 0;
    Wide w = 1;
};

Wide gcd(Wide a, Wide b) {
    while (b != 0) {
        a %= b;
        std::swap(a, b);
    }
    return a < 0 ? -a : a;
}

/// The half-plane a·x + b·y + c ≥ 0, with a, b in {−1, 0, 1}.
struct HalfPlane {
    int a = 0;
    int b = 0;
    std::int64_t c = 0;
    /// Distance times w.
    [[nodiscard]] Wide distance(const RationalPoint& point) const { return a * point.x + b * point.y + c * point.w; }
};

/// Where the segment meets the half-plane's edge; the distances of its ends have opposite signs.
RationalPoint intersect(const RationalPoint& inside, Wide inside_distance, const RationalPoint& outside,
                        Wide outside_distance) {
    const RationalPoint point{outside.x * inside_distance - inside.x * outside_distance,
                              outside.y * inside_distance - inside.y * outside_distance,
                              outside.w * inside_distance - inside.w * outside_distance};
    const Wide divisor = gcd(gcd(point.x, point.y), point.w);
    return {point.x / divisor, point.y / divisor, point.w / divisor};
}

std::vector<RationalPoint> clip_to_half_plane(const std::vector<RationalPoint>& polygon, const HalfPlane& half_plane) {
    std::vector<RationalPoint> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const RationalPoint& from = polygon[i];
        const RationalPoint& to = polygon[(i + 1) % polygon.size()];
        const Wide from_distance = half_plane.distance(from);
        const Wide to_distance = half_plane.distance(to);
        if (from_distance >= 0) {
            result.push_back(from);
        }
        if (from_distance > 0 && to_distance < 0) {
            result.push_back(intersect(from, from_distance, to, to_distance));
        } else if (from_distance < 0 && to_distance > 0) {
            result.push_back(intersect(to, to_distance, from, from_distance));
        }
    }
    return result;
}

/// To nearest, halves up; what is left after clipping is not negative.
std::int64_t round_quotient(Wide numerator, Wide denominator) {
    return static_cast<std::int64_t>((2 * numerator + denominator) / (2 * denominator));
}

bool strictly_inside(const SnappedPoint& point, const std::array<SnappedPoint, 3>& triangle, std::int64_t sign) {
    return sign * doubled_area(triangle[0], triangle[1], point) > 0 &&
           sign * doubled_area(triangle[1], triangle[2], point) > 0 &&
           sign * doubled_area(triangle[2], triangle[0], point) > 0;
}

/// Cuts ears off until nothing is left. Rounding can bend a convex polygon by one unit, and fold a sliver over itself;
/// ears keep the pieces disjoint then, and what is folded (area of the other sign) is dropped.
/// `sign` is the orientation of the triangle that was clipped.
std::vector<std::array<SnappedPoint, 3>> triangulate(std::vector<SnappedPoint> polygon, std::int64_t sign) {
    std::vector<std::array<SnappedPoint, 3>> pieces;
    std::size_t candidate = 0;
    std::size_t refused = 0;
    while (polygon.size() >= 3 && refused < polygon.size()) {
        const std::size_t count = polygon.size();
        const std::size_t middle = (candidate + 1) % count;
        const std::array<SnappedPoint, 3> ear{polygon[candidate], polygon[middle], polygon[(candidate + 2) % count]};
        const std::int64_t area = sign * doubled_area(ear[0], ear[1], ear[2]);
        const bool is_ear = area >= 0 && std::none_of(polygon.begin(), polygon.end(), [&](const SnappedPoint& point) {
                                return strictly_inside(point, ear, sign);
                            });
        if (!is_ear) {
            candidate = middle;
            ++refused;
            continue;
        }
        if (area > 0) {
            pieces.push_back(ear);
        }
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(middle));
        candidate = middle < candidate ? candidate - 1 : candidate;
        refused = 0;
    }
    return pieces;
}

}  // namespace

std::vector<std::array<SnappedPoint, 3>> clip_to_image(const std::array<SnappedPoint, 3>& triangle, int width,
                                                       int height) {
    const std::int64_t right = std::int64_t{width} << hls::subpixel_bits;
    const std::int64_t bottom = std::int64_t{height} << hls::subpixel_bits;
    const std::int64_t area = doubled_area(triangle[0], triangle[1], triangle[2]);
    if (area == 0) {
        return {};
    }
    const bool inside = std::all_of(triangle.begin(), triangle.end(), [&](const SnappedPoint& point) {
        return point.x >= 0 && point.x <= right && point.y >= 0 && point.y <= bottom;
    });
    if (inside) {
        return {triangle};
    }
    std::vector<RationalPoint> exact;
    for (const SnappedPoint& point : triangle) {
        exact.push_back({point.x, point.y, 1});
    }
    for (const HalfPlane& side : {HalfPlane{1, 0, 0}, {-1, 0, right}, {0, 1, 0}, {0, -1, bottom}}) {
        exact = clip_to_half_plane(exact, side);
    }
    std::vector<SnappedPoint> polygon;
    for (const RationalPoint& point : exact) {
        polygon.push_back({round_quotient(point.x, point.w), round_quotient(point.y, point.w)});
    }
    return triangulate(std::move(polygon), area > 0 ? 1 : -1);
}

}  // namespace sheen
