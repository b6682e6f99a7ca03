// SPDX-License-Identifier: MIT
#include "sheen/method.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"

namespace sheen {
namespace {

constexpr double farthest_depth = 65534.0;  // of a vertex: rounding must not wrap it

/// A colour node: within ±306, so that the quadratic's overshoot by 5/3 still fits ten integer bits.
glm::dvec3 node_colour(const Scene& scene, const glm::dvec3& position, const glm::dvec3& normal) {
    const glm::dvec3 limit(hls::colour_node_limit);
    return glm::clamp(shade(scene.material, scene.lights, normal, to_eye(scene, position)), -limit, limit);
}

/// The colour at the middle of an edge, from the edge alone: the same to the bit whichever triangle asks.
glm::dvec3 midpoint_colour(const Scene& scene, const ScreenVertex& a, const ScreenVertex& b) {
    const glm::dvec3 position = 0.5 * (a.position + b.position);
    return node_colour(scene, position, midpoint_normal(a.normal, b.normal, to_eye(scene, position)));
}

template <std::size_t count>
std::array<double, count> component(const std::array<glm::dvec3, count>& colours, int index) {
    std::array<double, count> values{};
    std::transform(colours.begin(), colours.end(), values.begin(), [&](const glm::dvec3& c) { return c[index]; });
    return values;
}

using ScreenPoints = std::array<SnappedPoint, 3>;

ScreenPoints screen_points(const ScreenTriangle& triangle) {
    return {triangle.vertices[0].point, triangle.vertices[1].point, triangle.vertices[2].point};
}

std::array<Polynomial, 3> flat_colour(const Scene& scene, const ScreenTriangle& triangle) {
    const auto& v = triangle.vertices;
    const glm::dvec3 colour =
        node_colour(scene, (v[0].position + v[1].position + v[2].position) / 3.0, triangle.face_normal);
    std::array<Polynomial, 3> channels;
    for (int c = 0; c < 3; ++c) {
        channels[static_cast<std::size_t>(c)] = fit_linear(screen_points(triangle), {colour[c], colour[c], colour[c]});
    }
    return channels;
}

std::array<Polynomial, 3> gouraud_colour(const Scene& scene, const ScreenTriangle& triangle) {
    std::array<glm::dvec3, 3> nodes{};
    for (std::size_t k = 0; k < 3; ++k) {
        nodes[k] = node_colour(scene, triangle.vertices[k].position, triangle.vertices[k].normal);
    }
    std::array<Polynomial, 3> channels;
    for (int c = 0; c < 3; ++c) {
        channels[static_cast<std::size_t>(c)] = fit_linear(screen_points(triangle), component(nodes, c));
    }
    return channels;
}

std::array<Polynomial, 3> quadratic_colour(const Scene& scene, const ScreenTriangle& triangle) {
    const auto& v = triangle.vertices;
    std::array<glm::dvec3, 6> nodes{};
    for (std::size_t k = 0; k < 3; ++k) {
        nodes[k] = node_colour(scene, v[k].position, v[k].normal);
        nodes[3 + k] = midpoint_colour(scene, v[k], v[(k + 1) % 3]);
    }
    std::array<Polynomial, 3> channels;
    for (int c = 0; c < 3; ++c) {
        channels[static_cast<std::size_t>(c)] = fit_quadratic(screen_points(triangle), component(nodes, c));
    }
    return channels;
}

/// How far (in barycentric coordinates) a piece may reach out of its triangle and keep its polynomial. Between nodes
/// of ±306 the quadratic stays within ±383 on an edge, and within ±500 up to here: it fits ten integer bits.
constexpr double reach = 1.0 / 32.0;

/// Value at a point given in 1/256 px.
double value_at(const Polynomial& polynomial, Coefficient x, Coefficient y) {
    constexpr Coefficient pixel = 1 << hls::subpixel_bits;
    return static_cast<double>(polynomial.value(x / pixel - Coefficient{0.5}, y / pixel - Coefficient{0.5}));
}

double value_at(const Polynomial& polynomial, const SnappedPoint& point) {
    return value_at(polynomial, static_cast<Coefficient>(point.x), static_cast<Coefficient>(point.y));
}

/// True when the triangle's own polynomials hold at the piece's corners, and so everywhere in it: colour as above, and
/// depth without wrapping.
bool keeps_polynomials(const TriangleShading& shading, const ScreenPoints& triangle, const ScreenPoints& piece) {
    return std::all_of(piece.begin(), piece.end(), [&](const SnappedPoint& corner) {
        const auto lambda = barycentric_coordinates(triangle, corner);
        const double depth = value_at(shading.depth, corner);
        return *std::min_element(lambda.begin(), lambda.end()) >= Coefficient{-reach} && depth >= 0.0 &&
               depth <= farthest_depth + 1.0;
    });
}

/// The polynomial's value at a point of the plane, or where the point leaves the triangle, at its border.
double value_inside(const Polynomial& polynomial, const ScreenPoints& triangle, const SnappedPoint& point) {
    auto lambda = barycentric_coordinates(triangle, point);
    Coefficient sum{0};
    for (Coefficient& l : lambda) {
        l = std::max(l, Coefficient{0});
        sum += l;
    }
    Coefficient x{0};
    Coefficient y{0};
    for (std::size_t k = 0; k < 3; ++k) {
        x += lambda[k] / sum * static_cast<Coefficient>(triangle[k].x);
        y += lambda[k] / sum * static_cast<Coefficient>(triangle[k].y);
    }
    return value_at(polynomial, x, y);
}

/// A polynomial for a piece that leaves its triangle: fitted to the piece, with nodes moved into the triangle.
Polynomial refitted(const Polynomial& polynomial, const ScreenPoints& triangle, const ScreenPoints& piece, bool linear,
                    double limit) {
    std::array<double, 6> nodes{};
    for (std::size_t k = 0; k < 3; ++k) {
        const SnappedPoint& a = piece[k];
        const SnappedPoint& b = piece[(k + 1) % 3];
        const SnappedPoint middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        nodes[k] = std::clamp(value_inside(polynomial, triangle, a), -limit, limit);
        nodes[3 + k] = std::clamp(value_inside(polynomial, triangle, middle), -limit, limit);
    }
    return linear ? fit_linear(piece, {nodes[0], nodes[1], nodes[2]}) : fit_quadratic(piece, nodes);
}

/// The triangle's shading as a piece uses it: about the middle of what is drawn. Snapping the clipped corners again
/// moves them by up to half a subpixel, which takes them far out of a sliver thinner than that, where its polynomial
/// soars: such a piece gets its own.
TriangleShading shading_of_piece(const TriangleShading& shading, const ScreenPoints& triangle,
                                 const ScreenPoints& piece) {
    const bool keeps = keeps_polynomials(shading, triangle, piece);
    const PixelIndex origin = centre_pixel(piece);
    const auto adapted = [&](const Polynomial& p, bool linear, double limit) {
        return keeps ? p.recentred(origin.x, origin.y) : refitted(p, triangle, piece, linear, limit);
    };
    TriangleShading result = shading;
    for (Polynomial& channel : result.colour) channel = adapted(channel, shading.linear, hls::colour_node_limit);
    result.depth = adapted(shading.depth, true, farthest_depth);
    return result;
}

TriangleSetup make_setup(const TriangleShading& shading, const TriangleWalk& walk) {
    TriangleSetup setup;
    setup.walk = walk;
    setup.linear = shading.linear;
    for (std::size_t c = 0; c < setup.colour.size(); ++c) {
        setup.colour[c] = channel_words(shading.colour[c], walk, hls::colour_fraction_bits, true);
    }
    setup.depth = channel_words(shading.depth, walk, hls::depth_fraction_bits, true);
    return setup;
}

}  // namespace

const std::vector<Method>& all_methods() {
    static const std::vector<Method> methods{Method::flat, Method::gouraud, Method::quadratic, Method::phong};
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

bool has_packets(Method method) { return method != Method::phong; }

glm::dvec3 midpoint_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye) {
    constexpr double vanishing = 1e-6;  // length of a + b below which its direction is rounding noise
    const glm::dvec3 sum = a + b;
    if (glm::length(sum) > vanishing) return glm::normalize(sum);
    const glm::dvec3 axis = glm::normalize(a - b);
    const glm::dvec3 towards_eye = eye - glm::dot(eye, axis) * axis;
    return glm::length(towards_eye) > vanishing ? glm::normalize(towards_eye) : eye;
}

TriangleShading shade_triangle(Method method, const Scene& scene, const ScreenTriangle& triangle) {
    const auto& v = triangle.vertices;
    TriangleShading shading;
    shading.linear = method != Method::quadratic;
    switch (method) {
        case Method::flat:
            shading.colour = flat_colour(scene, triangle);
            break;
        case Method::gouraud:
            shading.colour = gouraud_colour(scene, triangle);
            break;
        case Method::quadratic:
            shading.colour = quadratic_colour(scene, triangle);
            break;
        case Method::phong:
            throw Error("method 'phong' is computed per pixel: it has no polynomial and no packets");
    }
    shading.depth = fit_linear(screen_points(triangle), {v[0].depth, v[1].depth, v[2].depth});
    return shading;
}

std::vector<TriangleSetup> make_setups(Method method, const Scene& scene,
                                       const std::vector<ScreenTriangle>& triangles) {
    std::vector<TriangleSetup> setups;
    for (const ScreenTriangle& triangle : triangles) {
        std::optional<TriangleShading> shading;
        for (const auto& piece : triangle.pieces) {
            const auto walk = walk_triangle(piece[0], piece[1], piece[2]);
            if (!walk) continue;
            if (!shading) shading = shade_triangle(method, scene, triangle);
            setups.push_back(make_setup(shading_of_piece(*shading, screen_points(triangle), piece), *walk));
        }
    }
    return setups;
}

}  // namespace sheen
