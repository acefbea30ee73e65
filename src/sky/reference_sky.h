// The sky by the Monte Carlo reference: the truth, at its price.
#pragma once

#include "sky/sky.h"

namespace airlight {

class ReferenceSky : public Sky {
public:
    // `progress` is asked to stop, and told, during each question.
    // `bottom_radius`: of the atmosphere that the reference was made of.
    ReferenceSky(Reference reference, Length bottom_radius, ReferenceSettings settings, Progress progress = {});

    std::string name() const override { return "reference"; }
    std::span<const Wavelength> wavelengths() const override { return reference_.wavelengths(); }
    Result<RadianceEstimate> radiance(const View& view) const override;
    Result<IrradianceEstimate> irradiance(Length altitude, double sun_zenith) const override;
    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override;
    Result<AerialPerspective> aerial_perspective(const View& view, Length distance) const override;

private:
    Length bottom_radius() const override { return bottom_radius_; }

    Reference reference_;
    Length bottom_radius_;
    ReferenceSettings settings_;
    Progress progress_;
};

}  // namespace airlight
