// SPDX-License-Identifier: MIT
/// \file
/// The loop of `spherical`: a light's diffuse term and its highlight each step an angle, read a table and multiply
/// (paper `spherical`, section 4, figure 12). What the edge walker knows is free: where rows meet edges, how wide spans
/// are, where pixels lie in them.
#include "loops.hpp"
#include "spherical_span.hpp"

namespace sheen {
namespace {

/// function(angle), as one read of a table that holds it exactly.
template <typename Real, typename Function>
Real looked_up(const Function& function, Real angle) {
    if constexpr (std::is_same_v<Real, Counted>) Counted::count_table_read();
    return Real(function(value_of(angle)));
}

/// The reflectances times a light's colour in 8-bit steps.
struct LightScale {
    glm::dvec3 diffuse, highlight;
    bool white;  ///< one product serves the highlight's three components
};

std::vector<LightScale> light_scales(const LoopRequest& request) {
    std::vector<LightScale> scales;
    const Material& material = request.triangle.material;
    for (const Light& light : request.scene.lights) {
        const glm::dvec3 steps = full_scale * light.colour;
        scales.push_back(
            {steps * material.diffuse, steps * material.specular, steps.x == steps.y && steps.y == steps.z});
    }
    return scales;
}

template <typename Real>
class SphericalLoop : public Loop<Real> {
 public:
    explicit SphericalLoop(const LoopRequest& request)
        : ambient_(full_scale * request.triangle.material.ambient),
          scales_(light_scales(request)),
          diffuse_(1.0, 1.0, false),
          bell_(make_bell(request.options, request.triangle.material)),
          spans_(request.scene, request.triangle, request.options.as_printed) {}

    void start_row(const PixelRow& row) override {
        const SpanFrame::Span span = spans_.frame().span(row.y);
        const Real width(1.0 / span.position_step());
        const Real first(span.position(row.x));
        lights_ = spans_.start(span);
        constants_.clear();
        for (std::size_t i = 0; i < lights_.size(); ++i) {
            SphericalLight<Real>& light = lights_[i];
            for (CosineSpan<Real>* term : {&light.diffuse, &light.highlight}) {
                term->start = term->angle(first);
                term->rate /= width;
            }
            constants_.push_back({Vec3<Real>(scales_[i].diffuse) * light.diffuse.amplitude,
                                  Vec3<Real>(scales_[i].highlight) * light.power});
        }
    }

    Vec3<Real> next() override {
        Vec3<Real> sum = ambient_;
        for (std::size_t i = 0; i < lights_.size(); ++i) {
            SphericalLight<Real>& light = lights_[i];
            const Constants& constants = constants_[i];
            sum += constants.diffuse * looked_up(diffuse_, light.diffuse.start);
            const Real height = looked_up(bell_, light.highlight.start);
            sum += scales_[i].white ? Vec3<Real>(constants.highlight.x * height) : constants.highlight * height;
            light.diffuse.start += light.diffuse.rate;
            light.highlight.start += light.highlight.rate;
        }
        return sum;
    }

 private:
    /// What a span multiplies its tables' values by: C = 255·I·k·Aⁿ.
    struct Constants {
        Vec3<Real> diffuse, highlight;
    };
    Vec3<Real> ambient_;
    std::vector<LightScale> scales_;
    Bell diffuse_, bell_;
    SphericalSpan<Real> spans_;
    std::vector<SphericalLight<Real>> lights_;  ///< angles at the next pixel, rates a pixel
    std::vector<Constants> constants_;
};

/// With both vectors interpolated: two rotations, their product, its angle and one table read a term.
template <typename Real>
class SeparateLoop : public Loop<Real> {
 public:
    explicit SeparateLoop(const LoopRequest& request)
        : ambient_(full_scale * request.triangle.material.ambient),
          scales_(light_scales(request)),
          bell_(make_bell(request.options, request.triangle.material)),
          spans_(request.scene, request.triangle) {}

    void start_row(const PixelRow& row) override {
        const SpanFrame::Span span = spans_.frame().span(row.y);
        position_ = Real(span.position(row.x));
        step_ = Real(1.0) / Real(1.0 / span.position_step());
        spans_.start(span);
    }

    Vec3<Real> next() override {
        using std::acos;
        const auto cosines = spans_.at(position_);
        Vec3<Real> sum = ambient_;
        for (std::size_t i = 0; i < cosines.size(); ++i) {
            const Real cosine = std::min(Real(1.0), std::max(Real(-1.0), cosines[i].highlight));
            sum += Vec3<Real>(scales_[i].diffuse) * std::max(Real(0.0), cosines[i].diffuse) +
                   Vec3<Real>(scales_[i].highlight) * looked_up(bell_, Real(acos(cosine)));
        }
        position_ += step_;
        return sum;
    }

 private:
    Vec3<Real> ambient_;
    std::vector<LightScale> scales_;
    Bell bell_;
    SeparateSpan<Real> spans_;
    Real position_{0.0};  ///< of the next pixel in the span
    Real step_{0.0};
};

}  // namespace

template <typename Real>
std::unique_ptr<Loop<Real>> make_spherical_loop(const LoopRequest& request) {
    if (request.options.spherical_separate) return std::make_unique<SeparateLoop<Real>>(request);
    return std::make_unique<SphericalLoop<Real>>(request);
}

template std::unique_ptr<Loop<double>> make_spherical_loop(const LoopRequest&);
template std::unique_ptr<Loop<Counted>> make_spherical_loop(const LoopRequest&);

}  // namespace sheen
