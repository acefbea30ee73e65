// The tables of hillaire2020 for a pack of sixteen wavelengths, filled by the text that reads them. Internal to the model.
#pragma once

#include <span>
#include <vector>

#include "models/model.h"
#include "physics/models/f32.h"
#include "physics/models/f64.h"
#include "transport/air_optics.h"
#include "transport/ray_nodes.h"

namespace airlight {

class Hillaire2020Tables {
public:
    explicit Hillaire2020Tables(AirOptics optics);

    // What comes from the air along a ray that starts in it, up to its limit.
    struct Light {
        f32::RadianceSpectrum inscattered;
        f32::Spectrum transmittance;
        static Light none() { return {f32::RadianceSpectrum(f32::RadianceSpectrum::Scalar::of(0.0f)), f32::Spectrum(f32::Number(1.0))}; }
    };
    Light light(const Ray& ray) const;

    // The same with the ground, if the ray meets it.
    f32::RadianceSpectrum radiance(const Ray& ray) const;

    // The sky-view table of one eye and sun: [row][column]; and its light in a direction.
    std::vector<f32::RadianceSpectrum> sky_view(double altitude_m, double sun_zenith) const;
    f32::RadianceSpectrum seen_in(const std::vector<f32::RadianceSpectrum>& sky_view, double altitude_m, double mu,
                                  double cos_azimuth) const;

    // Light of all orders from the second on, and the share of light that is scattered once more: laws ask for it.
    f32::Hillaire2020Orders orders(double altitude_m, double mu_s) const;

    int count() const { return optics_.wavelength_count; }

    // What the text reads, for who reads it elsewhere: tables row by row, and the phase functions of air and, on average, of aerosols.
    const f32::Hillaire2020& sky() const { return sky_; }
    const f32::IrradianceSpectrum& sun() const { return sun_; }
    std::span<const f32::ScatteringSpectrum> medium_texels() const { return medium_; }
    std::span<const f32::Spectrum> transmittance_texels() const { return transmittance_; }
    std::span<const f32::PhaseSpectrum> multiple_texels() const { return multiple_; }
    Table2D<f32::Spectrum> transmittance() const;
    f32::PhaseSpectrum air_phase(double nu) const;
    f32::PhaseSpectrum aerosol_phase(double nu) const;

private:
    void fill_medium();
    void fill_multiple();
    Table2D<f32::ScatteringSpectrum> medium() const;

    AirOptics optics_;
    f32::Hillaire2020 sky_;
    f32::IrradianceSpectrum sun_;
    std::vector<f64::Spectrum> aerosol_share_;  // of each part: of the scattering by aerosols in a column of air
    std::size_t air_part_ = 0;
    bool has_air_ = false;
    std::vector<f32::ScatteringSpectrum> medium_;
    std::vector<f32::Spectrum> transmittance_;  // optical depths
    std::vector<f32::PhaseSpectrum> multiple_;
};

}  // namespace airlight
