// SPDX-License-Identifier: MIT
/// \file
/// The comparison's figures agree with what they are defined as, and its contact sheet shows every picture whole.
#include "sheen/compare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sheen/error.hpp"
#include "sheen/mesh.hpp"
#include "sheen/picture_metrics.hpp"
#include "sheen/reference.hpp"

namespace {

using sheen::Comparison;
using sheen::ComparisonRequest;
using sheen::ComparisonRow;
using sheen::Image;
using sheen::Method;

sheen::Scene sphere(int width, int height) {
    sheen::Scene scene;
    scene.mesh = sheen::make_builtin_mesh("builtin:sphere-168");
    scene.rotate_degrees = {23.0, 0.0, 11.0};
    scene.lights = sheen::measured_lights().front();
    scene.width = width;
    scene.height = height;
    return scene;
}

const ComparisonRow& row_of(const Comparison& comparison, Method method, const std::string& device) {
    const auto found = std::find_if(comparison.rows.begin(), comparison.rows.end(), [&](const ComparisonRow& row) {
        return row.method == method && row.device == device;
    });
    if (found == comparison.rows.end()) {
        throw sheen::Error("no row " + to_string(method) + " on " + device);
    }
    return *found;
}

/// True when `part` stands somewhere in `whole`, pixel by pixel.
bool contains(const Image& whole, const Image& part) {
    const std::size_t bytes = 3 * static_cast<std::size_t>(part.width);
    for (int top = 0; top + part.height <= whole.height; ++top) {
        for (int left = 0; left + part.width <= whole.width; ++left) {
            int y = 0;
            while (y < part.height && std::equal(part.at(0, y), part.at(0, y) + bytes, whole.at(left, top + y))) {
                ++y;
            }
            if (y == part.height) {
                return true;
            }
        }
    }
    return false;
}

TEST(compare, measured_lights_are_four_runs_of_one_unit_light) {
    const auto runs = sheen::measured_lights();
    ASSERT_EQ(runs.size(), 4U);
    for (const auto& lights : runs) {
        ASSERT_EQ(lights.size(), 1U);
        EXPECT_NEAR(glm::length(lights.front().vector), 1.0, 1e-15);
        EXPECT_EQ(lights.front().colour, glm::dvec3(1.0));
    }
}

TEST(compare, rows_are_every_method_on_every_device_and_impossible_pairs_say_why) {
    const ComparisonRequest request{sheen::all_methods(), {"reference", "hls"}, {}};
    const Comparison comparison = sheen::compare(sphere(60, 50), request);
    ASSERT_EQ(comparison.rows.size(), 2 * sheen::all_methods().size());
    for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
        const ComparisonRow& row = comparison.rows[i];
        EXPECT_EQ(row.method, sheen::all_methods()[i / 2]);
        EXPECT_EQ(row.device, i % 2 == 0 ? "reference" : "hls");
        EXPECT_EQ(row.reason.empty(), row.device == "reference" || sheen::has_packets(row.method)) << row.reason;
    }
}

TEST(compare, phong_on_the_reference_is_identical_to_itself) {
    const Comparison comparison = sheen::compare(sphere(40, 30), {{Method::phong}, {"reference"}, {}});
    const ComparisonRow& row = row_of(comparison, Method::phong, "reference");
    EXPECT_TRUE(std::isinf(row.psnr)) << row.psnr;
    EXPECT_EQ(row.max_error, 0.0);
    EXPECT_EQ(*std::max_element(row.error_map.rgb.begin(), row.error_map.rgb.end()), 0);
    EXPECT_EQ(row.picture.rgb, comparison.reference.rgb);
}

