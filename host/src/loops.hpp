// SPDX-License-Identifier: MIT
/// \file
/// The loops that make_loop() chooses from, each in a file loop_<name>.cpp of its own, instantiated there for double
/// and Counted. A new method's loop is a line here and a case there.
#pragma once

#include <memory>

#include "sheen/loop.hpp"

namespace sheen {

/// What loops are made of, for the duration of their construction; the scene and the triangle outlive the loop.
struct LoopRequest {
    Method method;
    const MethodOptions& options;
    const Scene& scene;
    const ScreenTriangle& triangle;
};

/// `flat`, `gouraud`, `quadratic`: forward differences.
template <typename Real>
std::unique_ptr<Loop<Real>> make_polynomial_loop(const LoopRequest& request);
/// `duff`: numerators and squared length by forward differences.
template <typename Real>
std::unique_ptr<Loop<Real>> make_duff_loop(const LoopRequest& request);
/// `taylor`, `taylor-finite`: series by forward differences, and the exponent table.
template <typename Real>
std::unique_ptr<Loop<Real>> make_taylor_loop(const LoopRequest& request);
/// `spherical`: stepped angles and tables of cosines and bells.
template <typename Real>
std::unique_ptr<Loop<Real>> make_spherical_loop(const LoopRequest& request);
/// `recurrence`: dot products from their two predecessors.
template <typename Real>
std::unique_ptr<Loop<Real>> make_recurrence_loop(const LoopRequest& request);
/// `log-quadratic`: forward differences, then a table read and a shift for each highlight.
template <typename Real>
std::unique_ptr<Loop<Real>> make_log_quadratic_loop(const LoopRequest& request);
/// `phong`: the normal interpolated and normalised at each pixel, and the reflection model with it.
template <typename Real>
std::unique_ptr<Loop<Real>> make_phong_loop(const LoopRequest& request);

}  // namespace sheen
