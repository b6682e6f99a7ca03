// SPDX-License-Identifier: MIT
// SSIM and FLIP through the Python program: against their definitions where those can be written down, over the mask
// alone, and what is said when the program or its packages are missing.
#include "sheen/picture_metrics.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "sheen/error.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 9091;

/// An environment variable for the duration of a test.
class Environment {
 public:
    Environment(const char* name, const std::string& value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        ::setenv(name, value.c_str(), 1);
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;
    ~Environment() { old_ ? ::setenv(name_, old_->c_str(), 1) : ::unsetenv(name_); }

 private:
    const char* name_;
    std::optional<std::string> old_;
};

/// A folder that goes with the test.
class Folder {
 public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "sheen_metrics_XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw Error("no folder " + name);
        path_ = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { std::filesystem::remove_all(path_); }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// An executable shell script.
    [[nodiscard]] std::string script(const std::string& name, const std::string& text) const {
        const std::filesystem::path file = path_ / name;
        std::ofstream(file) << "#!/bin/sh\n" << text << "\n";
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
        return file.string();
    }

 private:
    std::filesystem::path path_;
};

Image plain(int width, int height, std::array<std::uint8_t, 3> colour) {
    Image image(width, height);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = colour[i % 3];
    return image;
}

Image noise(std::mt19937& random, int width, int height) {
    Image image(width, height);
    for (std::uint8_t& byte : image.rgb) byte = static_cast<std::uint8_t>(random() % 256);
    return image;
}

std::vector<bool> whole(const Image& image) { return std::vector<bool>(image.rgb.size() / 3, true); }

PictureMeter::Result measured(const PictureMeter& meter) {
    PictureMeter::Result result = meter.measure();
    EXPECT_EQ(result.unavailable, "") << "`make setup` installs what is missing";
    return result;
}

/// One component's SSIM at a pixel at least five from the border, by the definition of Wang et al. (2004): a window of
/// 11 by 11 pixels, Gaussian weights of standard deviation 1.5.
double ssim_at(const Image& a, const Image& b, int x, int y, int component) {
    double weights = 0.0;
    std::array<double, 5> sums{};  // of a, b, a², b², ab
    for (int dy = -5; dy <= 5; ++dy) {
        for (int dx = -5; dx <= 5; ++dx) {
            const double weight = std::exp(-(dx * dx + dy * dy) / (2.0 * 1.5 * 1.5));
            const double p = a.at(x + dx, y + dy)[component];
            const double q = b.at(x + dx, y + dy)[component];
            const std::array<double, 5> terms{p, q, p * p, q * q, p * q};
            for (std::size_t k = 0; k < terms.size(); ++k) sums[k] += weight * terms[k];
            weights += weight;
        }
    }
    for (double& sum : sums) sum /= weights;
    const double c1 = std::pow(0.01 * 255.0, 2);
    const double c2 = std::pow(0.03 * 255.0, 2);
    const auto& [mean_a, mean_b, square_a, square_b, product] = sums;
    return (2.0 * mean_a * mean_b + c1) * (2.0 * (product - mean_a * mean_b) + c2) /
           ((mean_a * mean_a + mean_b * mean_b + c1) * (square_a - mean_a * mean_a + square_b - mean_b * mean_b + c2));
}

TEST(PictureMetrics, EqualPicturesHaveSsimOneAndFlipZero) {
    std::mt19937 random(seed);
    PictureMeter meter;
    const Image picture = noise(random, 40, 30);
    meter.expect(picture, whole(picture));
    EXPECT_EQ(meter.add(picture), 0U);
    const auto result = measured(meter);
    ASSERT_EQ(result.pairs.size(), 1U);
    EXPECT_NEAR(result.pairs[0].ssim.value(), 1.0, 1e-12);
    EXPECT_EQ(result.pairs[0].flip.value(), 0.0);
}

TEST(PictureMetrics, SsimIsItsDefinitionOnNoiseOverTheMask) {
    std::mt19937 random(seed);
    const Image a = noise(random, 24, 20);
    Image b = a;
    for (std::uint8_t& byte : b.rgb)
        byte = static_cast<std::uint8_t>(std::min<int>(255, byte + static_cast<int>(random() % 60)));
    std::vector<bool> mask(24 * 20, false);
    double sum = 0.0;
    for (int y = 5; y < 15; ++y) {
        for (int x = 5; x < 19; ++x) {
            if (random() % 2 == 0) continue;
            mask[static_cast<std::size_t>(y * 24 + x)] = true;
            for (int component = 0; component < 3; ++component) sum += ssim_at(a, b, x, y, component) / 3.0;
        }
    }
    PictureMeter meter;
    meter.expect(a, mask);
    meter.add(b);
    const double expected = sum / static_cast<double>(std::count(mask.begin(), mask.end(), true));
    EXPECT_NEAR(measured(meter).pairs.at(0).ssim.value(), expected, 1e-9) << "seed " << seed;
}

TEST(PictureMetrics, AConstantShiftIsWhatTheDefinitionsSay) {
    const Image grey = plain(40, 30, {100, 100, 100});
    PictureMeter meter;
    meter.expect(grey, whole(grey));
    for (const int shift : {1, 10, 40, 120}) {
        const auto level = static_cast<std::uint8_t>(100 + shift);
        meter.add(plain(40, 30, {level, level, level}));
    }
    const auto result = measured(meter);
    ASSERT_EQ(result.pairs.size(), 4U);
    double last = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        // No structure: luminance alone.
        const double b = 100.0 + std::array<double, 4>{1.0, 10.0, 40.0, 120.0}[i];
        const double c1 = std::pow(0.01 * 255.0, 2);
        EXPECT_NEAR(result.pairs[i].ssim.value(), (2.0 * 100.0 * b + c1) / (100.0 * 100.0 + b * b + c1), 1e-9);
        EXPECT_GT(result.pairs[i].flip.value(), last) << "a greater shift is seen more";
        last = result.pairs[i].flip.value();
    }
    EXPECT_LE(last, 1.0);
}

