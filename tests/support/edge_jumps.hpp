// SPDX-License-Identifier: MIT
/// \file
/// How far colours are apart on the two sides of shared edges.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "sheen/shader.hpp"

namespace sheen::test {

/// A point on edge k of a triangle: `along` 0…1 from vertex k to the next.
inline glm::dvec3 edge_weights(std::size_t k, double along) {
    glm::dvec3 weights(0.0);
    weights[static_cast<int>(k)] = 1.0 - along;
    weights[static_cast<int>((k + 1) % 3)] = along;
    return weights;
}

inline glm::dvec2 screen_point(const ScreenVertex& v) { return glm::dvec2(v.point.x, v.point.y); }

/// Where on edge k the screen point lies (1/256 px), if it does: within two steps of snapping, since a T-junction's
/// vertex stands beside the edge.
inline std::optional<double> place_on_edge(const ScreenTriangle& t, std::size_t k, const glm::dvec2& point) {
    const glm::dvec2 from = screen_point(t.vertices[k]);
    const glm::dvec2 edge = screen_point(t.vertices[(k + 1) % 3]) - from;
    const double square = glm::dot(edge, edge);
    if (square == 0.0) return std::nullopt;
    const double along = glm::dot(point - from, edge) / square;
    if (along < 0.0 || along > 1.0 || glm::length(from + along * edge - point) > 2.0) return std::nullopt;
    return along;
}

/// The largest difference of a component, in 8-bit steps as shown, between two triangles that meet at the same point
/// of the surface along their edges, whether they share the whole edge or, as at a T-junction, a part of it. The
/// orthographic camera's triangles; `apart` in eye space is what two surfaces one behind the other are at least.
inline double largest_edge_jump(Method method, const MethodOptions& options, const Scene& scene,
                                const std::vector<ScreenTriangle>& triangles, double apart) {
    std::vector<std::unique_ptr<Shader>> shaders;
    for (const ScreenTriangle& t : triangles) shaders.push_back(make_shader(method, options, scene, t));
    const auto shown = [&](std::size_t i, const glm::dvec3& weights) {
        return glm::clamp(shaders[i]->colour(0, weights), glm::dvec3(0.0), glm::dvec3(255.0));
    };
    const auto position = [&](const ScreenTriangle& t, const glm::dvec3& w) {
        return w.x * t.vertices[0].position + w.y * t.vertices[1].position + w.z * t.vertices[2].position;
    };
    double largest = 0.0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (int sample = 0; sample < 3 * 16; ++sample) {
            const auto k = static_cast<std::size_t>(sample / 16);
            const glm::dvec3 here = edge_weights(k, (sample % 16 + 0.5) / 16.0);
            const glm::dvec2 point =
                glm::mix(screen_point(triangles[i].vertices[k]), screen_point(triangles[i].vertices[(k + 1) % 3]),
                         here[(static_cast<int>(k) + 1) % 3]);
            for (std::size_t j = 0; j < triangles.size(); ++j) {
                for (std::size_t m = 0; j != i && m < 3; ++m) {
                    const std::optional<double> along = place_on_edge(triangles[j], m, point);
                    if (!along) continue;
                    const glm::dvec3 there = edge_weights(m, *along);
                    if (glm::distance(position(triangles[i], here), position(triangles[j], there)) > apart) continue;
                    const glm::dvec3 jump = glm::abs(shown(i, here) - shown(j, there));
                    largest = std::max({largest, jump.x, jump.y, jump.z});
                }
            }
        }
    }
    return largest;
}

}  // namespace sheen::test
