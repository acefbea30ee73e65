// The data set of the Prague sky model, in the binary form in which its authors publish it, little-endian:
//   radiance  int count, doubles: visibilities (km), albedos, altitudes (m), sun elevations (deg), each increasing;
//             int channels, double first wavelength (nm), double width (nm); int rank;
//             int count, doubles: breaks of the angle from the sun, of the zenith angle, of the emphasis (rad), each increasing;
//             for each visibility, albedo, altitude, elevation, channel:
//               rank times: half[sun breaks], double scale, half[zenith breaks] (to be divided by the scale); half[emphasis breaks]
//   transmittance  int distances, int altitudes (of its grid); int visibilities, int altitudes, int rank; floats: altitudes (m),
//             visibilities (km); float U[altitude][distance][grid altitude][rank]; float V[visibility][altitude][channel][rank]
//   polarisation, if it is there, is not read.
// [Wilkie2021]. Uses core; knows no sky.
#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"

namespace airlight {

struct Prague2021Radiance {
    std::vector<double> visibilities_km, albedos, altitudes_m, elevations_deg;
    int channels;
    double first_nm, width_nm;
    int rank;
    std::vector<double> sun_breaks, zenith_breaks, emphasis_breaks;
    // Of the visibilities that were asked for: [visibility][albedo][altitude][elevation][channel][coefficients()].
    std::vector<float> data;

    std::size_t coefficients() const {
        return static_cast<std::size_t>(rank) * (sun_breaks.size() + zenith_breaks.size()) + emphasis_breaks.size();
    }
    // Of all channels of a visibility.
    std::size_t configurations() const {
        return albedos.size() * altitudes_m.size() * elevations_deg.size() * static_cast<std::size_t>(channels);
    }
};

struct Prague2021Transmittance {
    int distances, grid_altitudes, rank;
    std::vector<double> altitudes_m, visibilities_km;
    std::vector<float> u, v;
};

struct Prague2021Data {
    Prague2021Radiance radiance;  // of the one or two visibilities around the one that was asked for
    Prague2021Transmittance transmittance;
};

// Reads what one visibility needs. Fails, naming what of the file is wrong, if it is cut or damaged, and naming the range if the
// visibility is outside of the data's.
Result<Prague2021Data> read_prague2021(const std::filesystem::path& path, double visibility_km);

}  // namespace airlight
