// SPDX-License-Identifier: MIT
/// \file
/// The loop of `recurrence`: every dot product by one multiplication and one subtraction a pixel (paper `recurrence`,
/// eq. 14), and the reflection model's formula with them.
#include "loops.hpp"
#include "recurrence_span.hpp"

namespace sheen {
namespace {

template <typename Real>
class RecurrenceLoop : public Loop<Real> {
 public:
    explicit RecurrenceLoop(const LoopRequest& request)
        : frame_(request.triangle.vertices),
          normal_(frame_, vertex_normals<Real>(request.triangle)),
          radiance_(request.scene, request.triangle),
          dots_(radiance_.directions(), request.options) {}

    void start_row(const PixelRow& row) override {
        const SpanFrame::Span span = frame_.span(row.y);
        dots_.start(frame_, span, normal_.ends(span), row);
    }

    Vec3<Real> next() override { return radiance_.colour(dots_.next()); }

 private:
    SpanFrame frame_;
    EdgeVector<Real> normal_;
    RecurrentRadiance<Real> radiance_;
    RecurrentDots<Real> dots_;
};

}  // namespace

template <typename Real>
std::unique_ptr<Loop<Real>> make_recurrence_loop(const LoopRequest& request) {
    return std::make_unique<RecurrenceLoop<Real>>(request);
}

template std::unique_ptr<Loop<double>> make_recurrence_loop(const LoopRequest&);
template std::unique_ptr<Loop<Counted>> make_recurrence_loop(const LoopRequest&);

}  // namespace sheen
