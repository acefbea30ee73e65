// EXR and PNG: round trips, headers, dithering, and what cannot be written or read.

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

#include "core/files.h"
#include "image/exr.h"
#include "image/png.h"
#include "spectrum/wavelength_grid.h"
#include "tools/temporary_folder.h"

using namespace airlight;
using test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

Image noise(int width, int height, int channels, float highest) {
    std::mt19937 random(20260104);
    std::uniform_real_distribution<float> value(0.0f, highest);
    Image image(width, height, channels);
    for (float& v : image.values) v = value(random);
    return image;
}

}  // namespace

TEST_CASE("an RGB image reads back from EXR to the same bits, with its meaning") {
    const TemporaryFolder folder;
    const Image image = noise(37, 21, 3, 2e9f);
    ImageMeaning meaning = ImageMeaning::rgb(RgbSpace::acescg);
    meaning.notes = {{"place", "Boulder"}, {"time", "2003-10-17T19:30:30Z"}};
    REQUIRE(write_exr(folder.path / "sky.exr", image, meaning));
    const Result<MeantImage> read = read_exr(folder.path / "sky.exr");
    REQUIRE(read);
    CHECK(read->image.values == image.values);
    CHECK(read->image.width == 37);
    CHECK(read->image.height == 21);
    CHECK(read->meaning.channel_names == meaning.channel_names);
    CHECK(read->meaning.unit == "cd m-2");
    CHECK(read->meaning.notes == meaning.notes);
    REQUIRE(read->meaning.primaries);
    CHECK(std::abs(read->meaning.primaries->red.x - 0.713) < 1e-7);  // stored as float
    CHECK(std::abs(read->meaning.primaries->white.y - 0.33767) < 1e-7);
}

TEST_CASE("the pixels are where they were: the top left is the first") {
    const TemporaryFolder folder;
    Image image(3, 2, 3);
    image.pixel(2, 0)[1] = 5.0f;
    REQUIRE(write_exr(folder.path / "sky.exr", image, ImageMeaning::rgb(RgbSpace::srgb)));
    const Result<MeantImage> read = read_exr(folder.path / "sky.exr");
    REQUIRE(read);
    CHECK(read->image.pixel(2, 0)[1] == 5.0f);
}

TEST_CASE("a spectral image keeps its wavelengths in order") {
    const TemporaryFolder folder;
    const WavelengthGrid grid = *parse_wavelength_grid("90,360.5,550,1000");  // by name, 1000 would come before 90
    const std::vector<Wavelength> wavelengths(grid.begin(), grid.end());
    const Image image = noise(8, 8, 4, 0.3f);
    REQUIRE(write_exr(folder.path / "sky.exr", image, ImageMeaning::spectral(wavelengths)));
    const Result<MeantImage> read = read_exr(folder.path / "sky.exr");
    REQUIRE(read);
    CHECK(read->image.values == image.values);
    CHECK(read->meaning.unit == "W m-2 sr-1 nm-1");
    CHECK(read->meaning.channel_names == std::vector<std::string>{"S0.90nm", "S0.360,5nm", "S0.550nm", "S0.1000nm"});
    CHECK(*spectral_channel_wavelength("S0.360,5nm") == 360.5 * nm);
    CHECK(!spectral_channel_wavelength("S1.550nm"));
    CHECK(!spectral_channel_wavelength("S0.nm"));
    CHECK(!spectral_channel_wavelength("R"));
}

TEST_CASE("half keeps 11 bits of the sun's disk and of the night") {
    const TemporaryFolder folder;
    for (const float highest : {1.6e9f, 70000.0f, 65504.0f, 3000.0f, 1.0f, 2e-4f}) {
        CAPTURE(highest);
        Image image = noise(16, 16, 3, highest);
        image.values[0] = highest;
        REQUIRE(write_exr(folder.path / "sky.exr", image, ImageMeaning::rgb(RgbSpace::srgb), ExrPixels::float16));
        const Result<MeantImage> read = read_exr(folder.path / "sky.exr");
        REQUIRE(read);
        for (std::size_t i = 0; i < image.values.size(); ++i)  // half a unit of 2^-10, or of the smallest half
            CHECK(std::abs(read->image.values[i] - image.values[i]) <= std::max(image.values[i] / 2048.0f, highest * 6e-8f));
    }
}

