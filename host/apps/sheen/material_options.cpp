// SPDX-License-Identifier: MIT
/// \file
/// Material options: each is checked where it is read, before any work.
#include "material_options.hpp"

#include <string>

#include "sheen/error.hpp"
#include "values.hpp"

namespace sheen::command {
namespace {

constexpr Range slopes = {0.01, 1.0};

Brdf parse_brdf(const std::string& word) {
    if (word == "blinn") return Brdf::blinn;
    if (word == "phong") return Brdf::phong;
    if (word == "cook-torrance") return Brdf::cook_torrance;
    throw UsageError("--brdf '" + word + "': give blinn, phong or cook-torrance");
}

/// Where a value was given, it replaces `component`.
template <typename Value>
void override_with(const std::optional<Value>& given, Value& component) {
    component = given.value_or(component);
}

}  // namespace

void MaterialOptions::add_to(CLI::App& command) {
    const auto add = [&command](const char* name, const char* words, const char* description, auto store) {
        command.add_option_function<std::string>(name, store, description)->type_name(words)->group("Material");
    };
    add("--ka", "R,G,B", "Ambient reflectance, 0 to 1 [.05,.05,.05]",
        [this](const std::string& word) { ambient_ = parse_vector("--ka", word, zero_to_one); });
    add("--kd", "R,G,B", "Diffuse reflectance, 0 to 1 [.55,.2,.12]",
        [this](const std::string& word) { diffuse_ = parse_vector("--kd", word, zero_to_one); });
    add("--ks", "S", "Specular reflectance, 0 to 1 [.4]",
        [this](const std::string& word) { specular_ = parse_number("--ks", word, zero_to_one); });
    add("--brdf", "B", "Reflection model: blinn, phong or cook-torrance [blinn]",
        [this](const std::string& word) { brdf_ = parse_brdf(word); });
    add("--shininess", "N", "blinn, phong: exponent of the highlight [50]",
        [this](const std::string& word) { shininess_ = parse_number("--shininess", word, not_negative); });
    add("--roughness", "M", "cook-torrance: slope of the facets, .01 to 1 [.2]",
        [this](const std::string& word) { roughness_ = parse_number("--roughness", word, slopes); });
    add("--fresnel", "F", "cook-torrance: reflectance at normal incidence, 0 to 1 [.1]",
        [this](const std::string& word) { normal_reflectance_ = parse_number("--fresnel", word, zero_to_one); });
}

void MaterialOptions::check() const {
    const bool facets = brdf_ == Brdf::cook_torrance;
    if (facets && shininess_) {
        throw UsageError("--shininess has no meaning with --brdf cook-torrance: give --roughness");
    }
    for (const auto& [name, given] : {std::pair{"--roughness", roughness_}, {"--fresnel", normal_reflectance_}}) {
        if (given && !facets) throw UsageError(std::string(name) + " has a meaning with --brdf cook-torrance only");
    }
}

void MaterialOptions::apply(Scene& scene) const {
    const auto apply_to = [this](Material& material) {
        override_with(ambient_, material.ambient);
        override_with(diffuse_, material.diffuse);
        override_with(specular_, material.specular);
        override_with(shininess_, material.shininess);
        override_with(roughness_, material.roughness);
        override_with(normal_reflectance_, material.normal_reflectance);
        override_with(brdf_, material.brdf);
    };
    apply_to(scene.material);
    for (Material& material : scene.mesh.materials) apply_to(material);
}

}  // namespace sheen::command
