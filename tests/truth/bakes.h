// Tables for the truth tests: of the default sizes in `make truth`, coarser ones in the light version.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "atmosphere/presets.h"
#include "figures.h"
#include "sky/table_sky.h"
#include "spectrum/wavelength_grid.h"

namespace airlight::truth {

// Light tables cost some twentieth of the default ones: by day they lose little.
inline BakeSettings light_bake(int azimuth, int view, int altitude) {
    return {
        .sizes = {.transmittance_mu = 128, .transmittance_altitude = 64, .sun = 32, .azimuth = azimuth, .view = view, .altitude = altitude},
        .orders = 4};
}
inline BakeSettings bake_settings() { return full() ? BakeSettings{} : light_bake(8, 20, 16); }

inline TableSky table_sky(const Atmosphere& atmosphere, const std::vector<Wavelength>& wavelengths,
                          const BakeSettings& settings = bake_settings()) {
    return TableSky(std::make_shared<Tables>(*bake_tables(atmosphere, wavelengths, settings, {})));
}

inline std::vector<Wavelength> sixteen_wavelengths() {
    const WavelengthGrid grid = WavelengthGrid::standard();
    return {grid.begin(), grid.end()};
}

// Of a preset, at sixteen wavelengths; baked once.
inline const TableSky& preset_sky(const std::string& name) {
    static std::map<std::string, TableSky> skies;
    const auto found = skies.find(name);
    if (found != skies.end()) return found->second;
    return skies.emplace(name, table_sky(*preset(name), sixteen_wavelengths())).first->second;
}

}  // namespace airlight::truth