TEST(PictureMetrics, FlipOfBlackAgainstAGreyIsItsColourDifferenceOnADisplay) {
    // No edges: FLIP is its colour difference, the distance L* to the power 0.7, mapped to 0…0.95 below 0.4 of the
    // greatest distance of two colours that a display has and to 0.95…1 above: that of blue and green, whose a* and b*
    // are weighted by L*. The levels are sRGB.
    const auto lab = [](double x, double y, double z) {
        const auto f = [](double t) {
            return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
        };
        const double l = 116.0 * f(y) - 16.0;
        const double weight = 0.01 * l;
        return std::array<double, 3>{l, weight * 500.0 * (f(x) - f(y)), weight * 200.0 * (f(y) - f(z))};
    };
    // Columns of the matrix from linear sRGB to XYZ, over those of its white.
    const auto green = lab(0.3575761 / 0.9504559, 0.7151522, 0.1191920 / 1.0890578);
    const auto blue = lab(0.1804375 / 0.9504559, 0.0721750, 0.9503041 / 1.0890578);
    const double greatest =
        std::pow(std::abs(green[0] - blue[0]) + std::hypot(green[1] - blue[1], green[2] - blue[2]), 0.7);
    const double knee = 0.4 * greatest;

    const Image black = plain(30, 30, {0, 0, 0});
    const std::array<std::uint8_t, 3> levels{255, 128, 60};
    PictureMeter meter;
    meter.expect(black, whole(black));
    for (const std::uint8_t level : levels) meter.add(plain(30, 30, {level, level, level}));
    const auto result = measured(meter);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const double linear = std::pow((levels[i] / 255.0 + 0.055) / 1.055, 2.4);
        const double distance = std::pow(lab(linear, linear, linear)[0], 0.7);
        const double expected =
            distance < knee ? 0.95 * distance / knee : 0.95 + (distance - knee) / (greatest - knee) * 0.05;
        EXPECT_NEAR(result.pairs.at(i).flip.value(), expected, 1e-3) << "level " << int{levels[i]};
    }
}

TEST(PictureMetrics, PixelsFarFromTheMaskCountForNothing) {
    const Image grey = plain(120, 40, {90, 120, 60});
    Image changed = grey;
    std::fill_n(changed.at(100, 10), 30, 255);
    std::vector<bool> mask(120 * 40, false);
    for (std::size_t y = 0; y < 40; ++y) std::fill_n(mask.begin() + static_cast<std::ptrdiff_t>(120 * y), 30, true);
    PictureMeter meter;
    meter.expect(grey, mask);
    meter.add(changed);
    meter.expect(grey, whole(grey));
    meter.add(changed);
    const auto result = measured(meter);
    ASSERT_EQ(result.pairs.size(), 2U);
    EXPECT_NEAR(result.pairs[0].ssim.value(), 1.0, 1e-12);
    EXPECT_NEAR(result.pairs[0].flip.value(), 0.0, 1e-6);
    EXPECT_LT(result.pairs[1].ssim.value(), 0.999);
    EXPECT_GT(result.pairs[1].flip.value(), 0.001);
}

