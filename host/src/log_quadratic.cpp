// SPDX-License-Identifier: MIT
/// \file
/// Nodes of `log-quadratic`, and its formula per pixel in double precision.
#include "sheen/log_quadratic.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>

#include "log_channels.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/surface.hpp"

namespace sheen {
namespace {

constexpr double full_scale = 255.0;
constexpr double full_scale_log = 8.0;  ///< z of 2^0: a pixel's step
constexpr double ln2 = 0.693147180559945309417;
constexpr double tangent_exponent = 7.0;  ///< G at θ₀ unless 72° comes first
constexpr double steepest_angle = 72.0;   ///< degrees

/// −n·log₂ cos θ from sin θ, which stays precise for the small angles of a large n.
double log_cosine_power(double sine, double shininess) { return -0.5 * shininess * std::log1p(-sine * sine) / ln2; }

/// Radians between two vectors, precise at 0 and π too.
double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// θ: between the normal and the half vector (Blinn), or between the mirrored light and the eye (Phong). Without a half
/// vector, light and eye being opposite, there is no highlight.
double highlight_angle(Brdf brdf, const Light& light, const SurfacePoint& point) {
    const glm::dvec3 to_light = light.direction_from(point.position);
    if (brdf == Brdf::phong) return angle_between(glm::reflect(-to_light, point.normal), point.to_eye);
    const glm::dvec3 half = to_light + point.to_eye;
    return glm::length(half) > 0.0 ? angle_between(point.normal, half) : LogBellTangent::farthest;
}

/// The six points of a triangle at which it is shaded.
std::array<SurfacePoint, 6> node_points(const Scene& scene, const ScreenTriangle& triangle) {
    std::array<SurfacePoint, 6> points;
    for (std::size_t k = 0; k < 3; ++k) {
        points[k] = vertex_node(scene, triangle.vertices[k]);
        points[3 + k] = edge_node(scene, triangle.vertices[k], triangle.vertices[(k + 1) % 3]);
    }
    return points;
}

/// The quadratic through six nodes, where the vertices have these weights.
double quadratic_at(const std::array<double, 6>& nodes, const glm::dvec3& weights) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double weight = weights[k];
        sum += nodes[static_cast<std::size_t>(k)] * weight * (2.0 * weight - 1.0);
        sum += nodes[static_cast<std::size_t>(3 + k)] * 4.0 * weight * weights[(k + 1) % 3];
    }
    return sum;
}

/// The common highlight of lights of one tint: z = −log₂ Σ 2^(−zᵢ), which is near the brightest one's alone.
LogHighlight log_highlight(const MethodOptions& options, const Material& material, const std::vector<Light>& lights,
                           const std::vector<std::size_t>& of_channel, const std::array<SurfacePoint, 6>& points) {
    LogHighlight highlight;
    highlight.tint = tint_of(lights[of_channel.front()]);
    for (std::size_t k = 0; k < points.size(); ++k) {
        std::vector<double> z;
        for (const std::size_t index : of_channel) {
            const Light& light = lights[index];
            const double peak = full_scale * material.specular * brightest_component(light);
            const double bell = log_bell(highlight_angle(material.brdf, light, points[k]), material.shininess);
            z.push_back(std::min(full_scale_log - std::log2(peak) + bell, options.log_node_limit));
        }
        const double brightest = *std::min_element(z.begin(), z.end());
        const double sum = std::accumulate(z.begin(), z.end(), 0.0, [brightest](double total, double each) {
            return total + std::exp2(brightest - each);
        });
        highlight.z[k] = brightest - std::log2(sum);
    }
    return highlight;
}

}  // namespace

LogChannels assign_log_channels(const MethodOptions& options, const Material& material,
                                const std::vector<Light>& lights) {
    LogChannels result;
    if (material.specular <= 0.0) return result;
    std::vector<std::size_t> bright;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (brightest_component(lights[i]) > 0.0) bright.push_back(i);
    }
    std::stable_sort(bright.begin(), bright.end(), [&](std::size_t a, std::size_t b) {
        return brightest_component(lights[a]) > brightest_component(lights[b]);
    });
    for (const std::size_t light : bright) {
        const auto same_tint = std::find_if(
            result.logarithmic.rbegin(), result.logarithmic.rend(),
            [&](const auto& channel) { return tint_of(lights[channel.front()]) == tint_of(lights[light]); });
        if (result.logarithmic.size() < options.log_channels) {
            result.logarithmic.push_back({light});
        } else if (same_tint != result.logarithmic.rend()) {
            same_tint->push_back(light);
        } else {
            result.in_colour.push_back(light);
        }
    }
    return result;
}

