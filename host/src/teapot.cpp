// SPDX-License-Identifier: MIT
/// \file
/// Tessellation of the teapot's bicubic Bézier patches.
#include "teapot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

#include "teapot_data.hpp"

namespace sheen {
namespace {

constexpr std::size_t cells = 10;  ///< per patch side
constexpr std::size_t first_lid_patch = 20;
constexpr std::size_t first_bottom_patch = 28;
/// The lid's edge has radius 1.3, the rim's inner edge 1.4: Newell's lid leaves a gap, this one closes it.
constexpr double lid_scale = 1.4 / 1.3;
/// The lip's inner edge: where the spout's last patches (18 and 19) end.
constexpr std::array<std::size_t, 2> spout_tip_patches{18, 19};

using ControlNet = std::array<std::array<glm::dvec3, 4>, 4>;

struct SurfacePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};
};

/// Cubic Bernstein weights at t and their derivatives.
struct Bernstein {
    std::array<double, 4> value{};
    std::array<double, 4> slope{};
};

Bernstein bernstein(double t) {
    const double s = 1.0 - t;
    return {{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
            {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t}};
}

glm::dvec3 weighted_sum(const ControlNet& net, const std::array<double, 4>& rows,
                        const std::array<double, 4>& columns) {
    glm::dvec3 sum(0.0);
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            sum += rows[row] * columns[column] * net[row][column];
        }
    }
    return sum;
}

/// The patch's control points with y up: (x, y, z) becomes (x, z, −y).
ControlNet control_net(std::size_t patch) {
    const double scale = patch >= first_lid_patch && patch < first_bottom_patch ? lid_scale : 1.0;
    ControlNet net;
    for (std::size_t index = 0; index < 16; ++index) {
        const auto& point = teapot_control_points[teapot_patches[patch][index]];
        net[index / 4][index % 4] = {scale * point[0], point[2], -scale * point[1]};
    }
    return net;
}

/// Point and outward normal at (u, v), u along rows' order. Where a whole row of control points is one point (the
/// knob's top and the bottom's centre, at u = 0), ∂v vanishes and its limit direction is ∂²/∂u∂v.
SurfacePoint evaluate(const ControlNet& net, double u, double v) {
    constexpr double vanishing = 1e-9;
    const Bernstein row = bernstein(u);
    const Bernstein column = bernstein(v);
    const glm::dvec3 along_u = weighted_sum(net, row.slope, column.value);
    glm::dvec3 along_v = weighted_sum(net, row.value, column.slope);
    if (glm::length(along_v) < vanishing) {
        along_v = weighted_sum(net, row.slope, column.slope);
    }
    return {weighted_sum(net, row.value, column.value), glm::normalize(glm::cross(along_v, along_u))};
}

/// Collects triangles and joins vertices that agree in place and, but for creases, in normal.
class Welder {
 public:
    std::uint32_t vertex(const SurfacePoint& point) {
        // Neighbouring patches sum the same terms in another order: a common grid makes their shared edges equal.
        constexpr double grid = 1 << 24;
        const std::array<double, 3> key{std::round(point.position.x * grid) / grid,
                                        std::round(point.position.y * grid) / grid,
                                        std::round(point.position.z * grid) / grid};
        constexpr double same_direction = 0.999;
        std::vector<std::uint32_t>& here = vertices_[key];
        for (const std::uint32_t index : here) {
            if (glm::dot(mesh_.normals[index], point.normal) > same_direction) {
                return index;
            }
        }
        here.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
        mesh_.positions.emplace_back(key[0], key[1], key[2]);
        mesh_.normals.push_back(point.normal);
        return here.back();
    }
    /// Adds a triangle; the flat ones at a pole are left out.
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a) {
            mesh_.triangles.push_back({a, b, c});
        }
    }
    Mesh take(std::string name) {
        mesh_.name = std::move(name);
        return std::move(mesh_);
    }

 private:
    Mesh mesh_;
    std::map<std::array<double, 3>, std::vector<std::uint32_t>> vertices_;
};

double parameter(std::size_t step) { return static_cast<double>(step) / static_cast<double>(cells); }

void add_patch(Welder& welder, const ControlNet& net) {
    std::array<std::array<std::uint32_t, cells + 1>, cells + 1> index{};
    for (std::size_t row = 0; row <= cells; ++row) {
        for (std::size_t column = 0; column <= cells; ++column) {
            index[row][column] = welder.vertex(evaluate(net, parameter(row), parameter(column)));
        }
    }
    for (std::size_t row = 0; row < cells; ++row) {
        for (std::size_t column = 0; column < cells; ++column) {
            welder.triangle(index[row][column], index[row][column + 1], index[row + 1][column + 1]);
            welder.triangle(index[row][column], index[row + 1][column + 1], index[row + 1][column]);
        }
    }
}

/// A flat cover over the spout's opening: its edge lies in a horizontal plane.
void add_spout_cap(Welder& welder) {
    const glm::dvec3 up(0.0, 1.0, 0.0);
    std::vector<glm::dvec3> edge;
    for (const std::size_t patch : spout_tip_patches) {
        const ControlNet net = control_net(patch);
        for (std::size_t column = 0; column < cells; ++column) {
            edge.push_back(evaluate(net, 1.0, parameter(column)).position);
        }
    }
    const auto [west, east] =
        std::minmax_element(edge.begin(), edge.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    const std::uint32_t centre = welder.vertex({0.5 * (*west + *east), up});
    for (std::size_t corner = 0; corner < edge.size(); ++corner) {
        welder.triangle(centre, welder.vertex({edge[corner], up}),
                        welder.vertex({edge[(corner + 1) % edge.size()], up}));
    }
}

}  // namespace

Mesh make_teapot() {
    Welder welder;
    for (std::size_t patch = 0; patch < teapot_patches.size(); ++patch) {
        add_patch(welder, control_net(patch));
    }
    add_spout_cap(welder);
    return welder.take("builtin:teapot");
}

}  // namespace sheen
