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

/// How far in barycentric coordinates a pixel may lie outside its triangle and be extrapolated. Snapping a clipped
/// piece moves its edges by up to half a subpixel; only in slivers about as thin does a pixel get further out.
constexpr double reach = 1.0 / 32.0;

/// A place in a triangle: weights of the vertices, and the pixel coordinates that they mean (whole at pixel centres).
struct Sample {
    glm::dvec3 weights{0.0};
    Coefficient x{0};
    Coefficient y{0};
};

/// Samples a triangle at pixel centres, from exact integer areas.
class Sampler {
 public:
    explicit Sampler(const std::array<ScreenVertex, 3>& vertices)
        : points_{vertices[0].point, vertices[1].point, vertices[2].point},
          area_(static_cast<double>(doubled_area(points_[0], points_[1], points_[2]))) {}

    /// The centre of pixel (x, y), or the triangle's border where the centre is out of reach.
    [[nodiscard]] Sample at(int x, int y) const {
        const SnappedPoint centre{pixel * x + pixel / 2, pixel * y + pixel / 2};
        const glm::dvec3 weights = glm::dvec3(static_cast<double>(doubled_area(centre, points_[1], points_[2])),
                                              static_cast<double>(doubled_area(points_[0], centre, points_[2])),
                                              static_cast<double>(doubled_area(points_[0], points_[1], centre))) /
                                   area_;
        if (std::min({weights.x, weights.y, weights.z}) >= -reach) {
            return {weights, static_cast<Coefficient>(x), static_cast<Coefficient>(y)};
        }
        // In slivers a polynomial's coefficients are so large that its arguments need its own precision.
        auto lambda = barycentric_coordinates(points_, centre);
        Coefficient sum{0};
        for (Coefficient& weight : lambda) {
            weight = std::max(weight, Coefficient{0});
            sum += weight;
        }
        Sample border{glm::dvec3(0.0), Coefficient{-0.5}, Coefficient{-0.5}};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Coefficient weight = lambda[corner] / sum;
            border.weights[static_cast<int>(corner)] = static_cast<double>(weight);
            border.x += weight * static_cast<Coefficient>(points_[corner].x) / pixel;
            border.y += weight * static_cast<Coefficient>(points_[corner].y) / pixel;
        }
        return border;
    }

 private:
    static constexpr std::int64_t pixel = std::int64_t{1} << hls::subpixel_bits;
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

    /// Draws the pieces of a triangle; `colour_at(sample)` is its unclamped colour there.
    template <typename ColourAt>
    void draw(const ScreenTriangle& triangle, ColourAt colour_at) {
        const Sampler sampler(triangle.vertices);
        for (const auto& piece : triangle.pieces) {
            const auto walk = walk_triangle(piece[0], piece[1], piece[2]);
            if (!walk) {
                continue;
            }
            ++image_.triangles;
            for_each_span(*walk, [&](int x, int y, int length, int step) {
                for (int i = 0; i < length; ++i, x += step) {
                    const Sample sample = sampler.at(x, y);
                    if (passes_depth(x, y, device_depth(triangle, sample.weights))) {
                        image_.colour[index(x, y)] =
                            glm::clamp(colour_at(sample), glm::dvec3(0.0), glm::dvec3(full_scale));
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
            canvas.draw(triangle, [&](const Sample& sample) { return phong_colour(scene, triangle, sample.weights); });
            continue;
        }
        const TriangleShading shading = shade_triangle(method, scene, triangle);
        canvas.draw(triangle, [&](const Sample& sample) {
            const auto value = [&](const Polynomial& channel) {
                return static_cast<double>(channel.value(sample.x, sample.y));
            };
            return glm::dvec3(value(shading.colour[0]), value(shading.colour[1]), value(shading.colour[2]));
        });
    }
    return canvas.take();
}

}  // namespace sheen
