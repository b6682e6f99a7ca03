// SPDX-License-Identifier: MIT
#include "measurement.hpp"

#include <fmt/format.h>

#include "error_map.hpp"
#include "sheen/error.hpp"
#include "sheen/render.hpp"

namespace sheen {
namespace {

void keep_picture(const Run& run, const Image& picture, Measurement& measurement) {
    if (run.pictures != nullptr) measurement.pairs.push_back(run.pictures->add(picture));
    if (run.first) measurement.row.picture = picture;
}

/// The pixels of both.
std::vector<bool> common(const std::vector<bool>& a, const std::vector<bool>& b) {
    std::vector<bool> both(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) both[i] = a[i] && b[i];
    return both;
}

}  // namespace

void MethodRun::measure(Measurement& measurement) {
    measurement.row.device == reference_name ? measure_reference(measurement) : measure_device(measurement);
}

void MethodRun::measure_reference(Measurement& measurement) {
    ComparisonRow& row = measurement.row;
    const ReferenceImage drawn = render_reference(method_, run_.scene, triangles(), run_.options);
    measurement.meter.add(run_.phong.colour, drawn.colour, common(run_.phong.covered, drawn.covered));
    keep_picture(run_, drawn.image(), measurement);
    if (run_.first) {
        row.triangles = drawn.triangles;
        row.pixels = drawn.pixels;
        row.error_map = error_map(run_.phong, drawn);
    }
}

void MethodRun::measure_device(Measurement& measurement) {
    prepare();
    ComparisonRow& row = measurement.row;
    const ComparedDevice& compared = devices_.at(row.device);
    if (const std::optional<std::string> reason = why_incapable(compared.core, setups_)) {
        throw Error(fmt::format("{} on {}: {}", to_string(method_), row.device, *reason));
    }
    const Drawing drawn = draw(*compared.device, packets_, run_.scene.width, run_.scene.height);
    const Image& picture = drawn.framebuffer.image();
    measurement.meter.add(run_.phong_image, picture, common(run_.phong.covered, drawn.framebuffer.covered()));
    row.bit_exact = row.bit_exact.value_or(true) && drawn.result.words == model_;
    keep_picture(run_, picture, measurement);
    if (run_.first) {
        const Statistics statistics = statistics_of(packets_, drawn.result);
        row.triangles = statistics.triangles;
        row.pixels = statistics.pixels;
        row.cycles = statistics.cycles;
        row.error_map = error_map(run_.phong_image, picture);
    }
}

const std::vector<ScreenTriangle>& MethodRun::triangles() {
    if (!run_.subdivision || method_ == Method::phong) return run_.triangles;
    if (!pieces_) pieces_ = subdivide(method_, run_.options, run_.scene, run_.triangles, *run_.subdivision);
    return *pieces_;
}

void MethodRun::prepare() {
    if (packets_.empty()) {
        setups_ = make_setups(method_, run_.scene, triangles(), run_.options);
        packets_ = picture_packets(setups_);
        model_ = devices_.at(model_name).device->run(packets_).words;
    }
}

}  // namespace sheen
