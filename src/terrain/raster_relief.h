// A ground from a raster, with procedural detail where the raster knows no more.
// Uses units.
#pragma once

#include <memory>

#include "terrain/procedural_relief.h"
#include "terrain/raster.h"

namespace airlight {

struct RasterRelief {
    double radius_m = 6'371'000.0;
    bool sea = true;
    // Detail begins at features as wide as two pixels; its amplitude there is this share of their width at detail_full_at_m and above.
    double detail_share = 0.07;
    double detail_smoothness = 0.85;
    double detail_narrowest_m = 0.5;
    double detail_full_at_m = 2000.0;
    double detail_least = 0.04;    // of plains and of the sea floor
    double detail_shore_m = 60.0;  // below this height above the sea, or depth, detail fades out: shores are the raster's
    std::uint32_t seed = 5;
};

// Outside of the raster, the ground is that of `outside`; at the raster's edge one goes over into the other.
HeightField raster_height(std::shared_ptr<const Raster> raster, const RasterRelief& relief, HeightField outside);

// A ground at 0 m everywhere: without detail, a sphere.
HeightField level_height(double radius_m);

// The latitudes and longitudes of a cap; all longitudes if a pole is within it.
struct GeographicRange {
    Interval latitudes, longitudes;
};
GeographicRange geographic_range(const Cap& cap);

}  // namespace airlight
