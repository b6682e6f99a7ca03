// SPDX-License-Identifier: MIT
// Framebuffer, sRGB, PNG, and files that appear whole or not at all.
#include "sheen/image.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "sheen/error.hpp"

namespace sheen {
namespace {

namespace fs = std::filesystem;
constexpr unsigned seed = 7006;

class ImageFile : public testing::Test {
 protected:
    ImageFile() : folder_(fs::temp_directory_path() / ("sheen_image_test_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~ImageFile() override { fs::remove_all(folder_); }
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    [[nodiscard]] std::ptrdiff_t files() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }
    static std::string content(const std::string& name) {
        std::ifstream file(name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

 private:
    fs::path folder_;
};

Image random_image(int width, int height) {
    std::mt19937 random(seed);
    Image image(width, height);
    for (std::uint8_t& component : image.rgb) {
        component = static_cast<std::uint8_t>(random());
    }
    return image;
}

TEST(Framebuffer, TheNearestPixelWinsInAnyOrderAndTheFirstOneWinsTies) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (int run = 0; run < 200; ++run) {
        // Few depths, the extremes among them, so that ties are common.
        std::vector<Pixel> pixels;
        for (int i = 0; i < 60; ++i) {
            const std::array<int, 4> depths{0, 1, 65534, 65535};
            pixels.push_back(
                {static_cast<int>(random() % 3), static_cast<int>(random() % 2), depths[random() % 4], i, 255 - i, 7});
        }
        Framebuffer framebuffer(3, 2);
        for (const Pixel& pixel : pixels) {
            framebuffer.write(pixel);
        }
        for (int y = 0; y < 2; ++y) {
            for (int x = 0; x < 3; ++x) {
                const Pixel* best = nullptr;
                for (const Pixel& pixel : pixels) {
                    const bool here = pixel.x == x && pixel.y == y;
                    best = here && (best == nullptr || pixel.depth < best->depth) ? &pixel : best;
                }
                ASSERT_EQ(framebuffer.covered()[static_cast<std::size_t>(3 * y + x)], best != nullptr);
                if (best != nullptr) {
                    EXPECT_EQ(framebuffer.image().at(x, y)[0], best->red);
                    EXPECT_EQ(framebuffer.image().at(x, y)[1], best->green);
                    EXPECT_EQ(framebuffer.image().at(x, y)[2], best->blue);
                }
            }
        }
    }
}

TEST(Framebuffer, PixelsOutsideAreRefusedAndNamed) {
    Framebuffer framebuffer(3, 2);
    for (const auto& [x, y] : {std::pair{3, 0}, {0, 2}, {-1, 0}, {0, -1}, {4094, 4094}}) {
        try {
            framebuffer.write({x, y, 0, 0, 0, 0});
            ADD_FAILURE() << x << ", " << y << " accepted";
        } catch (const Error& error) {
            const std::string place = "(" + std::to_string(x) + ", " + std::to_string(y) + ")";
            EXPECT_NE(std::string(error.what()).find(place), std::string::npos) << error.what();
        }
    }
}

TEST(Srgb, TheCurveIsTheStandardsInverseWithinHalfAStep) {
    Image ramp(256, 1);
    for (int v = 0; v < 256; ++v) {
        std::fill_n(ramp.at(v, 0), 3, static_cast<std::uint8_t>(v));
    }
    const Image encoded = to_srgb(ramp);
    // IEC 61966-2-1, encoded to linear.
    const auto decode = [](double e) { return e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4); };
    for (int v = 0; v < 256; ++v) {
        const double linear = v / 255.0;
        for (int c = 0; c < 3; ++c) {
            const double step = encoded.at(v, 0)[c];
            EXPECT_LE(decode((step - 0.51) / 255.0), linear + 1e-4) << v;
            EXPECT_GE(decode((step + 0.51) / 255.0), linear - 1e-4) << v;
        }
    }
    EXPECT_EQ(encoded.at(0, 0)[0], 0);
    EXPECT_EQ(encoded.at(255, 0)[0], 255);
}

TEST_F(ImageFile, APngReadsBackEqual) {
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {4095, 1}, {1, 4095}, {61, 97}}) {
        const Image image = random_image(width, height);
        write_png(path("a.png"), image);
        png_image header{};
        header.version = PNG_IMAGE_VERSION;
        ASSERT_NE(png_image_begin_read_from_file(&header, path("a.png").c_str()), 0) << header.message;
        ASSERT_EQ(header.width, static_cast<png_uint_32>(width));
        ASSERT_EQ(header.height, static_cast<png_uint_32>(height));
        header.format = PNG_FORMAT_RGB;
        std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(header));
        ASSERT_NE(png_image_finish_read(&header, nullptr, read.data(), 0, nullptr), 0) << header.message;
        EXPECT_EQ(read, image.rgb) << width << "x" << height << ", seed " << seed;
    }
    EXPECT_EQ(files(), 1) << "temporary files stay behind";
}

