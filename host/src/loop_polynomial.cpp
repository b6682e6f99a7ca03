// SPDX-License-Identifier: MIT
/// \file
/// The loops of `flat`, `gouraud` and `quadratic`: colour at nodes, a polynomial through them, forward differences.
#include <array>

#include "forward_difference.hpp"
#include "illumination.hpp"
#include "loops.hpp"

namespace sheen {
namespace {

int order_of(Method method) { return method == Method::flat ? 0 : method == Method::gouraud ? 1 : 2; }

template <typename Real>
class PolynomialLoop : public Loop<Real> {
 public:
    explicit PolynomialLoop(const LoopRequest& request)
        : colour_(order_of(request.method), terms(request), request.triangle.vertices[0].point,
                  left_edges(request.triangle)) {}
    void start_row(const PixelRow& row) override { colour_.start_row(row); }
    Vec3<Real> next() override { return colour_.next(); }

 private:
    std::array<Vec3<Real>, 6> terms(const LoopRequest& request) {
        const ScreenTriangle& triangle = request.triangle;
        const Illumination<Real> light(request.scene, triangle.material);
        Terms<Real, Vec3<Real>> terms;
        if (request.method == Method::flat) {
            terms.t[0] = flat_node(light, triangle);
            return terms.t;
        }
        const std::array<Vec3<Real>, 3> corners = corner_nodes(light, triangle);
        if (request.method == Method::gouraud) {
            terms.fit_linear(Barycentrics<Real>(triangle), corners);
        } else {
            const std::array<Vec3<Real>, 3> middles = edge_nodes(light, triangle);
            terms.fit_quadratic(Barycentrics<Real>(triangle),
                                {corners[0], corners[1], corners[2], middles[0], middles[1], middles[2]});
        }
        return terms.t;
    }

    Vec3<Real> flat_node(const Illumination<Real>& light, const ScreenTriangle& triangle) {
        const CountingScope scope;
        const auto& v = triangle.vertices;
        Vec3<Real> centroid(0.0);
        if (light.needs_position()) {
            centroid =
                (Vec3<Real>(v[0].position) + Vec3<Real>(v[1].position) + Vec3<Real>(v[2].position)) * Real(1.0 / 3.0);
        }
        const Vec3<Real> colour = light.node(centroid, Vec3<Real>(triangle.face_normal));
        this->node_counts_ += scope.counts();
        return colour;
    }
    std::array<Vec3<Real>, 3> corner_nodes(const Illumination<Real>& light, const ScreenTriangle& triangle) {
        const CountingScope scope;
        std::array<Vec3<Real>, 3> colours;
        for (std::size_t k = 0; k < 3; ++k) {
            const ScreenVertex& vertex = triangle.vertices[k];
            colours[k] = light.node(Vec3<Real>(vertex.position), Vec3<Real>(vertex.normal));
        }
        this->node_counts_ += scope.counts();
        return colours;
    }
    std::array<Vec3<Real>, 3> edge_nodes(const Illumination<Real>& light, const ScreenTriangle& triangle) {
        const CountingScope scope;
        std::array<Vec3<Real>, 3> colours;
        for (std::size_t k = 0; k < 3; ++k) {
            colours[k] = light.edge_node(triangle.vertices[k], triangle.vertices[(k + 1) % 3]);
        }
        this->node_counts_ += scope.counts();
        return colours;
    }

    ForwardDifference<Real, Vec3<Real>> colour_;
};

}  // namespace

template <typename Real>
std::unique_ptr<Loop<Real>> make_polynomial_loop(const LoopRequest& request) {
    return std::make_unique<PolynomialLoop<Real>>(request);
}

template std::unique_ptr<Loop<double>> make_polynomial_loop(const LoopRequest&);
template std::unique_ptr<Loop<Counted>> make_polynomial_loop(const LoopRequest&);

}  // namespace sheen
