// SPDX-License-Identifier: MIT
/// \file
/// The loop of `duff`: numerators and squared length by forward differences (for diffuse alone three additions, a
/// division and a root, as paper `fast-phong` says), and the power at each pixel.
#include <algorithm>
#include <cmath>
#include <optional>

#include "fast_phong.hpp"
#include "forward_difference.hpp"
#include "loops.hpp"

namespace sheen {
namespace {

constexpr double full_scale_steps = 255.0;

/// One light: the numerators of N·L and N·H, both cosines of the face's normal, and colours in 8-bit steps.
template <typename Real>
struct LightNumerators {
    ForwardDifference<Real, Real> diffuse, specular;
    Real face_diffuse, face_specular;
    Vec3<Real> colour, highlight;
};

template <typename Real>
class DuffLoop : public Loop<Real> {
 public:
    explicit DuffLoop(const LoopRequest& request)
        : as_printed_(request.options.as_printed),
          shininess_(request.triangle.material.shininess),
          has_highlight_(request.triangle.material.specular > 0.0),
          ambient_(full_scale_steps * request.triangle.material.ambient) {
        const ScreenTriangle& triangle = request.triangle;
        const std::vector<LeftEdge> edges = left_edges(triangle);
        const glm::dvec2 centre = centre_of(triangle);
        const auto stepped = [&](int order, const Quadratic<Real>& q) {
            return ForwardDifference<Real, Real>(order, {q.constant, q.y, q.x, q.yy, q.xy, q.xx}, centre, edges);
        };
        const Barycentrics<Real> at(triangle);
        const auto& v = triangle.vertices;
        const LinearVector<Real> normal =
            linear_vector<Real>({Vec3<Real>(v[0].normal), Vec3<Real>(v[1].normal), Vec3<Real>(v[2].normal)},
                                {{at.p_x, at.p_y}, {at.q_x, at.q_y}});
        const Vec3<Real> face(triangle.face_normal);
        squared_.emplace(stepped(2, squared_length(normal)));
        for (const Light& light : request.scene.lights) {
            const Vec3<Real> to_light(light.vector);
            const Vec3<Real> half(infinite_half(light));
            const glm::dvec3 full = full_scale_steps * light.colour;
            lights_.push_back({stepped(1, dot_product(normal, to_light)), stepped(1, dot_product(normal, half)),
                               dot(face, to_light), dot(face, half), Vec3<Real>(full * triangle.material.diffuse),
                               Vec3<Real>(full * triangle.material.specular)});
        }
    }

    void start_row(const PixelRow& row) override {
        squared_->start_row(row);
        for (LightNumerators<Real>& light : lights_) {
            light.diffuse.start_row(row);
            if (has_highlight_) light.specular.start_row(row);
        }
    }

    Vec3<Real> next() override {
        using std::pow;
        using std::sqrt;
        const Real squared = squared_->next();
        const bool vanishes = is_noise(squared);
        const Real inverse = vanishes ? Real(0.0) : Real(1.0) / sqrt(squared);
        const auto cosine = [&](const Real& numerator, const Real& face) {
            const bool unusable = as_printed_ ? is_noise(value_of(numerator) * value_of(numerator)) : vanishes;
            return std::max(Real(0.0), unusable ? face : duff_cosine(numerator, inverse, as_printed_));
        };
        Vec3<Real> colour = ambient_;
        for (LightNumerators<Real>& light : lights_) {
            colour += light.colour * cosine(light.diffuse.next(), light.face_diffuse);
            if (!has_highlight_) continue;
            colour += light.highlight * pow(cosine(light.specular.next(), light.face_specular), Real(shininess_));
        }
        return colour;
    }

 private:
    /// A guard: free.
    static bool is_noise(const Real& squared) { return value_of(squared) <= vanishing_squared_length; }

    bool as_printed_;
    double shininess_;
    bool has_highlight_;
    Vec3<Real> ambient_;
    std::optional<ForwardDifference<Real, Real>> squared_;
    std::vector<LightNumerators<Real>> lights_;
};

}  // namespace

template <typename Real>
std::unique_ptr<Loop<Real>> make_duff_loop(const LoopRequest& request) {
    return std::make_unique<DuffLoop<Real>>(request);
}

template std::unique_ptr<Loop<double>> make_duff_loop(const LoopRequest&);
template std::unique_ptr<Loop<Counted>> make_duff_loop(const LoopRequest&);

}  // namespace sheen
