// SPDX-License-Identifier: MIT
/// \file
/// Red and green splits of screen triangles, by the edge or by the centre.
#include "sheen/subdivide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <set>
#include <utility>

#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/shader.hpp"
#include "sheen/surface.hpp"

namespace sheen {
namespace {

constexpr double full_scale = 255.0;

/// A vertex of a piece.
struct Corner {
    ScreenVertex vertex;
    glm::dvec3 weights{0.0};  ///< barycentric on the screen, in the unsplit triangle; multiples of a power of ½, exact
};

/// What is left of an unsplit triangle.
struct Piece {
    std::size_t whole = 0;  ///< its index
    std::array<Corner, 3> corners;
    bool judged = false;  ///< its error has been looked at
};

/// An edge by its ends on the screen, the smaller first. Different edges that coincide there are halved together,
/// which does no harm, and neighbours find each other though they share no vertex, as along a seam of normals.
using EdgeKey = std::array<std::int64_t, 4>;

EdgeKey edge_key(const SnappedPoint& a, const SnappedPoint& b) {
    const bool in_order = a.x != b.x ? a.x < b.x : a.y < b.y;
    const SnappedPoint& first = in_order ? a : b;
    const SnappedPoint& second = in_order ? b : a;
    return {first.x, first.y, second.x, second.y};
}

EdgeKey edge_key(const Piece& piece, std::size_t k) {
    return edge_key(piece.corners[k].vertex.point, piece.corners[(k + 1) % 3].vertex.point);
}

bool long_enough(const EdgeKey& edge) {
    constexpr std::int64_t shortest = std::int64_t{shortest_split_edge} << hls::subpixel_bits;
    const std::int64_t dx = edge[2] - edge[0];
    const std::int64_t dy = edge[3] - edge[1];
    return dx * dx + dy * dy >= shortest * shortest;
}

std::int64_t signed_area(const std::array<Corner, 3>& corners) {
    return doubled_area(corners[0].vertex.point, corners[1].vertex.point, corners[2].vertex.point);
}

std::int64_t squared_distance(const Corner& a, const Corner& b) {
    const std::int64_t dx = a.vertex.point.x - b.vertex.point.x;
    const std::int64_t dy = a.vertex.point.y - b.vertex.point.y;
    return dx * dx + dy * dy;
}

/// Splits pieces of the scene's triangles and judges them.
class Splitter {
 public:
    Splitter(Method method, const MethodOptions& options, const Scene& scene,
             const std::vector<ScreenTriangle>& triangles, double tolerance)
        : method_(method), options_(options), scene_(scene), triangles_(triangles), tolerance_(tolerance) {}

    [[nodiscard]] Piece whole(std::size_t index) const {
        Piece piece{index, {}, false};
        for (std::size_t k = 0; k < 3; ++k) {
            piece.corners[k].vertex = triangles_[index].vertices[k];
            piece.corners[k].weights[static_cast<int>(k)] = 1.0;
        }
        return piece;
    }

    /// The pieces that halving these edges (01, 12, 20) makes, in the winding of the old one: itself, 2 (cut to the
    /// opposite corner), 3 (a corner off, the rest cut along its shorter diagonal) or 4. Nothing where snapping would
    /// turn one of them over.
    [[nodiscard]] std::vector<Piece> split(const Piece& piece, const std::array<bool, 3>& halved) const {
        std::array<Corner, 3> middles;
        for (std::size_t k = 0; k < 3; ++k) {
            if (halved[k]) middles[k] = middle(piece, piece.corners[k], piece.corners[(k + 1) % 3]);
        }
        const auto& c = piece.corners;
        const auto count = std::count(halved.begin(), halved.end(), true);
        std::vector<Piece> pieces;
        const auto add = [&](const Corner& p, const Corner& q, const Corner& r) {
            pieces.push_back({piece.whole, {p, q, r}, false});
        };
        if (count == 0) return {piece};
        if (count == 1) {
            const auto k = static_cast<std::size_t>(std::find(halved.begin(), halved.end(), true) - halved.begin());
            add(c[k], middles[k], c[(k + 2) % 3]);
            add(middles[k], c[(k + 1) % 3], c[(k + 2) % 3]);
        } else if (count == 2) {
            const auto k = static_cast<std::size_t>(std::find(halved.begin(), halved.end(), false) - halved.begin());
            const Corner& from = c[k];
            const Corner& to = c[(k + 1) % 3];
            const Corner& near_to = middles[(k + 1) % 3];
            const Corner& near_from = middles[(k + 2) % 3];
            add(near_to, c[(k + 2) % 3], near_from);
            if (squared_distance(from, near_to) <= squared_distance(to, near_from)) {
                add(from, to, near_to);
                add(from, near_to, near_from);
            } else {
                add(from, to, near_from);
                add(to, near_to, near_from);
            }
        } else {
            for (std::size_t k = 0; k < 3; ++k) add(c[k], middles[k], middles[(k + 2) % 3]);
            add(middles[0], middles[1], middles[2]);
        }
        return keeps_winding(piece, pieces) ? pieces : std::vector<Piece>{};
    }