std::optional<std::string> why_not_logarithmic(const Scene& scene) {
    const auto fits = [](const Material& material) { return material.brdf != Brdf::cook_torrance; };
    const std::vector<Material>& materials = scene.mesh.materials;
    const bool expressible = scene.mesh.triangle_materials.empty()
                                 ? fits(scene.material)
                                 : std::all_of(materials.begin(), materials.end(), fits);
    if (expressible) return std::nullopt;
    return "log-quadratic draws powers of a cosine: give every material the model blinn or phong, or take quadratic";
}

LogBellTangent::LogBellTangent(double shininess) {
    const double sine_squared_of_seven = -std::expm1(-2.0 * ln2 * tangent_exponent / shininess);
    start = std::min(std::asin(std::sqrt(sine_squared_of_seven)), glm::radians(steepest_angle));
    slope = shininess / ln2 * std::tan(start) / (2.0 * start);
    line = log_cosine_power(std::sin(start), shininess) - slope * start * start;
}

double log_bell(double angle, double shininess) {
    const LogBellTangent tangent(shininess);
    if (angle <= tangent.start) return log_cosine_power(std::sin(angle), shininess);
    const double capped = std::min(angle, LogBellTangent::farthest);
    return tangent.line + tangent.slope * (capped * capped);
}

glm::dvec3 unclamped_diffuse(const Material& material, const std::vector<Light>& lights, const SurfacePoint& point) {
    glm::dvec3 result(0.0);
    for (int c = 0; c < 3; ++c) {
        double lit = 0.0;
        double least_dark = -full_scale;
        bool reached = false;
        for (const Light& light : lights) {
            const double reflectance = full_scale * material.diffuse[c] * light.colour[c];
            if (reflectance <= 0.0) continue;
            const double radiance = reflectance * glm::dot(point.normal, light.direction_from(point.position));
            lit += std::max(0.0, radiance);
            least_dark = reached ? std::max(least_dark, radiance) : radiance;
            reached = true;
        }
        result[c] = lit > 0.0 ? lit : reached ? least_dark : 0.0;
    }
    return result;
}

glm::dvec3 LogHighlight::colour(double interpolated_z) const {
    return glm::min(std::exp2(full_scale_log - interpolated_z) * tint, glm::dvec3(std::exp2(full_scale_log)));
}

glm::dvec3 LogNodes::colour_at(const glm::dvec3& weights) const {
    glm::dvec3 sum = glm::max(diffuse.colour_at(weights), glm::dvec3(0.0)) + ambient;
    for (const LogHighlight& highlight : highlights) sum += highlight.colour(quadratic_at(highlight.z, weights));
    return sum;
}

LogNodes shade_log_nodes(const MethodOptions& options, const Scene& scene, const ScreenTriangle& triangle) {
    const std::array<SurfacePoint, 6> points = node_points(scene, triangle);
    const Material& material = triangle.material;
    const LogChannels channels = assign_log_channels(options, material, scene.lights);
    std::vector<Light> in_colour;
    for (const std::size_t light : channels.in_colour) in_colour.push_back(scene.lights[light]);
    Material mirror = material;
    mirror.ambient = mirror.diffuse = glm::dvec3(0.0);

    LogNodes nodes;
    nodes.ambient = full_scale * material.ambient;
    const glm::dvec3 limit(hls::colour_node_limit);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const glm::dvec3 diffuse = unclamped_diffuse(material, scene.lights, points[k]);
        nodes.diffuse.colour[k] = glm::clamp(diffuse + shade(mirror, in_colour, points[k]), -limit, limit);
    }
    for (const std::vector<std::size_t>& of_channel : channels.logarithmic) {
        nodes.highlights.push_back(log_highlight(options, material, scene.lights, of_channel, points));
    }
    return nodes;
}

}  // namespace sheen
