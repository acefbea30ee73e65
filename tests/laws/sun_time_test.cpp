// Time in text, and the calendar with its leap seconds.

#include <doctest/doctest.h>

#include <random>

#include "sun/time.h"
#include "sun/time_scales.h"

using namespace airlight;

TEST_CASE("a time reads the same in every form of ISO 8601 that says it") {
    const Utc expected{2003, 10, 17, 19, 30, 30.0};
    for (const char* text : {"2003-10-17T19:30:30Z", "2003-10-17T12:30:30-07:00", "2003-10-17T12:30:30-0700", "2003-10-17T12:30:30-07",
                             "2003-10-17 19:30:30", "2003-10-18T01:00:30+05:30", "2003-10-17t19:30:30.0z"}) {
        CAPTURE(text);
        CHECK(*parse_utc(text) == expected);
    }
    CHECK(*parse_utc("2003-10-17") == Utc{2003, 10, 17, 0, 0, 0.0});
    CHECK(*parse_utc("2004-02-29T23:59") == Utc{2004, 2, 29, 23, 59, 0.0});
    CHECK(*parse_utc("2000-01-01T00:30+01:00") == Utc{1999, 12, 31, 23, 30, 0.0});
}

TEST_CASE("second 60 exists in a leap second only, on any clock") {
    CHECK(*parse_utc("2016-12-31T23:59:60Z") == Utc{2016, 12, 31, 23, 59, 60.0});
    CHECK(*parse_utc("2017-01-01T00:59:60+01:00") == Utc{2016, 12, 31, 23, 59, 60.0});
    CHECK(parse_utc("2016-12-31T23:59:60.999Z"));
    CHECK(!parse_utc("2015-12-31T23:59:60Z"));
    CHECK(!parse_utc("2016-12-31T23:59:61Z"));
    CHECK(!parse_utc("2016-12-31T12:00:60Z"));
    CHECK(day_length_s({2016, 12, 31, 0, 0, 0.0}) == 86401.0);
    CHECK(day_length_s({2017, 1, 1, 0, 0, 0.0}) == 86400.0);
    CHECK(day_length_s({1965, 7, 31, 0, 0, 0.0}) == 86400.0);
    CHECK(*after({2016, 12, 31, 23, 59, 59.5}, 1.0) == Utc{2016, 12, 31, 23, 59, 60.5});
    CHECK(*after({2016, 12, 31, 23, 59, 59.5}, 2.0) == Utc{2017, 1, 1, 0, 0, 0.5});
    CHECK(*after({2017, 1, 1, 0, 0, 0.5}, -2.0) == Utc{2016, 12, 31, 23, 59, 59.5});
    CHECK(seconds_between({1972, 1, 1, 0, 0, 0.0}, {2017, 1, 1, 0, 0, 0.0}) == 16437 * 86400.0 + 27.0);  // 27 so far
}

TEST_CASE("what is no time is refused with the rule and the right form") {
    const auto says = [](const char* text, const char* rule) {
        CAPTURE(text);
        const Result<Utc> time = parse_utc(text);
        REQUIRE(!time);
        CHECK(time.error().message().find(rule) != std::string::npos);
        CHECK(time.error().message().find("2003-10-17T19:30:30Z") != std::string::npos);
    };
    says("", "begin with a year");
    says("noon", "begin with a year");
    says("2003/10/17", "begin with a year");
    says("03-10-17", "begin with a year");
    says("2003-1-17", "month of two digits");
    says("2003-10-7", "day of two digits");
    says("2003-10-17X19:30", "stands 'T'");
    says("2003-10-17T1930", "hh:mm");
    says("2003-10-17T19:30:3", "hh:mm");
    says("2003-10-17T19:30:30.Z", "hh:mm");
    says("2003-10-17T19:30:30 PST", "comes 'Z'");
    says("2003-10-17T19:30:30+25:00", "comes 'Z'");
    says("2003-10-17T19:30:30Z!", "comes 'Z'");
    says("1899-12-31T00:00Z", "1900 to 2100");
    says("2101-01-01", "1900 to 2100");
    says("2003-13-17", "month 13");
    says("2003-02-29", "day 29 is out of range: 2003-02 has 1 to 28");
    says("2100-02-29", "1 to 28");
    says("2003-10-17T24:00Z", "hour 24");
    says("2003-10-17T12:60Z", "minute 60");
    says("2003-10-17T12:30:60Z", "no leap second");
    says("1900-01-01T00:30+01:00", "1900 to 2100");
}

TEST_CASE("a written time reads back, and moments add up") {
    std::mt19937_64 random(20031017);
    std::uniform_real_distribution<double> seconds(0.0, 200.9 * 365.25 * 86400.0);
    const Utc start{1900, 1, 1, 0, 0, 0.0};
    for (int i = 0; i < 2000; ++i) {
        const double elapsed = std::floor(seconds(random) * 1e3) / 1e3;
        const Utc t = *after(start, elapsed);
        // Nine decimals of a second below 6.4e9 s: a double there has steps of 1e-6 s.
        CHECK(std::abs(seconds_between(start, t) - elapsed) < 2e-6);
        CHECK(std::abs(seconds_between(t, *parse_utc(utc_text(t, 9)))) < 2e-9);
        CHECK(parse_utc(utc_text(t)));
    }
    CHECK(utc_text({2003, 10, 17, 19, 30, 30.9}) == "2003-10-17T19:30:30Z");
    CHECK(utc_text({2003, 10, 17, 19, 30, 5.25}, 1) == "2003-10-17T19:30:05.2Z");
    CHECK(!after(start, -1.0));
    CHECK(!after(start, std::nan("")));
    CHECK(!after(start, 1e300));
    CHECK(day_of_year({2000, 12, 31, 0, 0, 0.0}) == 366);
    CHECK(day_of_year({2003, 1, 1, 23, 0, 0.0}) == 1);
}

TEST_CASE("TT runs on without a jump where the sources of Delta T change") {
    const auto delta_t = [](const Utc& t) {
        const TimeScales s = time_scales(t, 0.0);
        return ((s.tt.first - s.ut1.first) + (s.tt.second - s.ut1.second)) * 86400.0;
    };
    CHECK(std::abs(delta_t({1959, 12, 31, 23, 59, 59.0}) - delta_t({1960, 1, 1, 0, 0, 0.0})) < 0.6);  // |UT1 - UTC| of 1960
    CHECK(delta_t({2000, 1, 1, 12, 0, 0.0}) == doctest::Approx(64.184).epsilon(1e-6));
    CHECK(delta_t({2016, 12, 31, 23, 59, 60.5}) == doctest::Approx(68.184).epsilon(1e-6));
    CHECK(std::abs(delta_t_before_utc(1920.0 - 1e-6) - delta_t_before_utc(1920.0)) < 0.2);
    CHECK(std::abs(delta_t_before_utc(1941.0 - 1e-6) - delta_t_before_utc(1941.0)) < 0.2);
    CHECK(std::abs(delta_t_before_utc(1900.0) + 2.8) < 0.1);   // observed: -2.8 s
    CHECK(std::abs(delta_t_before_utc(1950.0) - 29.1) < 0.1);  // observed: 29.1 s
}
