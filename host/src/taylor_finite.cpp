// SPDX-License-Identifier: MIT
/// \file
/// `taylor-finite`, paper `fast-phong`, "Going Further": H = E + L is interpolated linearly between the vertices, where
/// E and L are unit; so is the vector to a positional light, which the diffuse part takes as it is.
///
/// In perspective a vector is interpolated on the surface: vertex k weighs 1/w_k on the screen, w its distance before
/// the eye. Since only directions count, the weights' sum, which isn't constant over the screen, may be left out.
#include "fast_phong.hpp"

namespace sheen {
namespace {

/// What all lights share of a triangle.
template <typename Real>
struct Vertices {
    VertexVectors<Real> position, normal, to_eye;
    std::array<Real, 3> weight{Real(1.0), Real(1.0), Real(1.0)};  ///< w_0/w_k
    bool perspective = false;
};

template <typename Real>
Vertices<Real> vertices_of(const Scene& scene, const ScreenTriangle& triangle) {
    Vertices<Real> result;
    result.perspective = scene.field_of_view.has_value();
    for (std::size_t k = 0; k < 3; ++k) {
        const ScreenVertex& vertex = triangle.vertices[k];
        result.position[k] = Vec3<Real>(vertex.position);
        result.normal[k] = Vec3<Real>(vertex.normal);
        result.to_eye[k] = Vec3<Real>(0.0, 0.0, 1.0);
        if (!result.perspective) continue;
        if (k > 0) result.weight[k] = result.position[0].z / result.position[k].z;
        if (!is_zero(result.position[k])) result.to_eye[k] = normalised(-result.position[k]);
        result.normal[k] *= result.weight[k];
    }
    return result;
}

/// The normal, and what its series share.
template <typename Real>
class Normal {
 public:
    Normal(const Vertices<Real>& vertices, const glm::dvec3& face_normal, const TriangleAxes<Real>& axes)
        : vector_(linear_vector(vertices.normal, axes)), face_(face_normal), directed_(has_direction(vector_)) {
        if (directed_) length_ = inverse_length(squared_length(vector_));
    }

    /// Series with a constant unit vector. Where the normals cancel at the centre, the face's all over the triangle.
    [[nodiscard]] TaylorSeries<Real> expand(const Vec3<Real>& to, bool as_printed) const {
        if (!directed_) return {dot(face_, to)};
        return as_printed ? printed_taylor_series(vector_, to) : taylor_series(dot_product(vector_, to), length_);
    }
    /// Series with a linear vector; `otherwise`, a unit vector or 0, stands for one that cancels at the centre.
    [[nodiscard]] TaylorSeries<Real> expand(const LinearVector<Real>& to, const Vec3<Real>& otherwise,
                                            bool as_printed) const {
        if (!has_direction(to)) return expand(otherwise, as_printed);
        if (!directed_) return {dot(face_, normalised(to.constant))};
        if (as_printed) return printed_taylor_series(vector_, to);
        return taylor_series(dot_product(vector_, to), length_, inverse_length(squared_length(to)));
    }

 private:
    LinearVector<Real> vector_;
    Vec3<Real> face_;
    bool directed_;
    InverseLength<Real> length_{};
};

/// A light's vectors at the vertices, weighted.
template <typename Real>
struct LightVectors {
    VertexVectors<Real> to_light;  ///< of any length
    VertexVectors<Real> half;      ///< E + L
};

template <typename Real>
LightVectors<Real> vectors_of(const Light& light, const Vertices<Real>& vertices) {
    LightVectors<Real> result;
    for (std::size_t k = 0; k < 3; ++k) {
        Vec3<Real> to_light(light.vector);
        Vec3<Real> unit = to_light;
        if (light.kind == Light::Kind::positional) {
            to_light -= vertices.position[k];
            unit = is_zero(to_light) ? Vec3<Real>(0.0, 0.0, 1.0) : normalised(to_light);
        }
        const bool weighted = vertices.perspective;
        const Vec3<Real> half = unit + vertices.to_eye[k];
        result.to_light[k] = weighted ? to_light * vertices.weight[k] : to_light;
        result.half[k] = weighted ? half * vertices.weight[k] : half;
    }
    return result;
}

}  // namespace

template <typename Real>
std::vector<LightSeries<Real>> finite_series(const MethodOptions& options, const Scene& scene,
                                             const ScreenTriangle& triangle, const TriangleAxes<Real>& axes) {
    const Vertices<Real> vertices = vertices_of<Real>(scene, triangle);
    const Normal<Real> normal(vertices, triangle.face_normal, axes);
    std::vector<LightSeries<Real>> series;
    for (const Light& light : scene.lights) {
        const bool directional = light.kind == Light::Kind::directional;
        LightSeries<Real>& expanded = series.emplace_back();
        if (directional) expanded.diffuse = normal.expand(Vec3<Real>(light.vector), options.as_printed);
        if (directional && !vertices.perspective) {
            expanded.specular = normal.expand(Vec3<Real>(infinite_half(light)), options.as_printed);
            continue;
        }
        const LightVectors<Real> vectors = vectors_of(light, vertices);
        if (!directional) {
            const Vec3<Real> in_the_light(0.0, 0.0, 1.0);
            expanded.diffuse = normal.expand(linear_vector(vectors.to_light, axes), in_the_light, options.as_printed);
        }
        expanded.specular = normal.expand(linear_vector(vectors.half, axes), Vec3<Real>(0.0), options.as_printed);
    }
    return series;
}

template std::vector<LightSeries<double>> finite_series(const MethodOptions&, const Scene&, const ScreenTriangle&,
                                                        const TriangleAxes<double>&);
template std::vector<LightSeries<Counted>> finite_series(const MethodOptions&, const Scene&, const ScreenTriangle&,
                                                         const TriangleAxes<Counted>&);

}  // namespace sheen