TEST(compare, hls_is_bit_exact_with_itself_and_the_reference_has_no_words_to_compare) {
    const Comparison comparison =
        sheen::compare(sphere(60, 50), {{Method::gouraud, Method::quadratic}, {"reference", "hls"}, {}});
    for (const Method method : {Method::gouraud, Method::quadratic}) {
        const ComparisonRow& reference = row_of(comparison, method, "reference");
        const ComparisonRow& hls = row_of(comparison, method, "hls");
        EXPECT_FALSE(reference.bit_exact.has_value());
        EXPECT_EQ(hls.bit_exact, true);
        EXPECT_EQ(hls.pixels, reference.pixels);
        EXPECT_EQ(hls.triangles, reference.triangles);
        EXPECT_NEAR(hls.psnr, reference.psnr, 0.5) << to_string(method);
    }
}

TEST(compare, several_runs_average_the_square_error_keep_the_largest_and_show_the_first) {
    const auto lights = sheen::measured_lights();
    const Comparison all = sheen::compare(sphere(50, 40), {{Method::gouraud}, {"reference"}, lights});
    double mean_square = 0.0;
    double greatest = 0.0;
    for (const auto& run : lights) {
        sheen::Scene scene = sphere(50, 40);
        scene.lights = run;
        const Comparison one = sheen::compare(scene, {{Method::gouraud}, {"reference"}, {}});
        const ComparisonRow& row = one.rows.front();
        mean_square += 255.0 * 255.0 * std::pow(10.0, -row.psnr / 10.0) / static_cast<double>(lights.size());
        greatest = std::max(greatest, row.max_error);
        const bool is_first = &run == &lights.front();
        EXPECT_EQ(row.picture.rgb == all.rows.front().picture.rgb, is_first);
        EXPECT_EQ(row.error_map.rgb == all.rows.front().error_map.rgb, is_first);
        EXPECT_EQ(one.reference.rgb == all.reference.rgb, is_first);
    }
    EXPECT_EQ(all.runs, 4U);
    EXPECT_NEAR(all.rows.front().psnr, 10.0 * std::log10(255.0 * 255.0 / mean_square), 1e-9);
    EXPECT_EQ(all.rows.front().max_error, greatest);
}

TEST(compare, figures_and_error_map_are_those_of_the_definition) {
    const sheen::Scene scene = sphere(64, 48);
    const auto triangles = sheen::project(scene);
    const auto phong = sheen::render_reference(Method::phong, scene, triangles);
    const auto gouraud = sheen::render_reference(Method::gouraud, scene, triangles);
    double sum = 0.0;
    double greatest = 0.0;
    std::size_t counted = 0;
    for (std::size_t i = 0; i < phong.colour.size(); ++i) {
        const glm::dvec3 error = gouraud.colour[i] - phong.colour[i];
        if (phong.covered[i]) {
            sum += glm::dot(error, error);
            greatest = std::max({greatest, std::abs(error.x), std::abs(error.y), std::abs(error.z)});
            ++counted;
        }
    }
    const double mean_square = sum / (3.0 * static_cast<double>(counted));

    const ComparisonRow row = sheen::compare(scene, {{Method::gouraud}, {"reference"}, {}}).rows.front();
    EXPECT_NEAR(row.psnr, 10.0 * std::log10(255.0 * 255.0 / mean_square), 1e-9);
    EXPECT_DOUBLE_EQ(row.max_error, greatest);
    for (std::size_t i = 0; i < phong.colour.size(); ++i) {
        const double expected = std::min(255.0, 16.0 * std::abs(gouraud.colour[i].x - phong.colour[i].x));
        ASSERT_NEAR(row.error_map.rgb[3 * i], expected, 0.5) << "pixel " << i;
    }
}

TEST(compare, quadratic_is_nearer_to_phong_than_gouraud_and_gouraud_than_flat) {
    const Comparison comparison =
        sheen::compare(sphere(160, 120), {sheen::all_methods(), {"reference"}, sheen::measured_lights()});
    EXPECT_GT(row_of(comparison, Method::gouraud, "reference").psnr,
              row_of(comparison, Method::flat, "reference").psnr);
    EXPECT_GT(row_of(comparison, Method::quadratic, "reference").psnr,
              row_of(comparison, Method::gouraud, "reference").psnr + 6.0);
}

