// The quantities of this project in double precision, and the units that make them.
// docs/conventions.md lists every symbol.
#pragma once

#include <numbers>

#include "units/quantity.h"

namespace airlight {

//                          m   nm  sr  W
using Number = Quantity<double, 0, 0, 0, 0>;
using Length = Quantity<double, 1, 0, 0, 0>;
using Area = Quantity<double, 2, 0, 0, 0>;
using InverseLength = Quantity<double, -1, 0, 0, 0>;  // a scattering, absorption or extinction coefficient
using NumberDensity = Quantity<double, -3, 0, 0, 0>;  // particles in a volume
using Wavelength = Quantity<double, 0, 1, 0, 0>;
using SolidAngle = Quantity<double, 0, 0, 1, 0>;
using InverseSolidAngle = Quantity<double, 0, 0, -1, 0>;  // a phase function
using Power = Quantity<double, 0, 0, 0, 1>;
using SpectralIrradiance = Quantity<double, -2, -1, 0, 1>;  // W m-2 nm-1
using SpectralRadiance = Quantity<double, -2, -1, -1, 1>;   // W m-2 sr-1 nm-1

inline constexpr Length m = Length::of(1.0);
inline constexpr Length km = Length::of(1000.0);
inline constexpr Length um = Length::of(1e-6);
inline constexpr Area m2 = Area::of(1.0);
inline constexpr Area cm2 = Area::of(1e-4);
inline constexpr NumberDensity per_m3 = NumberDensity::of(1.0);
inline constexpr NumberDensity per_cm3 = NumberDensity::of(1e6);
inline constexpr InverseLength per_m = InverseLength::of(1.0);
inline constexpr Wavelength nm = Wavelength::of(1.0);
inline constexpr SolidAngle sr = SolidAngle::of(1.0);
inline constexpr InverseSolidAngle per_sr = InverseSolidAngle::of(1.0);
inline constexpr SpectralIrradiance W_per_m2_nm = SpectralIrradiance::of(1.0);
inline constexpr SpectralRadiance W_per_m2_sr_nm = SpectralRadiance::of(1.0);

// Angles are plain numbers in radians.
inline constexpr double pi = std::numbers::pi;
inline constexpr double deg = pi / 180.0;

// A wavelength as a length, for optics, where both meet.
constexpr Length as_length(Wavelength w) { return Length::of(w.value * 1e-9); }

}  // namespace airlight
