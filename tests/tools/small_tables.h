// An atmosphere and settings so small that their tables are baked in milliseconds.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "transport/table_file.h"

namespace airlight::test {

inline Atmosphere one_gas() {
    Atmosphere atmosphere{.name = "one gas",
                          .bottom_radius = 6360.0 * km,
                          .top_altitude = 100.0 * km,
                          .constituents = {},
                          .ground_albedo = SpectrumOf<Number>::constant(0.3),
                          .sun = {}};
    atmosphere.constituents.push_back({"air", ExponentialProfile{8.0 * km}, SpectrumOf<InverseLength>::constant(2e-5 * per_m),
                                       SpectrumOf<InverseLength>::constant(0.0 * per_m), RayleighPhase{}});
    return atmosphere;
}

// 1 to 4096 wavelengths from 400 nm, 5 nm apart.
inline std::vector<Wavelength> some_wavelengths(int count) {
    std::vector<Wavelength> wavelengths;
    for (int i = 0; i < count; ++i) wavelengths.push_back((400.0 + 5.0 * i) * nm);
    return wavelengths;
}

inline BakeSettings tiny_bake(int orders) {
    return {.sizes = {.transmittance_mu = 4, .transmittance_altitude = 4, .sun = 2, .azimuth = 2, .view = 3, .altitude = 2},
            .orders = orders,
            .extrapolate = true};
}

inline bool same_bits(const PackTables& a, const PackTables& b) {
    const auto same = [](auto x, auto y) {
        return x.size_bytes() == y.size_bytes() && std::memcmp(x.data(), y.data(), x.size_bytes()) == 0;
    };
    return same(a.transmittance.cells(), b.transmittance.cells()) && same(a.source.cells(), b.source.cells()) &&
           same(a.irradiance.cells(), b.irradiance.cells());
}

}  // namespace airlight::test
