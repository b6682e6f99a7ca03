// SPDX-License-Identifier: MIT
// Paper `spherical`: figures 5, 14 and 15, and the two ways to interpolate a pair of vectors.
#include <cmath>

#include "results.hpp"
#include "sheen/hls/bell_table.hpp"
#include "spherical_span.hpp"

namespace sheen::paper {
namespace {

const double half_pi = std::acos(0.0);

/// What the hardware of figure 12 does to a picture: cos and cos² come from memories of as many address as data bits,
/// addressed by the angle's bin; all else is exact.
template <int bits>
class MemoryShader : public Shader {
 public:
    MemoryShader(const Scene& scene, const ScreenTriangle& triangle)
        : scene_(scene),
          material_(triangle.material),
          scale_(Bell(material_.shininess, 2.0, false).scale()),
          spans_(scene, triangle, false) {}

    void start_row(const PixelRow& row) override {
        span_ = spans_.frame().span(row.y);
        lights_ = spans_.start(span_);
    }

    [[nodiscard]] glm::dvec3 colour(int x, const glm::dvec3& /*weights*/) const override {
        const double t = span_.position(x);
        glm::dvec3 radiance = material_.ambient;
        for (std::size_t k = 0; k < lights_.size(); ++k) {
            const SphericalLight<double>& light = lights_[k];
            const double diffuse = light.diffuse.amplitude * read<10>(light.diffuse.angle(t));
            const double highlight = light.power * read<20>(scale_ * light.highlight.angle(t));
            radiance += scene_.lights[k].colour * (material_.diffuse * diffuse + material_.specular * highlight);
        }
        return 255.0 * radiance;
    }

 private:
    /// cos^(tenths/10) of the angle; 0 beyond ±π/2.
    template <int tenths>
    static double read(double angle) {
        constexpr const auto& quadrant = hls::bell_table<bits - 1, bits, tenths>;
        const double bin = std::floor(std::abs(angle) / half_pi * static_cast<double>(quadrant.size()));
        if (bin >= static_cast<double>(quadrant.size())) return 0.0;
        return static_cast<double>(quadrant[static_cast<std::size_t>(bin)]) / ((1 << bits) - 1);
    }

    const Scene& scene_;
    const Material& material_;
    double scale_;
    SphericalSpan<double> spans_;
    SpanFrame::Span span_;
    std::vector<SphericalLight<double>> lights_;
};

ordered_json halos(const Album& album) {
    ordered_json rows = ordered_json::array();
    for (const int n : {5, 10, 20}) {
        const Scene scene = grey_scene("sphere-690", n);
        const auto triangles = project(scene);
        MethodOptions power;
        power.spherical_base = 0.0;
        const ReferenceImage phong = render_reference(Method::phong, scene, triangles);
        const ReferenceImage exact = render_reference(Method::spherical, scene, triangles, power);
        const ReferenceImage bell = render_reference(Method::spherical, scene, triangles);
        album.keep("halo-power-" + std::to_string(n), exact);
        album.keep("halo-bell-" + std::to_string(n), bell);
        rows.push_back({{"n", n}, {"power", quality(phong, exact)}, {"bell", quality(phong, bell)}});
    }
    return rows;
}

template <int bits>
ordered_json memory_picture(const Album& album, const Scene& scene, const std::vector<ScreenTriangle>& triangles) {
    const ReferenceImage exact = render_reference(Method::spherical, scene, triangles);
    const ReferenceImage drawn = draw(scene, triangles, [&scene](const ScreenTriangle& triangle) {
        return std::make_unique<MemoryShader<bits>>(scene, triangle);
    });
    album.keep("memory-" + std::to_string(bits), drawn);
    ordered_json row = quality(exact, drawn);
    row["bits"] = bits;
    return row;
}

/// A lamp about two radii from the sphere's surface, so that L and H turn along a span too.
ordered_json pair_interpolation() {
    Scene scene = grey_scene("sphere-168", 50.0);
    scene.lights[0].kind = Light::Kind::positional;
    scene.lights[0].vector = {-1.2, 1.5, -1.7};
    const auto triangles = project(scene);
    MethodOptions options;
    options.spherical_base = 0.0;
    const ReferenceImage turned = render_reference(Method::spherical, scene, triangles, options);
    options.spherical_separate = true;
    const ReferenceImage separate = render_reference(Method::spherical, scene, triangles, options);
    const ReferenceImage phong = render_reference(Method::phong, scene, triangles);
    return {{"turned_against_separate", quality(separate, turned)},
            {"turned", quality(phong, turned)},
            {"separate", quality(phong, separate)}};
}

}  // namespace

ordered_json spherical_pictures(const Album& album) {
    const Scene coarse = grey_scene("sphere-168", 20.0);
    const auto triangles = project(coarse);
    const ReferenceImage phong = render_reference(Method::phong, coarse, triangles);
    const ReferenceImage gouraud = render_reference(Method::gouraud, coarse, triangles);
    album.keep("figure-5-phong", phong);
    album.keep("figure-5-gouraud", gouraud);

    const Scene wide = grey_scene("sphere-168", 5.0);
    const auto wide_triangles = project(wide);
    album.keep("memory-exact", render_reference(Method::spherical, wide, wide_triangles));
    return {
        {"figure_5", quality(phong, gouraud)},
        {"figure_14", halos(album)},
        {"figure_15", {memory_picture<4>(album, wide, wide_triangles), memory_picture<6>(album, wide, wide_triangles)}},
        {"pairs", pair_interpolation()}};
}

}  // namespace sheen::paper
