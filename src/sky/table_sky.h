// The sky from tables: single scattering integrated along the ray, all higher orders from the table of their source.
// Theory: docs/theory.md, section 5.5. Uses transport/tables.h.
#pragma once

#include "sky/pack_phases.h"
#include "sky/sky.h"
#include "transport/tables.h"

namespace airlight {

class TableSky : public Sky {
public:
    explicit TableSky(std::shared_ptr<const Tables> tables);

    std::string name() const override { return "tables"; }
    std::span<const Wavelength> wavelengths() const override { return tables_->wavelengths(); }
    Result<RadianceEstimate> radiance(const View& view) const override;
    Result<IrradianceEstimate> irradiance(Length altitude, double sun_zenith) const override;
    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override;
    Result<AerialPerspective> aerial_perspective(const View& view, Length distance) const override;

    // Integrates some ten thousand rays once; each direction is then interpolated, with phase functions taken exactly.
    Result<std::unique_ptr<SkyDome>> dome(Length altitude, double sun_zenith) const override;

private:
    Length bottom_radius() const override { return tables_->atmosphere().bottom_radius; }

    std::shared_ptr<const Tables> tables_;
    PhasesOfPacks phases_;
};

}  // namespace airlight
