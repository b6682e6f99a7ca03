// SPDX-License-Identifier: MIT
/// \file
/// Per-pixel evaluation in double precision.
#include "sheen/reference.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "sheen/hls/formats.hpp"
#include "sheen/shader.hpp"

namespace sheen {
namespace {

constexpr double full_scale = 255.0;

/// Weights of a triangle's vertices at pixel centres, from exact integer areas: within 0…1 at every covered pixel, and
/// as precise in slivers as anywhere.
class Sampler {
 public:
    explicit Sampler(const std::array<ScreenVertex, 3>& vertices)
        : points_{vertices[0].point, vertices[1].point, vertices[2].point},
          area_(static_cast<double>(doubled_area(points_[0], points_[1], points_[2]))) {}

    /// At the centre of pixel (x, y).
    [[nodiscard]] glm::dvec3 weights(int x, int y) const {
        const SnappedPoint centre{pixel * x + pixel / 2, pixel * y + pixel / 2};
        return glm::dvec3(static_cast<double>(doubled_area(centre, points_[1], points_[2])),
                          static_cast<double>(doubled_area(points_[0], centre, points_[2])),
                          static_cast<double>(doubled_area(points_[0], points_[1], centre))) /
               area_;
    }

 private:
    static constexpr std::int64_t pixel = std::int64_t{1} << hls::subpixel_bits;
    std::array<SnappedPoint, 3> points_;
    double area_;
};

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

    /// Draws the triangle's pixels.
    void draw(const ScreenTriangle& triangle, Shader& shader) {
        const Sampler sampler(triangle.vertices);
        for (const TriangleWalk& walk : triangle.walks) {
            ++image_.triangles;
            const ChannelWords depth = depth_words(triangle, walk);
            const int step = walk.leftward ? -1 : 1;
            for_each_row(walk, [&](const WalkRow& row) {
                if (row.length == 0) return;
                shader.start_row({walk.leftward ? row.x - row.length + 1 : row.x, row.y, row.length});
                for (int i = 0; i < row.length; ++i) {
                    const int x = row.x + step * i;
                    const std::uint32_t value = channel_value(depth, row.carries + i, row.row);
                    if (passes_depth(x, row.y, static_cast<std::uint16_t>(value >> hls::depth_fraction_bits))) {
                        const glm::dvec3 colour = shader.colour(x, sampler.weights(x, row.y));
                        image_.colour[index(x, row.y)] = glm::clamp(colour, glm::dvec3(0.0), glm::dvec3(full_scale));
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

ReferenceImage render_reference(Method method, const Scene& scene, const std::vector<ScreenTriangle>& triangles,
                                const MethodOptions& options) {
    Canvas canvas(scene.width, scene.height);
    for (const ScreenTriangle& triangle : triangles) {
        canvas.draw(triangle, *make_shader(method, options, scene, triangle));
    }
    return canvas.take();
}

}  // namespace sheen
