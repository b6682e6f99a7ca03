// SPDX-License-Identifier: MIT
/// \file
/// Runs every pair of method and device, and measures each against Phong per pixel.
#include "sheen/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <memory>

#include "sheen/device.hpp"
#include "sheen/error.hpp"
#include "sheen/metrics.hpp"
#include "sheen/reference.hpp"
#include "sheen/render.hpp"

namespace sheen {
namespace {

/// The device whose words are the others' model.
constexpr const char* model_name = "hls";

/// error_map_gain times the absolute error, `error(pixel, component)` in 8-bit steps.
template <typename Error>
Image make_error_map(int width, int height, Error error) {
    Image map(width, height);
    for (std::size_t i = 0; i < map.rgb.size(); ++i) {
        const double scaled = error_map_gain * std::abs(error(i / 3, i % 3));
        map.rgb[i] = static_cast<std::uint8_t>(std::lround(std::min(scaled, 255.0)));
    }
    return map;
}

Image error_map(const ReferenceImage& expected, const ReferenceImage& actual) {
    return make_error_map(actual.width, actual.height, [&](std::size_t pixel, std::size_t component) {
        const auto c = static_cast<int>(component);
        return actual.colour[pixel][c] - expected.colour[pixel][c];
    });
}

Image error_map(const Image& expected, const Image& actual) {
    return make_error_map(actual.width, actual.height, [&](std::size_t pixel, std::size_t component) {
        const std::size_t i = 3 * pixel + component;
        return static_cast<double>(actual.rgb[i]) - static_cast<double>(expected.rgb[i]);
    });
}

/// A row and the measurement behind its figures.
struct Measurement {
    ComparisonRow row;
    ErrorMeter meter;
};

/// What every drawing of one run is measured against.
struct Run {
    const Scene& scene;
    const std::vector<ScreenTriangle>& triangles;
    ReferenceImage phong;
    Image phong_image;
    bool first;
};

using Devices = std::map<std::string, std::unique_ptr<Device>>;

void measure_reference(const Run& run, Measurement& measurement) {
    ComparisonRow& row = measurement.row;
    const ReferenceImage drawn = render_reference(row.method, run.scene, run.triangles);
    measurement.meter.add(run.phong.colour, drawn.colour, run.phong.covered);
    if (run.first) {
        row.triangles = drawn.triangles;
        row.pixels = drawn.pixels;
        row.picture = drawn.image();
        row.error_map = error_map(run.phong, drawn);
    }
}

void measure_device(const Run& run, const std::vector<std::uint32_t>& packets, const std::vector<std::uint64_t>& model,
                    Device& device, Measurement& measurement) {
    ComparisonRow& row = measurement.row;
    const Drawing drawn = draw(device, packets, run.scene.width, run.scene.height);
    measurement.meter.add(run.phong_image, drawn.framebuffer.image(), run.phong.covered);
    row.bit_exact = row.bit_exact.value_or(true) && drawn.result.words == model;
    if (run.first) {
        const Statistics statistics = statistics_of(packets, drawn.result);
        row.triangles = statistics.triangles;
        row.pixels = statistics.pixels;
        row.cycles = statistics.cycles;
        row.picture = drawn.framebuffer.image();
        row.error_map = error_map(run.phong_image, drawn.framebuffer.image());
    }
}

/// Measures the rows of one method, devices in the order of `rows`.
class MethodRun {
 public:
    MethodRun(const Run& run, Method method, Devices& devices) : run_(run), method_(method), devices_(devices) {}

    void measure(Measurement& measurement) {
        if (measurement.row.device == reference_name) {
            measure_reference(run_, measurement);
        } else {
            prepare();
            measure_device(run_, packets_, model_, *devices_.at(measurement.row.device), measurement);
        }
    }

 private:
    /// Packets and the model's words, once for all devices.
    void prepare() {
        if (packets_.empty()) {
            packets_ = picture_packets(make_setups(method_, run_.scene, run_.triangles));
            model_ = devices_.at(model_name)->run(packets_).words;
        }
    }

