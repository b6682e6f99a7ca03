// SPDX-License-Identifier: MIT
/// \file
/// Labels in pictures: a 5×7 letter box, capitals, digits and a few signs.
#pragma once

#include <string>

#include "sheen/image.hpp"

namespace sheen {

/// Image pixels per font pixel.
inline constexpr int label_scale = 2;
inline constexpr int label_height = 7 * label_scale;

/// Width of `text` in pixels.
int label_width(const std::string& text);

/// Draws `text` with its upper left corner at (x, y), in grey `level`; what lies outside the image is left out. Lower
/// case is drawn as capitals, a character without a shape as a box.
void draw_label(Image& image, int x, int y, const std::string& text, std::uint8_t level);

}  // namespace sheen
