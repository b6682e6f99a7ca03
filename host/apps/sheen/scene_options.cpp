// SPDX-License-Identifier: MIT
/// \file
/// Scene options: each is checked where it is read, before any work.
#include "scene_options.hpp"

#include <glm/geometric.hpp>

#include "sheen/error.hpp"
#include "values.hpp"

namespace sheen::command {
namespace {

constexpr const char* material_group = "Material";
constexpr const char* light_group = "Lights";
/// A light may be brighter than white: colours saturate.
constexpr Range light_colours = {0.0, 100.0};

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
    command.add_flag("--two-sided", scene_.two_sided, "Draw back faces too, their normals flipped")->group(group);
    command.add_flag("--srgb", srgb_, "Store the image with the sRGB transfer curve")->group(group);
    add_light_options(command);
    add_material_options(command);
}

void SceneOptions::add_light_options(CLI::App& command) {
    // Called word by word, in the order given, so that a colour finds the light before it.
    command
        .add_option_function<std::string>(
            "--light",
            [this](const std::string& word) {
                Light light;
                light.vector = parse_direction("--light", word);
                scene_.lights.push_back(light);
                light_has_colour_ = false;
            },
            "Direction towards a light, eye space; repeat for more [-.4,.5,.77]")
        ->trigger_on_parse()
        ->type_name("X,Y,Z")
        ->group(light_group);
    command
        .add_option_function<std::string>(
            "--light-colour",
            [this](const std::string& word) {
                if (scene_.lights.empty()) {
                    throw UsageError("--light-colour '" + word + "': give it after the --light that it belongs to");
                }
                if (light_has_colour_) {
                    throw UsageError("--light-colour '" + word +
                                     "': the light before it has a colour; give one a light");
                }
                scene_.lights.back().colour = parse_vector("--light-colour", word, light_colours);
                light_has_colour_ = true;
            },
            "Colour of the light before it [1,1,1]")
        ->trigger_on_parse()
        ->type_name("R,G,B")
        ->group(light_group);
}

void SceneOptions::add_material_options(CLI::App& command) {
    const auto add = [&command](const char* name, const char* words, const char* description, auto store) {
        command.add_option_function<std::string>(name, store, description)->type_name(words)->group(material_group);
    };
    Material& material = scene_.material;
    add("--shininess", "N", "Exponent of the highlight [50]",
        [&material](const std::string& word) { material.shininess = parse_number("--shininess", word, not_negative); });
    add("--ka", "R,G,B", "Ambient reflectance, 0 to 1 [.05,.05,.05]",
        [&material](const std::string& word) { material.ambient = parse_vector("--ka", word, zero_to_one); });
    add("--kd", "R,G,B", "Diffuse reflectance, 0 to 1 [.55,.2,.12]",
        [&material](const std::string& word) { material.diffuse = parse_vector("--kd", word, zero_to_one); });
    add("--ks", "S", "Specular reflectance, 0 to 1 [.4]",
        [&material](const std::string& word) { material.specular = parse_number("--ks", word, zero_to_one); });
    add("--brdf", "B", "Reflection model: blinn [blinn]", [&material](const std::string& word) {
        if (word != "blinn") {
            throw UsageError("--brdf '" + word + "': give blinn");
        }
        material.brdf = Brdf::blinn;
    });
}

Scene SceneOptions::load() const {
    Scene scene = scene_;
    scene.mesh = load_mesh(mesh_);
    if (scene.lights.empty()) {
        Light light;
        light.vector = glm::normalize(light.vector);
        scene.lights.push_back(light);
    }
    return scene;
}

Image SceneOptions::finish(const Image& image) const { return srgb_ ? to_srgb(image) : image; }

}  // namespace sheen::command
