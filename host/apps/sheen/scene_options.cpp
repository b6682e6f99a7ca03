// SPDX-License-Identifier: MIT
/// \file
/// Scene options: each is checked where it is read, before any work.
#include "scene_options.hpp"

#include <glm/geometric.hpp>

#include "sheen/error.hpp"
#include "values.hpp"

namespace sheen::command {
namespace {

constexpr const char* light_group = "Lights";
/// A light may be brighter than white: colours saturate.
constexpr Range light_colours = {0.0, 100.0};
constexpr Range fields_of_view = {1.0, 170.0};
constexpr Range distances = {0.0, 1000.0};
/// Their squares are finite.
constexpr Range places = {-1e100, 1e100};

}  // namespace

SceneOptions::SceneOptions(CLI::App& command) {
    constexpr const char* group = "Scene";
    const auto add = [&command](const char* name, const char* words, const char* description, auto store) {
        command.add_option_function<std::string>(name, store, description)->type_name(words)->group(group);
    };
    command.add_option("MESH", mesh_, "OBJ file, or a built-in mesh: see `sheen info`")->required()->type_name("");
    add("--size", "WxH", "Image size in pixels [512x512]", [this](const std::string& word) {
        const Size size = parse_size("--size", word);
        scene_.width = size.width;
        scene_.height = size.height;
    });
    add("--rotate", "X,Y,Z", "Turn the mesh, degrees, about x, then y, then z [0,0,0]",
        [this](const std::string& word) { scene_.rotate_degrees = parse_vector("--rotate", word, any_number); });
    add("--perspective", "DEG", "Perspective: vertical field of view, 1 to 170 degrees [orthographic]",
        [this](const std::string& word) {
            scene_.field_of_view = parse_number("--perspective", word, fields_of_view);
        });
    add("--distance", "R", "Perspective: distance of the eye from the mesh's centre, 0 to 1000 radii [fills 0.9]",
        [this](const std::string& word) { scene_.distance = parse_number("--distance", word, distances); });
    command.add_flag("--two-sided", scene_.two_sided, "Draw back faces too, their normals flipped")->group(group);
    command.add_flag("--srgb", srgb_, "Store the image with the sRGB transfer curve")->group(group);
    add_light_options(command);
    material_.add_to(command);
}

void SceneOptions::add_light_options(CLI::App& command) {
    // Called word by word, in the order given, so that a colour finds the light before it.
    const auto add = [&command](const char* name, const char* words, const char* description, auto store) {
        command.add_option_function<std::string>(name, store, description)
            ->trigger_on_parse()
            ->type_name(words)
            ->group(light_group);
    };
    const auto add_light = [this](Light::Kind kind, const glm::dvec3& vector) {
        Light light;
        light.kind = kind;
        light.vector = vector;
        scene_.lights.push_back(light);
        light_has_colour_ = false;
    };
    add("--light", "X,Y,Z", "Direction towards a light, eye space; repeat for more [-.4,.5,.77]",
        [add_light](const std::string& word) {
            add_light(Light::Kind::directional, parse_direction("--light", word));
        });
    add("--point-light", "X,Y,Z", "Place of a light, eye space, in the mesh's unit; repeat for more",
        [add_light](const std::string& word) {
            add_light(Light::Kind::positional, parse_vector("--point-light", word, places));
        });
    add("--light-colour", "R,G,B", "Colour of the light before it [1,1,1]", [this](const std::string& word) {
        if (scene_.lights.empty()) {
            throw UsageError("--light-colour '" + word + "': give it after the light that it belongs to");
        }
        if (light_has_colour_) {
            throw UsageError("--light-colour '" + word + "': the light before it has a colour; give one a light");
        }
        scene_.lights.back().colour = parse_vector("--light-colour", word, light_colours);
        light_has_colour_ = true;
    });
}

Scene SceneOptions::load() const {
    material_.check();
    if (scene_.distance && !scene_.field_of_view) {
        throw UsageError("--distance has a meaning with --perspective only: the orthographic camera has no place");
    }
    Scene scene = scene_;
    scene.mesh = load_mesh(mesh_);
    material_.apply(scene);
    if (scene.lights.empty()) {
        Light light;
        light.vector = glm::normalize(light.vector);
        scene.lights.push_back(light);
    }
    return scene;
}

Image SceneOptions::finish(const Image& image) const { return srgb_ ? to_srgb(image) : image; }

}  // namespace sheen::command