    /// The piece as a method sees it, without its pixels.
    [[nodiscard]] ScreenTriangle triangle(const Piece& piece) const {
        const ScreenTriangle& source = triangles_[piece.whole];
        ScreenTriangle result;
        for (std::size_t k = 0; k < 3; ++k) result.vertices[k] = piece.corners[k].vertex;
        result.face_normal = source.face_normal;
        result.material = source.material;
        return result;
    }

    [[nodiscard]] bool visible(const Piece& piece) const { return !triangles_[piece.whole].walks.empty(); }
    [[nodiscard]] const Scene& scene() const { return scene_; }

    /// Tells where the method errs by more than the tolerance within one piece, against Phong on the unsplit triangle.
    class Judge {
     public:
        Judge(const Splitter& splitter, const Piece& piece)
            : splitter_(splitter),
              piece_(piece),
              triangle_(splitter.triangle(piece)),
              method_(make_shader(splitter.method_, splitter.options_, splitter.scene_, triangle_)),
              phong_(make_shader(Method::phong, splitter.options_, splitter.scene_, splitter.triangles_[piece.whole])) {
        }

        /// At the point where the piece's corners have these weights.
        [[nodiscard]] bool errs_at(const glm::dvec3& weights) const {
            glm::dvec3 in_whole(0.0);
            for (int k = 0; k < 3; ++k) in_whole += weights[k] * piece_.corners[static_cast<std::size_t>(k)].weights;
            const auto shown = [](const glm::dvec3& c) {
                return glm::clamp(c, glm::dvec3(0.0), glm::dvec3(full_scale));
            };
            const glm::dvec3 error = glm::abs(shown(method_->colour(0, weights)) - shown(phong_->colour(0, in_whole)));
            return std::max({error.x, error.y, error.z}) > splitter_.tolerance_;
        }

     private:
        const Splitter& splitter_;
        const Piece& piece_;
        ScreenTriangle triangle_;
        std::unique_ptr<Shader> method_;
        std::unique_ptr<Shader> phong_;
    };

 private:
    /// The middle of an edge on the screen: from the edge alone, the same to the bit from both sides. Its weights in
    /// either unsplit triangle are exact, and two that are not 0 add up alike in any order.
    [[nodiscard]] Corner middle(const Piece& piece, const Corner& a, const Corner& b) const {
        const ScreenTriangle& source = triangles_[piece.whole];
        Corner result;
        result.weights = 0.5 * (a.weights + b.weights);
        result.vertex.point = {(a.vertex.point.x + b.vertex.point.x) >> 1, (a.vertex.point.y + b.vertex.point.y) >> 1};
        result.vertex.depth = 0.5 * (a.vertex.depth + b.vertex.depth);
        const glm::dvec3 on_surface = surface_weights(scene_, source, result.weights);
        for (int k = 0; k < 3; ++k) {
            const ScreenVertex& vertex = source.vertices[static_cast<std::size_t>(k)];
            result.vertex.position += on_surface[k] * vertex.position;
            result.vertex.normal += on_surface[k] * vertex.normal;
        }
        const double length = glm::length(result.vertex.normal);
        constexpr double vanishing = 1e-6;
        result.vertex.normal =
            length > vanishing ? result.vertex.normal / length : edge_node(scene_, a.vertex, b.vertex).normal;
        return result;
    }

    [[nodiscard]] static bool keeps_winding(const Piece& old, const std::vector<Piece>& pieces) {
        const std::int64_t area = signed_area(old.corners);
        return std::all_of(pieces.begin(), pieces.end(), [area](const Piece& piece) {
            const std::int64_t part = signed_area(piece.corners);
            return part == 0 || (area != 0 && (part > 0) == (area > 0));
        });
    }

