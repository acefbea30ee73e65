// Quantities as people write them: "8 km", "35 deg", "550 nm", "2.5e-5 1/m".
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "units/units.h"

namespace airlight {

// Each reads a number and a unit of its own dimension; a missing or a foreign unit is refused, with those that fit named.
Result<Length> parse_length(std::string_view text);                 // m, km, um, nm, ft, mi (statute)
Result<Wavelength> parse_wavelength(std::string_view text);         // nm, um
Result<double> parse_angle(std::string_view text);                  // deg, rad, arcmin; radians are returned
Result<InverseLength> parse_inverse_length(std::string_view text);  // 1/m, 1/km

// The shortest text that reads back to the same quantity: "8 km", "1.2 km", "250 m", "550 nm".
std::string length_text(Length length);
std::string wavelength_text(Wavelength wavelength);
std::string angle_text(double radians);
std::string inverse_length_text(InverseLength coefficient);

// A finite number that fills the whole text.
Result<double> parse_number(std::string_view text);

}  // namespace airlight
