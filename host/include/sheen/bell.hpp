// SPDX-License-Identifier: MIT
/// \file
/// The bell cosᵏ(a·x) that stands for cosⁿ x, so that one table serves every shininess: paper `spherical`, eq. 19 and
/// 20, with any exponent k where the paper has 2.
#pragma once

namespace sheen {

/// cosᵏ(a·x) for |x| < min(π/2, π/2a), else 0 (eq. 19; the first bound matters where a < 1).
double bell(double x, double base, double scale);

/// max(0, cos x)ⁿ, what the bell stands for.
double cosine_power(double x, double shininess);

/// The paper's a: equal integrals of cosⁿ x·sin x and cosᵏ(a·x)·sin x (eq. 20; table 1 for k = 2), by quadrature and
/// root finding to 1e-10. n ≥ 0, k > 0. 1 where n = k, 0 where n = 0.
double equal_integral_scale(double shininess, double base);

/// The a with the least bell_error(), to 1e-7. n ≥ 0, k > 0.
double minimax_scale(double shininess, double base);

/// The largest |cosⁿ x − cosᵏ(a·x)| over all x.
double bell_error(double shininess, double base, double scale);

/// A highlight's shape: cosⁿ by a bell.
class Bell {
 public:
    /// n ≥ 0; k > 0, or 0 for cosⁿ itself.
    Bell(double shininess, double base, bool minimax);
    [[nodiscard]] double scale() const { return scale_; }  ///< a
    [[nodiscard]] double base() const { return base_; }    ///< k
    /// The bell's value for an angle in −π…π; 1 everywhere where n = 0, as cos⁰ is.
    [[nodiscard]] double operator()(double angle) const;

 private:
    double base_;
    double scale_;
};

}  // namespace sheen
