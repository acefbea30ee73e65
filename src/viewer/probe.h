// The light of the sky in one direction, beside the rest of the sky: what a click into the picture asks a model for.
// Uses sky and spectrum.
#pragma once

#include <vector>

#include "core/result.h"
#include "sky/sky.h"
#include "spectrum/colour_weights.h"
#include "units/vector.h"

namespace airlight::viewer {

// A direction from an eye above a ground sphere, and the sun's. All from the planet's centre, along the axes of the world.
struct ProbedView {
    Vec3 eye_m;
    Vec3 direction;    // of length one
    Vec3 towards_sun;  // of length one
    double bottom_m;   // the ground sphere's radius
};
View view_of(const ProbedView& view);

inline constexpr double spectrum_step_nm = 5.0, sun_plane_step_deg = 2.0;

// Without surfaces and the sun's disk.
struct Probe {
    double luminance;             // there, cd m-2
    double first_nm;              // the spectrum's first wavelength
    std::vector<float> spectrum;  // there, W m-2 sr-1 nm-1, each 5 nm from the sky's first wavelength, straight between its own
    // cd m-2, each 2 degrees from the horizon under the sun over the zenith to the other one.
    std::vector<float> sun_plane;
};

// Fails where the sky does. `colour` is for the sky's wavelengths.
Result<Probe> probed(const Sky& sky, const ColourWeights& colour, const ProbedView& view);

}  // namespace airlight::viewer
