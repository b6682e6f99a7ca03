// SPDX-License-Identifier: MIT
/// \file
/// The example of a core to take away: one shaded triangle as beats of the setup stream, and the words that the kernels
/// answer, both for $readmemh.
///
/// Usage: make_ip_example WORDS_PER_BEAT DEPTH QUADRATIC FOLDER (true or false each). Writes example_beats.hex (a line
/// a beat: tlast, tkeep and tdata, in this order from the highest bit) and example_words.hex.
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "sheen/compare.hpp"
#include "sheen/device.hpp"
#include "sheen/error.hpp"
#include "sheen/framing.hpp"
#include "sheen/render.hpp"

namespace {

using namespace sheen;

/// A triangle that a light from the front gives a highlight.
Scene one_triangle() {
    Scene scene;
    scene.mesh.name = "triangle";
    scene.mesh.positions = {{-1, -0.8, 0}, {1, -0.5, 0}, {-0.2, 1, 0}};
    scene.mesh.normals = {{-0.48, -0.36, 0.8}, {0.6, 0, 0.8}, {0, 0.6, 0.8}};
    scene.mesh.triangles = {{0, 1, 2}};
    scene.lights = measured_lights().front();
    scene.width = 32;
    scene.height = 32;
    return scene;
}

void write_lines(const std::string& path, const std::string& lines) {
    std::ofstream out(path, std::ios::binary);
    out << lines;
    out.flush();
    if (!out) throw Error(fmt::format("can't write '{}'", path));
}

void run(int words_per_beat, bool depth, bool quadratic, const std::string& folder) {
    const Scene scene = one_triangle();
    auto setups = make_setups(quadratic ? Method::quadratic : Method::gouraud, scene, project(scene));
    if (!depth) {
        for (TriangleSetup& setup : setups) setup.depth.reset();
    }
    const auto packets = picture_packets(setups);
    std::string lines;
    for (const Beat& beat : frame_packets(packets, words_per_beat)) {
        // tlast and up to 16 bits of tkeep; whole digits, so that a line is their concatenation.
        lines += fmt::format("{:x}{:0{}x}", beat.last ? 1 : 0, (1U << 4 * beat.count) - 1, words_per_beat);
        for (int k = words_per_beat - 1; k >= 0; --k) {
            lines += fmt::format("{:08x}", beat.words[static_cast<std::size_t>(k)]);
        }
        lines += '\n';
    }
    write_lines(folder + "/example_beats.hex", lines);
    lines.clear();
    for (const std::uint64_t word : make_device("hls")->run(packets).words) lines += fmt::format("{:016x}\n", word);
    write_lines(folder + "/example_words.hex", lines);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::cerr << "usage: make_ip_example WORDS_PER_BEAT DEPTH QUADRATIC FOLDER\n";
        return 2;
    }
    try {
        run(std::atoi(argv[1]), std::string(argv[2]) == "true", std::string(argv[3]) == "true", argv[4]);
        return 0;
    } catch (const std::exception& failure) {
        std::cerr << "make_ip_example: " << failure.what() << '\n';
        return 1;
    }
}
