// SPDX-License-Identifier: MIT
/// \file
/// Splitting the triangles that a method shades too far from the truth (paper `quadratic`, section 4), on the screen.
///
/// A new vertex lies in the middle of an edge on the screen, snapped to 1/256 px, so that it may stand up to ½ of that
/// in x and y beside the edge. Its surface point and normal are those of the unsplit triangle there: Phong shading of
/// the pieces is Phong shading of the whole, and the silhouette moves by no more than the snapping.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sheen/method.hpp"
#include "sheen/method_options.hpp"
#include "sheen/scene.hpp"

namespace sheen {

/// Where a triangle's error is looked at, and how it is split.
enum class SubdivisionTest {
    /// The paper's: at the triangle's centre on the screen; four pieces, whatever the neighbours do. Highlights off the
    /// centre are missed. Where a neighbour is not split, colours jump along the edge, and pixel centres within the
    /// snapping of the edge may be missed or drawn twice.
    centre,
    /// On each edge at ¼ and ¾, and, where that finds nothing, in the centres of the triangle's four quarters. What is
    /// halved is an edge, in both of its triangles; these then fall into 2, 3 or 4 pieces. Colours along edges stay
    /// continuous, and each pixel of
    /// a
    /// closed mesh is covered as often as without.
    edge
};

/// "centre" or "edge". \throws UsageError for another word.
SubdivisionTest parse_subdivision_test(const std::string& word);

struct Subdivision {
    double tolerance = 4.0;  ///< 8-bit steps that a component may err at the points looked at, > 0
    SubdivisionTest test = SubdivisionTest::edge;
    int rounds = 5;  ///< an edge is halved at most so often
};

/// Edges shorter than this, in px, are not halved.
inline constexpr int shortest_split_edge = 2;

/// Why subdivision doesn't serve the method: its error is looked at anywhere in a triangle, and must shrink with it.
std::optional<std::string> why_indivisible(Method method);

/// The triangles in pieces, in the same order; those that cover no pixel are left out. `triangles` should be all of
/// project(scene, Uncovered::keep): a triangle without a pixel can lie between two that have some.
/// \throws UsageError where why_indivisible(), or when the tolerance is not positive.
std::vector<ScreenTriangle> subdivide(Method method, const MethodOptions& options, const Scene& scene,
                                      const std::vector<ScreenTriangle>& triangles, const Subdivision& subdivision);

}  // namespace sheen
