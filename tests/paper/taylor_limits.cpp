// SPDX-License-Identifier: MIT
// Paper `fast-phong`: how large an exponent table must be, and how far a triangle may curve.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "results.hpp"
#include "sheen/exponent_table.hpp"
#include "sheen/metrics.hpp"

namespace sheen::paper {
namespace {

/// The largest |table − cosⁿ| at both ends and the middle of each cell, where a monotone function's error is largest.
double worst_read(double shininess, std::size_t bytes) {
    const ExponentTable table(shininess, bytes);
    const auto last = static_cast<double>(bytes - 1);
    double worst = 0.0;
    for (std::size_t k = 0; k < bytes; ++k) {
        for (const double side : {-0.5 + 1e-9, 0.0, 0.5 - 1e-9}) {
            const double cosine = std::min(1.0, std::max(0.0, (static_cast<double>(k) + side) / last));
            worst = std::max(worst, std::abs(table.read(cosine) - std::pow(cosine, shininess)));
        }
    }
    return worst;
}

ordered_json table_sizes() {
    ordered_json rows = ordered_json::array();
    for (const std::size_t bytes : {std::size_t{1024}, std::size_t{8192}}) {
        int n = 1;
        while (ExponentTable::sampling_error(n + 1, bytes) < 0.01) ++n;
        rows.push_back({{"bytes", bytes},
                        {"greatest_n", n},
                        {"sampling_error", ExponentTable::sampling_error(n, bytes)},
                        {"next_error", ExponentTable::sampling_error(n + 1, bytes)},
                        {"error_with_bytes", worst_read(n, bytes)}});
    }
    return rows;
}

/// An equilateral triangle across the image, its vertices' normals pairwise `degrees` apart, on a cone about the eye's
/// direction.
ScreenTriangle curved_triangle(const Scene& scene, double degrees) {
    const double tilt = std::asin(2.0 / std::sqrt(3.0) * std::sin(glm::radians(degrees) / 2.0));
    ScreenTriangle triangle;
    triangle.material = scene.material;
    triangle.face_normal = {0.0, 0.0, 1.0};
    const double radius = 0.55 * scene.width * 256.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double turn = glm::two_pi<double>() * (static_cast<double>(k) / 3.0 + 0.25);
        triangle.vertices[k].normal = {std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn),
                                       std::cos(tilt)};
        triangle.vertices[k].point = {128LL * scene.width + static_cast<std::int64_t>(radius * std::cos(turn)),
                                      static_cast<std::int64_t>(0.62 * scene.height * 256.0 - radius * std::sin(turn))};
    }
    const auto& [a, b, c] = triangle.vertices;
    triangle.walks = walk_in_image(a.point, b.point, c.point, scene.width, scene.height);
    return triangle;
}

/// 60 lights all round, from 3 to 87 degrees above the horizon.
std::vector<Light> lights_all_round() {
    std::vector<Light> lights(60);
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const std::size_t ring = k / 4;
        const double height = glm::radians(6.0 * static_cast<double>(ring) + 3.0);
        const double turn = glm::two_pi<double>() * static_cast<double>(k) / 24.0;
        lights[k].vector = {std::cos(turn) * std::cos(height), std::sin(turn) * std::cos(height), std::sin(height)};
    }
    return lights;
}

ordered_json curvature(const Album& album) {
    Scene scene;
    scene.width = scene.height = 128;
    scene.material.ambient = glm::dvec3(0.0);
    const std::vector<Light> all_round = lights_all_round();
    ordered_json rows = ordered_json::array();
    for (const double degrees : {10.0, 20.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0}) {
        ErrorMeter diffuse;
        ErrorMeter highlight;
        for (const Light& light : all_round) {
            scene.lights = {light};
            for (ErrorMeter* meter : {&diffuse, &highlight}) {
                const bool shiny = meter == &highlight;
                scene.material.diffuse = glm::dvec3(shiny ? 0.0 : 1.0);
                scene.material.specular = shiny ? 1.0 : 0.0;
                scene.material.shininess = 20.0;
                const std::vector<ScreenTriangle> triangle{curved_triangle(scene, degrees)};
                const ReferenceImage phong = render_reference(Method::phong, scene, triangle);
                MethodOptions options;
                options.taylor_table_bytes = 8192;
                const ReferenceImage drawn = render_reference(Method::taylor, scene, triangle, options);
                meter->add(phong.colour, drawn.colour, phong.covered);
            }
        }
        rows.push_back({{"degrees", degrees},
                        {"diffuse_max", diffuse.max_error()},
                        {"diffuse_rms", std::sqrt(diffuse.mean_square_error())},
                        {"highlight_max", highlight.max_error()},
                        {"highlight_rms", std::sqrt(highlight.mean_square_error())}});
    }

    scene.width = scene.height = 256;
    scene.material.diffuse = glm::dvec3(0.6);
    scene.material.specular = 0.4;
    scene.lights = {Light()};
    scene.lights[0].vector = glm::normalize(glm::dvec3(-0.75, 0.3, 0.6));
    for (const int degrees : {30, 60, 90}) {
        const std::vector<ScreenTriangle> triangle{curved_triangle(scene, degrees)};
        album.keep("curved-phong-" + std::to_string(degrees), render_reference(Method::phong, scene, triangle));
        album.keep("curved-taylor-" + std::to_string(degrees), render_reference(Method::taylor, scene, triangle));
    }
    return rows;
}

}  // namespace

ordered_json taylor_limits(const Album& album) { return {{"tables", table_sizes()}, {"curvature", curvature(album)}}; }

}  // namespace sheen::paper
