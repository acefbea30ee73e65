// An atmosphere under the weather that a METAR reports.
// The rules and their sources: docs/atmosphere-file.md, section "Weather reports". Uses the METAR and the aerosol's optics.
#pragma once

#include <string>
#include <vector>

#include "atmosphere/aerosol.h"
#include "weather/metar.h"

namespace airlight {

// What the report does not say.
struct WeatherOptions {
    AerosolType usual_aerosol = AerosolType::continental_average;  // of the place, when the weather names no other
};

struct AtmosphereUnderWeather {
    Atmosphere atmosphere;
    std::vector<ReportedCloud> clouds;   // as reported: they are not part of the description
    std::vector<std::string> decisions;  // one line each: what was taken from the report, and what was assumed
};

// `base` with its air scaled to the reported pressure and its aerosol (all that scatters and is not molecules) replaced by
// what the reported visibility, humidity and weather imply. What is not reported stays as it is in `base`.
// Fails if the report is NIL, or if the result breaks a rule of descriptions.
Result<AtmosphereUnderWeather> atmosphere_under(Atmosphere base, const Metar& report, const WeatherOptions& options = {});

}  // namespace airlight
