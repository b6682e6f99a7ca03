// SPDX-License-Identifier: MIT
/// \file
/// Shaders of the methods that need nothing but their nodes, and Phong; the table of all shaders.
#include "sheen/shader.hpp"

#include <glm/geometric.hpp>

#include "sheen/error.hpp"

namespace sheen {
namespace {

/// `flat`, `gouraud`, `quadratic`: the nodes' polynomial in barycentric form.
class NodeShader : public Shader {
 public:
    explicit NodeShader(const TriangleNodes& nodes) : nodes_(nodes) {}
    [[nodiscard]] glm::dvec3 colour(int /*x*/, const glm::dvec3& weights) const override {
        return nodes_.colour_at(weights);
    }

 private:
    TriangleNodes nodes_;
};

/// `phong`: the normal interpolated linearly and normalised, then shaded. Where opposite normals cancel, the face's.
class PhongShader : public Shader {
 public:
    PhongShader(const Scene& scene, const ScreenTriangle& triangle) : scene_(scene), triangle_(triangle) {}
    [[nodiscard]] glm::dvec3 colour(int /*x*/, const glm::dvec3& weights) const override {
        SurfacePoint point{glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0)};
        for (int corner = 0; corner < 3; ++corner) {
            const ScreenVertex& vertex = triangle_.vertices[static_cast<std::size_t>(corner)];
            point.normal += weights[corner] * vertex.normal;
            point.position += weights[corner] * vertex.position;
        }
        const double length = glm::length(point.normal);
        point.normal = length > 0.0 ? point.normal / length : triangle_.face_normal;
        point.to_eye = to_eye(scene_, point.position);
        return shade(triangle_.material, scene_.lights, point);
    }

 private:
    const Scene& scene_;
    const ScreenTriangle& triangle_;
};

}  // namespace

std::optional<std::string> why_inexpressible(Method method, const Scene& /*scene*/) {
    switch (method) {
        case Method::flat:
        case Method::gouraud:
        case Method::quadratic:
        case Method::phong:
            return std::nullopt;
    }
    throw Error("method number " + std::to_string(static_cast<int>(method)) + " does not exist");
}

std::unique_ptr<Shader> make_shader(Method method, const MethodOptions& /*options*/, const Scene& scene,
                                    const ScreenTriangle& triangle) {
    if (const std::optional<std::string> reason = why_inexpressible(method, scene)) throw Error(*reason);
    switch (method) {
        case Method::flat:
        case Method::gouraud:
        case Method::quadratic:
            return std::make_unique<NodeShader>(shade_nodes(method, scene, triangle));
        case Method::phong:
            return std::make_unique<PhongShader>(scene, triangle);
    }
    throw Error("method number " + std::to_string(static_cast<int>(method)) + " does not exist");
}

}  // namespace sheen
