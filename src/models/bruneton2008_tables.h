// The tables of bruneton2008 for a pack of sixteen wavelengths. Internal to the model.
// Rows of the scattering tables are filled when they are first read, so that a view from the ground does not wait for space.
#pragma once

#include <cstdlib>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "models/bruneton2008.h"
#include "models/two_look_ups.h"
#include "physics/models/f32.h"
#include "physics/models/f64.h"
#include "transport/ray_light.h"
#include "transport/tables.h"

namespace airlight {

class Bruneton2008Tables {
public:
    // `pack` must outlive it.
    Bruneton2008Tables(const Tables::Pack& pack, const Bruneton2008Settings& settings);

    // What comes from the air along a ray; `single` is in the order of scattering_parts(). In tables of four channels `multiple` is within the first constituent that is air.
    AirLight light(const AirView& view) const;

    // Times the phase functions; never below zero.
    f32::RadianceSpectrum radiance(const AirLight& light, double nu) const;

    // Transmittance over a distance that ends in the air or at the ground.
    f32::Spectrum transmittance(const AirView& view, double distance_m) const;

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
    void colour_mie(AirLight& light) const;

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
