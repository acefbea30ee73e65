// oneil2004: one look-up table of optical lengths for every ray, so that five samples along the view are enough. [ONeil2004]
//
//   computes     single scattering by molecules and aerosol from the ground to space, a sample in the middle of each of five steps
//                of equal length; transmittance and aerial perspective; the ground, Lambertian, lit by the sun alone
//   leaves out   light scattered more than once, skylight on the ground, gases that absorb (ozone)
//   parameters   128 altitudes, evenly, by 256 zenith angles, evenly, as published; 5 samples
//   converted    any atmosphere, to two exponential constituents (two_constituents.h)
//   cost         a table of four channels, 0.1 s; 16 look-ups a direction
//   reference    the text is physics/models/oneil2004.glsl
//
// Steps of equal length pass over the aerosol where the view is long: the model's haze at the horizon is what its few samples find.
#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "models/exponential_sky.h"
#include "models/list.h"

namespace airlight {

namespace {

constexpr int altitudes = 128;
constexpr int angles = 256;
constexpr int samples = 5;

constexpr ModelCard card{.key = "oneil2004",
                         .paper = "ONeil2004",
                         .scattering = "single",
                         .approach = "five samples, optical lengths from a table by altitude and angle",
                         .precomputation = "0.1 s",
                         .memory = "0.5 MiB of floats",
                         .highest_eye = anywhere,
                         .aerial_perspective = true};

// The texel of an altitude and a zenith angle. Below the horizon, where no ray reaches the top, that of the horizon: what is
// interpolated across it then stays finite.
f64::Spectrum texel(const f64::ExponentialAir& air, int i, int j) {
    const f64::Length h = air.top * (static_cast<double>(i) / (altitudes - 1));
    const double lowest = f64::horizon_cosine(h, air.bottom).value * (1.0 - 1e-9);
    const double mu = std::max(std::cos(pi * j / (angles - 1)), lowest);
    const f64::AirColumns column = f64::kaneda1991_columns(air, h, mu, f64::distance_to_top(h, mu, air.bottom, air.top), 48);
    const f64::AirDensities density = f64::air_densities(air, h);
    f64::Spectrum channels(f64::Number(0.0));
    channels.v[0] = density.air.value;
    channels.v[1] = column.air.value;
    channels.v[2] = density.aerosol.value;
    channels.v[3] = column.aerosol.value;
    return channels;
}

class ONeil2004 : public ExponentialSky {
public:
    ONeil2004(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths)
        : ExponentialSky(card, atmosphere, std::move(wavelengths)), table_(static_cast<std::size_t>(altitudes) * angles) {
        parallel_for(angles, [&](std::size_t j) {
            for (int i = 0; i < altitudes; ++i)
                table_[j * altitudes + static_cast<std::size_t>(i)] = texel(pack(0).air, i, static_cast<int>(j));
        });
    }

private:
    f64::ScatteredLight light(std::size_t i, const f64::AirRay& ray) const override {
        return f64::oneil2004_light(pack(i).air, Table2D<f64::Spectrum>(table_, altitudes, angles), altitudes, angles, ray, samples);
    }

    std::vector<f64::Spectrum> table_;  // [angles][altitudes]
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions&) {
    return std::unique_ptr<Sky>(std::make_unique<ONeil2004>(atmosphere, std::move(wavelengths)));
}

}  // namespace

Model oneil2004_model() { return {card, make}; }

}  // namespace airlight
