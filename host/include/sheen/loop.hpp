// SPDX-License-Identifier: MIT
/// \file
/// A method in the incremental form in which it is priced: what is done once a triangle, once a span, once a pixel.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "sheen/counted.hpp"
#include "sheen/method.hpp"
#include "sheen/scene.hpp"
#include "sheen/shader.hpp"

namespace sheen {

/// Shades the pixels of one triangle in order; Real is double or Counted. The constructor does the work per triangle.
/// The colours are the Shader's (to rounding), which computes each pixel afresh.
template <typename Real>
class Loop {
 public:
    Loop() = default;
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;
    virtual ~Loop() = default;
    /// The work per span. Rows come as triangle_rows() lists them.
    virtual void start_row(const PixelRow& row) = 0;
    /// One pixel of the row, the leftmost first: its colour in 8-bit steps, not clamped.
    virtual glm::vec<3, Real> next() = 0;
    /// The part of the constructor's operations that made radiances at nodes, by the reflection model: they depend on
    /// the model and the number of lights, not on the method's own arithmetic.
    [[nodiscard]] const OperationCounts& node_counts() const { return node_counts_; }

 protected:
    OperationCounts node_counts_;
};

/// The rows of the triangle's pixels in the image, walk by walk, each from its top to its bottom, without empty rows.
std::vector<PixelRow> triangle_rows(const ScreenTriangle& triangle);

/// The method's loop for a triangle of the scene, which must outlive it. \throws Error where why_inexpressible().
template <typename Real>
std::unique_ptr<Loop<Real>> make_loop(Method method, const MethodOptions& options, const Scene& scene,
                                      const ScreenTriangle& triangle);

extern template std::unique_ptr<Loop<double>> make_loop<double>(Method, const MethodOptions&, const Scene&,
                                                                const ScreenTriangle&);
extern template std::unique_ptr<Loop<Counted>> make_loop<Counted>(Method, const MethodOptions&, const Scene&,
                                                                  const ScreenTriangle&);

}  // namespace sheen
