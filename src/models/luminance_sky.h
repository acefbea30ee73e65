// Skies of which a model knows the relative luminance alone, made absolute and spectral in one way: the sky's light on level ground,
// wavelength by wavelength, is that of the atmosphere, and every direction has its spectrum.
// Uses small tables (transport/tables.h) for that light; knows no model.
#pragma once

#include "models/model.h"
#include "physics/models/f64.h"
#include "sky/table_sky.h"

namespace airlight {

// Coefficients, and which of the two formulas with them.
struct LuminanceFormula {
    f64::PerezCoefficients k;
    bool cie;  // cie2003, or else perez
};

class LuminanceSky : public PublishedSky {
public:
    // The tables of an atmosphere as small as its light on the ground needs: some seconds of one core.
    static Result<std::shared_ptr<const TableSky>> ground_light(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths,
                                                                const ModelOptions& options);

    LuminanceSky(const ModelCard& card, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths,
                 std::shared_ptr<const TableSky> ground);

    // The atmosphere's own; the sun is seen through its air.
    Result<IrradianceEstimate> irradiance(Length altitude, double sun_zenith) const override;
    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override;
    Result<std::unique_ptr<SkyDome>> dome(Length altitude, double sun_zenith) const override;

protected:
    // For a sun at 0 to pi / 2.
    virtual LuminanceFormula formula(double sun_zenith) const = 0;

private:
    std::vector<double> sky_radiance(const View& view) const override;

    std::shared_ptr<const TableSky> ground_;
};

// Relative luminance, not below zero, in a direction.
double relative_luminance(const LuminanceFormula& formula, double mu, double nu);

// What a sky of this relative luminance throws on level ground: the integral of it times mu.
double relative_illuminance(const LuminanceFormula& formula, double sun_zenith);

}  // namespace airlight
