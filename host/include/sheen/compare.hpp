// SPDX-License-Identifier: MIT
/// \file
/// Methods and devices side by side, against Phong per pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sheen/cost.hpp"
#include "sheen/image.hpp"
#include "sheen/lighting.hpp"
#include "sheen/method.hpp"
#include "sheen/scene.hpp"
#include "sheen/subdivide.hpp"

namespace sheen {

/// The word for double precision on the host, where a device's name is asked for.
inline constexpr const char* reference_name = "reference";

/// `reference`, then device_names().
std::vector<std::string> drawing_names();

/// \throws UsageError unless `name` is one of drawing_names().
void require_drawing_name(const std::string& name);

/// Why `device` can't draw `method`, whatever the scene; nothing where it can.
std::optional<std::string> why_impossible(Method method, const std::string& device);

/// What to compare.
struct ComparisonRequest {
    std::vector<Method> methods;
    std::vector<std::string> devices;  ///< of drawing_names()
    /// The lights of each run; the figures are over all runs. Empty: one run with the scene's lights.
    std::vector<std::vector<Light>> runs;
    MethodOptions options = {};                   ///< of all methods
    bool picture_metrics = false;                 ///< SSIM and FLIP too, which take seconds
    std::optional<Subdivision> subdivision = {};  ///< of every method's triangles but those of `phong`
};

/// One method on one device, against the reference `phong` over the pixels of the mesh (those that both cover:
/// subdivision moves silhouettes by its snapping): double against double for the reference, otherwise 8-bit against
/// `phong` rounded to 8 bits. SSIM and FLIP are of 8-bit pictures in any case.
struct ComparisonRow {
    Method method = Method::phong;
    std::string device;
    std::string reason;  ///< why the pair can't be drawn; the rest is then empty
    double psnr =
        0.0;  ///< dB, peak 255, of the square error averaged over components, pixels and runs; may be infinite
    double max_error = 0.0;               ///< 8-bit steps, over all runs
    std::optional<double> ssim;           ///< PictureMetrics, averaged over the runs
    std::optional<double> flip;           ///< PictureMetrics, averaged over the runs
    std::optional<MethodCost> cost;       ///< of the method, on any device; of the first run
    std::optional<bool> bit_exact;        ///< the words equal those of `hls` in every run; nothing for the reference
    std::size_t triangles = 0;            ///< of the first run
    std::size_t pixels = 0;               ///< of the first run, hidden ones included
    std::optional<std::uint64_t> cycles;  ///< of the first run; simulators only
    Image picture;                        ///< of the first run
    Image error_map;                      ///< of the first run: absolute error times error_map_gain, saturated
    /// pixels / cycles; nothing where cycles are not counted.
    [[nodiscard]] std::optional<double> pixels_per_clock() const;
};

/// An error of 16 steps is full brightness.
inline constexpr int error_map_gain = 16;

struct Comparison {
    Image reference;                  ///< Phong per pixel, first run
    std::vector<ComparisonRow> rows;  ///< devices vary fastest
    std::size_t runs = 1;             ///< how many went into the figures
    std::string metrics_unavailable;  ///< why SSIM and FLIP are missing though they were asked for
};

/// Told before each drawing, each method's cost, and each picture's metrics: how many steps are done, how many there
/// will be, and which comes now.
using ComparisonProgress = std::function<void(std::size_t done, std::size_t total, const std::string& what)>;

/// Draws and measures every pair of method and device; one that can't be drawn, or a scene that the method can't
/// express, is a row with a reason. \throws Error when a device fails; UsageError for an unknown one.
Comparison compare(const Scene& scene, const ComparisonRequest& request, const ComparisonProgress& progress = {});

/// The four directional lights that the project's quality figures are measured with, each a run of its own: one from
/// the side, three from the front.
std::vector<std::vector<Light>> measured_lights();

/// Draws the comparison: a column per method, a picture and an error map per device, the reference `phong` first.
/// Tiles of more than 512 pixels are reduced by a whole factor: pictures by the mean, error maps by the maximum.
Image contact_sheet(const Comparison& comparison);

}  // namespace sheen
