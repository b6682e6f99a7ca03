// SPDX-License-Identifier: MIT
/// \file
/// Per-pixel evaluation in double precision.
#include "sheen/reference.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sheen/hls/formats.hpp"

namespace sheen {
namespace {

constexpr double full_scale = 255.0;

/// Weights of a triangle's vertices at pixel centres, from exact integer areas; they reach outside 0…1 where a clipped
/// piece leaves the triangle by its rounding.
class Barycentric {
 public:
    explicit Barycentric(const std::array<ScreenVertex, 3>& vertices)
        : points_{vertices[0].point, vertices[1].point, vertices[2].point},
          area_(static_cast<double>(doubled_area(points_[0], points_[1], points_[2]))) {}

    [[nodiscard]] glm::dvec3 at(int x, int y) const {
        constexpr std::int64_t pixel = std::int64_t{1} << hls::subpixel_bits;
        const SnappedPoint centre{pixel * x + pixel / 2, pixel * y + pixel / 2};
        return glm::dvec3(static_cast<double>(doubled_area(centre, points_[1], points_[2])),
                          static_cast<double>(doubled_area(points_[0], centre, points_[2])),
                          static_cast<double>(doubled_area(points_[0], points_[1], centre))) /
               area_;
    }

 private:
    std::array<SnappedPoint, 3> points_;
    double area_;
};

/// Phong: the normal interpolated linearly and normalised, then shaded. Where opposite normals cancel, the face's.
glm::dvec3 phong_colour(const Scene& scene, const ScreenTriangle& triangle, const glm::dvec3& weights) {
    glm::dvec3 normal(0.0);
    glm::dvec3 position(0.0);
    for (int corner = 0; corner < 3; ++corner) {
        const ScreenVertex& vertex = triangle.vertices[static_cast<std::size_t>(corner)];
        normal += weights[corner] * vertex.normal;
        position += weights[corner] * vertex.position;
    }
    const double length = glm::length(normal);
    normal = length > 0.0 ? normal / length : triangle.face_normal;
    return shade(scene.material, scene.lights, normal, to_eye(scene, position));
}

/// As devices round it: ½ added, then cut to 16 bits.
std::uint16_t device_depth(const ScreenTriangle& triangle, const glm::dvec3& weights) {
    constexpr double greatest = (1 << hls::depth_bits) - 1;
    double depth = 0.0;
    for (int corner = 0; corner < 3; ++corner) {
        depth += weights[corner] * triangle.vertices[static_cast<std::size_t>(corner)].depth;
    }
    return static_cast<std::uint16_t>(std::clamp(std::floor(depth + 0.5), 0.0, greatest));
}

/// The picture under construction.
class Canvas {
 public:
    Canvas(int width, int height) {
        const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        image_.width = width;
        image_.height = height;
        image_.colour.assign(pixels, glm::dvec3(0.0));
        image_.covered.assign(pixels, false);
        depth_.assign(pixels, 0);
    }

    /// Draws the pieces of a triangle; `colour_at(x, y, weights)` is its unclamped colour there.
    template <typename ColourAt>
    void draw(const ScreenTriangle& triangle, ColourAt colour_at) {
        const Barycentric barycentric(triangle.vertices);
        for (const auto& piece : triangle.pieces) {
            const auto walk = walk_triangle(piece[0], piece[1], piece[2]);
            if (!walk) {
                continue;
            }
            ++image_.triangles;
            for_each_span(*walk, [&](int x, int y, int length, int step) {
                for (int i = 0; i < length; ++i, x += step) {
                    const glm::dvec3 weights = barycentric.at(x, y);
                    if (passes_depth(x, y, device_depth(triangle, weights))) {
                        image_.colour[index(x, y)] =
                            glm::clamp(colour_at(x, y, weights), glm::dvec3(0.0), glm::dvec3(full_scale));
                    }
                }
            });
        }
    }

    ReferenceImage take() { return std::move(image_); }

 private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x);
    }
    /// 0 is nearest; the first pixel wins ties.
    bool passes_depth(int x, int y, std::uint16_t depth) {
        ++image_.pixels;
        const std::size_t pixel = index(x, y);
        if (image_.covered[pixel] && depth >= depth_[pixel]) {
            return false;
        }
        image_.covered[pixel] = true;
        depth_[pixel] = depth;
        return true;
    }

    ReferenceImage image_;
    std::vector<std::uint16_t> depth_;
};

}  // namespace

Image ReferenceImage::image() const {
    Image result(width, height);
    for (std::size_t pixel = 0; pixel < colour.size(); ++pixel) {
        for (int component = 0; component < 3; ++component) {
            result.rgb[3 * pixel + static_cast<std::size_t>(component)] =
                static_cast<std::uint8_t>(std::lround(colour[pixel][component]));
        }
    }
    return result;
}

ReferenceImage render_reference(Method method, const Scene& scene, const std::vector<ScreenTriangle>& triangles) {
    Canvas canvas(scene.width, scene.height);
    for (const ScreenTriangle& triangle : triangles) {
        if (method == Method::phong) {
            canvas.draw(triangle, [&](int /*x*/, int /*y*/, const glm::dvec3& weights) {
                return phong_colour(scene, triangle, weights);
            });
            continue;
        }
        const TriangleShading shading = shade_triangle(method, scene, triangle);
        canvas.draw(triangle, [&](int x, int y, const glm::dvec3& /*weights*/) {
            return glm::dvec3(shading.colour[0].at(x, y), shading.colour[1].at(x, y), shading.colour[2].at(x, y));
        });
    }
    return canvas.take();
}

}  // namespace sheen
