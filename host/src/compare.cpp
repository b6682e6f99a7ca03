// SPDX-License-Identifier: MIT
/// \file
/// Runs every pair of method and device, and measures each against Phong per pixel.
#include "sheen/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "measurement.hpp"
#include "sheen/error.hpp"
#include "sheen/lit_setup.hpp"
#include "sheen/render.hpp"
#include "sheen/shader.hpp"

namespace sheen {
namespace {

using Runs = std::vector<std::vector<Light>>;

/// why(scene) under one of the runs' lights; nothing where it says nothing under all.
template <typename Why>
std::optional<std::string> under_any(const Runs& runs, Scene scene, Why why) {
    for (const std::vector<Light>& lights : runs) {
        scene.lights = lights;
        if (std::optional<std::string> reason = why(scene)) return reason;
    }
    return std::nullopt;
}

std::vector<Measurement> make_rows(const ComparisonRequest& request, const Scene& scene, const Runs& runs) {
    std::vector<Measurement> rows;
    for (const Method method : request.methods) {
        std::optional<std::string> inexpressible =
            under_any(runs, scene, [&](const Scene& lit) { return why_inexpressible(method, lit); });
        const std::optional<std::string> only_reference =
            under_any(runs, scene, [&](const Scene& lit) { return why_not_on_devices(method, request.options, lit); });
        if (!inexpressible && request.subdivision && method != Method::phong) inexpressible = why_indivisible(method);
        for (const std::string& device : request.devices) {
            std::optional<std::string> reason = inexpressible ? inexpressible : why_impossible(method, device);
            if (!reason && device != reference_name) reason = only_reference;
            Measurement measurement;
            measurement.row.method = method;
            measurement.row.device = device;
            measurement.row.reason = reason.value_or("");
            rows.push_back(std::move(measurement));
        }
    }
    return rows;
}

/// The devices that the request names, and the model that they are held against.
Devices make_devices(const ComparisonRequest& request) {
    Devices devices;
    const auto add = [&devices](const std::string& name) {
        if (devices.count(name) != 0) return;
        std::unique_ptr<Device> device = make_device(name);
        const Capabilities core = query_capabilities(*device);
        devices.emplace(name, ComparedDevice{std::move(device), core});
    };
    for (const std::string& name : request.devices) {
        if (name != reference_name) add(name);
    }
    if (!devices.empty()) add(model_name);
    return devices;
}

/// Tells the steps of a comparison one by one.
class Steps {
 public:
    Steps(const ComparisonProgress& progress, std::size_t runs, const std::vector<Measurement>& rows,
          const ComparisonRequest& request)
        : progress_(progress), total_(request.methods.size()) {
        for (const Measurement& measurement : rows) {
            if (measurement.row.reason.empty()) total_ += runs * (request.picture_metrics ? 2 : 1);
        }
    }
    void next(const std::string& what) {
        if (progress_) progress_(done_, total_, what);
        ++done_;
    }

 private:
    const ComparisonProgress& progress_;
    std::size_t total_;
    std::size_t done_ = 0;
};

/// One run of all rows that can be drawn.
void draw_all(const Run& run, std::size_t devices_per_method, Devices& devices, std::vector<Measurement>& measurements,
              Steps& steps) {
    std::optional<MethodRun> method_run;
    for (std::size_t r = 0; r < measurements.size(); ++r) {
        const ComparisonRow& row = measurements[r].row;
        if (r % devices_per_method == 0) method_run.emplace(run, row.method, devices);
        if (!row.reason.empty()) continue;
        steps.next(fmt::format("{} on {}", to_string(row.method), row.device));
        method_run->measure(measurements[r]);
    }
}

/// Of the pieces where triangles are divided; the division itself is not counted.
void add_costs(const Scene& scene, const std::vector<ScreenTriangle>& triangles, const ComparisonRequest& request,
               std::vector<Measurement>& measurements, Steps& steps) {
    for (const Method method : request.methods) {
        steps.next(fmt::format("cost of {}", to_string(method)));
        std::optional<MethodCost> cost;
        for (Measurement& measurement : measurements) {
            ComparisonRow& row = measurement.row;
            if (row.method != method || !row.reason.empty()) continue;
            if (!cost) {
                const bool whole = !request.subdivision || method == Method::phong;
                cost = method_cost(
                    method, scene,
                    whole ? triangles : subdivide(method, request.options, scene, triangles, *request.subdivision),
                    request.options);
            }
            row.cost = cost;
        }
    }
}

/// The mean over a row's runs; nothing where one of them has none.
std::optional<double> mean_of(const std::vector<std::size_t>& pairs, const std::vector<PictureMetrics>& metrics,
                              std::optional<double> PictureMetrics::*metric) {
    double sum = 0.0;
    for (const std::size_t pair : pairs) {
        const std::optional<double>& value = metrics[pair].*metric;
        if (!value) return std::nullopt;
        sum += *value;
    }
    return pairs.empty() ? std::nullopt : std::optional(sum / static_cast<double>(pairs.size()));
}

/// Says why there are none, or nothing.
std::string add_picture_metrics(const PictureMeter& pictures, std::vector<Measurement>& measurements, Steps& steps) {
    const PictureMeter::Result result = pictures.measure(
        [&steps](std::size_t done, std::size_t total) { steps.next(fmt::format("SSIM, FLIP {}/{}", done, total)); });
    if (result.pairs.empty()) return result.unavailable;
    for (Measurement& measurement : measurements) {
        measurement.row.ssim = mean_of(measurement.pairs, result.pairs, &PictureMetrics::ssim);
        measurement.row.flip = mean_of(measurement.pairs, result.pairs, &PictureMetrics::flip);
    }
    return {};
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
    const Uncovered uncovered = request.subdivision ? Uncovered::keep : Uncovered::drop;
    const std::vector<ScreenTriangle> triangles = project(scene, uncovered);
    const Runs runs = request.runs.empty() ? Runs{scene.lights} : request.runs;
    std::vector<Measurement> measurements = make_rows(request, scene, runs);
    std::optional<PictureMeter> pictures;
    if (request.picture_metrics) pictures.emplace();
    Steps steps(progress, runs.size(), measurements, request);

    Comparison comparison;
    comparison.runs = runs.size();
    Scene lit = scene;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        lit.lights = runs[i];
        ReferenceImage phong = render_reference(Method::phong, lit, triangles);
        Image phong_image = phong.image();
        const Run run{lit,    triangles,       std::move(phong),    std::move(phong_image),
                      i == 0, request.options, request.subdivision, pictures ? &*pictures : nullptr};
        if (pictures) pictures->expect(run.phong_image, run.phong.covered);
        if (run.first) comparison.reference = run.phong_image;
        draw_all(run, request.devices.size(), devices, measurements, steps);
    }
    lit.lights = runs.front();
    add_costs(lit, triangles, request, measurements, steps);
    if (pictures) comparison.metrics_unavailable = add_picture_metrics(*pictures, measurements, steps);
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
