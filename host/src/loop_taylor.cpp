// SPDX-License-Identifier: MIT
/// \file
/// The loop of `taylor` and `taylor-finite`: the series by forward differences, two additions each. Ambient is rolled
/// into the first light's diffuse series, and the specular series is scaled to address the exponent table, as in paper
/// `fast-phong`.
#include <algorithm>
#include <optional>

#include "fast_phong.hpp"
#include "forward_difference.hpp"
#include "loops.hpp"
#include "sheen/exponent_table.hpp"

namespace sheen {
namespace {

constexpr double full_scale_steps = 255.0;

/// One light: its diffuse colour, its highlight's table address, and what the table's word holds for an entry of 1.
template <typename Real>
struct LightChannels {
    ForwardDifference<Real, Vec3<Real>> diffuse;
    Vec3<Real> least;  ///< of the diffuse colour: where the light is behind the surface
    std::optional<ForwardDifference<Real, Real>> address;
    glm::dvec3 highlight;  ///< 8-bit steps
};

template <typename Real>
class TaylorLoop : public Loop<Real> {
 public:
    explicit TaylorLoop(const LoopRequest& request)
        : ambient_(full_scale_steps * request.triangle.material.ambient),
          table_(request.triangle.material.shininess, request.options.taylor_table_bytes) {
        const Material& material = request.triangle.material;
        const Barycentrics<Real> at(request.triangle);
        const TriangleAxes<Real> axes{{at.p_x, at.p_y}, {at.q_x, at.q_y}};
        const std::vector<LightSeries<Real>> series =
            request.method == Method::taylor ? infinite_series(request.options, request.scene, request.triangle, axes)
                                             : finite_series(request.options, request.scene, request.triangle, axes);
        const std::vector<LeftEdge> edges = left_edges(request.triangle);
        const glm::dvec2 centre = centre_of(request.triangle);
        for (std::size_t k = 0; k < series.size(); ++k) {
            const glm::dvec3 light = full_scale_steps * request.scene.lights[k].colour;
            const Vec3<Real> least = k == 0 ? ambient_ : Vec3<Real>(0.0);
            std::array<Vec3<Real>, 6> colour;
            for (std::size_t t = 0; t < colour.size(); ++t) {
                colour[t] = Vec3<Real>(light * material.diffuse) * series[k].diffuse[t];
            }
            if (k == 0) colour[0] += ambient_;
            channels_.push_back({{2, colour, centre, edges}, least, std::nullopt, light * material.specular});
            if (material.specular == 0.0) continue;
            std::array<Real, 6> address;
            for (std::size_t t = 0; t < address.size(); ++t) address[t] = series[k].specular[t] * last_address();
            address[0] += Real(0.5);  // so that truncation rounds
            channels_.back().address.emplace(2, address, centre, edges);
        }
    }

    void start_row(const PixelRow& row) override {
        for (LightChannels<Real>& channels : channels_) {
            channels.diffuse.start_row(row);
            if (channels.address) channels.address->start_row(row);
        }
    }

    Vec3<Real> next() override {
        if (channels_.empty()) return ambient_;
        Vec3<Real> colour = light_colour(channels_[0]);
        for (std::size_t k = 1; k < channels_.size(); ++k) colour += light_colour(channels_[k]);
        return colour;
    }

 private:
    [[nodiscard]] Real last_address() const { return Real(static_cast<double>(table_.entries().size() - 1)); }

    Vec3<Real> light_colour(LightChannels<Real>& channels) const {
        Vec3<Real> colour = channels.diffuse.next();
        for (int c = 0; c < 3; ++c) colour[c] = std::max(colour[c], channels.least[c]);
        if (!channels.address) return colour;
        const Real address = std::min(std::max(channels.address->next(), Real(0.0)), last_address());
        const Real entry = read_table<Real>(table_.entries(), static_cast<std::size_t>(value_of(address)));
        // The word that is read holds the product: no multiplication.
        return colour + Vec3<Real>(channels.highlight * (value_of(entry) / full_scale_steps));
    }

    Vec3<Real> ambient_;
    ExponentTable table_;
    std::vector<LightChannels<Real>> channels_;
};

}  // namespace

template <typename Real>
std::unique_ptr<Loop<Real>> make_taylor_loop(const LoopRequest& request) {
    return std::make_unique<TaylorLoop<Real>>(request);
}

template std::unique_ptr<Loop<double>> make_taylor_loop(const LoopRequest&);
template std::unique_ptr<Loop<Counted>> make_taylor_loop(const LoopRequest&);

}  // namespace sheen
