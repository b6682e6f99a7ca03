// SPDX-License-Identifier: MIT
/// \file
/// The project's quality figures: a method in double against Phong per pixel, over the measured lights.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sheen/compare.hpp"
#include "sheen/mesh.hpp"
#include "sheen/metrics.hpp"
#include "sheen/reference.hpp"

namespace sheen::test {

/// A built-in mesh (named without "builtin:") as the figures show it: 512×512, turned, n = 50.
inline Scene measured_scene(const std::string& mesh) {
    Scene scene;
    scene.mesh = make_builtin_mesh("builtin:" + mesh);
    scene.rotate_degrees = mesh == "torus-knot" ? glm::dvec3(30, 20, 0) : glm::dvec3(23, 0, 11);
    return scene;
}

/// The method against Phong over the runs' lights. A colour that is no number is a failure.
inline ErrorMeter measure(Method method, const MethodOptions& options, Scene scene,
                          const std::vector<std::vector<Light>>& runs) {
    const std::vector<ScreenTriangle> triangles = project(scene);
    ErrorMeter meter;
    for (const std::vector<Light>& lights : runs) {
        scene.lights = lights;
        const ReferenceImage phong = render_reference(Method::phong, scene, triangles);
        const ReferenceImage drawn = render_reference(method, scene, triangles, options);
        for (std::size_t i = 0; i < drawn.colour.size(); ++i) {
            const glm::dvec3& c = drawn.colour[i];
            // Comparisons with what is no number are false.
            EXPECT_TRUE(c.x >= 0.0 && c.y >= 0.0 && c.z >= 0.0) << to_string(method) << " at pixel " << i;
        }
        meter.add(phong.colour, drawn.colour, phong.covered);
    }
    return meter;
}

}  // namespace sheen::test