TEST(compare, progress_is_told_once_before_each_drawing_each_cost_and_each_pictures_metrics) {
    for (const bool metrics : {false, true}) {
        const std::size_t total_steps = metrics ? 8 + 2 + 8 : 8 + 2;
        std::size_t next = 0;
        ComparisonRequest request{{Method::flat, Method::gouraud}, {"reference"}, sheen::measured_lights()};
        request.picture_metrics = metrics;
        (void)sheen::compare(sphere(20, 20), request,
                             [&](std::size_t done, std::size_t total, const std::string& what) {
                                 const char* word = next < 8 ? "reference" : next < 10 ? "cost" : "SSIM";
                                 EXPECT_EQ(done, next++);
                                 EXPECT_EQ(total, total_steps);
                                 EXPECT_NE(what.find(word), std::string::npos) << what;
                             });
        EXPECT_EQ(next, total_steps);
    }
}

TEST(compare, picture_metrics_are_of_the_8_bit_pictures_averaged_over_the_runs) {
    ComparisonRequest request{{Method::gouraud, Method::quadratic, Method::phong}, {"reference", "hls"}, {}};
    request.picture_metrics = true;
    request.runs = sheen::measured_lights();
    const Comparison all = sheen::compare(sphere(50, 40), request);
    ASSERT_EQ(all.metrics_unavailable, "") << "`make setup` installs what is missing";

    sheen::PictureMeter meter;  // the same pictures once more: those of a comparison a run
    for (const auto& lights : request.runs) {
        sheen::Scene scene = sphere(50, 40);
        scene.lights = lights;
        const auto phong = sheen::render_reference(Method::phong, scene, sheen::project(scene));
        const Comparison one = sheen::compare(scene, {request.methods, request.devices, {}});
        meter.expect(phong.image(), phong.covered);
        for (const ComparisonRow& row : one.rows) {
            if (row.reason.empty()) meter.add(row.picture);
        }
    }
    const auto metrics = meter.measure().pairs;
    ASSERT_EQ(metrics.size(), 4U * 5U);
    for (std::size_t r = 0; r < 5; ++r) {
        double ssim = 0.0;
        double flip = 0.0;
        for (std::size_t run = 0; run < 4; ++run) {
            ssim += metrics[5 * run + r].ssim.value() / 4.0;
            flip += metrics[5 * run + r].flip.value() / 4.0;
        }
        EXPECT_NEAR(all.rows[r].ssim.value(), ssim, 1e-12);
        EXPECT_NEAR(all.rows[r].flip.value(), flip, 1e-12);
    }
    const ComparisonRow& phong = row_of(all, Method::phong, "reference");
    EXPECT_NEAR(phong.ssim.value(), 1.0, 1e-12);
    EXPECT_EQ(phong.flip.value(), 0.0);
    EXPECT_FALSE(row_of(all, Method::phong, "hls").ssim.has_value()) << "it is not drawn";
    for (const char* device : {"reference", "hls"}) {
        EXPECT_GT(row_of(all, Method::quadratic, device).ssim, row_of(all, Method::gouraud, device).ssim);
        EXPECT_LT(row_of(all, Method::quadratic, device).flip, row_of(all, Method::gouraud, device).flip);
    }
}

TEST(compare, picture_metrics_are_left_out_unless_asked_for) {
    const Comparison comparison = sheen::compare(sphere(20, 20), {{Method::gouraud}, {"reference"}, {}});
    EXPECT_FALSE(comparison.rows.front().ssim.has_value());
    EXPECT_FALSE(comparison.rows.front().flip.has_value());
    EXPECT_EQ(comparison.metrics_unavailable, "");
}

