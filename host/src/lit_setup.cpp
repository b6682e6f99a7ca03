// SPDX-License-Identifier: MIT
#include "sheen/lit_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "fast_phong.hpp"
#include "log_channels.hpp"
#include "sheen/error.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/log_quadratic.hpp"
#include "sheen/shader.hpp"

namespace sheen {
namespace {

constexpr double full_scale = 255.0;
constexpr int power_table_entries = 1 << hls::power_address_bits;

/// The materials that triangles of the scene may have.
std::vector<Material> materials_of(const Scene& scene) {
    return scene.mesh.triangle_materials.empty() ? std::vector<Material>{scene.material} : scene.mesh.materials;
}

bool is_coloured(const Light& light) { return tint_of(light) != glm::dvec3(1.0); }

std::string coloured_light(Method method, std::size_t light) {
    return fmt::format(
        "{}: light {} is coloured, and a device's highlights are grey: give it equal components, or take quadratic",
        to_string(method), light + 1);
}

std::optional<std::string> why_not_log_quadratic(const MethodOptions& options, const Scene& scene) {
    for (const Material& material : materials_of(scene)) {
        const LogChannels channels = assign_log_channels(options, material, scene.lights);
        if (channels.logarithmic.size() > hls::max_log_channels) {
            return fmt::format("log-quadratic: {} log channels, and a device has at most {}: give as many",
                               channels.logarithmic.size(), hls::max_log_channels);
        }
        for (const std::vector<std::size_t>& of_channel : channels.logarithmic) {
            if (is_coloured(scene.lights[of_channel.front()])) {
                return coloured_light(Method::log_quadratic, of_channel.front());
            }
        }
    }
    return std::nullopt;
}

/// The lights that are not black; indices.
std::vector<std::size_t> bright_lights(const Scene& scene) {
    std::vector<std::size_t> bright;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        if (brightest_component(scene.lights[k]) > 0.0) bright.push_back(k);
    }
    return bright;
}

std::optional<std::string> why_not_taylor(Method method, const MethodOptions& options, const Scene& scene) {
    const std::vector<std::size_t> bright = bright_lights(scene);
    if (bright.size() > 1) {
        return fmt::format("{}: {} lights, and a device expands one: give one light, or take log-quadratic",
                           to_string(method), bright.size());
    }
    if (options.taylor_table_bytes != power_table_entries) {
        return fmt::format("{}: an exponent table of {} bytes, and a device's has {}: give that size",
                           to_string(method), options.taylor_table_bytes, power_table_entries);
    }
    const std::vector<Material> materials = materials_of(scene);
    const bool shines =
        std::any_of(materials.begin(), materials.end(), [](const Material& m) { return m.specular > 0.0; });
    if (!bright.empty() && shines && is_coloured(scene.lights[bright.front()])) {
        return coloured_light(method, bright.front());
    }
    return std::nullopt;
}

/// Ambient in the material's units, to the nearest step that the core keeps, and ½ for the pixel's rounding.
MaterialSetup material_setup(const Material& material) {
    constexpr int kept = 1 << hls::colour_sum_fraction_bits;
    constexpr int unit = 1 << (hls::ambient_fraction_bits - hls::colour_sum_fraction_bits);
    MaterialSetup setup;
    for (int c = 0; c < hls::colour_channels; ++c) {
        const double steps = full_scale * material.ambient[c] + 0.5;
        setup.ambient[static_cast<std::size_t>(c)] = static_cast<int>(std::lround(kept * steps)) * unit;
    }
    return setup;
}

/// Where a message finds the triangle.
std::string place_of(const ScreenTriangle& triangle) {
    const glm::dvec2 centre = centre_of(triangle);
    return fmt::format("the triangle at pixel ({:.0f}, {:.0f})", centre.x, centre.y);
}

/// \throws Error unless all values lie in least…greatest.
void require_range(const std::array<double, 6>& values, double least, double greatest, Method method,
                   const ScreenTriangle& triangle, const char* what, const char* advice) {
    for (const double value : values) {
        if (value >= least && value <= greatest) continue;
        throw Error(fmt::format("{}: {} has {} of {:.4g} at a node, and a device's channel holds {:.4g} to {:.4g}: {}",
                                to_string(method), place_of(triangle), what, value, least, greatest, advice));
    }
}

/// A highlight that is nothing anywhere.
std::array<double, 6> dark_channel() {
    std::array<double, 6> z{};
    z.fill(greatest_z_node);
    return z;
}

/// The vertices' weights at the nodes: vertices 0, 1, 2 and midpoints 01, 12, 20.
constexpr std::array<std::array<double, 3>, 6> node_weights{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}};

}  // namespace

/// The power tables made so far, by strength and shininess.
class LitSetups::Tables {
 public:
    std::shared_ptr<const PowerEntries> get(double strength, double shininess) {
        std::shared_ptr<const PowerEntries>& table = tables_[{strength, shininess}];
        if (table == nullptr) table = std::make_shared<const PowerEntries>(power_entries(strength, shininess));
        return table;
    }

