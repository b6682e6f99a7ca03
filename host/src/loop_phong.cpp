// SPDX-License-Identifier: MIT
/// \file
/// The loop of `phong`: the normal by linear forward differences, normalised at each pixel, and radiance with it.
#include <array>
#include <optional>

#include "forward_difference.hpp"
#include "illumination.hpp"
#include "loops.hpp"

namespace sheen {
namespace {

template <typename Real>
class PhongLoop : public Loop<Real> {
 public:
    explicit PhongLoop(const LoopRequest& request)
        : light_(request.scene, request.triangle.material), face_normal_(request.triangle.face_normal) {
        const auto& v = request.triangle.vertices;
        const Barycentrics<Real> barycentrics(request.triangle);
        const std::vector<LeftEdge> edges = left_edges(request.triangle);
        // In perspective what is linear on the screen is each quantity over w, the distance before the eye. Directions
        // need no division by 1/w.
        std::array<Real, 3> inverse{Real(1.0), Real(1.0), Real(1.0)};
        if (light_.perspective()) {
            for (std::size_t k = 0; k < 3; ++k) inverse[k] = Real(1.0) / -Real(v[k].position.z);
        }
        const auto over_w = [&](std::size_t k, const glm::dvec3& vector) {
            return light_.perspective() ? Vec3<Real>(vector) * inverse[k] : Vec3<Real>(vector);
        };
        const auto linear = [&](const auto& nodes) {
            using Value = std::decay_t<decltype(nodes[0])>;
            Terms<Real, Value> terms;
            terms.fit_linear(barycentrics, nodes);
            return ForwardDifference<Real, Value>(1, terms.t, v[0].point, edges);
        };
        normal_.emplace(
            linear(std::array<Vec3<Real>, 3>{over_w(0, v[0].normal), over_w(1, v[1].normal), over_w(2, v[2].normal)}));
        if (!light_.needs_position()) return;
        position_.emplace(linear(
            std::array<Vec3<Real>, 3>{over_w(0, v[0].position), over_w(1, v[1].position), over_w(2, v[2].position)}));
        if (light_.perspective()) inverse_w_.emplace(linear(inverse));
    }

    void start_row(const PixelRow& row) override {
        normal_->start_row(row);
        if (position_) position_->start_row(row);
        if (inverse_w_) inverse_w_->start_row(row);
    }

    Vec3<Real> next() override {
        const Vec3<Real> normal = normal_->next();
        Vec3<Real> position(0.0);
        if (position_) position = position_->next();
        if (inverse_w_) position *= Real(1.0) / inverse_w_->next();
        return light_.radiance(position, is_zero(normal) ? face_normal_ : normalised(normal));
    }

 private:
    template <typename Value>
    using Channel = std::optional<ForwardDifference<Real, Value>>;

    Illumination<Real> light_;
    Vec3<Real> face_normal_;
    Channel<Vec3<Real>> normal_;
    Channel<Vec3<Real>> position_;  ///< where radiance depends on it
    Channel<Real> inverse_w_;       ///< and the camera is in perspective
};

}  // namespace

template <typename Real>
std::unique_ptr<Loop<Real>> make_phong_loop(const LoopRequest& request) {
    return std::make_unique<PhongLoop<Real>>(request);
}

template std::unique_ptr<Loop<double>> make_phong_loop(const LoopRequest&);
template std::unique_ptr<Loop<Counted>> make_phong_loop(const LoopRequest&);

}  // namespace sheen
