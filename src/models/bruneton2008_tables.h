// The tables of bruneton2008 for a pack of sixteen wavelengths. Internal to the model.
// Rows of the scattering tables are filled when they are first read, so that a view from the ground does not wait for space.
#pragma once

#include <cstdlib>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "models/bruneton2008.h"
#include "physics/models/f32.h"
#include "physics/models/f64.h"
#include "transport/ray_light.h"
#include "transport/tables.h"

namespace airlight {

// Where a view stands in the tables: its altitude within the air, and whether its ray meets the ground.
struct Bruneton2008View {
    double altitude_m, mu, mu_s, nu;
    bool ground;
};

class Bruneton2008Tables {
public:
    // `pack` must outlive it.
    Bruneton2008Tables(const Tables::Pack& pack, const Bruneton2008Settings& settings);

    // What comes from the air along a ray: light scattered once by each kind of particle, to be multiplied by its phase function, and
    // the light of higher orders. In tables of four channels `multiple` is within the first constituent that is air.
    struct Light {
        f32::RadianceSpectrum multiple;
        std::array<f32::IrradianceSpectrum, max_parts> single;
    };
    Light light(const Bruneton2008View& view) const;

    // Times the phase functions; never below zero.
    f32::RadianceSpectrum radiance(const Light& light, double nu) const;

    // Transmittance over a distance that ends in the air or at the ground.
    f32::Spectrum transmittance(const Bruneton2008View& view, double distance_m) const;

    // Radiance of the ground where the sun stands at mu_s, and irradiance by the sky at an altitude.
    f32::RadianceSpectrum ground(double mu_s) const;
    f32::IrradianceSpectrum irradiance(double altitude_m, double mu_s) const;

    // Light in the sky by direction for one eye and sun: [view texel above the horizon][nu texel].
    struct Slice {
        int views, nus;
        std::vector<f32::RadianceSpectrum> multiple;
        std::vector<std::vector<f32::IrradianceSpectrum>> single;  // of each scattering part
    };
    Slice sky_slice(double altitude_m, double mu_s) const;

    const f32::Bruneton2008& shape() const { return shape_; }
    const Tables::Pack& pack() const { return pack_; }
    const std::vector<std::size_t>& scattering_parts() const { return parts_; }
    bool four_channels() const { return settings_.four_channels; }

private:
    struct Free {
        void operator()(float* p) const { std::free(p); }
    };
    // Zeros whose memory is taken only when it is written.
    using Values = std::unique_ptr<float[], Free>;
    Values zeros() const;
    double view_cosine(int view, double altitude_m) const;
    bool is_ground(int view) const { return view < shape_.view_size / 2; }

    void need(const f32::Bruneton2008Place& place) const;
    void fill_row(int view, int altitude) const;
    void write(std::size_t texel, const RayLight& light, double nu) const;
    void fill_irradiance();
    void round_to_eight_bits(const Values& values) const;
    void colour_mie(Light& light) const;

    std::size_t texels() const;
    template <class T>
    Table3D<T> table(const Values& values) const {
        return Table3D<T>(values.get(), shape_.nu_size * shape_.sun_size, shape_.view_size, shape_.altitude_size);
    }

    const Tables::Pack& pack_;
    Bruneton2008Settings settings_;
    f32::Bruneton2008 shape_;
    std::vector<std::size_t> parts_;            // those that scatter
    std::optional<std::size_t> air_;            // the first that is air
    std::vector<f32::Spectrum> transmittance_;  // optical depths
    std::vector<f32::IrradianceSpectrum> irradiance_;
    Values multiple_;
    std::vector<Values> single_;                // of each scattering part
    std::unique_ptr<std::once_flag[]> filled_;  // [altitude][view]
};

}  // namespace airlight
