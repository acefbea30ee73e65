// Heights from a file: any raster in latitude and longitude that GDAL reads (GeoTIFF, HGT, netCDF), of any size, read block by block
// as it is needed, within a bound of memory.
// Uses core; includes GDAL in its source only.
#pragma once

#include <filesystem>
#include <memory>

#include "core/result.h"
#include "terrain/height_field.h"

namespace airlight {

class Raster {
public:
    // Reads how the first band lies on the planet, and, of files of up to 2^28 heights, between which heights each part of it lies.
    // Keeps at most `most_bytes` of blocks in memory (one block, if that is more). Where the file has no height, it is 0 m.
    // Fails, naming the path, if the file is missing, is no raster or is damaged; if it does not say where it lies; if it is not in
    // latitude and longitude with north up; if its heights are not real numbers.
    static Result<std::shared_ptr<const Raster>> open(const std::filesystem::path& path, std::size_t most_bytes = std::size_t{128} << 20);
    ~Raster();

    // Interpolated through the heights at pixels' centres, smoothly [CatmullRom1974]. From any thread; reads what is not in memory.
    // Beyond an edge it goes on as at the edge; a raster that goes round the planet has no edge in longitude.
    double height_m(double latitude, double longitude) const;

    // 0 outside of the raster and at its edges, 1 from eight pixels inside; a raster that goes round the planet has no edge there,
    // and one that ends at a pole none there.
    double presence(double latitude, double longitude) const;

    // No height_m() within these latitudes and longitudes is outside of it.
    Interval range(Interval latitudes, Interval longitudes) const;

    // Between pixels along a meridian, in radians.
    double pixel() const;
    // The same, or along a parallel of that latitude if that is less.
    double narrowest_pixel(double latitude) const;

    std::size_t bytes() const;  // of blocks in memory
    // Fails if a block could not be read since it was opened; its heights count as 0 m.
    Result<Done> check() const;

private:
    struct Content;
    explicit Raster(std::unique_ptr<Content> content);
    std::unique_ptr<Content> content_;
};

}  // namespace airlight
