// SPDX-License-Identifier: MIT
#include "gltf_primitives.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace sheen {
namespace {

enum Mode : std::size_t { lines_last = 3, triangles = 4, strip = 5, fan = 6 };

/// The vertices of the k-th triangle, as positions in the primitive's list of vertices.
std::array<std::size_t, 3> triangle_corners(std::size_t mode, std::size_t k) {
    if (mode == triangles) {
        return {3 * k, 3 * k + 1, 3 * k + 2};
    }
    if (mode == strip) {
        return {k, k + 1 + k % 2, k + 2 - k % 2};
    }
    return {k + 1, k + 2, 0};
}

/// The triangles that `vertices` vertices make. \throws Error when they make none.
std::size_t triangle_count(const GltfField& primitive, std::size_t mode, std::size_t vertices) {
    if (vertices < 3 || (mode == triangles && vertices % 3 != 0)) {
        primitive.fail(fmt::format("has {} corners, which make no triangles", vertices));
    }
    return mode == triangles ? vertices / 3 : vertices - 2;
}

void require_integers(const GltfField& field, const GltfElements& indices) {
    const ScalarType type = indices.type();
    if (type != ScalarType::u8 && type != ScalarType::u16 && type != ScalarType::u32) {
        field.fail("its accessor's componentType must be 5121, 5123 or 5125: indices have no sign");
    }
}

/// Appends element `i`, if all of it is finite and within single precision.
bool append(std::string& bytes, const GltfElements& vectors, std::size_t i) {
    std::array<double, 3> values{};
    for (std::size_t axis = 0; axis < values.size(); ++axis) {
        values[axis] = vectors.value(i, axis);
        if (!(std::abs(values[axis]) <= std::numeric_limits<float>::max())) {
            return false;
        }
    }
    for (const double value : values) {
        append_f32(bytes, static_cast<float>(value));
    }
    return true;
}

}  // namespace

GltfCorners read_gltf_primitive(const GltfField& primitive, GltfBuffers& buffers, std::size_t max_triangles) {
    GltfCorners corners;
    const std::size_t mode = primitive.whole("mode", triangles);
    if (mode <= lines_last) {
        return corners;
    }
    if (mode > fan) {
        primitive["mode"].fail("is no kind of primitive; they are 0 to 6");
    }
    const GltfField attributes = primitive["attributes"];
    const GltfField position_field = attributes["POSITION"];
    const GltfElements positions = buffers.elements(position_field, "VEC3");
    std::optional<GltfElements> normals;
    if (attributes.has("NORMAL")) {
        normals = buffers.elements(attributes["NORMAL"], "VEC3");
        if (normals->size() != positions.size()) {
            attributes["NORMAL"].fail(
                fmt::format("has {} elements; POSITION has {}", normals->size(), positions.size()));
        }
    }
    std::optional<GltfElements> indices;
    if (primitive.has("indices")) {
        indices = buffers.elements(primitive["indices"], "SCALAR");
        require_integers(primitive["indices"], *indices);
    }
    const std::size_t count = triangle_count(primitive, mode, indices ? indices->size() : positions.size());
    if (count > max_triangles) {
        primitive.fail(fmt::format("its {} triangles are more than the {} that are left of the most of a file", count,
                                   max_triangles));
    }
    corners.count = 3 * count;
    corners.has_normals = normals.has_value();
    for (std::size_t k = 0; k < count; ++k) {
        for (const std::size_t corner : triangle_corners(mode, k)) {
            const std::size_t vertex = indices ? static_cast<std::size_t>(indices->value(corner, 0)) : corner;
            if (vertex >= positions.size()) {
                primitive["indices"].fail(fmt::format("index {} of triangle {} is out of range; there are {} vertices",
                                                      vertex, k + 1, positions.size()));
            }
            if (!append(corners.positions, positions, vertex)) {
                position_field.fail(fmt::format(
                    "vertex {} has a coordinate that is not finite or not within single precision", vertex));
            }
            if (normals && !append(corners.normals, *normals, vertex)) {
                corners.normals.append(3 * sizeof(float), '\0');
            }
        }
    }
    return corners;
}

}  // namespace sheen
