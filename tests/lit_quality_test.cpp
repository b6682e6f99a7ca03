// SPDX-License-Identifier: MIT
/// \file
/// Methods with log channels, drawn by the kernels: how near 8-bit pictures come to 8-bit Phong, and to what rounding
/// the method in double precision to 8 bits would give.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "sheen/device.hpp"
#include "sheen/render.hpp"
#include "support/quality.hpp"

namespace sheen::test {
namespace {

/// 8-bit pictures against 8-bit Phong.
struct Quality {
    ErrorMeter device;   ///< the kernels'
    ErrorMeter rounded;  ///< the method in double precision, rounded
};

Quality measure_device(Method method, Scene scene, const std::vector<std::vector<Light>>& runs) {
    const std::vector<ScreenTriangle> triangles = project(scene);
    const std::unique_ptr<Device> device = make_device("hls");
    Quality quality;
    for (const std::vector<Light>& lights : runs) {
        scene.lights = lights;
        const ReferenceImage phong = render_reference(Method::phong, scene, triangles);
        const Image expected = phong.image();
        const auto packets = picture_packets(make_setups(method, scene, triangles));
        const Drawing drawn = draw(*device, packets, scene.width, scene.height);
        quality.device.add(expected, drawn.framebuffer.image(), phong.covered);
        quality.rounded.add(expected, render_reference(method, scene, triangles).image(), phong.covered);
    }
    return quality;
}

std::string print(const std::string& what, const Quality& quality) {
    std::string text = what + ": ";
    for (const ErrorMeter* meter : {&quality.device, &quality.rounded}) {
        text += std::to_string(meter->psnr()) + " dB, max " + std::to_string(std::lround(meter->max_error())) +
                (meter == &quality.device ? " on hls; " : " rounded from double");
    }
    std::cout << text << "\n";
    return text;
}

Scene sphere(const std::string& mesh, double shininess) {
    Scene scene = measured_scene(mesh);
    scene.material.shininess = shininess;
    return scene;
}

/// Three white lights from the front, side by side: a log channel each.
std::vector<std::vector<Light>> three_lights() {
    std::vector<Light> lights;
    for (const glm::dvec3& direction :
         {glm::dvec3(-0.4, 0.5, 0.77), glm::dvec3(0.6, 0.3, 0.74), glm::dvec3(0.2, -0.55, 0.8)}) {
        lights.push_back({glm::normalize(direction), glm::dvec3(0.6)});
    }
    return {lights};
}

TEST(LitQuality, LogQuadraticOn168TrianglesIsNearlyTheRoundedMethod) {
    const Quality quality = measure_device(Method::log_quadratic, sphere("sphere-168", 50.0), measured_lights());
    const std::string text = print("log-quadratic, 168 triangles, n = 50", quality);
    EXPECT_GE(quality.device.psnr(), 57.0) << text;
    EXPECT_LE(quality.device.max_error(), 4.0) << text;
    EXPECT_GE(quality.device.psnr(), quality.rounded.psnr() - 0.5) << text;
}

/// Wide highlights meet all cells of the table.
TEST(LitQuality, WideHighlightsStayWithinTwoSteps) {
    for (const int shininess : {5, 20}) {
        const Quality quality =
            measure_device(Method::log_quadratic, sphere("sphere-168", shininess), measured_lights());
        const std::string text = print("log-quadratic, 168 triangles, n = " + std::to_string(shininess), quality);
        EXPECT_GE(quality.device.psnr(), 56.5) << text;
        EXPECT_LE(quality.device.max_error(), 2.0) << text;
    }
}

TEST(LitQuality, LogQuadraticOn374TrianglesStaysWithinTwoSteps) {
    const Quality quality = measure_device(Method::log_quadratic, sphere("sphere-374", 50.0), measured_lights());
    const std::string text = print("log-quadratic, 374 triangles, n = 50", quality);
    EXPECT_LE(quality.device.max_error(), 2.0) << text;
}

TEST(LitQuality, ThreeLightsOnThreeLogChannels) {
    const Quality quality = measure_device(Method::log_quadratic, sphere("sphere-168", 50.0), three_lights());
    const std::string text = print("log-quadratic, 168 triangles, n = 50, three lights", quality);
    EXPECT_GE(quality.device.psnr(), quality.rounded.psnr() - 0.5) << text;
}

/// Where the mesh is finer the table's bytes are the limit: an entry is rounded, and the pixel again.
TEST(LitQuality, TaylorIsNearlyTheRoundedMethod) {
    struct Case {
        const char* mesh;
        double loss;  ///< dB
    };
    for (const Method method : {Method::taylor, Method::taylor_finite}) {
        for (const Case& tested : {Case{"sphere-168", 0.5}, Case{"sphere-374", 1.0}}) {
            const Quality quality = measure_device(method, sphere(tested.mesh, 50.0), measured_lights());
            const std::string text = print(to_string(method) + ", " + tested.mesh + ", n = 50", quality);
            EXPECT_GE(quality.device.psnr(), quality.rounded.psnr() - tested.loss) << text;
        }
    }
}

}  // namespace
}  // namespace sheen::test
