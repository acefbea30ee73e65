// Any bytes are a METAR or a refusal; what parses keeps to the ranges that weather/metar.h states.

#include <cmath>

#include "fuzz.h"
#include "weather/metar.h"

using namespace airlight;
using fuzz::demand;

namespace {

void check_distance(const std::optional<ReportedDistance>& reported) {
    demand(!reported || (reported->distance >= 0.0 * m && reported->distance <= 200.0 * km), "a distance is between 0 and 200 km");
}

void check(const Metar& metar) {
    demand(metar.station.size() == 4, "a station has four characters");
    demand(metar.day >= 1 && metar.day <= 31 && metar.hour >= 0 && metar.hour <= 23 && metar.minute >= 0 && metar.minute <= 59,
           "a time exists");
    check_distance(metar.visibility);
    for (const auto& side : metar.directional_visibility) check_distance(side.visibility);
    for (const auto& range : metar.runway_visual_range) {
        check_distance(range.least);
        check_distance(range.most);
    }
    for (const auto& cloud : metar.clouds)
        demand(!cloud.base || (*cloud.base >= 0.0 * m && *cloud.base < 31.0 * km), "a cloud is below 31 km");
    demand(!metar.qnh_hpa || (*metar.qnh_hpa >= 850.0 && *metar.qnh_hpa <= 1100.0), "a pressure is near 1000 hPa");
    demand(!metar.temperature_c || std::abs(*metar.temperature_c) < 100.0, "a temperature is on Earth");
    const std::optional<double> humidity = relative_humidity(metar);
    demand(!humidity || (*humidity >= 0.0 && *humidity <= 1.0), "a humidity is between 0 and 1");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<Metar> metar = parse_metar(fuzz::text_of(data, size));
    if (metar) check(*metar);
    else fuzz::demand_message(metar.error());
    return 0;
}
