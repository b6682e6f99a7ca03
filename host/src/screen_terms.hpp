// SPDX-License-Identifier: MIT
/// \file
/// Polynomials over the screen through values at a triangle's nodes, over any Real: the setup that loops price.
#pragma once

#include <array>
#include <cstdint>

#include "real_vector.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/scene.hpp"

namespace sheen {

/// The triangle's barycentric coordinates p of vertex 1 and q of vertex 2 over the screen, linear in X and Y, pixels
/// from vertex 0: p = p_x·X + p_y·Y. One division, and no edge is special.
template <typename Real>
struct Barycentrics {
    Real p_x, p_y, q_x, q_y;

    explicit Barycentrics(const ScreenTriangle& triangle) {
        const auto coordinate = [](std::int64_t subpixels) {
            return Real(static_cast<double>(subpixels) / (1 << hls::subpixel_bits));
        };
        const auto& [a, b, c] = triangle.vertices;
        const Real x1 = coordinate(b.point.x) - coordinate(a.point.x);
        const Real y1 = coordinate(b.point.y) - coordinate(a.point.y);
        const Real x2 = coordinate(c.point.x) - coordinate(a.point.x);
        const Real y2 = coordinate(c.point.y) - coordinate(a.point.y);
        const Real inverse = Real(1.0) / (x1 * y2 - y1 * x2);
        p_x = y2 * inverse;
        p_y = -x2 * inverse;
        q_x = -y1 * inverse;
        q_y = x1 * inverse;
    }
};

/// A polynomial T₀ + T₁Y + T₂X + T₃Y² + T₄XY + T₅X² (paper `quadratic`, eq. 4) over the screen, X and Y in pixels from
/// vertex 0 of a triangle. Value is Real or Vec3<Real>.
template <typename Real, typename Value>
struct Terms {
    std::array<Value, 6> t{};

    /// Through the values at the vertices.
    void fit_linear(const Barycentrics<Real>& at, const std::array<Value, 3>& nodes) {
        t[0] = nodes[0];
        add_slopes(at, nodes[1] - nodes[0], nodes[2] - nodes[0]);
    }
    /// Through the values at vertices 0, 1, 2 and midpoints 01, 12, 20. In p and q it is I₀ + Bp + Cq + Dp² + Epq +
    /// Fq², from the differences of first and second order along the two edges at vertex 0 and the twist between them.
    void fit_quadratic(const Barycentrics<Real>& at, const std::array<Value, 6>& nodes) {
        t[0] = nodes[0];
        const Value along_p = nodes[3] - nodes[0];
        const Value along_q = nodes[5] - nodes[0];
        const Value bend_p = (nodes[1] - nodes[3]) - along_p;
        const Value bend_q = (nodes[2] - nodes[5]) - along_q;
        add_slopes(at, (along_p + along_p) - bend_p, (along_q + along_q) - bend_q);

        const Value d = bend_p + bend_p;
        const Value f = bend_q + bend_q;
        const Value e = ((nodes[4] - nodes[5]) - along_p) * Real(4.0);
        const Real cross_p = at.p_x * at.p_y;
        const Real cross_q = at.q_x * at.q_y;
        t[3] = d * (at.p_y * at.p_y) + e * (at.p_y * at.q_y) + f * (at.q_y * at.q_y);
        t[4] = d * (cross_p + cross_p) + e * (at.p_x * at.q_y + at.p_y * at.q_x) + f * (cross_q + cross_q);
        t[5] = d * (at.p_x * at.p_x) + e * (at.p_x * at.q_x) + f * (at.q_x * at.q_x);
    }

 private:
    void add_slopes(const Barycentrics<Real>& at, const Value& along_p, const Value& along_q) {
        t[1] = along_p * at.p_y + along_q * at.q_y;
        t[2] = along_p * at.p_x + along_q * at.q_x;
    }
};

}  // namespace sheen
