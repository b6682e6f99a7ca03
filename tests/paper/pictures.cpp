// SPDX-License-Identifier: MIT
#include "pictures.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "sheen/hls/formats.hpp"
#include "sheen/metrics.hpp"

namespace sheen::paper {
namespace {

constexpr double full_scale = 255.0;

bool is_number(const glm::dvec3& colour) {
    return std::isfinite(colour.x) && std::isfinite(colour.y) && std::isfinite(colour.z);
}

/// The vertices' weights at the centre of a pixel.
glm::dvec3 weights_at(const ScreenTriangle& triangle, int x, int y) {
    const auto& [a, b, c] = triangle.vertices;
    const SnappedPoint centre{256LL * x + 128, 256LL * y + 128};
    const glm::dvec3 areas(static_cast<double>(doubled_area(centre, b.point, c.point)),
                           static_cast<double>(doubled_area(a.point, centre, c.point)),
                           static_cast<double>(doubled_area(a.point, b.point, centre)));
    return areas / static_cast<double>(doubled_area(a.point, b.point, c.point));
}

/// Dark within half a line's width of an edge, light elsewhere.
class WireShader : public Shader {
 public:
    explicit WireShader(const ScreenTriangle& triangle) {
        const double area = std::abs(static_cast<double>(
            doubled_area(triangle.vertices[0].point, triangle.vertices[1].point, triangle.vertices[2].point)));
        for (std::size_t k = 0; k < 3; ++k) {
            const SnappedPoint& p = triangle.vertices[(k + 1) % 3].point;
            const SnappedPoint& q = triangle.vertices[(k + 2) % 3].point;
            height_[static_cast<int>(k)] =
                area / 256.0 / std::hypot(static_cast<double>(p.x - q.x), static_cast<double>(p.y - q.y));
        }
    }
    [[nodiscard]] glm::dvec3 colour(int /*x*/, const glm::dvec3& weights) const override {
        constexpr double half_width = 0.8;  // pixels
        const glm::dvec3 distance = weights * height_;
        const double nearest = std::min({distance.x, distance.y, distance.z});
        return glm::dvec3(nearest < half_width ? 30.0 : 225.0);
    }

