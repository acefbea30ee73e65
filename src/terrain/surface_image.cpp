#include "terrain/surface_image.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal.h>

#include <algorithm>
#include <utility>

namespace airlight {

namespace {

constexpr std::int64_t most_pixels = std::int64_t{1} << 27;

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
    SurfaceImage pixels{GDALGetRasterXSize(dataset.get()), GDALGetRasterYSize(dataset.get()), {}};
    if (pixels.width != 2 * pixels.height)
        return Error{
            name, fmt::format("it is {} x {} pixels: an image of the whole planet is twice as wide as high.", pixels.width, pixels.height),
            "Give one in latitude and longitude, from pole to pole, with 180 degrees west at its left edge."};
    const std::int64_t count = std::int64_t{pixels.width} * pixels.height;
    if (count > most_pixels)
        return Error{name, fmt::format("it has {} pixels; at most {} are held in memory.", count, most_pixels),
                     "Make it smaller with gdal_translate -outsize."};
    pixels.levels.assign(static_cast<std::size_t>(4 * count), 255);
    const int bands = GDALGetRasterCount(dataset.get());
    if (bands < 3 && GDALGetRasterColorTable(GDALGetRasterBand(dataset.get(), 1)))
        return Error{name, "its colours are those of a palette: an image has bands of red, green and blue, or of greys.",
                     "Expand it with: gdal_translate -expand rgb in.png out.png."};
    for (int channel = 0; channel < 3; ++channel) {
        const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), bands >= 3 ? channel + 1 : 1);
        if (GDALRasterIO(band, GF_Read, 0, 0, pixels.width, pixels.height, &pixels.levels[static_cast<std::size_t>(channel)], pixels.width,
                         pixels.height, GDT_Byte, 4, 4 * pixels.width) != CE_None)
            return Error{name, fmt::format("it is damaged: {}.", CPLGetLastErrorMsg()), "Fetch or make the file again."};
    }
    return GroundColour{std::make_shared<const SurfaceImage>(std::move(pixels))};
}

}  // namespace airlight
