// SPDX-License-Identifier: MIT
/// \file
/// Co-simulation of whole pictures: the kernels, the VHDL on GHDL and the VHDL on Verilator draw the same packets, and
/// every word must be the same. Each 8-bit component must lie within greatest_step() of the method in double precision.
/// Then random packet streams (streams.hpp) on every core configuration, with and without pauses.
///
/// Usage: cosim_pictures [--full]. Without --full GHDL draws each combination at 128×96 and one picture at 512×512.
/// Exit status: 0 all agree, 1 a difference or a failing device; the packets of a failing picture are left behind.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <glm/geometric.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sheen/device.hpp"
#include "sheen/error.hpp"
#include "sheen/packet.hpp"
#include "sheen/reference.hpp"
#include "sheen/render.hpp"
#include "sheen/simulator_device.hpp"
#include "streams.hpp"

namespace {

using namespace sheen;

struct Subject {
    const char* mesh;
    glm::dvec3 rotation;
    bool two_sided;
};

struct Size {
    int width;
    int height;
    bool ghdl;  ///< GHDL draws it too
};

/// What was compared on one device.
struct Tally {
    std::size_t pictures = 0;
    std::size_t words = 0;
};

/// How far, in 8-bit steps, a drawn component may lie from the rounded method in double precision. One step is
/// rounding: the device's value is off by far less. Then each of two highlights of log-quadratic may be off by half a
/// unit and half a bin of its table, 2.2 steps, and a Taylor method's by an entry of its table: 5 steps where n = 50
/// and ks = 0.4.
int greatest_step(Method method) { return !has_log_channels(method) ? 1 : method == Method::log_quadratic ? 5 : 6; }

/// Largest difference, in 8-bit steps, between drawn components and the method in double precision.
int largest_step(const Image& drawn, const ReferenceImage& reference) {
    const Image expected = reference.image();
    int largest = 0;
    for (std::size_t i = 0; i < drawn.rgb.size(); ++i) {
        largest = std::max(largest, std::abs(int{drawn.rgb[i]} - int{expected.rgb[i]}));
    }
    return largest;
}

class Cosimulation {
 public:
    /// True when all devices drew the same and the reference is near.
    bool compare(const Subject& subject, Method method, const Size& size) {
        Scene scene;
        scene.mesh = load_mesh(subject.mesh);
        scene.rotate_degrees = subject.rotation;
        scene.two_sided = subject.two_sided;
        // A device's highlights are grey, and the Taylor methods take one light there.
        const glm::dvec3 second = has_log_channels(method) ? glm::dvec3(0.4) : glm::dvec3(0.3, 0.2, 0.5);
        scene.lights = {{glm::normalize(glm::dvec3(-0.4, 0.5, 0.77)), glm::dvec3(1.0)},
                        {glm::normalize(glm::dvec3(0.85, 0.45, 0.15)), second}};
        if (method == Method::taylor || method == Method::taylor_finite) scene.lights.pop_back();
        scene.width = size.width;
        scene.height = size.height;
        const auto triangles = project(scene);
        const auto packets = picture_packets(make_setups(method, scene, triangles));
        const std::string what = fmt::format("{} {} {}x{}", subject.mesh, to_string(method), size.width, size.height);

        const Drawing kernels = draw(*hls_, packets, size.width, size.height);
        bool good = judge(what, *verilator_, packets, kernels.result.words, verilator);
        if (size.ghdl) good &= judge(what, *ghdl_, packets, kernels.result.words, ghdl);
        const int step = largest_step(kernels.framebuffer.image(), render_reference(method, scene, triangles));
        if (step > greatest_step(method)) {
            std::cerr << fmt::format("{}: {} steps from the method in double precision, {} is the bound\n", what, step,
                                     greatest_step(method));
            good = false;
        }
        fmt::print("{:<50} {:>8} words, hls = verilator{}, {} step{} from double\n", what, kernels.result.words.size(),
                   size.ghdl ? " = ghdl" : "", step, step == 1 ? "" : "s");
        std::fflush(stdout);
        return good;
    }

