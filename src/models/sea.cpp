#include "models/sea.h"

#include <algorithm>
#include <cmath>

namespace airlight {

namespace {

// Absorption of pure water in 1/m at 380, 400, ... 700 nm. [PopeFry1997, table 3]
constexpr double absorption_per_m[] = {0.01137, 0.00663, 0.00454, 0.00635, 0.00979, 0.0127, 0.0204, 0.0409, 0.0474,
                                       0.0619,  0.0896,  0.2224,  0.2755,  0.3108,  0.4100, 0.4650, 0.6240};
constexpr double first_nm = 380.0, step_nm = 20.0;
constexpr int samples = 17;

double absorption(double nanometres) {
    const double x = std::clamp((nanometres - first_nm) / step_nm, 0.0, samples - 1.0);
    const int i = std::min(static_cast<int>(x), samples - 2);
    return std::lerp(absorption_per_m[i], absorption_per_m[i + 1], x - i);
}

// Of water with salt. [Morel1974]
double scattering(double nanometres) { return 0.00288 * std::pow(std::clamp(nanometres, 380.0, 700.0) / 500.0, -4.32); }

}  // namespace

SeaWater sea_water(const std::array<Wavelength, pack_size>& wavelengths) {
    SeaWater water;
    for (int w = 0; w < pack_size; ++w) {
        const double nanometres = wavelengths[static_cast<std::size_t>(w)].in(nm);
        water.absorption.v[w] = absorption(nanometres);
        water.scattering.v[w] = scattering(nanometres);
    }
    return water;
}

}  // namespace airlight
