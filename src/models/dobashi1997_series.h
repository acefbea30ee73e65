// The series of dobashi1997, computed from samples of any sky: as few functions as a demanded error needs. [Dobashi1997]
// Uses the form of the file (dobashi1997_data.h), and the sky's interface.
#pragma once

#include "core/progress.h"
#include "models/dobashi1997_data.h"

namespace airlight {

struct Dobashi1997Settings {
    SkyBasis basis = SkyBasis::cosines;
    // The square of what a series leaves, over that of the sky, at which it ends: of a band, or of the whole sky for harmonics.
    double error = 1e-4;
    int most_functions = 64;  // of a band; no more than the azimuths that are sampled
    int most_degree = 20;     // of harmonics, the paper's largest
    Length altitude = 0.0 * m;
};

// The fewest cosines whose error is at most `error`, or `most`; of radiances at azimuths (k + 1/2) pi / K.
//   weights    W_i = c_i sum over k of cos(i azimuth_k) L_k pi / K, with c_0 = sqrt(1 / pi), else sqrt(2 / pi) [Lopes2015, eq. 46]
//   error      1 - sum of W_i^2 / integral of L^2, by Parseval's equation [Lopes2015, eq. 48, 49]
// Returns the factors c_i W_i of cos(i azimuth).
std::vector<double> cosine_factors(std::span<const double> radiances, double error, int most);

// What a series leaves of them, by the measure above.
double cosine_error(std::span<const double> radiances, std::span<const double> factors);

// The views at which a sky is sampled, sun after sun.
std::vector<View> dobashi1997_views(const Dobashi1997Settings& settings);

// The series of radiances at these views: [view * N + wavelength].
Dobashi1997Data dobashi1997_series(std::span<const double> radiances, std::span<const Wavelength> wavelengths,
                                   const Dobashi1997Settings& settings);

// Of a sky that is asked at these views.
Result<Dobashi1997Data> dobashi1997_series(const Sky& sky, const Dobashi1997Settings& settings, const Progress& progress);

}  // namespace airlight
