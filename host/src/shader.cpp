// SPDX-License-Identifier: MIT
/// \file
/// Shaders of the methods that need nothing but their nodes, and Phong; the table of all shaders.
#include "sheen/shader.hpp"

#include <utility>

#include "fast_phong.hpp"
#include "sheen/error.hpp"
#include "sheen/log_quadratic.hpp"
#include "sheen/recurrence.hpp"
#include "sheen/spherical.hpp"

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

/// `log-quadratic`: diffuse and highlights from nodes of their own.
class LogShader : public Shader {
 public:
    explicit LogShader(LogNodes nodes) : nodes_(std::move(nodes)) {}
    [[nodiscard]] glm::dvec3 colour(int /*x*/, const glm::dvec3& weights) const override {
        return nodes_.colour_at(weights);
    }

 private:
    LogNodes nodes_;
};

/// `phong`: position and normal interpolated on the surface at every pixel, then shaded.
class PhongShader : public Shader {
 public:
    PhongShader(const Scene& scene, const ScreenTriangle& triangle) : scene_(scene), triangle_(triangle) {}
    [[nodiscard]] glm::dvec3 colour(int /*x*/, const glm::dvec3& weights) const override {
        return shade(triangle_.material, scene_.lights, surface_point(scene_, triangle_, weights));
    }

 private:
    const Scene& scene_;
    const ScreenTriangle& triangle_;
};

}  // namespace

std::optional<std::string> why_inexpressible(Method method, const Scene& scene) {
    switch (method) {
        case Method::flat:
        case Method::gouraud:
        case Method::quadratic:
        case Method::phong:
            return std::nullopt;
        case Method::log_quadratic:
            return why_not_logarithmic(scene);
        case Method::spherical:
            return why_not_spherical(scene);
        case Method::recurrence:
            return why_not_recurrent(scene);
        case Method::duff:
        case Method::taylor:
            return why_not_infinite(method, scene);
        case Method::taylor_finite:
            return why_not_blinn(method, scene);
    }
    throw Error("method number " + std::to_string(static_cast<int>(method)) + " does not exist");
}

std::unique_ptr<Shader> make_shader(Method method, const MethodOptions& options, const Scene& scene,
                                    const ScreenTriangle& triangle) {
    if (const std::optional<std::string> reason = why_inexpressible(method, scene)) throw Error(*reason);
    switch (method) {
        case Method::flat:
        case Method::gouraud:
        case Method::quadratic:
            return std::make_unique<NodeShader>(shade_nodes(method, scene, triangle));
        case Method::duff:
            return make_duff_shader(options, scene, triangle);
        case Method::taylor:
        case Method::taylor_finite:
            return make_taylor_shader(method, options, scene, triangle);
        case Method::spherical:
            return make_spherical_shader(options, scene, triangle);
        case Method::recurrence:
            return make_recurrence_shader(options, scene, triangle);
        case Method::log_quadratic:
            return std::make_unique<LogShader>(shade_log_nodes(options, scene, triangle));
        case Method::phong:
            return std::make_unique<PhongShader>(scene, triangle);
    }
    throw Error("method number " + std::to_string(static_cast<int>(method)) + " does not exist");
}

}  // namespace sheen
