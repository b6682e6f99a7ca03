// SPDX-License-Identifier: MIT
#include "camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/surface.hpp"

namespace sheen {
namespace {

constexpr int max_side = 4095;
constexpr double least_field_of_view = 1.0;  // degrees
constexpr double greatest_field_of_view = 170.0;
constexpr double greatest_distance = 1000.0;     // radii
constexpr double fill = 0.9;                     // of the image's height, by the bounding sphere
constexpr double orthographic_distance = 4.0;    // radii
constexpr double least_near_plane = 1.0 / 256;   // radii: nearer than the sphere at its default distance ever comes
constexpr double greatest_offset = 1024 * 1024;  // pixels from the image's middle; half of what walk_in_image() takes
constexpr double depth_of_nearest = 1.0;
constexpr double depth_of_farthest = 65534.0;
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

void require_possible(const Scene& scene) {
    if (scene.width < 1 || scene.width > max_side || scene.height < 1 || scene.height > max_side) {
        throw UsageError("impossible image size " + std::to_string(scene.width) + "x" + std::to_string(scene.height) +
                         "; width and height must be 1 to " + std::to_string(max_side));
    }
    // Written so that NaN fails.
    if (scene.field_of_view &&
        !(*scene.field_of_view >= least_field_of_view && *scene.field_of_view <= greatest_field_of_view)) {
        throw UsageError("impossible field of view " + std::to_string(*scene.field_of_view) +
                         "; it must be 1 to 170 degrees");
    }
    if (scene.distance && !scene.field_of_view) {
        throw UsageError("a distance of the eye needs a field of view: the orthographic camera has none");
    }
    if (scene.distance && !(*scene.distance >= 0.0 && *scene.distance <= greatest_distance)) {
        throw UsageError("impossible distance " + std::to_string(*scene.distance) +
                         " of the eye from the mesh; it must be 0 to 1000 radii");
    }
}

/// The same way in both cases, from the value at `first` to that at `last`.
double mapped_depth(double value, double first, double last) {
    return depth_of_nearest + (value - first) / (last - first) * (depth_of_farthest - depth_of_nearest);
}

}  // namespace

Camera::Camera(const Scene& scene)
    : scene_(scene), rotation_(rotation(scene.rotate_degrees)), perspective_(scene.field_of_view.has_value()) {
    require_possible(scene);
    sphere_ = bounding_sphere(scene.mesh);
    if (!std::isfinite(sphere_.radius) || sphere_.radius <= 0.0) {
        throw Error(scene.mesh.name + ": the mesh cannot be framed: the radius of its bounding sphere is " +
                    std::to_string(sphere_.radius) + "; it must be positive and finite");
    }
    if (!perspective_) {
        focal_ = 0.5 * fill * scene.height;
        distance_ = orthographic_distance;
        nearest_depth_ = distance_ - 1.0;
    } else {
        const double tangent = std::tan(0.5 * glm::radians(*scene.field_of_view));
        focal_ = 0.5 * scene.height / tangent;
        // A tangent of the sphere through the eye meets the screen at `fill` of half its height.
        distance_ = scene.distance.value_or(std::hypot(1.0, 1.0 / (fill * tangent)));
        near_ = std::max(least_near_plane, focal_ / greatest_offset);
        nearest_depth_ = std::max(near_, distance_ - 1.0);
    }
    farthest_depth_ = distance_ + 1.0;
}

EyeVertex Camera::vertex(std::uint32_t index) const {
    const glm::dvec3 centred = (scene_.mesh.positions[index] - sphere_.centre) / sphere_.radius;
    return {rotation_ * centred - glm::dvec3(0.0, 0.0, distance_), rotation_ * scene_.mesh.normals[index]};
}

EyeVertex Camera::near_crossing(const EyeVertex& seen, const EyeVertex& unseen) const {
    const double t = (seen.position.z + near_) / (seen.position.z - unseen.position.z);
    EyeVertex crossing;
    crossing.position = seen.position + t * (unseen.position - seen.position);
    crossing.position.z = -near_;
    crossing.normal = midpoint_normal(seen.normal, unseen.normal, to_eye(scene_, crossing.position), 1.0 - 2.0 * t);
    return crossing;
}

ScreenVertex Camera::to_screen(const EyeVertex& vertex) const {
    const glm::dvec3& p = vertex.position;
    const double scale = perspective_ ? focal_ / -p.z : focal_;
    ScreenVertex result;
    result.point.x = std::llround(subpixels * (0.5 * scene_.width + scale * p.x));
    result.point.y = std::llround(subpixels * (0.5 * scene_.height - scale * p.y));
    result.depth = perspective_ ? mapped_depth(1.0 / p.z, -1.0 / nearest_depth_, -1.0 / farthest_depth_)
                                : mapped_depth(-p.z, nearest_depth_, farthest_depth_);
    result.position = sphere_.radius * p;
    result.normal = vertex.normal;
    return result;
}

glm::dvec3 Camera::visible_normal(const EyeVertex& a, const EyeVertex& b, const EyeVertex& c) const {
    const glm::dvec3 area = glm::cross(b.position - a.position, c.position - a.position);
    const double length = glm::length(area);
    const glm::dvec3 eye = to_eye(scene_, a.position);
    if (length == 0.0) return eye;
    return area / (glm::dot(area, eye) < 0.0 ? -length : length);
}

}  // namespace sheen
