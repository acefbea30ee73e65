#include "eval/truth.h"

#include <fmt/format.h>

namespace airlight {

std::int64_t paths_for(std::int64_t by_day, const Condition& condition) {
    if (condition.sun_zenith_deg <= 80.0) return by_day;
    if (condition.sun_zenith_deg > 98.0) return by_day * 192;
    return by_day * (condition.altitude > 100.0 * km && condition.sun_zenith_deg > 85.0 ? 768 : 24);
}

std::string paths_text(std::int64_t by_day) {
    return fmt::format(
        "{} paths a direction by day, 24 times as many with the sun beyond 80°, 192 times beyond 98°, 768 times from space "
        "in twilight",
        by_day);
}

Result<SkyTruth> truth_by(const Sky& sky, const Atmosphere& atmosphere, const Condition& condition, const Progress& progress) {
    SkyTruth truth{condition_text(condition), condition, judged_directions(atmosphere, condition), {}, {}};
    const double steps = static_cast<double>(truth.directions.size() + 1);
    for (const JudgedDirection& judged : truth.directions) {
        if (progress.stop.stop_requested()) return Error{"", "the comparison was interrupted", ""};
        progress.report("truth", static_cast<double>(truth.radiance.size()) / steps);
        Result<RadianceEstimate> seen = sky.radiance(view_of(condition, judged.direction));
        if (!seen) return at(truth.name, seen.error());
        truth.radiance.push_back(std::move(*seen));
    }
    if (condition.altitude > atmosphere.top_altitude) return truth;
    Result<IrradianceEstimate> light = sky.irradiance(condition.altitude, condition.sun_zenith_deg * deg);
    if (!light) return at(truth.name, light.error());
    truth.irradiance = std::move(*light);
    progress.report("truth", 1.0);
    return truth;
}

}  // namespace airlight
