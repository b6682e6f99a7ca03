// SPDX-License-Identifier: MIT
/// \file
/// The loop of `log-quadratic` as hardware steps it: D and z by forward differences, two additions each, then for each
/// highlight a read of exp2_rom's table and a shift. The table's 64 bins are 1.1 % wide, and its entries 8 bits: the
/// highlights are within 1 % of the Shader's.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/exponential.hpp>
#include <optional>

#include "forward_difference.hpp"
#include "illumination.hpp"
#include "log_channels.hpp"
#include "loops.hpp"
#include "sheen/hls/exp2_table.hpp"
#include "sheen/log_quadratic.hpp"

namespace sheen {
namespace {

/// z of 2^0 8-bit steps.
constexpr double full_scale_log = 8.0;

/// One log channel while it is stepped.
template <typename Real>
struct SteppedHighlight {
    ForwardDifference<Real, Real> z;
    glm::dvec3 offset;  ///< −log₂ tint, added to z; infinite where a component is left out
};

/// Makes a triangle's nodes from incidences; what depends on the material alone is free.
template <typename Real>
class LogNodeMaker {
 public:
    LogNodeMaker(const LoopRequest& request, const LogChannels& channels)
        : options_(request.options),
          lights_(request.scene.lights),
          material_(request.triangle.material),
          channels_(channels),
          illumination_(request.scene, request.triangle.material) {
        mirror_.ambient = mirror_.diffuse = glm::dvec3(0.0);
    }
    [[nodiscard]] NodePoint<Real> corner(const ScreenVertex& vertex) const {
        return {Vec3<Real>(vertex.position), Vec3<Real>(vertex.normal)};
    }
    [[nodiscard]] NodePoint<Real> middle(const ScreenVertex& a, const ScreenVertex& b) const {
        return illumination_.edge_point(a, b);
    }
    [[nodiscard]] std::vector<Incidence<Real>> incidences(const NodePoint<Real>& point) const {
        return illumination_.incidences(point.position);
    }

    /// The node of D.
    [[nodiscard]] Vec3<Real> diffuse(const std::vector<Incidence<Real>>& at, const Vec3<Real>& normal) const {
        std::vector<Real> lambert;
        for (const Incidence<Real>& light : at) lambert.push_back(dot(normal, light.to_light));
        Vec3<Real> node(0.0);
        for (int c = 0; c < 3; ++c) node[c] = diffuse(c, lambert);
        for (const std::size_t light : channels_.in_colour) {
            node += reflected(mirror_, lights_[light], at[light], normal);
        }
        const Real limit(hls::colour_node_limit);
        for (int c = 0; c < 3; ++c) node[c] = std::min(std::max(node[c], -limit), limit);
        return node;
    }

    /// The node of z of one channel.
    [[nodiscard]] Real z(const std::vector<std::size_t>& channel, const std::vector<Incidence<Real>>& at,
                         const Vec3<Real>& normal) const {
        using std::exp2;
        using std::log2;
        std::vector<Real> each;
        for (const std::size_t light : channel) {
            const double peak = full_scale * material_.specular * brightest_component(lights_[light]);
            const Real z = Real(full_scale_log - std::log2(peak)) + bell(at[light], normal);
            each.push_back(std::min(z, Real(options_.log_node_limit)));
        }
        if (each.size() == 1) return each.front();
        const Real brightest = *std::min_element(each.begin(), each.end());
        Real sum(0.0);
        for (const Real& z : each) sum += exp2(brightest - z);
        return brightest - log2(sum);
    }

 private:
    [[nodiscard]] Real diffuse(int c, const std::vector<Real>& lambert) const {
        Real lit(0.0);
        std::optional<Real> least_dark;
        for (std::size_t i = 0; i < lambert.size(); ++i) {
            const double reflectance = full_scale * material_.diffuse[c] * lights_[i].colour[c];
            if (reflectance <= 0.0) continue;
            const Real radiance = Real(reflectance) * lambert[i];
            lit += std::max(Real(0.0), radiance);
            least_dark = least_dark ? std::max(*least_dark, radiance) : radiance;
        }
        return lit > Real(0.0) ? lit : least_dark.value_or(Real(0.0));
    }
    /// log_bell() of the highlight's cosine: a logarithm, or past its tangent's start an angle.
    [[nodiscard]] Real bell(const Incidence<Real>& at, const Vec3<Real>& normal) const {
        using std::acos;
        using std::log2;
        if (is_zero(at.half) && material_.brdf == Brdf::blinn)
            return Real(tangent_.line + tangent_.slope * farthest_ * farthest_);
        const Real cosine =
            material_.brdf == Brdf::phong
                ? Real(2.0) * dot(normal, at.to_light) * dot(normal, at.to_eye) - dot(at.to_light, at.to_eye)
                : dot(normal, at.half);
        if (cosine >= Real(std::cos(tangent_.start))) return Real(-material_.shininess) * log2(cosine);
        const Real angle = std::min(acos(std::max(Real(-1.0), cosine)), Real(farthest_));
        return Real(tangent_.line) + Real(tangent_.slope) * (angle * angle);
    }

