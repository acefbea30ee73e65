#include "sun/preetham1999.h"

#include <algorithm>
#include <cmath>

namespace airlight {

HorizontalDirection preetham1999_sun(const Place& place, const Utc& moment) {
    const double day = day_of_year(moment);
    const double clock = moment.hour + moment.minute / 60.0 + moment.second / 3600.0;
    const double time = clock + 0.170 * std::sin(4.0 * pi * (day - 80.0) / 373.0) - 0.129 * std::sin(2.0 * pi * (day - 8.0) / 355.0) +
                        12.0 * place.longitude / pi;
    const double declination = 0.4093 * std::sin(2.0 * pi * (day - 81.0) / 368.0);
    const double l = place.latitude;
    const double angle = pi * time / 12.0;  // from midnight

    const double up = std::sin(l) * std::sin(declination) - std::cos(l) * std::cos(declination) * std::cos(angle);
    const double west = -std::cos(declination) * std::sin(angle);
    const double south = -std::cos(l) * std::sin(declination) - std::sin(l) * std::cos(declination) * std::cos(angle);
    const double azimuth = std::atan2(west, south) + pi;  // from north, clockwise: half a turn on from south, westward
    return {azimuth >= 2.0 * pi ? azimuth - 2.0 * pi : azimuth, std::acos(std::clamp(up, -1.0, 1.0))};
}

}  // namespace airlight
