#include "spectrum/solar.h"

#include <cassert>

namespace airlight {

namespace {

struct Row {
    double wavelength_nm, irradiance;
};
constexpr Row table[] = {
#include "solar_irradiance.inc"
};

}  // namespace

SpectrumOf<SpectralIrradiance> solar_irradiance(double distance_au) {
    assert(distance_au > 0.0);
    std::vector<SpectrumOf<SpectralIrradiance>::Sample> samples;
    for (const Row& row : table) samples.push_back({row.wavelength_nm * nm, row.irradiance / (distance_au * distance_au) * W_per_m2_nm});
    return *SpectrumOf<SpectralIrradiance>::of(std::move(samples));
}

}  // namespace airlight
