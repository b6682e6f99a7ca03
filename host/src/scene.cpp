// SPDX-License-Identifier: MIT
/// \file
/// From mesh to screen triangles: clipped at the near plane, culled, and walked in the image.
#include "sheen/scene.hpp"

#include <array>
#include <glm/geometric.hpp>

#include "camera.hpp"

namespace sheen {
namespace {

using EyeTriangle = std::array<EyeVertex, 3>;

/// What the camera sees of a triangle: nothing, itself, or one or two triangles that end at the near plane, wound the
/// same way. A crossing depends on its edge alone, so that neighbours stay joined.
std::vector<EyeTriangle> clip_near(const Camera& camera, const EyeTriangle& triangle) {
    std::vector<EyeVertex> outline;
    for (std::size_t k = 0; k < 3; ++k) {
        const EyeVertex& from = triangle[k];
        const EyeVertex& to = triangle[(k + 1) % 3];
        const bool from_seen = camera.sees(from);
        const bool to_seen = camera.sees(to);
        if (from_seen) outline.push_back(from);
        if (from_seen && !to_seen) outline.push_back(camera.near_crossing(from, to));
        if (!from_seen && to_seen) outline.push_back(camera.near_crossing(to, from));
    }
    std::vector<EyeTriangle> pieces;
    for (std::size_t k = 2; k < outline.size(); ++k) pieces.push_back({outline[0], outline[k - 1], outline[k]});
    return pieces;
}

const Material& material_of(const Scene& scene, std::size_t triangle) {
    const Mesh& mesh = scene.mesh;
    return mesh.triangle_materials.empty() ? scene.material : mesh.materials[mesh.triangle_materials[triangle]];
}

/// The piece on the screen; nothing when it is culled. Material and face normal are left.
std::optional<ScreenTriangle> on_screen(const Scene& scene, const Camera& camera, const EyeTriangle& piece) {
    ScreenTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle.vertices[k] = camera.to_screen(piece[k]);
    auto& [a, b, c] = triangle.vertices;
    // Counter-clockwise for the viewer is a negative area, as y points down on the screen. A triangle without area
    // covers no pixel.
    const bool back_face = doubled_area(a.point, b.point, c.point) > 0;
    if (back_face && !scene.two_sided) return std::nullopt;
    triangle.walks = walk_in_image(a.point, b.point, c.point, scene.width, scene.height);
    if (back_face) {
        for (ScreenVertex& vertex : triangle.vertices) vertex.normal = -vertex.normal;
    }
    return triangle;
}

}  // namespace

std::vector<ScreenTriangle> project(const Scene& scene, Uncovered uncovered) {
    const Camera camera(scene);
    std::vector<ScreenTriangle> result;
    for (std::size_t index = 0; index < scene.mesh.triangles.size(); ++index) {
        const auto& [a, b, c] = scene.mesh.triangles[index];
        const EyeTriangle whole{camera.vertex(a), camera.vertex(b), camera.vertex(c)};
        for (const EyeTriangle& piece : clip_near(camera, whole)) {
            std::optional<ScreenTriangle> triangle = on_screen(scene, camera, piece);
            if (!triangle || (triangle->walks.empty() && uncovered == Uncovered::drop)) continue;
            triangle->material = material_of(scene, index);
            triangle->face_normal = camera.visible_normal(whole[0], whole[1], whole[2]);
            result.push_back(std::move(*triangle));
        }
    }
    return result;
}

glm::dvec3 to_eye(const Scene& scene, const glm::dvec3& position) {
    const glm::dvec3 forward(0.0, 0.0, 1.0);
    if (!scene.field_of_view) return forward;
    const double distance = glm::length(position);
    return distance > 0.0 ? -position / distance : forward;
}

}  // namespace sheen
