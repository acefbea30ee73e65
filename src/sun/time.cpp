#include "sun/time.h"

#include <erfa.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/scanner.h"

namespace airlight {

namespace {

constexpr int first_year = 1900;
constexpr int last_year = 2100;
constexpr const char* form = "Write it as 2003-10-17T19:30:30Z, or with an offset: 2003-10-17T12:30:30-07:00.";

// The modified Julian day number at the midnight that begins the day of `t`.
int day_number(const Utc& t) {
    double zero = 0.0;
    double mjd = 0.0;
    eraCal2jd(t.year, t.month, t.day, &zero, &mjd);
    return static_cast<int>(std::lround(mjd));
}

// The midnight that begins a day.
Utc midnight(int day) {
    Utc t;
    double fraction = 0.0;
    eraJd2cal(2400000.5, day, &t.year, &t.month, &t.day, &fraction);
    return t;
}

// Leap seconds inserted before a day; none before 1972, when UTC ran at another rate (TimeScales knows it).
int leap_seconds(int day) {
    const Utc t = midnight(day);
    double tai_minus_utc = 10.0;
    if (t.year >= 1972) eraDat(t.year, t.month, t.day, 0.0, &tai_minus_utc);
    return static_cast<int>(std::lround(tai_minus_utc)) - 10;
}

double day_length(int day) { return 86400.0 + leap_seconds(day + 1) - leap_seconds(day); }

double second_of_day(const Utc& t) { return t.hour * 3600.0 + t.minute * 60.0 + t.second; }

bool has_leap_second(const Utc& t) { return t.hour == 23 && t.minute == 59 && day_length(day_number(t)) > 86400.0; }

int month_length(int year, int month) {
    constexpr int lengths[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return lengths[month - 1] + (month == 2 && leap ? 1 : 0);
}

// The digits after the decimal sign. Nanoseconds are kept: a sum of 0.999... must not reach the next second.
std::optional<double> read_fraction(Scanner& scanner) {
    double value = 0.0;
    double place = 0.1;
    if (!scanner.at_digit()) return {};
    for (; scanner.at_digit(); place *= 0.1) value += *scanner.digits(1) * place;
    return std::min(value, 1.0 - 1e-9);
}

// hh:mm, hh:mm:ss or hh:mm:ss.sss into `t`.
bool read_clock(Scanner& scanner, Utc& t) {
    const auto hour = scanner.digits(2);
    if (!hour || !scanner.skip(":")) return false;
    const auto minute = scanner.digits(2);
    if (!minute) return false;
    t.hour = *hour;
    t.minute = *minute;
    if (!scanner.skip(":")) return true;
    const auto second = scanner.digits(2);
    if (!second) return false;
    t.second = *second;
    if (!scanner.skip(".") && !scanner.skip(",")) return true;
    const auto fraction = read_fraction(scanner);
    if (!fraction) return false;
    t.second += *fraction;
    return true;
}

// Z, +hh:mm, +hhmm, +hh or nothing: minutes that the clock is ahead of UTC.
std::optional<int> read_offset(Scanner& scanner) {
    if (scanner.empty() || scanner.skip("Z") || scanner.skip("z")) return 0;
    const bool behind = scanner.skip("-");
    if (!behind && !scanner.skip("+")) return {};
    const auto hours = scanner.digits(2);
    if (!hours) return {};
    int minutes = 0;
    if (!scanner.empty()) {
        scanner.skip(":");
        const auto read = scanner.digits(2);
        if (!read) return {};
        minutes = *read;
    }
    if (*hours > 15 || minutes > 59) return {};
    return (behind ? -1 : 1) * (*hours * 60 + minutes);
}

}  // namespace

Result<Utc> utc_of(Utc t) {
    const auto refuse = [](std::string what) { return Error{"", std::move(what), form}; };
    if (t.year < first_year || t.year > last_year)
        return refuse(fmt::format("year {} is out of range: it must be {} to {}", t.year, first_year, last_year));
    if (t.month < 1 || t.month > 12) return refuse(fmt::format("month {} is out of range: it must be 1 to 12", t.month));
    const int days = month_length(t.year, t.month);
    if (t.day < 1 || t.day > days) return refuse(fmt::format("day {} is out of range: {}-{:02} has 1 to {}", t.day, t.year, t.month, days));
    if (t.hour < 0 || t.hour > 23) return refuse(fmt::format("hour {} is out of range: it must be 0 to 23", t.hour));
    if (t.minute < 0 || t.minute > 59) return refuse(fmt::format("minute {} is out of range: it must be 0 to 59", t.minute));
    if (!(t.second >= 0.0 && t.second < 61.0))
        return refuse(fmt::format("second {:g} is out of range: it must be below 60, or 60 in a leap second", t.second));
    if (t.second >= 60.0 && !has_leap_second(t))
        return refuse(fmt::format("second {:g} is out of range: {}-{:02}-{:02} {:02}:{:02} UTC has no leap second", t.second, t.year,
                                  t.month, t.day, t.hour, t.minute));
    return t;
}

Result<Utc> parse_utc(std::string_view text) {
    const auto refuse = [&](std::string_view why) { return Error{"", fmt::format("\"{}\" is not a time: {}", text, why), form}; };
    Scanner scanner(text);
    Utc t;
    const auto year = scanner.digits(4);
    if (!year || !scanner.skip("-")) return refuse("it must begin with a year of four digits and '-'");
    const auto month = scanner.digits(2);
    if (!month || !scanner.skip("-")) return refuse("after the year comes a month of two digits and '-'");
    const auto day = scanner.digits(2);
    if (!day) return refuse("after the month comes a day of two digits");
    t = {*year, *month, *day, 0, 0, 0.0};
    std::optional<int> offset = 0;
    if (!scanner.empty()) {
        if (!scanner.skip("T") && !scanner.skip("t") && !scanner.skip(" ")) return refuse("between date and time stands 'T'");
        if (!read_clock(scanner, t)) return refuse("the clock is hh:mm or hh:mm:ss, with two digits each");
        offset = read_offset(scanner);
    }
    if (!offset || !scanner.empty()) return refuse("after the time comes 'Z', an offset such as +02:00, or nothing (UTC)");
    if (*offset == 0) return utc_of(t);

    // A clock ahead of UTC reads its own leap second: only the minute of UTC can tell whether it exists.
    const double second = t.second;
    t.second = 0.0;
    const Result<Utc> local = utc_of(t);
    if (!local) return local.error();
    Result<Utc> utc = after(*local, -60.0 * *offset);
    if (!utc) return utc.error();
    utc->second = second;
    return utc_of(*utc);
}

std::string utc_text(const Utc& t, int decimals) {
    assert(decimals >= 0 && decimals <= 9);
    const std::string second = fmt::format("{:012.9f}", t.second).substr(0, decimals > 0 ? 3 + static_cast<std::size_t>(decimals) : 2);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{}Z", t.year, t.month, t.day, t.hour, t.minute, second);
}

Result<Utc> after(const Utc& moment, double seconds) {
    constexpr double two_centuries = 201.0 * 366.0 * 86400.0;
    if (!(std::abs(seconds) < two_centuries)) return Error{"", fmt::format("{:g} s lead out of the years 1900 to 2100", seconds), ""};
    const int start = day_number(moment);
    const double total = second_of_day(moment) + seconds;
    int day = start + static_cast<int>(std::floor(total / 86400.0));
    double rest = total - 86400.0 * (day - start) - (leap_seconds(day) - leap_seconds(start));
    rest = std::round(rest * 1e9) * 1e-9;
    if (rest < 0.0) rest += day_length(--day);
    if (rest >= day_length(day)) rest -= day_length(day++);

    Utc t = midnight(day);
    const int minute = std::min(static_cast<int>(rest / 60.0), 1439);  // a leap second belongs to the last minute
    t.hour = minute / 60;
    t.minute = minute % 60;
    t.second = rest - 60.0 * minute;
    return utc_of(t);
}

double seconds_between(const Utc& a, const Utc& b) {
    const int first = day_number(a);
    const int last = day_number(b);
    return 86400.0 * (last - first) + (leap_seconds(last) - leap_seconds(first)) + (second_of_day(b) - second_of_day(a));
}

double day_length_s(const Utc& t) { return day_length(day_number(t)); }

int day_of_year(const Utc& t) { return day_number(t) - day_number({t.year, 1, 1, 0, 0, 0.0}) + 1; }

}  // namespace airlight
