// What every model of the sky answers: the reference, the tables, measured skies and each published model.
// A model says what it cannot answer by an error; it never makes up a value.
// Uses transport (views and estimates); knows nothing of pixels and colour.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "transport/reference.h"

namespace airlight {

// A direction of view from an eye. Angles in radians.
struct Direction {
    double view_zenith;       // 0 (straight up) to pi
    double relative_azimuth;  // 0 towards the sun
};

// The whole sphere of directions around one eye under one sun: many directions at little cost each. Thread-safe.
class SkyDome {
public:
    virtual ~SkyDome() = default;

    // Radiance in one direction, in W m-2 sr-1 nm-1, at each wavelength of the sky; the sun's disk is not in it.
    //   view_zenith       radians, 0 (straight up) to pi
    //   relative_azimuth  radians, 0 towards the sun
    //   radiance          [N], overwritten
    virtual void radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const = 0;

    // The same in many directions: [directions][N]. Models whose loops run over directions in the vector unit override it.
    virtual void radiances(std::span<const Direction> directions, std::span<float> radiance) const;
};

// What the air between an eye and a point does to the point's light: a part comes through, and the air adds its own.
struct AerialPerspective {
    std::vector<double> transmittance;           // [N]
    std::vector<double> inscattered_W_m2_sr_nm;  // [N]
};

// Read-only; every question may be asked from any thread.
class Sky {
public:
    virtual ~Sky() = default;

    virtual std::string name() const = 0;
    virtual std::span<const Wavelength> wavelengths() const = 0;

    // Radiance that reaches the eye, with standard errors where the model knows them (else zeros): [N], [N].
    // The sun's disk is not in it. Fails if the eye is below the ground or an argument is out of the model's range.
    virtual Result<RadianceEstimate> radiance(const View& view) const = 0;

    // What falls on a level plane facing up at an altitude: from the sun's disk, and from the rest of the sky.
    virtual Result<IrradianceEstimate> irradiance(Length altitude, double sun_zenith) const = 0;

    // Transmittance from the eye over a distance, or to where the ray leaves the air or meets the ground: [N].
    virtual Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const = 0;

    // The air's part of a view over a distance, or to where the view leaves the air or meets the ground, whose light is not in it.
    // By default an error: the model has no aerial perspective.
    virtual Result<AerialPerspective> aerial_perspective(const View& view, Length distance) const;

    // Transmittance from the eye to the sun's disk in a direction: [N]; zeros where the ground stands before it.
    Result<std::vector<double>> sunlight_transmittance(Length altitude, double view_zenith) const;

    // The sky around one eye. The default asks radiance() for each direction.
    virtual Result<std::unique_ptr<SkyDome>> dome(Length altitude, double sun_zenith) const;

protected:
    // Of the ground sphere.
    virtual Length bottom_radius() const = 0;
};

// Radiance of the sun's disk at an angle from its centre (radians), seen from above the atmosphere: [N]; zeros beyond its edge.
// The mean over the disk is the irradiance over its solid angle.
std::vector<double> sun_disk_radiance(const Sun& sun, std::span<const Wavelength> wavelengths, double angle);

// The cosine of the angle between the view and the sun.
double view_sun_cosine(const View& view);

// The error for an eye below the ground or an angle that is not finite; none otherwise. Every model asks it first.
Result<Done> check_view(Length altitude, double view_zenith, double sun_zenith, double relative_azimuth);

}  // namespace airlight