TEST(PictureMetrics, WhatHasNoMeaningIsNothing) {
    const Image small = plain(40, 10, {1, 2, 3});
    const Image picture = plain(40, 30, {1, 2, 3});
    PictureMeter meter;
    meter.expect(small, whole(small));
    meter.add(small);
    meter.expect(picture, std::vector<bool>(40 * 30, false));
    meter.add(picture);
    const auto result = measured(meter);
    ASSERT_EQ(result.pairs.size(), 2U);
    EXPECT_FALSE(result.pairs[0].ssim.has_value()) << "lower than SSIM's window";
    EXPECT_EQ(result.pairs[0].flip.value(), 0.0);
    EXPECT_FALSE(result.pairs[1].ssim.has_value()) << "no pixel in the mask";
    EXPECT_FALSE(result.pairs[1].flip.has_value());
    EXPECT_TRUE(PictureMeter().measure().pairs.empty());
}

TEST(PictureMetrics, ProgressIsToldBeforeEachPair) {
    const Image picture = plain(12, 12, {9, 9, 9});
    PictureMeter meter;
    meter.expect(picture, whole(picture));
    for (std::uint8_t level = 0; level < 5; ++level) meter.add(plain(12, 12, {level, level, level}));
    std::size_t next = 0;
    (void)meter.measure([&next](std::size_t done, std::size_t total) {
        EXPECT_EQ(done, next++);
        EXPECT_EQ(total, 5U);
    });
    EXPECT_EQ(next, 5U);
}

TEST(PictureMetrics, APictureOfAnotherSizeThanExpectedIsAnError) {
    const Image picture = plain(12, 12, {9, 9, 9});
    PictureMeter meter;
    EXPECT_THROW(meter.add(picture), Error);
    EXPECT_THROW(meter.expect(picture, std::vector<bool>(12, true)), Error);
    meter.expect(picture, whole(picture));
    EXPECT_THROW(meter.add(plain(12, 13, {9, 9, 9})), Error);
}

/// The result with SHEEN_PYTHON set to `interpreter`, for one pair.
PictureMeter::Result with_interpreter(const std::string& interpreter) {
    const Environment python("SHEEN_PYTHON", interpreter);
    const Image picture = plain(12, 12, {9, 9, 9});
    PictureMeter meter;
    meter.expect(picture, whole(picture));
    meter.add(picture);
    return meter.measure();
}

TEST(PictureMetrics, AMissingInterpreterOrPackageIsNamedWithWhatToInstall) {
    const Folder folder;
    const std::string absent = (folder.path() / "no; such $(python)").string();
    const PictureMeter::Result missing = with_interpreter(absent);
    EXPECT_TRUE(missing.pairs.empty());
    EXPECT_NE(missing.unavailable.find(absent), std::string::npos) << missing.unavailable;
    EXPECT_NE(missing.unavailable.find("SHEEN_PYTHON"), std::string::npos) << missing.unavailable;

    const std::string bare = folder.script("bare python", "exec python3 -I -S \"$@\"");
    const PictureMeter::Result without = with_interpreter(bare);
    EXPECT_TRUE(without.pairs.empty());
    EXPECT_NE(without.unavailable.find("flip_evaluator"), std::string::npos) << without.unavailable;
    EXPECT_NE(without.unavailable.find("make setup"), std::string::npos) << without.unavailable;
}

TEST(PictureMetrics, AProgramThatFailsIsAnErrorInItsOwnWords) {
    const Folder folder;
    const auto message = [&folder](const std::string& text) -> std::string {
        try {
            (void)with_interpreter(folder.script("python", text));
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_NE(message("echo it rains >&2; exit 1").find("it rains"), std::string::npos);
    EXPECT_NE(message("kill -9 $$").find("said nothing"), std::string::npos);
    EXPECT_NE(message("exit 0").find("answered for 0 pictures of 1"), std::string::npos);
    EXPECT_NE(message("echo 42").find("'42'"), std::string::npos);
    EXPECT_NE(message("echo '{\"ssim\": \"good\", \"flip\": 0}'; yes").find("good"), std::string::npos)
        << "one that goes on writing is not waited for";
}

TEST(PictureMetrics, NoFileIsLeftBehind) {
    const Folder folder;
    const Environment temporary("TMPDIR", folder.path().string());
    {
        const Image picture = plain(12, 12, {9, 9, 9});
        PictureMeter meter;
        meter.expect(picture, whole(picture));
        meter.add(picture);
        EXPECT_FALSE(std::filesystem::is_empty(folder.path()));
        const Environment python("SHEEN_PYTHON", "/bin/false");
        EXPECT_THROW((void)meter.measure(), Error);
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace sheen::test