TEST_CASE("light that is not finite or is negative is refused, and the pixel named") {
    const TemporaryFolder folder;
    const fs::path path = folder.path / "sky.exr";
    REQUIRE(write_file(path, "old"));
    for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e-9f}) {
        Image image = noise(8, 6, 3, 1.0f);
        image.pixel(5, 4)[2] = wrong;
        const Result<Done> written = write_exr(path, image, ImageMeaning::rgb(RgbSpace::srgb));
        REQUIRE(!written);
        CHECK(written.error().message().starts_with(path.string() + ": pixel (5, 4), channel B, is "));
        CHECK(!write_png(path, image));
    }
    CHECK(*read_file(path) == "old");
}

TEST_CASE("a folder that cannot be written and a full disk give one error and leave nothing") {
    const TemporaryFolder folder;
    const Image image = noise(64, 64, 3, 1.0f);
    const ImageMeaning meaning = ImageMeaning::rgb(RgbSpace::srgb);
    const fs::path absent = folder.path / "absent" / "sky";
    CHECK(write_exr(absent, image, meaning).error().message().starts_with(absent.string() + ": cannot be written: No such file"));
    CHECK(write_png(absent, image).error().message().starts_with(absent.string() + ": cannot be written: No such file"));
    if (!fs::exists("/dev/full")) {
        MESSAGE("[skipped] no /dev/full on this system");
        return;
    }
    const fs::path file = folder.path / "sky";
    REQUIRE(write_file(file, "old"));
    fs::create_symlink("/dev/full", temporary_name(file));  // what is written to, is full
    CHECK(write_exr(file, image, meaning).error().message().starts_with(file.string() + ": cannot be written: No space left"));
    fs::create_symlink("/dev/full", temporary_name(file));
    CHECK(write_png(file, image).error().message().starts_with(file.string() + ": cannot be written: No space left"));
    CHECK(*read_file(file) == "old");
    CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
}

TEST_CASE("a damaged or foreign file is refused and named") {
    const TemporaryFolder folder;
    const fs::path exr = folder.path / "sky.exr", png = folder.path / "sky.png";
    const Image image = noise(64, 64, 3, 1.0f);
    REQUIRE(write_exr(exr, image, ImageMeaning::rgb(RgbSpace::srgb)));
    REQUIRE(write_png(png, image));
    const std::string whole_exr = *read_file(exr), whole_png = *read_file(png);
    for (const double share : {0.0, 0.001, 0.01, 0.1, 0.5, 0.99}) {
        CAPTURE(share);
        REQUIRE(write_file(exr, whole_exr.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole_exr.size())))));
        REQUIRE(write_file(png, whole_png.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole_png.size())))));
        const Result<MeantImage> read = read_exr(exr);
        REQUIRE(!read);
        CHECK(read.error().message().starts_with(exr.string() + ": is not "));
        const Result<PngLevels> levels = read_png(png);
        REQUIRE(!levels);
        CHECK(levels.error().message().starts_with(png.string() + ": is not a readable PNG image"));
    }
    REQUIRE(write_file(exr, whole_png));
    CHECK(!read_exr(exr));
    CHECK(read_exr(folder.path / "absent").error().message().find("cannot be read") != std::string::npos);
}

