// Perez's formula for radiance, fitted to an atmosphere wavelength by wavelength and sun by sun: what `airlight fit perez` writes and
// perez1993 reads. [Perez1993]. Its file is a CSV, every combination once, in the order of the columns:
//     altitude_m = 0                   (of the eye; may be left out)
//     wavelength_nm,sun_zenith_deg,a,b,c,d,e,scale
// radiance = scale (1 + a exp(b / cos theta)) (1 + c exp(d gamma) + e cos^2 gamma), W m-2 sr-1 nm-1; b is at most 0. Between two suns,
// and between two wavelengths, radiance is linear: each form with the angle gamma from the true sun.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "physics/models/f64.h"
#include "sky/sky.h"

namespace airlight {

struct PerezForm {
    f64::PerezCoefficients k;
    double scale;

    // Towards a zenith angle of cosine mu >= 0, at an angle of cosine nu from the sun.
    double value(double mu, double nu) const { return scale * f64::perez(k, mu, nu, f64::angle_of_cosine(nu)).value; }
};

struct Perez1993Data {
    double altitude_m;                    // of the eye
    std::vector<double> wavelengths_nm;   // each of the two increases
    std::vector<double> sun_zeniths_deg;  // 0 to 90
    std::vector<PerezForm> forms;         // [wavelength][sun]

    // Between two suns, never below zero; the view's altitude is not looked at.
    double radiance(std::size_t wavelength, const View& view) const;
};

// Fails, naming the line, if a cell is damaged or out of range, or a combination is missing or out of order.
Result<Perez1993Data> parse_perez1993(std::string_view text, std::string_view where);

// Numbers have seven digits; `comment` becomes its first lines.
std::string perez1993_csv(const Perez1993Data& data, std::string_view comment);

}  // namespace airlight
