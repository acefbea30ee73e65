#include "terrain/surface_image.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace airlight {

namespace {

constexpr std::int64_t most_pixels = std::int64_t{1} << 27;

struct Pixels {
    int width, height;
    std::vector<std::array<float, 3>> reflectances;

    Vec3 at(int column, int row) const {
        const int x = (column % width + width) % width, y = std::clamp(row, 0, height - 1);
        const auto& r = reflectances[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
        return {r[0], r[1], r[2]};
    }

    Vec3 reflectance(Vec3 d) const {
        const double x = (std::atan2(d.y, d.x) / (2.0 * pi) + 0.5) * width - 0.5;
        const double y = (0.5 - std::atan2(d.z, std::hypot(d.x, d.y)) / pi) * height - 0.5;
        const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
        const double u = x - column, v = y - row;
        return glm::mix(glm::mix(at(column, row), at(column + 1, row), u), glm::mix(at(column, row + 1), at(column + 1, row + 1), u), v);
    }
};

// From sRGB's levels to linear light (IEC 61966-2-1).
std::array<float, 256> linear_levels() {
    std::array<float, 256> linear{};
    for (int level = 0; level < 256; ++level) {
        const double x = level / 255.0;
        linear[static_cast<std::size_t>(level)] = static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
    }
    return linear;
}

class Quiet {
public:
    Quiet() { CPLPushErrorHandler(CPLQuietErrorHandler), CPLErrorReset(); }
    ~Quiet() { CPLPopErrorHandler(); }
};

struct CloseDataset {
    void operator()(GDALDatasetH dataset) const { GDALClose(dataset); }
};

}  // namespace

Result<GroundColour> surface_image(const std::filesystem::path& path) {
    GDALAllRegister();
    const Quiet quiet;
    const std::string name = path.string();
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return Error{name, "there is no such file.", "Name an image of the whole planet."};
    const std::unique_ptr<std::remove_pointer_t<GDALDatasetH>, CloseDataset> dataset(
        GDALOpenEx(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
    if (!dataset || GDALGetRasterCount(dataset.get()) == 0)
        return Error{name, "it is no image that GDAL can read.", "gdalinfo tells more about a file."};
    Pixels pixels{GDALGetRasterXSize(dataset.get()), GDALGetRasterYSize(dataset.get()), {}};
    if (pixels.width != 2 * pixels.height)
        return Error{
            name, fmt::format("it is {} x {} pixels: an image of the whole planet is twice as wide as high.", pixels.width, pixels.height),
            "Give one in latitude and longitude, from pole to pole, with 180 degrees west at its left edge."};
    const std::int64_t count = std::int64_t{pixels.width} * pixels.height;
    if (count > most_pixels)
        return Error{name, fmt::format("it has {} pixels; at most {} are held in memory.", count, most_pixels),
                     "Make it smaller with gdal_translate -outsize."};
    pixels.reflectances.resize(static_cast<std::size_t>(count));
    const std::array<float, 256> linear = linear_levels();
    const int bands = GDALGetRasterCount(dataset.get());
    std::vector<std::uint8_t> row(static_cast<std::size_t>(pixels.width));
    for (int channel = 0; channel < 3; ++channel)
        for (int y = 0; y < pixels.height; ++y) {
            const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), bands >= 3 ? channel + 1 : 1);
            if (GDALRasterIO(band, GF_Read, 0, y, pixels.width, 1, row.data(), pixels.width, 1, GDT_Byte, 0, 0) != CE_None)
                return Error{name, fmt::format("it is damaged: {}.", CPLGetLastErrorMsg()), "Fetch or make the file again."};
            for (std::size_t x = 0; x < row.size(); ++x)
                pixels.reflectances[static_cast<std::size_t>(y) * row.size() + x][static_cast<std::size_t>(channel)] = linear[row[x]];
        }
    const auto shared = std::make_shared<const Pixels>(std::move(pixels));
    return GroundColour([shared](Vec3 direction, double, Vec3) { return shared->reflectance(direction); });
}

}  // namespace airlight