    const Run& run_;
    Method method_;
    Devices& devices_;
    std::vector<std::uint32_t> packets_;
    std::vector<std::uint64_t> model_;
};

std::vector<Measurement> make_rows(const ComparisonRequest& request) {
    std::vector<Measurement> rows;
    for (const Method method : request.methods) {
        for (const std::string& device : request.devices) {
            Measurement measurement;
            measurement.row.method = method;
            measurement.row.device = device;
            measurement.row.reason = why_impossible(method, device).value_or("");
            rows.push_back(std::move(measurement));
        }
    }
    return rows;
}

/// The devices that the request names, and the model that they are held against.
Devices make_devices(const ComparisonRequest& request) {
    Devices devices;
    for (const std::string& name : request.devices) {
        if (name != reference_name) {
            devices.emplace(name, make_device(name));
        }
    }
    if (!devices.empty() && devices.count(model_name) == 0) {
        devices.emplace(model_name, make_device(model_name));
    }
    return devices;
}

}  // namespace

std::vector<std::string> drawing_names() {
    std::vector<std::string> names = device_names();
    names.insert(names.begin(), reference_name);
    return names;
}

void require_drawing_name(const std::string& name) {
    const std::vector<std::string> names = drawing_names();
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        throw UsageError(fmt::format("unknown device '{}': give one of {}", name, fmt::join(names, ", ")));
    }
}

std::optional<std::string> why_impossible(Method method, const std::string& device) {
    if (device == reference_name || has_packets(method)) {
        return std::nullopt;
    }
    return fmt::format("{} has no packets: only the reference draws it", to_string(method));
}

std::optional<double> ComparisonRow::pixels_per_clock() const {
    return Statistics{pixels, triangles, cycles, std::nullopt}.pixels_per_clock();
}

Comparison compare(const Scene& scene, const ComparisonRequest& request, const ComparisonProgress& progress) {
    std::for_each(request.devices.begin(), request.devices.end(), require_drawing_name);
    Devices devices = make_devices(request);
    std::vector<Measurement> measurements = make_rows(request);
    const std::vector<ScreenTriangle> triangles = project(scene);
    const std::vector<std::vector<Light>> runs =
        request.runs.empty() ? std::vector<std::vector<Light>>{scene.lights} : request.runs;

    Comparison comparison;
    comparison.runs = runs.size();
    Scene lit = scene;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        lit.lights = runs[i];
        ReferenceImage phong = render_reference(Method::phong, lit, triangles);
        Image phong_image = phong.image();
        const Run run{lit, triangles, std::move(phong), std::move(phong_image), i == 0};
        if (run.first) {
            comparison.reference = run.phong_image;
        }
        std::optional<MethodRun> method_run;
        for (std::size_t r = 0; r < measurements.size(); ++r) {
            Measurement& measurement = measurements[r];
            const ComparisonRow& row = measurement.row;
            if (r % request.devices.size() == 0) {
                method_run.emplace(run, row.method, devices);
            }
            if (progress) {
                progress(i * measurements.size() + r, runs.size() * measurements.size(),
                         fmt::format("{} on {}", to_string(row.method), row.device));
            }
            if (row.reason.empty()) {
                method_run->measure(measurement);
            }
        }
    }
    for (Measurement& measurement : measurements) {
        measurement.row.psnr = measurement.meter.psnr();
        measurement.row.max_error = measurement.meter.max_error();
        comparison.rows.push_back(std::move(measurement.row));
    }
    return comparison;
}

std::vector<std::vector<Light>> measured_lights() {
    std::vector<std::vector<Light>> runs;
    for (const glm::dvec3& direction : {glm::dvec3(-0.4, 0.5, 0.77), glm::dvec3(0.6, 0.3, 0.74),
                                        glm::dvec3(0.2, -0.55, 0.8), glm::dvec3(0.85, 0.45, 0.15)}) {
        Light light;
        light.vector = glm::normalize(direction);
        runs.push_back({light});
    }
    return runs;
}

}  // namespace sheen