TEST_F(ImageFile, AnEmptyImageIsRefusedAndLeavesNoFile) {
    EXPECT_THROW(write_png(path("a.png"), Image()), Error);
    EXPECT_EQ(files(), 0);
}

TEST_F(ImageFile, AFailureNamesTheFileAndLeavesNothingBehind) {
    const std::string text = "whole";
    fs::create_directories(path("folder"));
    for (const std::string& name : {path("missing/a.bin"), path("folder")}) {
        try {
            write_file_atomically(name, text.data(), text.size());
            ADD_FAILURE() << name << " accepted";
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).rfind(name + ": ", 0), 0U) << error.what();
        }
    }
    EXPECT_EQ(files(), 1);
    EXPECT_TRUE(fs::is_empty(path("folder")));
}

/// Root may write anywhere: while this lives, a test that runs as root acts as a user without rights.
class OrdinaryUser {
 public:
    OrdinaryUser() {
        if (before_ == 0) {
            EXPECT_EQ(::seteuid(nobody), 0);
        }
    }
    ~OrdinaryUser() {
        if (before_ == 0) {
            EXPECT_EQ(::seteuid(before_), 0);
        }
    }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;

 private:
    static constexpr uid_t nobody = 65534;
    uid_t before_ = ::geteuid();
};

TEST_F(ImageFile, AWriteProtectedFileKeepsItsContentEvenWhereItsFolderIsWritable) {
    std::ofstream(path("a.bin")) << "old";
    fs::permissions(path("a.bin"), fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read);
    fs::permissions(path(""), fs::perms::all);
    const std::string text = "new";
    {
        const OrdinaryUser user;
        EXPECT_THROW(write_file_atomically(path("a.bin"), text.data(), text.size()), Error);
    }
    EXPECT_EQ(content(path("a.bin")), "old");
    EXPECT_EQ(files(), 1);
}

TEST_F(ImageFile, AWriteThatFailsHalfwayKeepsTheOldFileAndLeavesNoOther) {
    write_file_atomically(path("a.bin"), "old", 3);
    // The system refuses bytes past a process's file size limit, as it does on a full disk.
    struct rlimit before {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    struct rlimit small = before;
    small.rlim_cur = 1000;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string text(5000, 'n');
    EXPECT_THROW(write_file_atomically(path("a.bin"), text.data(), text.size()), Error);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(content(path("a.bin")), "old");
    EXPECT_EQ(files(), 1) << "the temporary file stays behind";
}

TEST_F(ImageFile, AReaderOfTheOldFileKeepsItWholeWhileItIsReplaced) {
    write_file_atomically(path("a.bin"), "old", 3);
    std::ifstream reader(path("a.bin"), std::ios::binary);
    write_file_atomically(path("a.bin"), "newer", 5);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old") << "written in place, not replaced";
    EXPECT_EQ(content(path("a.bin")), "newer");
    EXPECT_EQ(files(), 1);
}

TEST_F(ImageFile, LinksKeepPointingAndPipesAreWrittenTo) {
    write_file_atomically(path("target"), "old", 3);
    fs::create_symlink(path("target"), path("link"));
    write_file_atomically(path("link"), "new", 3);
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(content(path("target")), "new");

    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    const int reader = ::open(path("pipe").c_str(), O_RDWR);
    ASSERT_GE(reader, 0);
    write_file_atomically(path("pipe"), "new", 3);
    std::array<char, 3> read{};
    ASSERT_TRUE(fs::is_fifo(path("pipe"))) << "the pipe was replaced";
    EXPECT_EQ(::read(reader, read.data(), read.size()), 3);
    EXPECT_EQ(std::string(read.data(), read.size()), "new");
    ::close(reader);
}

TEST_F(ImageFile, NewFilesHaveOrdinaryPermissions) {
    const mode_t mask = ::umask(022);
    write_file_atomically(path("a.bin"), "x", 1);
    ::umask(mask);
    struct stat status {};
    ASSERT_EQ(::stat(path("a.bin").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0644U);
}

TEST_F(ImageFile, ADashIsStandardOutput) {
    testing::internal::CaptureStdout();
    write_file_atomically("-", "bytes", 5);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "bytes");
    EXPECT_FALSE(fs::exists("-"));
}

}  // namespace
}  // namespace sheen
