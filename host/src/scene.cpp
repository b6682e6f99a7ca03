// SPDX-License-Identifier: MIT
/// \file
/// The orthographic camera: mesh units to eye space to 1/256 pixel.
#include "sheen/scene.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"

namespace sheen {
namespace {

constexpr int max_side = 4095;
constexpr double fill = 0.9;          ///< of the image's height, by the bounding sphere
constexpr double eye_distance = 4.0;  ///< of the sphere's centre, in radii
constexpr double near_plane = 3.0;    ///< in radii; the far plane is at 5
constexpr double nearest_depth = 1.0;
constexpr double farthest_depth = 65534.0;
constexpr double subpixels = 1 << hls::subpixel_bits;

/// Rotation about x, then y, then z.
glm::dmat3 rotation(const glm::dvec3& degrees) {
    const glm::dvec3 angle = glm::radians(degrees);
    const glm::dvec3 c = glm::cos(angle);
    const glm::dvec3 s = glm::sin(angle);
    // glm takes columns.
    const glm::dmat3 about_x({1, 0, 0}, {0, c.x, s.x}, {0, -s.x, c.x});
    const glm::dmat3 about_y({c.y, 0, -s.y}, {0, 1, 0}, {s.y, 0, c.y});
    const glm::dmat3 about_z({c.z, s.z, 0}, {-s.z, c.z, 0}, {0, 0, 1});
    return about_z * about_y * about_x;
}

/// A mesh's place before the camera. Points are handled in units of the bounding sphere's radius about its centre, so
/// that neither tiny nor huge meshes lose precision.
class View {
 public:
    explicit View(const Scene& scene)
        : scene_(scene), sphere_(bounding_sphere(scene.mesh)), rotation_(rotation(scene.rotate_degrees)) {
        if (!std::isfinite(sphere_.radius) || sphere_.radius <= 0.0) {
            throw Error(scene.mesh.name + ": the mesh cannot be framed: the radius of its bounding sphere is " +
                        std::to_string(sphere_.radius) + "; it must be positive and finite");
        }
    }

    [[nodiscard]] ScreenVertex vertex(std::uint32_t index) const {
        const glm::dvec3 unit = rotation_ * ((scene_.mesh.positions[index] - sphere_.centre) / sphere_.radius);
        const double pixels_per_radius = 0.5 * fill * scene_.height;
        ScreenVertex result;
        result.point.x = std::llround(subpixels * (0.5 * scene_.width + pixels_per_radius * unit.x));
        result.point.y = std::llround(subpixels * (0.5 * scene_.height - pixels_per_radius * unit.y));
        const double behind_near_plane = (eye_distance - unit.z - near_plane) / (2.0 * (eye_distance - near_plane));
        result.depth = nearest_depth + behind_near_plane * (farthest_depth - nearest_depth);
        result.position = sphere_.radius * (unit - glm::dvec3(0.0, 0.0, eye_distance));
        result.normal = rotation_ * scene_.mesh.normals[index];
        return result;
    }

    /// Unit normal of the side that faces the eye; towards the eye where rounding leaves the triangle without one.
    [[nodiscard]] glm::dvec3 visible_normal(const std::array<ScreenVertex, 3>& vertices) const {
        const glm::dvec3 u = (vertices[1].position - vertices[0].position) / sphere_.radius;
        const glm::dvec3 v = (vertices[2].position - vertices[0].position) / sphere_.radius;
        const glm::dvec3 area = glm::cross(u, v);
        const double length = glm::length(area);
        if (length == 0.0) {
            return {0.0, 0.0, 1.0};
        }
        return area / (area.z < 0.0 ? -length : length);
    }

 private:
    const Scene& scene_;
    BoundingSphere sphere_;
    glm::dmat3 rotation_;
};

const Material& material_of(const Scene& scene, std::size_t triangle) {
    const Mesh& mesh = scene.mesh;
    return mesh.triangle_materials.empty() ? scene.material : mesh.materials[mesh.triangle_materials[triangle]];
}

void require_size(const Scene& scene) {
    if (scene.width < 1 || scene.width > max_side || scene.height < 1 || scene.height > max_side) {
        throw UsageError("impossible image size " + std::to_string(scene.width) + "x" + std::to_string(scene.height) +
                         "; width and height must be 1 to " + std::to_string(max_side));
    }
}

}  // namespace

std::vector<ScreenTriangle> project(const Scene& scene) {
    require_size(scene);
    const View view(scene);
    std::vector<ScreenTriangle> result;
    for (std::size_t index = 0; index < scene.mesh.triangles.size(); ++index) {
        const auto& indices = scene.mesh.triangles[index];
        ScreenTriangle triangle;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            triangle.vertices[corner] = view.vertex(indices[corner]);
        }
        const std::array<SnappedPoint, 3> points{triangle.vertices[0].point, triangle.vertices[1].point,
                                                 triangle.vertices[2].point};
        // Counter-clockwise for the viewer is a negative area, as y points down on the screen. A triangle without
        // area covers no pixel.
        const bool back_face = doubled_area(points[0], points[1], points[2]) > 0;
        if (back_face && !scene.two_sided) {
            continue;
        }
        triangle.walks = walk_in_image(points[0], points[1], points[2], scene.width, scene.height);
        if (triangle.walks.empty()) {
            continue;
        }
        triangle.material = material_of(scene, index);
        triangle.face_normal = view.visible_normal(triangle.vertices);
        if (back_face) {
            for (ScreenVertex& vertex : triangle.vertices) {
                vertex.normal = -vertex.normal;
            }
        }
        result.push_back(std::move(triangle));
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
