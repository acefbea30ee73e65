// What models are judged by: light in some directions, with its standard error, computed or measured.
// Uses the sky and the reference; truth_file.h keeps it on disk.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "eval/condition.h"

namespace airlight {

struct SkyTruth {
    std::string name;  // of the condition, for reports
    Condition condition;
    std::vector<JudgedDirection> directions;
    std::vector<RadianceEstimate> radiance;        // in each direction
    std::optional<IrradianceEstimate> irradiance;  // on a level plane at the eye; none from space, and none measured
};

// How hard the reference works: light of twilight comes by rare paths, from space by the rarest; with too few of them the
// reference reads too dark, and its standard error too small.
//   by_day  paths in each direction with the sun up to 80 degrees from the zenith
// 24 times as many beyond, 192 times beyond 98, and 768 times for an eye above 100 km with the sun beyond 85 degrees.
std::int64_t paths_for(std::int64_t by_day, const Condition& condition);
// The same in words.
std::string paths_text(std::int64_t by_day);

// The truth by a sky that gives it: the reference, or the tables.
// Fails if the sky cannot answer, or `progress` asks to stop; progress is told the share of directions done.
Result<SkyTruth> truth_by(const Sky& sky, const Atmosphere& atmosphere, const Condition& condition, const Progress& progress);

}  // namespace airlight
