// SPDX-License-Identifier: MIT
/// \file
/// Which loop a method has.
#include "sheen/loop.hpp"

#include "loops.hpp"
#include "sheen/error.hpp"

namespace sheen {

std::vector<PixelRow> triangle_rows(const ScreenTriangle& triangle) {
    std::vector<PixelRow> rows;
    for (const TriangleWalk& walk : triangle.walks) {
        for_each_span(walk, [&rows](int x, int y, int length, int step) {
            rows.push_back({step < 0 ? x - length + 1 : x, y, length});
        });
    }
    return rows;
}

template <typename Real>
std::unique_ptr<Loop<Real>> make_loop(Method method, const MethodOptions& options, const Scene& scene,
                                      const ScreenTriangle& triangle) {
    if (const std::optional<std::string> reason = why_inexpressible(method, scene)) throw Error(*reason);
    const LoopRequest request{method, options, scene, triangle};
    switch (method) {
        case Method::flat:
        case Method::gouraud:
        case Method::quadratic:
            return make_polynomial_loop<Real>(request);
        case Method::duff:
            return make_duff_loop<Real>(request);
        case Method::taylor:
        case Method::taylor_finite:
            return make_taylor_loop<Real>(request);
        case Method::spherical:
            return make_spherical_loop<Real>(request);
        case Method::recurrence:
            return make_recurrence_loop<Real>(request);
        case Method::log_quadratic:
            return make_log_quadratic_loop<Real>(request);
        case Method::phong:
            return make_phong_loop<Real>(request);
    }
    throw Error("method number " + std::to_string(static_cast<int>(method)) + " does not exist");
}

template std::unique_ptr<Loop<double>> make_loop<double>(Method, const MethodOptions&, const Scene&,
                                                         const ScreenTriangle&);
template std::unique_ptr<Loop<Counted>> make_loop<Counted>(Method, const MethodOptions&, const Scene&,
                                                           const ScreenTriangle&);

}  // namespace sheen
