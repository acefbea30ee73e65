// When the sun and the moon rise and set at a place, and when twilight begins and ends, in one day of UTC.
// docs/theory.md, section 7. Uses the positions; knows nothing of clocks on walls.
#pragma once

#include <vector>

#include "sun/position.h"

namespace airlight {

// The moments of one UTC day at which a body crosses a circle of equal zenith angle. Away from Greenwich a set may come
// before the rise; beyond the polar circles there may be neither, or two of one: all are answers.
struct Crossings {
    std::vector<Utc> rises;  // in order of time
    std::vector<Utc> sets;
    bool above_at_start;  // at 00:00 UTC

    bool always_above() const { return above_at_start && rises.empty() && sets.empty(); }
    bool always_below() const { return !above_at_start && rises.empty() && sets.empty(); }
};

// Zenith angles of the sun's centre, without air, that define the events: [Seidelmann1992, section 9.3].
inline constexpr double sunrise_zenith = 90.833 * deg;  // 34' of refraction and 16' of radius: the upper limb appears
inline constexpr double civil_twilight_zenith = 96.0 * deg;
inline constexpr double nautical_twilight_zenith = 102.0 * deg;
inline constexpr double astronomical_twilight_zenith = 108.0 * deg;

struct SunDay {
    Crossings sun;    // its upper limb, over a horizon at the level of the eye
    Crossings civil;  // a rise is the morning's beginning, a set the evening's end
    Crossings nautical;
    Crossings astronomical;
    Utc highest;            // the moment of the day at which the sun stands highest
    double highest_zenith;  // radians, of its centre, without air
};

// The sun's day that holds `date` (its clock does not matter). Moments are exact to 0.02 s for the definitions above;
// real refraction at the horizon moves a real sunrise by a minute or more.
SunDay sun_day(const Place& place, const Utc& date, double ut1_minus_utc_s = 0.0);

// Rise and set of the moon's upper limb, with its own radius and 34' of refraction.
Crossings moon_rises_and_sets(const Place& place, const Utc& date, double ut1_minus_utc_s = 0.0);

}  // namespace airlight
