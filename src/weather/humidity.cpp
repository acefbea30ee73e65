#include "weather/humidity.h"

#include <algorithm>
#include <cmath>

namespace airlight {

double saturation_vapour_pressure_hpa(double t) { return 6.112 * std::exp(17.62 * t / (243.12 + t)); }

double relative_humidity(double temperature_c, double dew_point_c) {
    return std::min(saturation_vapour_pressure_hpa(dew_point_c) / saturation_vapour_pressure_hpa(temperature_c), 1.0);
}

}  // namespace airlight
