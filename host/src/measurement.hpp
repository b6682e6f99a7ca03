// SPDX-License-Identifier: MIT
/// \file
/// One row of a comparison while it is measured.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sheen/compare.hpp"
#include "sheen/device.hpp"
#include "sheen/metrics.hpp"
#include "sheen/picture_metrics.hpp"
#include "sheen/reference.hpp"

namespace sheen {

/// The device whose words are the others' model.
inline constexpr const char* model_name = "hls";

/// A row and the measurement behind its figures.
struct Measurement {
    ComparisonRow row;
    ErrorMeter meter;
    std::vector<std::size_t> pairs;  ///< of the PictureMeter, one a run
};

/// What every drawing of one run is measured against.
struct Run {
    const Scene& scene;
    const std::vector<ScreenTriangle>& triangles;
    ReferenceImage phong;
    Image phong_image;
    bool first;
    const MethodOptions& options;
    const std::optional<Subdivision>& subdivision;
    PictureMeter* pictures;  ///< none where no picture metrics are asked for
};

/// A device, and what it says of itself.
struct ComparedDevice {
    std::unique_ptr<Device> device;
    Capabilities core;
};
using Devices = std::map<std::string, ComparedDevice>;

/// Measures the rows of one method in one run.
class MethodRun {
 public:
    /// `devices` holds those of the rows and the model's, unless all rows are the reference's.
    MethodRun(const Run& run, Method method, Devices& devices) : run_(run), method_(method), devices_(devices) {}
    /// Draws and adds to the measurement's figures. \throws Error when the device fails, or lacks what the method
    /// needs.
    void measure(Measurement& measurement);

 private:
    void measure_reference(Measurement& measurement);
    void measure_device(Measurement& measurement);
    /// The run's triangles, in pieces where that is asked for.
    const std::vector<ScreenTriangle>& triangles();
    /// Setups, packets and the model's words, once for all devices.
    void prepare();

    const Run& run_;
    Method method_;
    Devices& devices_;
    std::optional<std::vector<ScreenTriangle>> pieces_;
    std::vector<TriangleSetup> setups_;
    std::vector<std::uint32_t> packets_;
    std::vector<std::uint64_t> model_;
};

}  // namespace sheen
