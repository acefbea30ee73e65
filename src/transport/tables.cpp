#include "transport/tables.h"

#include <cassert>

namespace airlight {

Tables::Tables(Atmosphere atmosphere, std::vector<Wavelength> wavelengths, BakeSettings settings, std::vector<PackTables> packs)
    : atmosphere_(std::move(atmosphere)), wavelengths_(std::move(wavelengths)), settings_(settings) {
    const std::vector<std::vector<Wavelength>> groups = airlight::packs(wavelengths_);
    assert(groups.size() == packs.size());
    for (std::size_t i = 0; i < groups.size(); ++i) {
        AirOptics optics = air_optics(atmosphere_, groups[i]);
        PackAir air = pack_air(optics, settings.sizes);
        packs_.push_back({std::move(optics), std::move(air), std::move(packs[i])});
    }
}

Result<Tables> bake_tables(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const BakeSettings& settings,
                           const Progress& progress) {
    assert(!wavelengths.empty());
    const std::vector<std::vector<Wavelength>> groups = packs(wavelengths);
    std::vector<PackTables> baked;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const double share = 1.0 / static_cast<double>(groups.size());
        Result<PackTables> pack =
            bake_pack(air_optics(atmosphere, groups[i]), settings, part_of(progress, static_cast<double>(i) * share, share));
        if (!pack) return pack.error();
        baked.push_back(std::move(*pack));
    }
    return Tables(atmosphere, std::move(wavelengths), settings, std::move(baked));
}

}  // namespace airlight
