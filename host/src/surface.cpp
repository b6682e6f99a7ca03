// SPDX-License-Identifier: MIT
#include "sheen/surface.hpp"

#include <glm/geometric.hpp>

namespace sheen {

glm::dvec3 surface_weights(const Scene& scene, const ScreenTriangle& triangle, const glm::dvec3& screen_weights) {
    if (!scene.field_of_view) return screen_weights;
    glm::dvec3 weights(0.0);
    for (int k = 0; k < 3; ++k) {
        weights[k] = screen_weights[k] / -triangle.vertices[static_cast<std::size_t>(k)].position.z;
    }
    return weights / (weights[0] + weights[1] + weights[2]);
}

SurfacePoint surface_point(const Scene& scene, const ScreenTriangle& triangle, const glm::dvec3& screen_weights) {
    const glm::dvec3 weights = surface_weights(scene, triangle, screen_weights);
    SurfacePoint point{glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0)};
    for (int k = 0; k < 3; ++k) {
        const ScreenVertex& vertex = triangle.vertices[static_cast<std::size_t>(k)];
        point.normal += weights[k] * vertex.normal;
        point.position += weights[k] * vertex.position;
    }
    const double length = glm::length(point.normal);
    point.normal = length > 0.0 ? point.normal / length : triangle.face_normal;
    point.to_eye = to_eye(scene, point.position);
    return point;
}

glm::dvec3 midpoint_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye, double lean) {
    constexpr double vanishing = 1e-6;  // length of the sum below which its direction is rounding noise
    const glm::dvec3 sum = (a + b) + lean * (a - b);
    if (glm::length(sum) > vanishing) return glm::normalize(sum);
    const glm::dvec3 axis = glm::normalize(a - b);
    const glm::dvec3 towards_eye = eye - glm::dot(eye, axis) * axis;
    return glm::length(towards_eye) > vanishing ? glm::normalize(towards_eye) : eye;
}

SurfacePoint vertex_node(const Scene& scene, const ScreenVertex& vertex) {
    return {vertex.position, vertex.normal, to_eye(scene, vertex.position)};
}

SurfacePoint edge_node(const Scene& scene, const ScreenVertex& a, const ScreenVertex& b) {
    // Weights on the surface are (1 ± lean)/2: w_b/(w_a + w_b) for a. Exchanging a and b changes signs only, so that
    // products and sums keep their bits.
    const double lean = scene.field_of_view ? (a.position.z - b.position.z) / -(a.position.z + b.position.z) : 0.0;
    SurfacePoint node;
    node.position = 0.5 * (a.position + b.position) + 0.5 * lean * (a.position - b.position);
    node.to_eye = to_eye(scene, node.position);
    node.normal = midpoint_normal(a.normal, b.normal, node.to_eye, lean);
    return node;
}

}  // namespace sheen