    const MethodOptions& options_;
    const std::vector<Light>& lights_;
    const Material& material_;
    const LogChannels& channels_;
    Illumination<Real> illumination_;
    Material mirror_ = material_;
    static constexpr double farthest_ = LogBellTangent::farthest;
    LogBellTangent tangent_{material_.shininess};
};

template <typename Real>
class LogQuadraticLoop : public Loop<Real> {
 public:
    explicit LogQuadraticLoop(const LoopRequest& request)
        : LogQuadraticLoop(request,
                           assign_log_channels(request.options, request.triangle.material, request.scene.lights)) {}
    void start_row(const PixelRow& row) override {
        diffuse_->start_row(row);
        for (SteppedHighlight<Real>& highlight : highlights_) highlight.z.start_row(row);
    }
    Vec3<Real> next() override {
        Vec3<Real> colour = diffuse_->next();
        for (int c = 0; c < 3; ++c) colour[c] = std::max(colour[c], Real(0.0));
        colour += ambient_;
        for (SteppedHighlight<Real>& highlight : highlights_) add(highlight, colour);
        return colour;
    }

 private:
    LogQuadraticLoop(const LoopRequest& request, const LogChannels& channels)
        : ambient_(full_scale * request.triangle.material.ambient) {
        std::array<Vec3<Real>, 6> diffuse;
        std::vector<std::array<Real, 6>> z(channels.logarithmic.size());
        make_nodes(request, channels, diffuse, z);

        const Barycentrics<Real> at(request.triangle);
        const SnappedPoint& origin = request.triangle.vertices[0].point;
        const std::vector<LeftEdge> edges = left_edges(request.triangle);
        Terms<Real, Vec3<Real>> colour;
        colour.fit_quadratic(at, diffuse);
        diffuse_.emplace(2, colour.t, origin, edges);
        for (std::size_t k = 0; k < z.size(); ++k) {
            Terms<Real, Real> terms;
            terms.fit_quadratic(at, z[k]);
            const glm::dvec3 tint = tint_of(request.scene.lights[channels.logarithmic[k].front()]);
            highlights_.push_back({{2, terms.t, origin, edges}, -glm::log2(tint)});
        }
    }

    void make_nodes(const LoopRequest& request, const LogChannels& channels, std::array<Vec3<Real>, 6>& diffuse,
                    std::vector<std::array<Real, 6>>& z) {
        const CountingScope scope;
        const LogNodeMaker<Real> maker(request, channels);
        const auto& v = request.triangle.vertices;
        for (std::size_t n = 0; n < 6; ++n) {
            const NodePoint<Real> point = n < 3 ? maker.corner(v[n]) : maker.middle(v[n - 3], v[(n - 2) % 3]);
            const std::vector<Incidence<Real>> at = maker.incidences(point);
            diffuse[n] = maker.diffuse(at, point.normal);
            for (std::size_t k = 0; k < z.size(); ++k) z[k][n] = maker.z(channels.logarithmic[k], at, point.normal);
        }
        this->node_counts_ += scope.counts();
    }

    /// A grey light needs one read; a coloured one an addition and a read for each component that it has.
    static void add(SteppedHighlight<Real>& highlight, Vec3<Real>& colour) {
        const Real z = highlight.z.next();
        if (highlight.offset == glm::dvec3(0.0)) {
            colour += Vec3<Real>(power(z));
            return;
        }
        for (int c = 0; c < 3; ++c) {
            if (std::isfinite(highlight.offset[c])) colour[c] += power(z + Real(highlight.offset[c]));
        }
    }

    /// 2^(8 − z), z ≥ 0: the table's entry for the bin of z's fraction, shifted by its integer part.
    static Real power(const Real& z) {
        constexpr auto& table = hls::exp2_table<hls::exp2_address_bits, hls::exp2_data_bits>;
        const double stopped = value_of(std::max(z, Real(0.0)));
        const double whole = std::floor(stopped);
        const auto bin = static_cast<std::size_t>((stopped - whole) * static_cast<double>(table.size()));
        const Real entry = read_table<Real>(table, bin);
        return Real(std::exp2(-whole) * value_of(entry));  // a shift
    }

    Vec3<Real> ambient_;
    std::optional<ForwardDifference<Real, Vec3<Real>>> diffuse_;
    std::vector<SteppedHighlight<Real>> highlights_;
};

}  // namespace

template <typename Real>
std::unique_ptr<Loop<Real>> make_log_quadratic_loop(const LoopRequest& request) {
    return std::make_unique<LogQuadraticLoop<Real>>(request);
}

template std::unique_ptr<Loop<double>> make_log_quadratic_loop(const LoopRequest&);
template std::unique_ptr<Loop<Counted>> make_log_quadratic_loop(const LoopRequest&);

}  // namespace sheen
