// SPDX-License-Identifier: MIT
/// \file
/// Lays a comparison out as one picture.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "label.hpp"
#include "sheen/compare.hpp"

namespace sheen {
namespace {

constexpr int margin = 16;
constexpr int largest_tile = 512;
constexpr int label_gap = 6;
constexpr std::uint8_t background = 36;
constexpr std::uint8_t ink = 235;

/// A picture and the two lines above it.
struct Tile {
    std::string title;
    std::string detail;
    Image image;
};

/// How one pixel stands for the many that it replaces.
enum class Reduction { mean, maximum };

/// Every factor×factor block (smaller at the right and lower border) as one pixel.
Image reduce(const Image& image, int factor, Reduction reduction) {
    if (factor == 1) {
        return image;
    }
    Image reduced((image.width + factor - 1) / factor, (image.height + factor - 1) / factor);
    for (int y = 0; y < reduced.height; ++y) {
        for (int x = 0; x < reduced.width; ++x) {
            const int right = std::min((x + 1) * factor, image.width);
            const int bottom = std::min((y + 1) * factor, image.height);
            for (int component = 0; component < 3; ++component) {
                int sum = 0;
                int count = 0;
                int greatest = 0;
                for (int from_y = y * factor; from_y < bottom; ++from_y) {
                    for (int from_x = x * factor; from_x < right; ++from_x) {
                        const int value = image.at(from_x, from_y)[component];
                        sum += value;
                        ++count;
                        greatest = std::max(greatest, value);
                    }
                }
                reduced.at(x, y)[component] =
                    static_cast<std::uint8_t>(reduction == Reduction::mean ? (sum + count / 2) / count : greatest);
            }
        }
    }
    return reduced;
}

void paste(Image& sheet, const Image& tile, int left, int top) {
    for (int y = 0; y < tile.height; ++y) {
        std::copy_n(tile.at(0, y), 3 * static_cast<std::size_t>(tile.width), sheet.at(left, top + y));
    }
}

std::string quality(const ComparisonRow& row) {
    return std::isinf(row.psnr) ? std::string("identical")
                                : fmt::format("{:.1f} dB, max {:.0f}", row.psnr, row.max_error);
}

/// The tiles, column by column: the reference alone, then for each method a picture and an error map per device.
std::vector<std::vector<Tile>> make_columns(const Comparison& comparison, int factor) {
    std::vector<std::vector<Tile>> columns;
    const std::string runs = comparison.runs > 1 ? fmt::format(", run 1 of {}", comparison.runs) : std::string();
    columns.push_back({{"phong", "per pixel" + runs, reduce(comparison.reference, factor, Reduction::mean)}});
    const Method* current = nullptr;
    for (const ComparisonRow& row : comparison.rows) {
        if (!row.reason.empty() || row.method == Method::phong) {
            continue;
        }
        if (current == nullptr || *current != row.method) {
            columns.emplace_back();
            current = &row.method;
        }
        columns.back().push_back({fmt::format("{} on {}", to_string(row.method), row.device), quality(row),
                                  reduce(row.picture, factor, Reduction::mean)});
        columns.back().push_back(
            {fmt::format("error x {}", error_map_gain),
             fmt::format("against phong in {}", row.device == reference_name ? "double" : "8 bits"),
             reduce(row.error_map, factor, Reduction::maximum)});
    }
    return columns;
}

}  // namespace

Image contact_sheet(const Comparison& comparison) {
    const int longest = std::max(comparison.reference.width, comparison.reference.height);
    const int factor = (longest + largest_tile - 1) / largest_tile;
    const std::vector<std::vector<Tile>> columns = make_columns(comparison, factor);

    int width = columns.front().front().image.width;
    std::size_t rows = 0;
    for (const std::vector<Tile>& column : columns) {
        rows = std::max(rows, column.size());
        for (const Tile& tile : column) {
            width = std::max({width, label_width(tile.title), label_width(tile.detail)});
        }
    }
    const int labels = 2 * (label_height + label_gap);
    const int height = labels + columns.front().front().image.height;

    Image sheet(margin + static_cast<int>(columns.size()) * (width + margin),
                margin + static_cast<int>(rows) * (height + margin));
    std::fill(sheet.rgb.begin(), sheet.rgb.end(), background);
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const int left = margin + static_cast<int>(column) * (width + margin);
        for (std::size_t row = 0; row < columns[column].size(); ++row) {
            const Tile& tile = columns[column][row];
            const int top = margin + static_cast<int>(row) * (height + margin);
            draw_label(sheet, left, top, tile.title, ink);
            draw_label(sheet, left, top + label_height + label_gap, tile.detail, ink);
            paste(sheet, tile.image, left, top + labels);
        }
    }
    return sheet;
}

}  // namespace sheen
