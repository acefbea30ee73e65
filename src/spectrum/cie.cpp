#include "spectrum/cie.h"

#include <cassert>

namespace airlight {

namespace {

constexpr ColourMatch table[] = {
#include "cie1931_2deg.inc"
};

template <class Y>
Xyz sum_over_bands(const SpectrumOf<Y>& spectrum) {
    Xyz sum{0.0, 0.0, 0.0};
    for (const ColourMatch& row : table) sum = sum + spectrum.at(row.wavelength_nm * nm).value * Xyz{row.x, row.y, row.z};
    return lumen_per_watt * cie_step_nm * sum;
}

}  // namespace

std::span<const ColourMatch> cie1931() { return table; }

Xyz to_xyz(const SpectrumOf<SpectralRadiance>& radiance) { return sum_over_bands(radiance); }
Xyz to_xyz(const SpectrumOf<SpectralIrradiance>& irradiance) { return sum_over_bands(irradiance); }

double luminance(const SpectrumOf<SpectralRadiance>& radiance) { return to_xyz(radiance).y; }
double illuminance(const SpectrumOf<SpectralIrradiance>& irradiance) { return to_xyz(irradiance).y; }

Chromaticity chromaticity(Xyz colour) {
    const double sum = colour.x + colour.y + colour.z;
    assert(sum > 0.0);
    return {colour.x / sum, colour.y / sum};
}

UniformChromaticity uniform_chromaticity(Xyz colour) {
    const double sum = colour.x + 15.0 * colour.y + 3.0 * colour.z;
    assert(sum > 0.0);
    return {4.0 * colour.x / sum, 9.0 * colour.y / sum};
}

double distance(UniformChromaticity a, UniformChromaticity b) { return std::hypot(a.u - b.u, a.v - b.v); }

Xyz with_luminance(Chromaticity c, double y) {
    assert(c.y > 0.0);
    return {c.x / c.y * y, y, (1.0 - c.x - c.y) / c.y * y};
}

}  // namespace airlight