TEST(compare, cost_is_the_methods_on_the_scene_whatever_the_device) {
    const sheen::Scene scene = sphere(60, 50);
    const Comparison comparison =
        sheen::compare(scene, {{Method::gouraud, Method::quadratic, Method::phong}, {"reference", "hls"}, {}});
    for (const ComparisonRow& row : comparison.rows) {
        SCOPED_TRACE(to_string(row.method) + " on " + row.device);
        ASSERT_EQ(row.cost.has_value(), row.reason.empty());
        if (!row.cost) continue;
        const sheen::MethodCost cost = sheen::method_cost(row.method, scene, sheen::project(scene));
        for (std::size_t part = 0; part < 4; ++part) {
            EXPECT_EQ(row.cost->named()[part].second.named(), cost.named()[part].second.named());
        }
    }
    const auto pixel = [&](Method method) { return row_of(comparison, method, "reference").cost.value().pixel; };
    EXPECT_EQ(pixel(Method::gouraud).additions, 3.0);
    EXPECT_EQ(pixel(Method::quadratic).additions, 6.0);
    EXPECT_EQ(pixel(Method::phong).roots, 1.0);
}

TEST(compare, a_scene_that_a_method_cant_express_is_a_row_with_a_reason_and_no_failure) {
    sheen::Scene scene = sphere(30, 30);
    scene.field_of_view = 40.0;
    const Comparison comparison =
        sheen::compare(scene, {{Method::taylor, Method::gouraud}, {"reference"}, sheen::measured_lights()});
    const ComparisonRow& taylor = row_of(comparison, Method::taylor, "reference");
    EXPECT_NE(taylor.reason, "");
    EXPECT_FALSE(taylor.cost.has_value());
    EXPECT_EQ(row_of(comparison, Method::gouraud, "reference").reason, "");
}

TEST(compare, an_unknown_device_is_a_usage_error_that_names_it) {
    try {
        (void)sheen::compare(sphere(8, 8), {{Method::flat}, {"reference", "abacus"}, {}});
        FAIL() << "abacus was accepted";
    } catch (const sheen::UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("abacus"), std::string::npos) << error.what();
    }
}

TEST(contact_sheet, shows_every_picture_and_error_map_whole) {
    const Comparison comparison =
        sheen::compare(sphere(40, 30), {{Method::flat, Method::quadratic, Method::phong}, {"reference"}, {}});
    const Image sheet = sheen::contact_sheet(comparison);
    EXPECT_TRUE(contains(sheet, comparison.reference));
    for (const Method method : {Method::flat, Method::quadratic}) {
        const ComparisonRow& row = row_of(comparison, method, "reference");
        EXPECT_TRUE(contains(sheet, row.picture)) << to_string(method);
        EXPECT_TRUE(contains(sheet, row.error_map)) << to_string(method);
    }
}

TEST(contact_sheet, reduces_large_pictures_by_the_mean_and_error_maps_by_the_maximum) {
    constexpr int side = 1030;  // three pixels to one, the last column and row of blocks partly filled
    Comparison comparison;
    comparison.reference = Image(side, side);
    ComparisonRow row;
    row.method = Method::flat;
    row.device = "reference";
    row.picture = Image(side, side);
    row.error_map = Image(side, side);
    std::fill_n(row.picture.at(side - 1, 0), 3, 200);
    std::fill_n(row.error_map.at(700, 500), 3, 99);
    comparison.rows.push_back(row);

    const Image sheet = sheen::contact_sheet(comparison);
    const auto count = [&sheet](std::uint8_t level) { return std::count(sheet.rgb.begin(), sheet.rgb.end(), level); };
    EXPECT_LT(sheet.width, 2 * 512);
    EXPECT_EQ(count(99), 3) << "the only error must survive";
    EXPECT_EQ(count(67), 3) << "200 over a block of one by three pixels";
}

TEST(contact_sheet, labels_differ_where_the_figures_do) {
    Comparison comparison = sheen::compare(sphere(40, 30), {{Method::flat}, {"reference"}, {}});
    const Image before = sheen::contact_sheet(comparison);
    comparison.rows.front().psnr += 1.0;
    const Image after = sheen::contact_sheet(comparison);
    ASSERT_EQ(before.width, after.width);
    EXPECT_FALSE(before.rgb == after.rgb);
}

}  // namespace
