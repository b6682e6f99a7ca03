// SPDX-License-Identifier: MIT
/// \file
/// Images in memory: pixels with a depth test, and the sRGB curve.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "sheen/error.hpp"
#include "sheen/image.hpp"

namespace sheen {
namespace {

constexpr std::size_t bytes_per_pixel = 3;

std::size_t pixel_index(int width, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

std::size_t pixel_count(int width, int height) {
    if (width < 0 || height < 0) {
        throw Error("an image cannot be " + std::to_string(width) + "x" + std::to_string(height) +
                    "; both sides must be 0 or more");
    }
    return pixel_index(width, 0, height);
}

/// IEC 61966-2-1: linear 0…1 to the encoded 0…1.
double srgb_curve(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

}  // namespace

Image::Image(int width_, int height_)
    : width(width_), height(height_), rgb(bytes_per_pixel * pixel_count(width_, height_)) {}

std::uint8_t* Image::at(int x, int y) { return rgb.data() + bytes_per_pixel * pixel_index(width, x, y); }

const std::uint8_t* Image::at(int x, int y) const { return rgb.data() + bytes_per_pixel * pixel_index(width, x, y); }

Framebuffer::Framebuffer(int width, int height)
    : image_(width, height),
      depth_(pixel_count(width, height), std::numeric_limits<std::uint16_t>::max()),
      covered_(pixel_count(width, height), false) {}

void Framebuffer::write(const Pixel& pixel) {
    if (pixel.x < 0 || pixel.x >= image_.width || pixel.y < 0 || pixel.y >= image_.height) {
        throw Error("pixel (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ") lies outside the " +
                    std::to_string(image_.width) + "x" + std::to_string(image_.height) + " image");
    }
    const std::size_t index = pixel_index(image_.width, pixel.x, pixel.y);
    const auto depth = static_cast<std::uint16_t>(pixel.depth);
    if (covered_[index] && depth >= depth_[index]) {
        return;
    }
    covered_[index] = true;
    depth_[index] = depth;
    std::uint8_t* rgb = image_.at(pixel.x, pixel.y);
    rgb[0] = static_cast<std::uint8_t>(pixel.red);
    rgb[1] = static_cast<std::uint8_t>(pixel.green);
    rgb[2] = static_cast<std::uint8_t>(pixel.blue);
}

Image to_srgb(const Image& image) {
    constexpr int full = std::numeric_limits<std::uint8_t>::max();
    std::array<std::uint8_t, full + 1> curve{};
    for (int value = 0; value <= full; ++value) {
        curve[static_cast<std::size_t>(value)] =
            static_cast<std::uint8_t>(std::lround(full * srgb_curve(static_cast<double>(value) / full)));
    }
    Image result = image;
    for (std::uint8_t& component : result.rgb) {
        component = curve[component];
    }
    return result;
}

}  // namespace sheen
