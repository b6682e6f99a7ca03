// SPDX-License-Identifier: MIT
/// \file
/// Images, the framebuffer that collects pixels, and PNG.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sheen/packet.hpp"

namespace sheen {

/// 8-bit RGB, row 0 at the top, 3 bytes a pixel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
    Image() = default;
    Image(int width_, int height_);
    std::uint8_t* at(int x, int y);
    [[nodiscard]] const std::uint8_t* at(int x, int y) const;
};

/// Collects pixels with a depth test: 0 is nearest, the first pixel wins ties.
class Framebuffer {
 public:
    Framebuffer(int width, int height);
    /// \throws Error when the pixel lies outside the image.
    void write(const Pixel& pixel);
    [[nodiscard]] const Image& image() const { return image_; }
    /// True where a pixel was written.
    [[nodiscard]] const std::vector<bool>& covered() const { return covered_; }

 private:
    Image image_;
    std::vector<std::uint16_t> depth_;
    std::vector<bool> covered_;
};

/// The image with the sRGB transfer curve applied to each component.
Image to_srgb(const Image& image);

/// Writes a PNG whole or not at all; "-" is standard output. \throws Error naming the file.
void write_png(const std::string& path, const Image& image);

/// Writes `size` bytes to `path` whole or not at all (temporary name beside it, then rename); "-" is standard output.
/// \throws Error naming the file.
void write_file_atomically(const std::string& path, const void* data, std::size_t size);

}  // namespace sheen
