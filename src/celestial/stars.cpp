#include "celestial/stars.h"

#include <erfa.h>

#include <cmath>

#include "spectrum/colour_temperature.h"
#include "sun/time_scales.h"
#include "units/units.h"

namespace airlight {

namespace {

struct Row {
    double ascension_deg, declination_deg, magnitude, b_minus_v;
};
constexpr Row table[] = {
#include "stars.inc"
};

}  // namespace

double temperature_of_colour_index(double b_minus_v) { return 4600.0 * (1.0 / (0.92 * b_minus_v + 1.7) + 1.0 / (0.92 * b_minus_v + 0.62)); }

std::vector<Star> stars_at(const Utc& moment, double faintest) {
    const TimeScales time = time_scales(moment, 0.0);
    double to_earth[3][3];
    eraC2t00b(time.tt.first, time.tt.second, time.ut1.first, time.ut1.second, 0.0, 0.0, to_earth);
    std::vector<Star> stars;
    for (const Row& row : table) {
        if (row.magnitude > faintest) break;
        double celestial[3], fixed[3];
        eraS2c(row.ascension_deg * deg, row.declination_deg * deg, celestial);
        eraRxp(to_earth, celestial, fixed);
        const double lux = lux_of_magnitude_0 * std::pow(10.0, -0.4 * row.magnitude);
        stars.push_back({{fixed[0], fixed[1], fixed[2]}, lux * black_body_colour(temperature_of_colour_index(row.b_minus_v))});
    }
    return stars;
}

}  // namespace airlight
