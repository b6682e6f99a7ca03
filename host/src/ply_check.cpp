// SPDX-License-Identifier: MIT
#include "ply_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "ply_body.hpp"
#include "ply_header.hpp"
#include "sheen/error.hpp"
#include "statements.hpp"

namespace sheen {
namespace {

constexpr std::array<std::string_view, 6> vertex_properties{"x", "y", "z", "nx", "ny", "nz"};

class Checker {
 public:
    Checker(const std::string& name, std::string_view bytes)
        : name_(name), header_(read_ply_header(name, bytes)), body_(make_ply_body(name, bytes, header_)) {}

    PlainMesh check() {
        const PlyElement& vertex = element("vertex");
        const PlyElement& face = element("face");
        vertex_count_ = vertex.count;
        find_vertex_properties(vertex);
        find_corners(face);
        for (const PlyElement& each : header_.elements) {
            for (std::size_t row = 0; row < each.count; ++row) {
                body_->begin_row(each, row);
                if (&each == &vertex) {
                    read_vertex(each);
                } else if (&each == &face) {
                    read_face(each);
                } else {
                    read_other(each);
                }
                body_->end_row();
            }
        }
        PlainMesh plain;
        plain.bytes = plain_header(face.count) + vertices_ + faces_;
        return plain;
    }

 private:
    /// The element of this name, with at least one row.
    [[nodiscard]] const PlyElement& element(std::string_view element_name) const {
        for (const PlyElement& each : header_.elements) {
            if (each.name == element_name && each.count > 0) {
                return each;
            }
        }
        throw Error(fmt::format("{}: the file has no triangles; it needs the elements 'vertex' and 'face'", name_));
    }

    void find_vertex_properties(const PlyElement& vertex) {
        for (std::size_t i = 0; i < vertex_properties.size(); ++i) {
            columns_[i] = vertex.find(vertex_properties[i]);
            if (columns_[i] && vertex.properties[*columns_[i]].count_type) {
                throw Error(
                    fmt::format("{}: property '{}' is a list; it must be a number", name_, vertex_properties[i]));
            }
            if (!columns_[i] && i < 3) {
                throw Error(fmt::format("{}: element 'vertex' has no property '{}'; it needs x, y and z", name_,
                                        vertex_properties[i]));
            }
        }
        has_normals_ = columns_[3] && columns_[4] && columns_[5];
    }

    void find_corners(const PlyElement& face) {
        const std::optional<std::size_t> plural = face.find("vertex_indices");
        const std::optional<std::size_t> corners = plural ? plural : face.find("vertex_index");
        if (!corners || !face.properties[*corners].count_type) {
            throw Error(fmt::format("{}: element 'face' has no list 'vertex_indices'", name_));
        }
        corners_ = *corners;
    }

    void read_vertex(const PlyElement& vertex) {
        std::array<double, 6> values{};
        for (std::size_t i = 0; i < vertex.properties.size(); ++i) {
            const PlyProperty& property = vertex.properties[i];
            if (property.count_type) {
                skip_list(property);
                continue;
            }
            const double value = body_->next(property.type);
            const std::size_t column = column_of(i);
            if (column < 3 && !(std::abs(value) <= std::numeric_limits<float>::max())) {
                body_->fail("is no coordinate; it must be finite and within single precision");
            }
            if (column < values.size()) {
                values[column] = value;
            }
        }
        const bool normal_is_finite = std::all_of(values.begin() + 3, values.end(), [](double value) {
            return std::abs(value) <= std::numeric_limits<float>::max();
        });
        for (std::size_t column = 0; column < (has_normals_ ? 6U : 3U); ++column) {
            append_f32(vertices_, column < 3 || normal_is_finite ? static_cast<float>(values[column]) : 0.0F);
        }
    }

    /// Which of vertex_properties the vertex's i-th property is; past their end for none.
    [[nodiscard]] std::size_t column_of(std::size_t i) const {
        return static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), i) - columns_.begin());
    }

    void read_face(const PlyElement& face) {
        for (std::size_t i = 0; i < face.properties.size(); ++i) {
            const PlyProperty& property = face.properties[i];
            if (i == corners_) {
                read_corners(property);
            } else if (property.count_type) {
                skip_list(property);
            } else {
                body_->next(property.type);
            }
        }
    }

    void read_corners(const PlyProperty& property) {
        const double corners = body_->next(*property.count_type);
        if (!(corners >= double{min_corners} && corners <= double{max_corners}) || corners != std::floor(corners)) {
            body_->fail(fmt::format("is no number of corners; a face needs {} to {}", min_corners, max_corners));
        }
        if (!budget_.take(static_cast<std::size_t>(corners))) {
            body_->fail(
                fmt::format("corners are too many with the large faces before; divide them into faces of at most {}",
                            TriangulationBudget::free_corners));
        }
        append_u32(faces_, static_cast<std::uint32_t>(corners));
        for (std::size_t corner = 0; corner < static_cast<std::size_t>(corners); ++corner) {
            const double index = body_->next(property.type);
            if (!(index >= 0.0 && index < static_cast<double>(vertex_count_)) || index != std::floor(index)) {
                body_->fail(fmt::format("is out of range; the file has {} vertices, counted from 0", vertex_count_));
            }
            append_u32(faces_, static_cast<std::uint32_t>(index));
        }
    }

    void read_other(const PlyElement& other) {
        for (const PlyProperty& property : other.properties) {
            if (property.count_type) {
                skip_list(property);
            } else {
                body_->next(property.type);
            }
        }
    }

    void skip_list(const PlyProperty& property) {
        const double length = body_->next(*property.count_type);
        if (!(length >= 0.0 && length <= double{std::numeric_limits<std::uint32_t>::max()}) ||
            length != std::floor(length)) {
            body_->fail("is no length of a list");
        }
        for (double i = 0.0; i < length; ++i) {
            body_->next(property.type);
        }
    }

    [[nodiscard]] std::string plain_header(std::size_t face_count) const {
        std::string header = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", vertex_count_);
        for (std::size_t i = 0; i < (has_normals_ ? 6U : 3U); ++i) {
            header += fmt::format("property float {}\n", vertex_properties[i]);
        }
        return header +
               fmt::format("element face {}\nproperty list uint uint vertex_indices\nend_header\n", face_count);
    }

    const std::string& name_;
    PlyHeader header_;
    std::unique_ptr<PlyBody> body_;
    std::array<std::optional<std::size_t>, 6> columns_{};  ///< which property of a vertex is x, y, z, nx, ny, nz
    std::size_t corners_ = 0;                              ///< which property of a face is its list of vertices
    std::size_t vertex_count_ = 0;
    bool has_normals_ = false;
    std::string vertices_;
    TriangulationBudget budget_;
    std::string faces_;
};

}  // namespace

PlainMesh check_ply(const std::string& name, std::string_view bytes) { return Checker(name, bytes).check(); }

}  // namespace sheen
