// SPDX-License-Identifier: MIT
/// \file
/// Method `recurrence`: dot products along a span by a recurrence of second order (paper `recurrence`).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "sheen/shader.hpp"

namespace sheen {

/// The values f(t + 1)…f(t + 4) of f(t) = A·cos(tφ − α) from f(t) and f(t − 1), whatever A and α.
///
/// f(t + k) = U_k(cos φ)·f(t) − U_{k−1}(cos φ)·f(t − 1), U the Chebyshev polynomials of the second kind: eq. 7 is k =
/// 1, eq. 9 is k = 2. Errata: eq. 10 and 11 (k = 3 and 4) are printed wrong, and `as_printed` has them so:
///
///     k = 3   right    4c·cos 2φ·f(t) − (2·cos 2φ + 1)·f(t − 1)                         c = cos φ
///             printed  cos 2φ·(4c·f(t) − f(t − 1)) − 3·f(t − 1)
///     k = 4   right    (4·cos²2φ + 2·cos 2φ − 1)·f(t) − 4c·cos 2φ·f(t − 1)
///             printed  2·cos 2φ·(2·cos 2φ + 3)·f(t) − 2c·(cos 2φ + 4)·f(t − 1) + f(t)
template <typename Real>
class RecurrenceStep {
 public:
    /// The weights of f(t) and f(t − 1).
    struct Weights {
        Real now{0.0};
        Real before{0.0};
    };

    /// From c = cos φ. Without `four` only the first weights are made.
    RecurrenceStep(Real c, bool four, bool as_printed) {
        const Real one(1.0);
        const Real twice = c + c;
        weights_[0] = {twice, -one};
        if (!four) return;
        const Real c2 = twice * c - one;  // cos 2φ
        const Real twice_c2 = c2 + c2;
        weights_[1] = {twice_c2 + one, -twice};
        if (as_printed) {
            weights_[2] = {Real(4.0) * c * c2, -(c2 + Real(3.0))};
            weights_[3] = {twice_c2 * (twice_c2 + Real(3.0)) + one, -(twice * (c2 + Real(4.0)))};
        } else {
            const Real product = (twice + twice) * c2;
            weights_[2] = {product, -(twice_c2 + one)};
            weights_[3] = {twice_c2 * (twice_c2 + one) - one, -product};
        }
    }

    /// f(t + k), k = 1…4 (1 without `four`).
    [[nodiscard]] Real ahead(int k, Real now, Real before) const {
        const Weights& w = weights_[static_cast<std::size_t>(k - 1)];
        if (k == 1) return w.now * now - before;
        return w.now * now + w.before * before;
    }

 private:
    std::array<Weights, 4> weights_;
};

/// Why `recurrence` can't express the scene, if it can't: L, V and H must be the same along a span, so lights must be
/// directional and the camera orthographic. Any reflection model will do.
std::optional<std::string> why_not_recurrent(const Scene& scene);

/// \throws UsageError for a number of pixels a step other than 1 or 4.
std::unique_ptr<Shader> make_recurrence_shader(const MethodOptions& options, const Scene& scene,
                                               const ScreenTriangle& triangle);

}  // namespace sheen
