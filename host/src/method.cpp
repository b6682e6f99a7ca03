// SPDX-License-Identifier: MIT
#include "sheen/method.hpp"

#include <algorithm>
#include <glm/common.hpp>

#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/lit_setup.hpp"

namespace sheen {
namespace {

/// Its colour is a polynomial over the triangle.
bool is_polynomial(Method method) {
    return method == Method::flat || method == Method::gouraud || method == Method::quadratic;
}

/// A colour node: within ±306, so that the quadratic's overshoot by 5/3 still fits ten integer bits.
glm::dvec3 node_colour(const Scene& scene, const Material& material, const SurfacePoint& node) {
    const glm::dvec3 limit(hls::colour_node_limit);
    return glm::clamp(shade(material, scene.lights, node), -limit, limit);
}

std::array<SnappedPoint, 3> screen_points(const ScreenTriangle& triangle) {
    return {triangle.vertices[0].point, triangle.vertices[1].point, triangle.vertices[2].point};
}

/// One colour component of the first nodes.
template <std::size_t count>
std::array<double, count> component(const TriangleNodes& nodes, std::size_t index) {
    std::array<double, count> values{};
    for (std::size_t k = 0; k < count; ++k) values[k] = nodes.colour[k][static_cast<int>(index)];
    return values;
}

}  // namespace

const std::vector<Method>& all_methods() {
    static const std::vector<Method> methods{
        Method::flat,          Method::gouraud,   Method::quadratic,  Method::duff,          Method::taylor,
        Method::taylor_finite, Method::spherical, Method::recurrence, Method::log_quadratic, Method::phong};
    return methods;
}

std::string to_string(Method method) {
    switch (method) {
        case Method::flat:
            return "flat";
        case Method::gouraud:
            return "gouraud";
        case Method::quadratic:
            return "quadratic";
        case Method::duff:
            return "duff";
        case Method::taylor:
            return "taylor";
        case Method::taylor_finite:
            return "taylor-finite";
        case Method::spherical:
            return "spherical";
        case Method::recurrence:
            return "recurrence";
        case Method::log_quadratic:
            return "log-quadratic";
        case Method::phong:
            return "phong";
    }
    throw Error("method number " + std::to_string(static_cast<int>(method)) + " does not exist");
}

Method parse_method(const std::string& word) {
    std::string names;
    for (const Method method : all_methods()) {
        if (word == to_string(method)) return method;
        names += (names.empty() ? "" : ", ") + to_string(method);
    }
    throw UsageError("unknown method '" + word + "': expected one of " + names);
}

bool has_log_channels(Method method) {
    return method == Method::log_quadratic || method == Method::taylor || method == Method::taylor_finite;
}

bool has_packets(Method method) { return is_polynomial(method) || has_log_channels(method); }

glm::dvec3 TriangleNodes::colour_at(const glm::dvec3& weights) const {
    glm::dvec3 sum(0.0);
    for (int k = 0; k < 3; ++k) {
        const double weight = weights[k];
        sum += colour[static_cast<std::size_t>(k)] * (linear ? weight : weight * (2.0 * weight - 1.0));
        if (!linear) sum += colour[static_cast<std::size_t>(3 + k)] * (4.0 * weight * weights[(k + 1) % 3]);
    }
    return sum;
}

TriangleNodes shade_nodes(Method method, const Scene& scene, const ScreenTriangle& triangle) {
    if (!is_polynomial(method)) throw Error("method '" + to_string(method) + "' is no polynomial of colour");
    const auto& v = triangle.vertices;
    TriangleNodes nodes;
    nodes.linear = method != Method::quadratic;
    if (method == Method::flat) {
        const glm::dvec3 centroid = (v[0].position + v[1].position + v[2].position) / 3.0;
        const SurfacePoint middle{centroid, triangle.face_normal, to_eye(scene, centroid)};
        std::fill_n(nodes.colour.begin(), 3, node_colour(scene, triangle.material, middle));
        return nodes;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        nodes.colour[k] = node_colour(scene, triangle.material, vertex_node(scene, v[k]));
        if (nodes.linear) continue;
        nodes.colour[3 + k] = node_colour(scene, triangle.material, edge_node(scene, v[k], v[(k + 1) % 3]));
    }
    return nodes;
}

std::array<Polynomial, 3> fit_colour(const TriangleNodes& nodes, const ScreenTriangle& triangle,
                                     const PixelIndex& origin) {
    const std::array<SnappedPoint, 3> points = screen_points(triangle);
    std::array<Polynomial, 3> colour;
    for (std::size_t c = 0; c < colour.size(); ++c) {
        colour[c] = nodes.linear ? fit_linear(points, component<3>(nodes, c), origin)
                                 : fit_quadratic(points, component<6>(nodes, c), origin);
    }
    return colour;
}

Polynomial fit_depth(const ScreenTriangle& triangle, const PixelIndex& origin) {
    const auto& v = triangle.vertices;
    return fit_linear(screen_points(triangle), {v[0].depth, v[1].depth, v[2].depth}, origin);
}

ChannelWords depth_words(const ScreenTriangle& triangle, const TriangleWalk& walk) {
    return channel_words(fit_depth(triangle, centre_pixel(walk)), walk, hls::depth_fraction_bits, true);
}

TriangleSetup make_setup(const TriangleNodes& nodes, const ScreenTriangle& triangle, const TriangleWalk& walk) {
    const std::array<Polynomial, 3> colour = fit_colour(nodes, triangle, centre_pixel(walk));
    TriangleSetup setup;
    setup.walk = walk;
    setup.linear = nodes.linear;
    for (std::size_t c = 0; c < colour.size(); ++c) {
        setup.colour[c] = channel_words(colour[c], walk, hls::colour_fraction_bits, true);
    }
    setup.depth = depth_words(triangle, walk);
    return setup;
}

std::vector<TriangleSetup> make_setups(Method method, const Scene& scene, const std::vector<ScreenTriangle>& triangles,
                                       const MethodOptions& options) {
    std::vector<TriangleSetup> setups;
    if (has_log_channels(method)) {
        const LitSetups lit(method, options, scene);
        for (const ScreenTriangle& triangle : triangles) {
            if (triangle.walks.empty()) continue;
            const LitNodes nodes = lit.nodes(triangle);
            for (const TriangleWalk& walk : triangle.walks) setups.push_back(LitSetups::setup(nodes, triangle, walk));
        }
        return setups;
    }
    for (const ScreenTriangle& triangle : triangles) {
        if (triangle.walks.empty()) continue;
        const TriangleNodes nodes = shade_nodes(method, scene, triangle);
        for (const TriangleWalk& walk : triangle.walks) setups.push_back(make_setup(nodes, triangle, walk));
    }
    return setups;
}

}  // namespace sheen
