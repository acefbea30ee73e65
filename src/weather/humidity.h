// Humidity of air from what a weather report says: temperature and dew point.
// docs/theory.md, section 8. Uses nothing.
#pragma once

namespace airlight {

// Saturation vapour pressure over liquid water in hPa, Magnus' form with the constants of [WMO2018, annex 4.B];
// for -45 to 60 deg C, within 0.3 % there.
double saturation_vapour_pressure_hpa(double temperature_c);

// Relative humidity over water, 0 to 1, of air at `temperature_c` whose dew point is `dew_point_c`.
// A dew point above the temperature (both are rounded to whole degrees in a report) is saturated air: 1.
double relative_humidity(double temperature_c, double dew_point_c);

}  // namespace airlight