TEST_CASE("a level written to PNG reads back to the same level, black and white exactly") {
    const TemporaryFolder folder;
    for (const PngBits bits : {PngBits::eight, PngBits::sixteen}) {
        const int highest = bits == PngBits::eight ? 255 : 65535;
        Image image(256, 2, 3);
        for (int x = 0; x < 256; ++x)
            for (float& v : image.pixel(x, 0)) v = static_cast<float>(srgb_linear(x / 255.0));
        for (int x = 0; x < 256; ++x)
            for (float& v : image.pixel(x, 1)) v = x % 2 == 0 ? 0.0f : 1.0f;
        REQUIRE(write_png(folder.path / "sky.png", image, bits));
        const Result<PngLevels> read = read_png(folder.path / "sky.png");
        REQUIRE(read);
        CHECK(read->bits == static_cast<int>(bits));
        REQUIRE(read->levels.size() == image.values.size());
        for (std::size_t i = 0; i < image.values.size(); ++i) {
            const double exact = srgb_encoded(static_cast<double>(image.values[i])) * highest;
            CHECK(std::abs(read->levels[i] - exact) < 1.0);
            if (i >= 256 * 3) CHECK(read->levels[i] == std::lround(exact));
        }
    }
}

TEST_CASE("levels that a display shows come back from their PNG file as they were") {
    const TemporaryFolder folder;
    PngLevels shown{7, 3, 3, 8, {}};
    for (int i = 0; i < 7 * 3 * 3; ++i) shown.levels.push_back(static_cast<std::uint16_t>(37 * i % 256));
    REQUIRE(write_png(folder.path / "shown.png", shown));
    const Result<PngLevels> read = read_png(folder.path / "shown.png");
    REQUIRE(read);
    CHECK(read->width == 7);
    CHECK(read->height == 3);
    CHECK(read->levels == shown.levels);
    CHECK(!write_png(folder.path / "absent/shown.png", shown));
}

TEST_CASE("a smooth gradient has no bands: over blocks of 16 x 16 pixels the mean level is right to 0.1") {
    const TemporaryFolder folder;
    Image image(512, 256, 3);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 512; ++x)
            for (float& v : image.pixel(x, y)) v = static_cast<float>(srgb_linear((20.0 + x / 64.0 + y / 100.0) / 255.0));  // 11 levels
    REQUIRE(write_png(folder.path / "sky.png", image));
    const Result<PngLevels> read = read_png(folder.path / "sky.png");
    REQUIRE(read);
    double worst = 0.0;
    for (int top = 0; top < 256; top += 16)
        for (int left = 0; left < 512; left += 16) {
            double error = 0.0;
            for (int y = top; y < top + 16; ++y)
                for (int x = left; x < left + 16; ++x)
                    error += read->levels[static_cast<std::size_t>(3 * (y * 512 + x) + 1)] - (20.0 + x / 64.0 + y / 100.0);
            worst = std::max(worst, std::abs(error) / 256.0);
        }
    MESSAGE("mean error of a block: at most " << worst << " levels");
    CHECK(worst < 0.1);
}

TEST_CASE("the same image gives the same PNG bytes, marked as sRGB") {
    const TemporaryFolder folder;
    const Image image = noise(32, 32, 1, 1.0f);
    REQUIRE(write_png(folder.path / "a.png", image));
    REQUIRE(write_png(folder.path / "b.png", image));
    const std::string bytes = *read_file(folder.path / "a.png");
    CHECK(bytes == *read_file(folder.path / "b.png"));
    CHECK(bytes.find("sRGB") != std::string::npos);
    CHECK(bytes.find("gAMA") != std::string::npos);
}

TEST_CASE("an image out of bounds is refused with the rule") {
    CHECK(Image::check_size(1, 1, 1));
    CHECK(Image::check_size(65536, 1, 4096));
    CHECK(Image::check_size(0, 1, 3).error().message().starts_with("an image of 0 x 1 pixels is out of range"));
    CHECK(Image::check_size(65537, 1, 3).error().message().starts_with("an image of 65537 x 1"));
    CHECK(Image::check_size(10, 10, 0).error().message().starts_with("an image of 0 channels"));
    CHECK(Image::check_size(65536, 65536, 4096).error().message().find("too large") != std::string::npos);
}
