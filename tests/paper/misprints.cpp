// SPDX-License-Identifier: MIT
// Each formula that a paper prints wrong: the picture with it, the picture with the right one, both against Phong.
#include <cmath>

#include "printed_shaders.hpp"
#include "results.hpp"
#include "sheen/hls/formats.hpp"

namespace sheen::paper {
namespace {

/// One misprint: names of its pictures, and what they measure.
ordered_json pair(const Album& album, const std::string& name, const ReferenceImage& phong, const ReferenceImage& right,
                  const ReferenceImage& printed) {
    album.keep("misprint-" + name + "-right", right);
    album.keep("misprint-" + name + "-printed", printed);
    return {{"name", name}, {"right", quality(phong, right)}, {"printed", quality(phong, printed)}};
}

ordered_json by_options(const Album& album, const std::string& name, Method method, const Scene& scene,
                        const MethodOptions& right, const MethodOptions& printed) {
    const auto triangles = project(scene);
    return pair(album, name, render_reference(Method::phong, scene, triangles),
                render_reference(method, scene, triangles, right), render_reference(method, scene, triangles, printed));
}

/// The quadratic's six words with `bits` bits of fraction, stepped as a device steps them.
ReferenceImage with_fraction(const Scene& scene, const ScreenTriangle& triangle, int bits) {
    ReferenceImage picture = draw(
        scene, {triangle}, [&scene](const ScreenTriangle& t) { return make_shader(Method::quadratic, {}, scene, t); });
    const TriangleNodes nodes = shade_nodes(Method::quadratic, scene, triangle);
    for (const TriangleWalk& walk : triangle.walks) {
        const auto colour = fit_colour(nodes, triangle, centre_pixel(walk));
        for (int c = 0; c < 3; ++c) {
            const ChannelWords words = channel_words(colour[static_cast<std::size_t>(c)], walk, bits, false);
            for_each_row(walk, [&](const WalkRow& row) {
                for (int i = 0; i < row.length; ++i) {
                    const int x = row.x + (walk.leftward ? -i : i);
                    const auto pixel = static_cast<std::size_t>(row.y * scene.width + x);
                    const auto value = static_cast<std::int32_t>(channel_value(words, row.carries + i, row.row));
                    picture.colour[pixel][c] = std::min(255.0, std::max(0.0, std::ldexp(value, -bits)));
                }
            });
        }
    }
    return picture;
}

ordered_json fraction_bits(const Album& album) {
    const Scene scene = one_triangle_scene();
    const auto triangles = project(scene);
    constexpr int printed_bits = 10;  // > log₂ 960, the rows and columns together
    const ReferenceImage exact = render_reference(Method::quadratic, scene, triangles);
    return pair(album, "fraction-bits", exact, with_fraction(scene, triangles[0], hls::colour_fraction_bits),
                with_fraction(scene, triangles[0], printed_bits));
}

/// An upright sphere: half of its triangles have their bottom edge horizontal.
ordered_json horizontal_edges(const Album& album) {
    Scene scene = grey_scene("sphere-168", 50.0);
    scene.rotate_degrees = glm::dvec3(0.0);
    const auto triangles = project(scene);
    return pair(album, "horizontal-edges", render_reference(Method::phong, scene, triangles),
                render_reference(Method::quadratic, scene, triangles),
                draw(scene, triangles, [&scene](const ScreenTriangle& triangle) {
                    return std::make_unique<PrintedTermsShader>(scene, triangle);
                }));
}

/// Against the same polynomial, sampled at the pixels' centres.
ordered_json real_steps(const Album& album) {
    const Scene scene = grey_scene("sphere-168", 50.0);
    const auto triangles = project(scene);
    const ReferenceImage centres = render_reference(Method::quadratic, scene, triangles);
    return pair(album, "real-steps", centres, centres, draw(scene, triangles, [&scene](const ScreenTriangle& triangle) {
                    return std::make_unique<RealStepShader>(scene, triangle);
                }));
}

/// The printed T4 and T5 where vertices 1 and 2 are at one height: the worst difference from the quadratic that the
/// nodes were taken from.
double second_order_on_horizontal_edges() {
    double worst = 0.0;
    for (int k = 0; k < 64; ++k) {
        const PrintedGeometry<double> at{20.0 + k, 0.0, 3.0 * k - 40.0, 31.0};
        const std::array<double, 6> t{90.0, 0.7, -0.4, 0.011, 0.013 - 0.001 * k, 0.02};
        const auto value = [&t](double x, double y) {
            return t[5] * x * x + t[4] * x * y + t[3] * y * y + t[2] * x + t[1] * y + t[0];
        };
        const auto got = printed_terms<double>(
            at, {value(0, 0), value(at.x2, at.y2), value(at.x3, at.y3), value(at.x2 / 2, at.y2 / 2),
                 value(at.x3 / 2, at.y3 / 2), value((at.x2 + at.x3) / 2, (at.y2 + at.y3) / 2)});
        for (const std::size_t c : {1U, 2U, 4U, 5U}) worst = std::max(worst, std::abs(got[c] - t[c]));
    }
    return worst;
}

}  // namespace

ordered_json misprints(const Album& album) {
    MethodOptions printed;
    printed.as_printed = true;
    MethodOptions power;  // cosⁿ itself, so that the angle's error alone is seen
    power.spherical_base = 0.0;
    MethodOptions power_printed = power;
    power_printed.as_printed = true;
    MethodOptions four;
    four.recurrence_pixels = 4;
    MethodOptions four_printed = four;
    four_printed.as_printed = true;
    MethodOptions integer_index;
    integer_index.recurrence_integer_index = true;
    const Scene sphere = grey_scene("sphere-168", 50.0);
    Scene perspective = sphere;
    perspective.field_of_view = 40.0;

    const ordered_json rows = {
        horizontal_edges(album),
        real_steps(album),
        fraction_bits(album),
        by_options(album, "equation-15", Method::spherical, sphere, power, power_printed),
        by_options(album, "equations-10-11", Method::recurrence, sphere, four, four_printed),
        by_options(album, "integer-index", Method::recurrence, sphere, {}, integer_index),
        by_options(album, "duff", Method::duff, sphere, {}, printed),
        by_options(album, "t5", Method::taylor, sphere, {}, printed),
        by_options(album, "finite-eye", Method::taylor_finite, perspective, {}, printed),
    };
    return {{"pairs", rows}, {"printed_t4_t5_on_horizontal_edges", second_order_on_horizontal_edges()}};
}

}  // namespace sheen::paper