    /// True when a core configuration answers random packets as the kernels do.
    bool compare_stream(const char* core, int words_per_beat, const Stalls& stalls, int packet_count, Tally& tally) {
        test::Rng rng(stalls.seed);
        const auto packets = test::random_stream(rng, packet_count);
        SimulatorDevice device(core, words_per_beat, stalls);
        const std::string what = fmt::format("random packets, seed {}, pauses {} % and {} %, {} bits", stalls.seed,
                                             stalls.source_percent, stalls.sink_percent, 32 * words_per_beat);
        const auto expected = hls_->run(packets).words;
        const bool good = judge(what, device, packets, expected, tally);
        fmt::print("{:<62} {:>8} words, hls = {}\n", what, expected.size(), core);
        return good;
    }

    Tally verilator, ghdl;

 private:
    static bool judge(const std::string& what, Device& device, const std::vector<std::uint32_t>& packets,
                      const std::vector<std::uint64_t>& expected, Tally& tally) {
        const std::vector<std::uint64_t> got = device.run(packets).words;
        tally.pictures += 1;
        tally.words += got.size();
        if (got == expected) return true;
        std::size_t i = 0;
        while (i < std::min(got.size(), expected.size()) && got[i] == expected[i]) ++i;
        const std::string file = "cosim-failure.packets";
        write_packet_file(file, packets);
        std::cerr << fmt::format(
            "{}: {} differs from hls at word {}: expected {:016x}, got {:016x} ({} and {} words); packets in {}\n",
            what, device.name(), i, i < expected.size() ? expected[i] : 0, i < got.size() ? got[i] : 0, expected.size(),
            got.size(), file);
        return false;
    }

    std::unique_ptr<Device> hls_ = make_device("hls");
    std::unique_ptr<Device> verilator_ = make_device("verilator");
    std::unique_ptr<Device> ghdl_ = make_device("ghdl");
};

bool run(bool full) {
    const std::vector<Subject> subjects = {{"builtin:sphere-168", {23, 0, 11}, false},
                                           {"builtin:torus-knot", {30, 20, 0}, false},
                                           {"builtin:teapot", {20, -30, 0}, true}};
    const std::vector<Method> methods = {Method::flat,   Method::gouraud,       Method::quadratic,
                                         Method::taylor, Method::taylor_finite, Method::log_quadratic};
    Cosimulation cosimulation;
    bool good = true;
    for (const Subject& subject : subjects) {
        for (const Method method : methods) {
            good &= cosimulation.compare(subject, method, {128, 96, true});
            const bool frame = method == Method::quadratic && std::strcmp(subject.mesh, "builtin:torus-knot") == 0;
            good &= cosimulation.compare(subject, method, {512, 512, full || frame});
            if (full) good &= cosimulation.compare(subject, method, {1024, 768, true});
        }
    }
    // Any fields: a row may be 4095 pixels long.
    constexpr int many = 40;
    constexpr int few = 8;
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        const Stalls none{0, 0, seed};
        const Stalls some{25, 40, seed};
        good &= cosimulation.compare_stream("verilator", 2, none, many, cosimulation.verilator);
        good &= cosimulation.compare_stream("verilator", 2, some, many, cosimulation.verilator);
        good &= cosimulation.compare_stream("verilator-plain", 2, some, many, cosimulation.verilator);
        good &= cosimulation.compare_stream("verilator-w32", 1, some, many, cosimulation.verilator);
        good &= cosimulation.compare_stream("verilator-w128", 4, none, many, cosimulation.verilator);
        good &= cosimulation.compare_stream("verilator-w128", 4, some, many, cosimulation.verilator);
    }
    good &= cosimulation.compare_stream("ghdl", 2, {25, 40, 4}, few, cosimulation.ghdl);
    for (const auto& [name, tally] :
         {std::pair{"verilator", cosimulation.verilator}, std::pair{"ghdl", cosimulation.ghdl}}) {
        fmt::print("shading_core on {}: {} words of {} pictures and streams compared with the kernels\n", name,
                   tally.words, tally.pictures);
    }
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string option = argc > 1 ? argv[1] : "";
    if (argc > 2 || (argc == 2 && option != "--full")) {
        std::cerr << "usage: cosim_pictures [--full]\n";
        return 2;
    }
    try {
        return run(option == "--full") ? 0 : 1;
    } catch (const sheen::Error& failure) {
        std::cerr << "cosim_pictures: " << failure.what() << '\n';
        return 1;
    }
}
