// UTC to the time scales that astronomy runs on: UT1 (the Earth's rotation) and TT (the planets' motion).
// docs/theory.md, section 7. Uses ERFA; internal to this module.
#pragma once

#include "sun/time.h"

namespace airlight {

// A Julian date in two parts whose sum keeps nanoseconds, as ERFA takes it.
struct JulianDate {
    double first;
    double second;
};

struct TimeScales {
    JulianDate ut1;
    JulianDate tt;
};

// From 1972 on, TT is UTC + ERFA's leap seconds + 32.184 s, its last leap second holding for the future.
// Before 1960 what is written as UTC is UT1, and TT = UT1 + Delta T by Espenak and Meeus [EspenakMeeus2006].
// From 1960 to 1971 UTC ran at a rate of its own, which ERFA knows.
//   ut1_minus_utc_s   |.| < 0.9 while leap seconds keep it so; 0 errs by at most 0.0038 deg of the Earth's rotation
TimeScales time_scales(const Utc& moment, double ut1_minus_utc_s);

// TT - UT1 in seconds for a year from 1900 to 1961 [EspenakMeeus2006], within 0.1 s of observation there.
double delta_t_before_utc(double year);

}  // namespace airlight
