// The skies of dobashi1997, each a series of functions of the direction, and their file. [Dobashi1997]
// The file is a CSV with every combination once, in the order of the columns:
//     basis = cosines                  (or samples, harmonics)
//     altitude_m = 0                   (of the eye; may be left out)
//     wavelength_nm,sun_zenith_deg,band,factors
// factors are numbers with spaces between them:
//     cosines    of cos 0, cos(azimuth), cos(2 azimuth)...; the band is a zenith angle of the view in degrees
//     samples    the radiances at equal steps of azimuth from 0 to 180 degrees; the band as before
//     harmonics  of Legendre's functions of degree m, m + 2, m + 4..., whose sum is the factor of cos(m azimuth); the band is the order m
// Radiance is linear between two bands of cosines and samples, between two suns and between two wavelengths.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sky/sky.h"

namespace airlight {

enum class SkyBasis { cosines, samples, harmonics };

std::string_view name_of(SkyBasis basis);
Result<SkyBasis> sky_basis_named(std::string_view name);

// The skies of one sun at one wavelength: the factors of each band.
using BandSeries = std::vector<std::vector<double>>;

struct Dobashi1997Data {
    SkyBasis basis;
    double altitude_m;                    // of the eye
    std::vector<double> wavelengths_nm;   // each of the three increases
    std::vector<double> sun_zeniths_deg;  // 0 to 90
    std::vector<double> bands;
    std::vector<BandSeries> skies;  // [wavelength][sun]

    const BandSeries& at(std::size_t wavelength, std::size_t sun) const { return skies[wavelength * sun_zeniths_deg.size() + sun]; }

    // Between two suns of the data. The view's altitude is not looked at.
    double radiance(std::size_t wavelength, const View& view) const;

    // The series for a sun between two of the data: what is linear in the factors is so in the sky.
    BandSeries between_suns(std::size_t wavelength, double sun_zenith) const;
};

// A direction from the zenith to the horizon, and what of a basis is the same there for every wavelength and sun.
class SeriesPlace {
public:
    SeriesPlace(SkyBasis basis, std::span<const double> bands, const Direction& direction);

    double radiance(const BandSeries& series) const;

private:
    double at(const std::vector<double>& band) const;

    SkyBasis basis_;
    double azimuth_;  // 0 to pi
    std::size_t low_ = 0, high_ = 0;
    double weight_ = 0.0;                         // of the band `high_`
    std::vector<std::vector<double>> functions_;  // of harmonics: [order][(degree - order) / 2]
};

// Legendre's functions of one order, of degree order, order + 2... up to `degree`.
std::vector<double> legendre_functions(int order, int degree, double mu);

// Fails, naming the line, if a cell is damaged or out of range, or a combination is missing or out of order.
Result<Dobashi1997Data> parse_dobashi1997(std::string_view text, std::string_view where);

// Factors have six digits; `comment` becomes its first lines.
std::string dobashi1997_csv(const Dobashi1997Data& data, std::string_view comment);

}  // namespace airlight
