// SPDX-License-Identifier: MIT
/// \file
/// A span of method `recurrence`, over any Real: drawn with double, priced with Counted.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "edge_vectors.hpp"
#include "sheen/recurrence.hpp"

namespace sheen {

/// Dot products of the normal with fixed directions, pixel by pixel along a span.
template <typename Real>
class RecurrentDots {
 public:
    /// \throws UsageError for a number of pixels a step other than 1 or 4.
    RecurrentDots(std::vector<glm::dvec3> directions, const MethodOptions& options)
        : directions_(std::move(directions)),
          pixels_(checked(options.recurrence_pixels)),
          integer_index_(options.recurrence_integer_index),
          as_printed_(options.as_printed),
          now_(directions_.size()),
          before_(directions_.size()),
          ahead_(static_cast<std::size_t>(pixels_), std::vector<Real>(directions_.size())) {}

    /// Begins at the row's first pixel. The normal turns by ψ over the span, by φ from pixel to pixel; the paper's
    /// φ = ψ/m and angle tφ for the t-th of m pixels (`integer_index`) don't ask where pixels lie in the span.
    void start(const SpanFrame& frame, const SpanFrame::Span& span, const SpanEnds<Real>& normal, const PixelRow& row) {
        using std::cos;
        const GreatArc<Real> arc = normal.arc();
        Real first(0.0);
        Real phi(0.0);
        if (integer_index_) {
            const SpanFrame::Pixels covered = frame.pixels(row.y);
            phi = arc.angle() / Real(static_cast<double>(covered.end - covered.first));
            first = phi * Real(static_cast<double>(row.x - covered.first));
        } else {
            first = arc.angle() * Real(span.position(row.x));
            // A span narrower than a pixel has one: any step will do.
            phi = arc.angle() / Real(std::max(1.0, 1.0 / span.position_step()));
        }
        step_ = RecurrenceStep<Real>(cos(phi), pixels_ > 1, as_printed_);
        const Vec3<Real> one_before = arc.at_angle(first - phi);
        const Vec3<Real> two_before = arc.at_angle(first - (phi + phi));
        for (std::size_t i = 0; i < directions_.size(); ++i) {
            now_[i] = dot(one_before, Vec3<Real>(directions_[i]));
            before_[i] = dot(two_before, Vec3<Real>(directions_[i]));
        }
        ready_ = 0;
    }

    /// The dot products at the next pixel, in the order of the directions.
    const std::vector<Real>& next() {
        const auto pixels = static_cast<std::size_t>(pixels_);
        if (ready_ == 0) {
            for (std::size_t i = 0; i < directions_.size(); ++i) {
                const Real now = now_[i];
                const Real before = before_[i];
                for (std::size_t k = 0; k < pixels; ++k) {
                    ahead_[k][i] = step_.ahead(static_cast<int>(k) + 1, now, before);
                }
                before_[i] = pixels_ > 1 ? ahead_[pixels - 2][i] : now;
                now_[i] = ahead_[pixels - 1][i];
            }
            ready_ = pixels;
        }
        return ahead_[pixels - ready_--];
    }

 private:
    static int checked(int pixels) {
        if (pixels == 1 || pixels == 4) return pixels;
        throw UsageError("method 'recurrence' with " + std::to_string(pixels) + " pixels a step: give 1 or 4");
    }

    std::vector<glm::dvec3> directions_;
    int pixels_;
    bool integer_index_;
    bool as_printed_;
    RecurrenceStep<Real> step_{Real(1.0), false, false};
    std::vector<Real> now_, before_;        ///< f(t) and f(t − 1)
    std::vector<std::vector<Real>> ahead_;  ///< the last step's pixels
    std::size_t ready_ = 0;                 ///< of which these, the last ones, are still to come
};

/// What a triangle's pixels are made of: N·L and N·H or R·V of each light, and the radiance of these.
template <typename Real>
class RecurrentRadiance {
 public:
    /// Scene and triangle must outlive it.
    RecurrentRadiance(const Scene& scene, const ScreenTriangle& triangle)
        : scene_(scene), material_(triangle.material) {
        for (const Light& light : scene.lights) {
            lights_.push_back(incidence(light, glm::dvec3(0.0), towards_camera()));
        }
    }

    /// L of each light, then H of each, then V: those that the reflection model asks for.
    [[nodiscard]] std::vector<glm::dvec3> directions() const {
        std::vector<glm::dvec3> result;
        for (const Incidence<double>& at : lights_) result.push_back(at.to_light);
        if (material_.brdf != Brdf::phong) {
            for (const Incidence<double>& at : lights_) result.push_back(at.half);
        }
        if (material_.brdf != Brdf::blinn) result.push_back(towards_camera());
        return result;
    }

    /// In 8-bit steps, not clamped, from the dot products with directions().
    [[nodiscard]] Vec3<Real> colour(const std::vector<Real>& dots) const {
        Vec3<Real> sum(full_scale * material_.ambient);
        for (std::size_t i = 0; i < lights_.size(); ++i) {
            const glm::dvec3 steps = full_scale * scene_.lights[i].colour;
            sum += Vec3<Real>(steps * material_.diffuse) * std::max(Real(0.0), dots[i]) +
                   Vec3<Real>(steps * material_.specular) * highlight_of(i, dots);
        }
        return sum;
    }

 private:
    [[nodiscard]] Real highlight_of(std::size_t i, const std::vector<Real>& dots) const {
        const Incidence<double>& at = lights_[i];
        if (is_zero(at.half)) return Real(0.0);
        const std::size_t half = lights_.size() + i;
        switch (material_.brdf) {
            case Brdf::blinn:
                return blinn_highlight(material_, dots[half]);
            case Brdf::phong:
                return phong_highlight(material_, dots[i], dots.back(), Real(dot(at.to_light, at.to_eye)));
            case Brdf::cook_torrance:
                return cook_torrance_highlight(material_, dots[half], dots[i], dots.back(),
                                               Real(dot(at.to_eye, at.half)));
        }
        throw Error("reflection model number " + std::to_string(static_cast<int>(material_.brdf)) + " does not exist");
    }

    const Scene& scene_;
    const Material& material_;
    std::vector<Incidence<double>> lights_;
};

}  // namespace sheen
