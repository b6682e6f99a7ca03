// SPDX-License-Identifier: MIT
// Paper `quadratic`: figures 8 to 11; its knot also stands for figure 16 of paper `spherical`.
#include "results.hpp"

namespace sheen::paper {

ordered_json quadratic_pictures(const Album& album) {
    ordered_json spheres = ordered_json::array();
    for (const int count : {168, 374, 690}) {
        for (const int n : {5, 50}) {
            const Scene scene = grey_scene("sphere-" + std::to_string(count), n);
            const auto triangles = project(scene);
            const ReferenceImage phong = render_reference(Method::phong, scene, triangles);
            ordered_json row = {{"triangles", count}, {"n", n}};
            for (const Method method : {Method::gouraud, Method::quadratic, Method::phong}) {
                const ReferenceImage drawn = render_reference(method, scene, triangles);
                album.keep("sphere-" + std::to_string(count) + "-" + std::to_string(n) + "-" + to_string(method),
                           drawn);
                row[to_string(method)] = quality(phong, drawn);
            }
            spheres.push_back(row);
        }
    }

    Scene knot = grey_scene("torus-knot", 20.0);
    knot.material.diffuse = {0.62, 0.36, 0.10};
    const auto triangles = project(knot);
    const ReferenceImage phong = render_reference(Method::phong, knot, triangles);
    ordered_json complex = {{"triangles", knot.mesh.triangles.size()}};
    album.keep("knot-mesh", wireframe(knot, triangles));
    album.keep("knot-phong", phong);
    for (const Method method : {Method::gouraud, Method::quadratic, Method::spherical}) {
        const ReferenceImage drawn = render_reference(method, knot, triangles);
        album.keep("knot-" + to_string(method), drawn);
        complex[to_string(method)] = quality(phong, drawn);
    }
    return {{"spheres", spheres}, {"knot", complex}};
}

}  // namespace sheen::paper
