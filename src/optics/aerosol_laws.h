// The aerosol from what people report of it: a visibility, a turbidity, optical depths at two wavelengths.
// Theory: docs/theory.md, section 3.4. Uses quantities; knows nothing of particles.
#pragma once

#include "core/result.h"
#include "units/units.h"

namespace airlight {

// Optical depth beta (wavelength / 1 um)^-alpha: alpha is near 1.3 for haze, near 0 for coarse particles. [Angstrom1929]
struct AngstromLaw {
    double beta;
    double alpha;
};

double optical_depth(const AngstromLaw& law, Wavelength wavelength);

// The law through two optical depths > 0 at two different wavelengths.
AngstromLaw angstrom_law(Wavelength first, double first_depth, Wavelength second, double second_depth);

// What a coefficient at `from` is multiplied by to have it at `to`.
double angstrom_factor(double alpha, Wavelength from, Wavelength to);

// The contrast at which a black object is lost against the sky: the meteorological range, Koschmieder's own,
// and the meteorological optical range, which weather stations report as visibility. [Koschmieder1924; WMO2018, ch. 9]
inline constexpr double range_contrast = 0.02;
inline constexpr double optical_range_contrast = 0.05;

// Extinction of air through which one sees as far as `visibility` > 0: ln(1 / contrast) / visibility.
InverseLength extinction_of_visibility(Length visibility, double contrast);
Length visibility_of_extinction(InverseLength extinction, double contrast);

// What of it is the aerosol's, beside molecules that scatter `molecular` at the same wavelength (550 nm, as the eye sees).
// Fails if molecules alone do not let one see so far.
Result<InverseLength> aerosol_extinction_of_visibility(Length visibility, InverseLength molecular, double contrast);

// Turbidity T >= 1: optical depth of molecules and aerosol over that of molecules alone. [Nielsen2003, eq. 2.10]
double aerosol_depth_of_turbidity(double turbidity, double molecular_depth);
double turbidity_of_aerosol_depth(double aerosol_depth, double molecular_depth);

// Preetham's reading of turbidity, 1 <= T: the aerosol's optical depth as an Angstrom law. [Preetham1999, app. A.1]
AngstromLaw preetham_angstrom_law(double turbidity);

// Scattering coefficient of haze at the ground in the same paper, to be used with a scale height of 1.25 km.
// Its c = (0.6544 T - 0.6510) 1e-16 wants the wavelength in centimetres and gives the coefficient per centimetre, which the
// texts that quote it leave out; K is taken as 0.67 at all wavelengths. [Preetham1999, app. A.3; Nielsen2003, eq. 2.5]
InverseLength preetham_haze_scattering(double turbidity, Wavelength wavelength);

}  // namespace airlight
