// What the moon sends of the sun's light and of the Earth's. docs/theory.md, section 7.2.
// Uses curves; where the moon stands is said by sun/position.h.
#pragma once

#include "units/curve.h"
#include "units/units.h"

namespace airlight {

inline constexpr Length moon_mean_distance = 384400.0 * km;  // from the Earth's centre [Cox2000]

// The moon's light at a phase angle (sun - moon - eye, 0 to pi radians) over that of a full one, the surge near 0 left out there:
// 10^(-0.4 (0.026 a + 4e-9 a^4)), a in degrees [KrisciunasSchaefer1991, eq. 20], and below 7 degrees up to 35 % more [p. 1035].
double moon_brightness(double phase_angle);

// The same of a ball that reflects as Lommel and Seeliger's law says, radiance as mu_0 / (mu_0 + mu): one of the law's few integrals in
// closed form, 1 - sin(a / 2) tan(a / 2) ln cot(a / 4). 0 at pi.
double lommel_seeliger_brightness(double phase_angle);

// What Lommel and Seeliger's law is multiplied by, at a phase angle, so that the whole disk is as bright as it was measured:
//     radiance = E albedo / pi * factor * 2 mu_0 / (mu_0 + mu)
// with the sun's irradiance E. Held beyond 160 degrees, where nothing was measured.
double moon_radiance_factor(double phase_angle);

// Geometric albedo: 0.122 at 550 nm, which makes the full moon V = -12.73 at its mean distance beside a sun of -26.74, and as much
// redder than the sun as B - V = 0.92 beside 0.65 says [Cox2000], straight in wavelength.
SpectrumOf<Number> moon_albedo();

// Irradiance of the moon's light over that of the sun's, at a distance from the moon.
SpectrumOf<Number> moonlight_share(double phase_angle, Length distance);

// Irradiance of the Earth's light on the moon over that of the sun's, at the moon's phase angle: a Lambertian ball of albedo 0.297, as
// the moon's dark side was measured to be lit [Goode2001], bluer than the sun as B - V = 0.20 says [Cox2000], the excess as the inverse
// fourth power of wavelength. Clouds change it by a tenth or two. There it is seen at full phase: radiance = E share albedo / pi.
SpectrumOf<Number> earthshine_share(double phase_angle, Length distance);

}  // namespace airlight
