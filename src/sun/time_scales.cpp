#include "sun/time_scales.h"

#include <erfa.h>

namespace airlight {

double delta_t_before_utc(double year) {
    if (year < 1920.0) {
        const double t = year - 1900.0;
        return -2.79 + t * (1.494119 + t * (-0.0598939 + t * (0.0061966 - t * 0.000197)));
    }
    if (year < 1941.0) {
        const double t = year - 1920.0;
        return 21.20 + t * (0.84493 + t * (-0.076100 + t * 0.0020936));
    }
    const double t = year - 1950.0;
    return 29.07 + t * (0.407 + t * (-1.0 / 233.0 + t / 2547.0));
}

TimeScales time_scales(const Utc& t, double ut1_minus_utc_s) {
    JulianDate utc{};
    eraDtf2d("UTC", t.year, t.month, t.day, t.hour, t.minute, t.second, &utc.first, &utc.second);
    TimeScales scales{};
    if (t.year < 1960) {
        scales.ut1 = {utc.first, utc.second + ut1_minus_utc_s / 86400.0};
        eraUt1tt(scales.ut1.first, scales.ut1.second, delta_t_before_utc(t.year + (t.month - 0.5) / 12.0), &scales.tt.first,
                 &scales.tt.second);
        return scales;
    }
    JulianDate tai{};
    eraUtctai(utc.first, utc.second, &tai.first, &tai.second);
    eraTaitt(tai.first, tai.second, &scales.tt.first, &scales.tt.second);
    eraUtcut1(utc.first, utc.second, ut1_minus_utc_s, &scales.ut1.first, &scales.ut1.second);
    return scales;
}

}  // namespace airlight
