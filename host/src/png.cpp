// SPDX-License-Identifier: MIT
/// \file
/// PNG through libpng's simplified interface, encoded in memory so that a file appears whole or not at all.
#include <png.h>

#include <string>
#include <vector>

#include "sheen/error.hpp"
#include "sheen/image.hpp"

namespace sheen {
namespace {

[[noreturn]] void fail(const std::string& path, const char* message) {
    throw Error(path + ": cannot encode the image as PNG: " + message);
}

}  // namespace

void write_png(const std::string& path, const Image& image) {
    if (image.width <= 0 || image.height <= 0) {
        fail(path, "it has no pixels; width and height must be 1 or more");
    }
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);
    header.format = PNG_FORMAT_RGB;

    constexpr int eight_bit = 0;
    constexpr int tight_rows = 0;
    std::vector<png_byte> bytes(PNG_IMAGE_PNG_SIZE_MAX(header));
    png_alloc_size_t size = bytes.size();
    if (png_image_write_to_memory(&header, bytes.data(), &size, eight_bit, image.rgb.data(), tight_rows, nullptr) ==
        0) {
        fail(path, header.message);
    }
    write_file_atomically(path, bytes.data(), size);
}

}  // namespace sheen
