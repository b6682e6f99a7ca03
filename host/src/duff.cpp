// SPDX-License-Identifier: MIT
/// \file
/// `duff`: Phong's normal interpolation with dot product and length expanded into polynomials (paper `fast-phong`,
/// "Background"): (ax + by + c)/√(dx² + exy + fy² + gx + hy + i). Exact, with a division and a root a pixel.
#include <algorithm>
#include <cmath>

#include "fast_phong.hpp"

namespace sheen {
namespace {

/// One light's a, b, c for N·L and N·H, and both for the face's normal.
struct DuffLight {
    glm::dvec3 colour;
    Quadratic<double> diffuse, specular;
    double face_diffuse, face_specular;
};

class DuffShader : public Shader {
 public:
    DuffShader(const MethodOptions& options, const Scene& scene, const ScreenTriangle& triangle)
        : material_(triangle.material), as_printed_(options.as_printed) {
        const auto& v = triangle.vertices;
        const LinearVector<double> normal =
            linear_vector<double>({v[0].normal, v[1].normal, v[2].normal}, TriangleAxes<double>());
        length_ = squared_length(normal);
        for (const Light& light : scene.lights) {
            const glm::dvec3 half = infinite_half(light);
            lights_.push_back({light.colour, dot_product(normal, light.vector), dot_product(normal, half),
                               dot(triangle.face_normal, light.vector), dot(triangle.face_normal, half)});
        }
    }

    [[nodiscard]] glm::dvec3 colour(int /*x*/, const glm::dvec3& weights) const override {
        const double x = weights[1] - 1.0 / 3.0;
        const double y = weights[2] - 1.0 / 3.0;
        const double squared =
            (length_.xx * x + length_.xy * y + length_.x) * x + (length_.yy * y + length_.y) * y + length_.constant;
        const double inverse = squared > vanishing_squared_length ? 1.0 / std::sqrt(squared) : 0.0;
        glm::dvec3 sum = material_.ambient;
        for (const DuffLight& light : lights_) {
            const auto cosine = [&](const Quadratic<double>& product, double face) {
                const double numerator = product.x * x + product.y * y + product.constant;
                const double noise = as_printed_ ? numerator * numerator : squared;
                return noise > vanishing_squared_length ? duff_cosine(numerator, inverse, as_printed_) : face;
            };
            const double lambert = std::max(0.0, cosine(light.diffuse, light.face_diffuse));
            const double highlight =
                std::pow(std::max(0.0, cosine(light.specular, light.face_specular)), material_.shininess);
            sum += light.colour * (material_.diffuse * lambert + material_.specular * highlight);
        }
        return 255.0 * sum;
    }

 private:
    const Material& material_;
    bool as_printed_;
    Quadratic<double> length_;
    std::vector<DuffLight> lights_;
};

}  // namespace

std::unique_ptr<Shader> make_duff_shader(const MethodOptions& options, const Scene& scene,
                                         const ScreenTriangle& triangle) {
    return std::make_unique<DuffShader>(options, scene, triangle);
}

}  // namespace sheen
