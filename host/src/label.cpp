// SPDX-License-Identifier: MIT
/// \file
/// Seven rows of five dots a letter, each written as it looks.
#include "label.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace sheen {
namespace {

constexpr int glyph_width = 5;
constexpr int glyph_height = 7;
constexpr int advance = glyph_width + 1;

/// Rows from top to bottom, separated by a space.
struct Glyph {
    char character;
    const char* rows;
};

constexpr Glyph glyphs[] = {
    {'A', ".###. #...# #...# ##### #...# #...# #...#"}, {'B', "####. #...# #...# ####. #...# #...# ####."},
    {'C', ".#### #.... #.... #.... #.... #.... .####"}, {'D', "####. #...# #...# #...# #...# #...# ####."},
    {'E', "##### #.... #.... ####. #.... #.... #####"}, {'F', "##### #.... #.... ####. #.... #.... #...."},
    {'G', ".#### #.... #.... #..## #...# #...# .####"}, {'H', "#...# #...# #...# ##### #...# #...# #...#"},
    {'I', ".###. ..#.. ..#.. ..#.. ..#.. ..#.. .###."}, {'J', "..### ...#. ...#. ...#. ...#. #..#. .##.."},
    {'K', "#...# #..#. #.#.. ##... #.#.. #..#. #...#"}, {'L', "#.... #.... #.... #.... #.... #.... #####"},
    {'M', "#...# ##.## #.#.# #.#.# #...# #...# #...#"}, {'N', "#...# ##..# ##..# #.#.# #..## #..## #...#"},
    {'O', ".###. #...# #...# #...# #...# #...# .###."}, {'P', "####. #...# #...# ####. #.... #.... #...."},
    {'Q', ".###. #...# #...# #...# #.#.# #..#. .##.#"}, {'R', "####. #...# #...# ####. #.#.. #..#. #...#"},
    {'S', ".#### #.... #.... .###. ....# ....# ####."}, {'T', "##### ..#.. ..#.. ..#.. ..#.. ..#.. ..#.."},
    {'U', "#...# #...# #...# #...# #...# #...# .###."}, {'V', "#...# #...# #...# #...# #...# .#.#. ..#.."},
    {'W', "#...# #...# #...# #.#.# #.#.# ##.## #...#"}, {'X', "#...# #...# .#.#. ..#.. .#.#. #...# #...#"},
    {'Y', "#...# #...# .#.#. ..#.. ..#.. ..#.. ..#.."}, {'Z', "##### ....# ...#. ..#.. .#... #.... #####"},
    {'0', ".###. #...# #..## #.#.# ##..# #...# .###."}, {'1', "..#.. .##.. ..#.. ..#.. ..#.. ..#.. .###."},
    {'2', ".###. #...# ....# ...#. ..#.. .#... #####"}, {'3', ".###. #...# ....# ..##. ....# #...# .###."},
    {'4', "...#. ..##. .#.#. #..#. ##### ...#. ...#."}, {'5', "##### #.... ####. ....# ....# #...# .###."},
    {'6', "..##. .#... #.... ####. #...# #...# .###."}, {'7', "##### ....# ...#. ..#.. ..#.. .#... .#..."},
    {'8', ".###. #...# #...# .###. #...# #...# .###."}, {'9', ".###. #...# #...# .#### ....# ...#. .##.."},
    {' ', "..... ..... ..... ..... ..... ..... ....."}, {'.', "..... ..... ..... ..... ..... .##.. .##.."},
    {',', "..... ..... ..... ..... .##.. ..#.. .#..."}, {':', "..... .##.. .##.. ..... .##.. .##.. ....."},
    {'-', "..... ..... ..... .###. ..... ..... ....."}, {'/', "....# ....# ...#. ..#.. .#... #.... #...."},
    {'(', "...#. ..#.. .#... .#... .#... ..#.. ...#."}, {')', ".#... ..#.. ...#. ...#. ...#. ..#.. .#..."},
};
constexpr Glyph box = {'\0', "##### #...# #...# #...# #...# #...# #####"};

const Glyph& glyph_of(char character) {
    const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
    const auto* found = std::find_if(std::begin(glyphs), std::end(glyphs),
                                     [capital](const Glyph& glyph) { return glyph.character == capital; });
    return found == std::end(glyphs) ? box : *found;
}

/// Fills the square of image pixels that one font pixel covers.
void draw_dot(Image& image, int left, int top, std::uint8_t level) {
    for (int y = std::max(top, 0); y < std::min(top + label_scale, image.height); ++y) {
        for (int x = std::max(left, 0); x < std::min(left + label_scale, image.width); ++x) {
            std::fill_n(image.at(x, y), 3, level);
        }
    }
}

}  // namespace

int label_width(const std::string& text) {
    return text.empty() ? 0 : (static_cast<int>(text.size()) * advance - 1) * label_scale;
}

void draw_label(Image& image, int x, int y, const std::string& text, std::uint8_t level) {
    for (const char character : text) {
        const char* rows = glyph_of(character).rows;
        for (int row = 0; row < glyph_height; ++row) {
            for (int column = 0; column < glyph_width; ++column) {
                if (rows[row * advance + column] == '#') {
                    draw_dot(image, x + column * label_scale, y + row * label_scale, level);
                }
            }
        }
        x += advance * label_scale;
    }
}

}  // namespace sheen