 private:
    std::map<std::pair<double, double>, std::shared_ptr<const PowerEntries>> tables_;
};

std::optional<std::string> why_not_on_devices(Method method, const MethodOptions& options, const Scene& scene) {
    if (method == Method::log_quadratic) return why_not_log_quadratic(options, scene);
    if (has_log_channels(method)) return why_not_taylor(method, options, scene);
    return std::nullopt;
}

PowerEntries power_entries(double strength, double shininess) {
    PowerEntries entries(power_table_entries);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const double cosine = static_cast<double>(k) / (power_table_entries - 1);
        const double highlight = std::min(strength * std::pow(cosine, shininess), full_scale);
        entries[k] = static_cast<std::uint8_t>(std::lround(highlight));
    }
    return entries;
}

LitSetups::LitSetups(Method method, const MethodOptions& options, const Scene& scene)
    : method_(method), options_(options), scene_(scene), tables_(std::make_unique<Tables>()) {
    if (!has_log_channels(method)) throw Error(fmt::format("method '{}' has no log channels", to_string(method)));
    if (const std::optional<std::string> reason = why_inexpressible(method, scene)) throw Error(*reason);
    if (const std::optional<std::string> reason = why_not_on_devices(method, options, scene)) throw Error(*reason);
    options_.log_node_limit = std::min(options_.log_node_limit, greatest_z_node);
}

LitSetups::~LitSetups() = default;

LitNodes LitSetups::nodes(const ScreenTriangle& triangle) const {
    LitNodes nodes = method_ == Method::log_quadratic ? log_quadratic_nodes(triangle) : taylor_nodes(triangle);
    if (nodes.log.empty()) nodes.log.push_back(dark_channel());
    return nodes;
}

LitNodes LitSetups::log_quadratic_nodes(const ScreenTriangle& triangle) const {
    const LogNodes shaded = shade_log_nodes(options_, scene_, triangle);
    LitNodes nodes;
    nodes.diffuse = shaded.diffuse;
    nodes.material = material_setup(triangle.material);
    for (const LogHighlight& highlight : shaded.highlights) {
        require_range(highlight.z, least_z_node, greatest_z_node, method_, triangle, "a highlight's z",
                      "take darker lights");
        nodes.log.push_back(highlight.z);
    }
    return nodes;
}

LitNodes LitSetups::taylor_nodes(const ScreenTriangle& triangle) const {
    const TriangleSeries series(method_, options_, scene_, triangle);
    const Material& material = triangle.material;
    LitNodes nodes;
    nodes.material = material_setup(material);
    for (const std::size_t index : bright_lights(scene_)) {
        const Light& light = scene_.lights[index];
        std::array<double, 6> power{};
        for (std::size_t k = 0; k < node_weights.size(); ++k) {
            const auto& [a, b, c] = node_weights[k];
            const TriangleSeries::Cosines cosines = series.at(index, {a, b, c});
            nodes.diffuse.colour[k] = full_scale * light.colour * material.diffuse * cosines.diffuse;
            // The address is the cosine's nearest entry, as ExponentTable reads.
            power[k] =
                ((power_table_entries - 1) * cosines.specular + 0.5) / (power_table_entries >> hls::power_integer_bits);
        }
        constexpr const char* advice = "take a darker light or a mesh of smaller triangles, or log-quadratic";
        for (int c = 0; c < hls::colour_channels; ++c) {
            std::array<double, 6> diffuse{};
            for (std::size_t k = 0; k < diffuse.size(); ++k) diffuse[k] = nodes.diffuse.colour[k][c];
            require_range(diffuse, -hls::colour_node_limit, hls::colour_node_limit, method_, triangle,
                          "a diffuse colour", advice);
        }
        if (material.specular <= 0.0) continue;
        require_range(power, -greatest_power_node, greatest_power_node, method_, triangle, "16 times a cosine", advice);
        nodes.log.push_back(power);
        nodes.material.power_channels = 1;
        nodes.table = tables_->get(full_scale * material.specular * brightest_component(light), material.shininess);
    }
    return nodes;
}

TriangleSetup LitSetups::setup(const LitNodes& nodes, const ScreenTriangle& triangle, const TriangleWalk& walk) {
    const PixelIndex origin = centre_pixel(walk);
    const auto& v = triangle.vertices;
    TriangleSetup setup;
    setup.walk = walk;
    const std::array<Polynomial, 3> colour = fit_colour(nodes.diffuse, triangle, origin);
    for (std::size_t c = 0; c < colour.size(); ++c) {
        setup.colour[c] = channel_words(colour[c], walk, hls::colour_fraction_bits, false);
    }
    for (const std::array<double, 6>& values : nodes.log) {
        const Polynomial polynomial = fit_quadratic({v[0].point, v[1].point, v[2].point}, values, origin);
        setup.log.push_back(channel_words(polynomial, walk, hls::log_fraction_bits, false));
    }
    setup.depth = depth_words(triangle, walk);
    setup.material = nodes.material;
    setup.table = nodes.table;
    return setup;
}

}  // namespace sheen