    Method method_;
    const MethodOptions& options_;
    const Scene& scene_;
    const std::vector<ScreenTriangle>& triangles_;
    double tolerance_;
};

/// The paper's test and split, down to `rounds` levels.
void split_by_centre(const Splitter& splitter, const Piece& piece, int rounds, std::vector<Piece>& result) {
    const bool splits = rounds > 0 && splitter.visible(piece) && long_enough(edge_key(piece, 0)) &&
                        long_enough(edge_key(piece, 1)) && long_enough(edge_key(piece, 2)) &&
                        Splitter::Judge(splitter, piece).errs_at(glm::dvec3(1.0 / 3.0));
    const std::vector<Piece> pieces = splits ? splitter.split(piece, {true, true, true}) : std::vector<Piece>{};
    if (pieces.empty()) result.push_back(piece);
    for (const Piece& part : pieces) split_by_centre(splitter, part, rounds - 1, result);
}

/// The edges that a piece wants halved: those with an error of their own; where they have none, but the inside has,
/// all.
std::array<bool, 3> judge_edges(const Splitter& splitter, const Piece& piece) {
    const Splitter::Judge judge(splitter, piece);
    std::array<bool, 3> wanted{};
    for (std::size_t k = 0; k < 3; ++k) {
        for (const double along : {0.25, 0.75}) {
            glm::dvec3 weights(0.0);
            weights[static_cast<int>(k)] = 1.0 - along;
            weights[static_cast<int>((k + 1) % 3)] = along;
            wanted[k] = wanted[k] || judge.errs_at(weights);
        }
    }
    if (wanted != std::array<bool, 3>{}) return wanted;
    bool inside = judge.errs_at(glm::dvec3(1.0 / 3.0));
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 quarter(1.0 / 6.0);
        quarter[k] = 2.0 / 3.0;
        inside = inside || judge.errs_at(quarter);
    }
    return {inside, inside, inside};
}

using Edges = std::set<EdgeKey>;

std::array<bool, 3> marks(const Piece& piece, const Edges& edges) {
    return {edges.count(edge_key(piece, 0)) > 0, edges.count(edge_key(piece, 1)) > 0,
            edges.count(edge_key(piece, 2)) > 0};
}

/// One round: halves every edge that one of its pieces wants halved, in all of them. Returns whether there was one.
bool split_by_edges(const Splitter& splitter, std::vector<Piece>& pieces) {
    Edges edges;
    for (Piece& piece : pieces) {
        if (std::exchange(piece.judged, true) || !splitter.visible(piece)) continue;
        const std::array<bool, 3> wanted = judge_edges(splitter, piece);
        for (std::size_t k = 0; k < 3; ++k) {
            if (wanted[k] && long_enough(edge_key(piece, k))) edges.insert(edge_key(piece, k));
        }
    }
    // An edge stays whole where halving it would turn a sliver over. That can spoil another split: until none is left.
    for (bool settled = false; !settled;) {
        settled = true;
        for (const Piece& piece : pieces) {
            if (!splitter.split(piece, marks(piece, edges)).empty()) continue;
            for (std::size_t k = 0; k < 3; ++k) edges.erase(edge_key(piece, k));
            settled = false;
        }
    }
    if (edges.empty()) return false;
    std::vector<Piece> result;
    for (const Piece& piece : pieces) {
        const std::vector<Piece> parts = splitter.split(piece, marks(piece, edges));
        result.insert(result.end(), parts.begin(), parts.end());
    }
    pieces = std::move(result);
    return true;
}

}  // namespace

SubdivisionTest parse_subdivision_test(const std::string& word) {
    if (word == "centre") return SubdivisionTest::centre;
    if (word == "edge") return SubdivisionTest::edge;
    throw UsageError("unknown subdivision test '" + word + "': expected centre or edge");
}

std::optional<std::string> why_indivisible(Method method) {
    if (method == Method::gouraud || method == Method::quadratic || method == Method::log_quadratic) {
        return std::nullopt;
    }
    return fmt::format(
        "{} can't be subdivided: give gouraud, quadratic or log-quadratic, which shade from nodes on the edges",
        to_string(method));
}

std::vector<ScreenTriangle> subdivide(Method method, const MethodOptions& options, const Scene& scene,
                                      const std::vector<ScreenTriangle>& triangles, const Subdivision& subdivision) {
    if (const std::optional<std::string> reason = why_indivisible(method)) throw UsageError(*reason);
    if (!(subdivision.tolerance > 0.0)) {
        throw UsageError(fmt::format("subdivision tolerance {} steps: must be above 0", subdivision.tolerance));
    }
    const Splitter splitter(method, options, scene, triangles, subdivision.tolerance);
    std::vector<Piece> pieces;
    for (std::size_t index = 0; index < triangles.size(); ++index) {
        const Piece whole = splitter.whole(index);
        if (subdivision.test == SubdivisionTest::centre) {
            split_by_centre(splitter, whole, subdivision.rounds, pieces);
        } else {
            pieces.push_back(whole);
        }
    }
    if (subdivision.test == SubdivisionTest::edge) {
        for (int round = 0; round < subdivision.rounds && split_by_edges(splitter, pieces); ++round) {
        }
    }
    std::vector<ScreenTriangle> result;
    for (const Piece& piece : pieces) {
        ScreenTriangle triangle = splitter.triangle(piece);
        triangle.walks = walk_in_image(triangle.vertices[0].point, triangle.vertices[1].point,
                                       triangle.vertices[2].point, scene.width, scene.height);
        if (!triangle.walks.empty()) result.push_back(std::move(triangle));
    }
    return result;
}

}  // namespace sheen