 private:
    glm::dvec3 height_;  ///< of each vertex above the opposite edge, pixels
};

}  // namespace

void Album::keep(const std::string& name, const Image& picture) const {
    write_png(folder_ + "/" + name + ".png", picture);
}

void Album::keep(const std::string& name, const ReferenceImage& picture) const {
    constexpr int square = 16;
    ReferenceImage shown = picture;
    for (std::size_t i = 0; i < shown.colour.size(); ++i) {
        if (is_number(shown.colour[i])) continue;
        const int column = static_cast<int>(i % static_cast<std::size_t>(shown.width)) / square;
        const int row = static_cast<int>(i / static_cast<std::size_t>(shown.width)) / square;
        shown.colour[i] = glm::dvec3((column + row) % 2 == 0 ? 0.0 : full_scale);
    }
    keep(name, shown.image());
}

Scene grey_scene(const std::string& mesh, double shininess) {
    Scene scene;
    scene.mesh = make_builtin_mesh("builtin:" + mesh);
    scene.rotate_degrees = mesh == "torus-knot" ? glm::dvec3(30, 20, 0) : glm::dvec3(23, 0, 11);
    scene.material.diffuse = glm::dvec3(0.45);
    scene.material.specular = 0.45;
    scene.material.shininess = shininess;
    scene.lights = {Light()};
    scene.lights[0].vector = glm::normalize(scene.lights[0].vector);
    return scene;
}

Scene one_triangle_scene() {
    Scene scene = grey_scene("sphere-168", 20.0);
    scene.rotate_degrees = glm::dvec3(0.0);
    scene.mesh = Mesh();
    scene.mesh.name = "one triangle";
    scene.mesh.positions = {{-1.0, -1.0, 0.0}, {1.0, -1.0, 0.0}, {0.1, 1.0, 0.0}};
    for (const glm::dvec3& p : scene.mesh.positions) {
        scene.mesh.normals.push_back(glm::normalize(glm::dvec3(0.4 * p.x, 0.4 * p.y, 1.0)));
    }
    scene.mesh.triangles = {{0, 1, 2}};
    return scene;
}

Mesh sphere(std::uint32_t segments, std::uint32_t rings) {
    Mesh mesh;
    mesh.name = "sphere";
    mesh.positions.emplace_back(0.0, 1.0, 0.0);
    for (std::uint32_t ring = 1; ring < rings; ++ring) {
        const double polar = glm::pi<double>() * ring / rings;
        for (std::uint32_t segment = 0; segment < segments; ++segment) {
            const double turn = glm::two_pi<double>() * segment / segments;
            mesh.positions.emplace_back(std::sin(polar) * std::cos(turn), std::cos(polar),
                                        -std::sin(polar) * std::sin(turn));
        }
    }
    mesh.positions.emplace_back(0.0, -1.0, 0.0);
    mesh.normals = mesh.positions;
    const auto south = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    const auto at = [segments](std::uint32_t ring, std::uint32_t segment) {
        return 1 + (ring - 1) * segments + segment % segments;
    };
    for (std::uint32_t segment = 0; segment < segments; ++segment) {
        mesh.triangles.push_back({0, at(1, segment), at(1, segment + 1)});
        for (std::uint32_t ring = 1; ring + 1 < rings; ++ring) {
            mesh.triangles.push_back({at(ring, segment), at(ring + 1, segment), at(ring, segment + 1)});
            mesh.triangles.push_back({at(ring, segment + 1), at(ring + 1, segment), at(ring + 1, segment + 1)});
        }
        mesh.triangles.push_back({at(rings - 1, segment), south, at(rings - 1, segment + 1)});
    }
    return mesh;
}

ReferenceImage draw(const Scene& scene, const std::vector<ScreenTriangle>& triangles, const MakeShader& make) {
    ReferenceImage picture;
    picture.width = scene.width;
    picture.height = scene.height;
    const auto size = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
    picture.colour.assign(size, glm::dvec3(0.0));
    picture.covered.assign(size, false);
    std::vector<std::uint32_t> nearest(size, UINT32_MAX);
    for (const ScreenTriangle& triangle : triangles) {
        const std::unique_ptr<Shader> shader = make(triangle);
        for (const TriangleWalk& walk : triangle.walks) {
            const ChannelWords depth = depth_words(triangle, walk);
            const int step = walk.leftward ? -1 : 1;
            for_each_row(walk, [&](const WalkRow& row) {
                if (row.length == 0) return;
                shader->start_row({walk.leftward ? row.x - row.length + 1 : row.x, row.y, row.length});
                for (int i = 0; i < row.length; ++i) {
                    const int x = row.x + step * i;
                    const auto pixel = static_cast<std::size_t>(row.y) * static_cast<std::size_t>(scene.width) +
                                       static_cast<std::size_t>(x);
                    const std::uint32_t z = channel_value(depth, row.carries + i, row.row) >> hls::depth_fraction_bits;
                    if (picture.covered[pixel] && z >= nearest[pixel]) continue;
                    picture.covered[pixel] = true;
                    nearest[pixel] = z;
                    const glm::dvec3 colour = shader->colour(x, weights_at(triangle, x, row.y));
                    picture.colour[pixel] =
                        is_number(colour) ? glm::clamp(colour, glm::dvec3(0.0), glm::dvec3(full_scale)) : colour;
                }
            });
        }
    }
    return picture;
}

Image wireframe(const Scene& scene, const std::vector<ScreenTriangle>& triangles) {
    return draw(scene, triangles, [](const ScreenTriangle& triangle) { return std::make_unique<WireShader>(triangle); })
        .image();
}

ordered_json quality(const ReferenceImage& expected, const ReferenceImage& drawn) {
    std::vector<bool> numbers = drawn.covered;
    std::size_t covered = 0;
    std::size_t without = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!numbers[i]) continue;
        ++covered;
        numbers[i] = is_number(drawn.colour[i]);
        if (!numbers[i]) ++without;
    }
    ErrorMeter meter;
    meter.add(expected.colour, drawn.colour, numbers);
    ordered_json json;
    json["psnr"] = std::isfinite(meter.psnr()) ? ordered_json(meter.psnr()) : ordered_json(nullptr);
    json["max_error"] = meter.max_error();
    json["undefined_percent"] =
        covered == 0 ? 0.0 : 100.0 * static_cast<double>(without) / static_cast<double>(covered);
    return json;
}

}  // namespace sheen::paper
