#include "atmosphere/sunlight.h"

#include <cassert>

#include "spectrum/solar.h"

namespace airlight {

namespace {

struct Row {
    double wavelength_nm, u, v;
};
constexpr Row table[] = {
#include "solar_limb_darkening.inc"
};

}  // namespace

LimbDarkening solar_limb_darkening() {
    std::vector<SpectrumOf<Number>::Sample> first, second;
    for (const Row& row : table) {
        first.push_back({row.wavelength_nm * nm, row.u + 2.0 * row.v});
        second.push_back({row.wavelength_nm * nm, -row.v});
    }
    return {*SpectrumOf<Number>::of(std::move(first)), *SpectrumOf<Number>::of(std::move(second))};
}

Sun sun_at(double distance_au) {
    assert(distance_au > 0.0);
    const LimbDarkening limb = solar_limb_darkening();
    return {solar_irradiance(distance_au), std::asin(std::sin(solar_angular_radius_1au) / distance_au), limb.first, limb.second};
}

}  // namespace airlight
