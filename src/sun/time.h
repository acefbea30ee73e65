// Moments in Coordinated Universal Time: read, written and shifted. docs/theory.md, section 7.
// Uses ERFA's calendar and leap seconds; knows nothing of places or of the sky.
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace airlight {

// A moment of UTC. Invariant, kept by those who make one (parse_utc, utc_of, after): it exists in the calendar and in
// ERFA's list of leap seconds, and lies in the years 1900 to 2100.
struct Utc {
    int year = 2000;      // 1900 to 2100, Gregorian
    int month = 1;        // 1 to 12
    int day = 1;          // 1 to 31
    int hour = 0;         // 0 to 23
    int minute = 0;       // 0 to 59
    double second = 0.0;  // [0, 60), [0, 61) in a minute with a leap second

    friend bool operator==(const Utc&, const Utc&) = default;
};

// `moment` if it exists. Fails, naming the field and its range, for month 13, 30 February, second 60 where there is
// no leap second, a year before 1900 or after 2100.
Result<Utc> utc_of(Utc moment);

// Reads ISO 8601: "2003-10-17T19:30:30Z", "2003-10-17T12:30:30.5-07:00", "2003-10-17 19:30", "2003-10-17".
// The date alone is its midnight. 'Z' or an offset (+hh:mm, +hhmm, +hh) says what the clock is; with neither it is UTC.
// Second 60 is accepted in a leap second. Fails with the form that would be right.
Result<Utc> parse_utc(std::string_view text);

// "2003-10-17T19:30:30Z", with `decimals` (0 to 9) of a second, cut, not rounded: parse_utc() reads it back.
std::string utc_text(const Utc& moment, int decimals = 0);

// The moment `seconds` later (or earlier); a leap second in between counts. Fails outside the years 1900 to 2100.
Result<Utc> after(const Utc& moment, double seconds);

// Seconds of UTC from `a` to `b`, leap seconds counted.
double seconds_between(const Utc& a, const Utc& b);

// Seconds in the day that holds the moment: 86 400, or 86 401 if it ends in a leap second.
double day_length_s(const Utc& moment);

// The day of the year, 1 to 366.
int day_of_year(const Utc& moment);

}  // namespace airlight
