// Weather reports: what each group means, what must parse, and what a wrong group is told.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "core/files.h"
#include "weather/humidity.h"
#include "weather/metar.h"

using namespace airlight;

namespace {

const std::filesystem::path corpus = std::filesystem::path(AIRLIGHT_SOURCE_DIR) / "tests/corpus";

std::vector<std::filesystem::path> texts_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".txt") paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

Metar parsed(std::string_view message) {
    CAPTURE(message);
    Result<Metar> metar = parse_metar(message);
    if (!metar) FAIL(metar.error().message());
    return *metar;
}

Metar kept(const char* name) { return parsed(*read_file(corpus / "metar" / (std::string(name) + ".txt"))); }

}  // namespace

TEST_CASE("every report of the corpus parses") {
    const auto paths = texts_in(corpus / "metar");
    CHECK(paths.size() >= 60);
    for (const auto& path : paths) {
        CAPTURE(path.filename().string());
        const Metar metar = parsed(*read_file(path));
        CHECK(metar.station.size() == 4);
        CHECK(
            (metar.nil || metar.visibility || !metar.directional_visibility.empty() || metar.station == "EGNM" || metar.station == "EGPC"));
    }
}

// AIRLIGHT_WRITE_EXPECTED=1 writes the texts instead; read them before committing.
TEST_CASE("every wrong report is refused with the text kept beside it") {
    const auto paths = texts_in(corpus / "metar-bad");
    CHECK(paths.size() >= 40);
    for (std::filesystem::path path : paths) {
        CAPTURE(path.filename().string());
        const Result<Metar> metar = parse_metar(*read_file(path));
        REQUIRE(!metar);
        const std::string message = metar.error().message() + "\n";
        path.replace_extension(".error");
        if (std::getenv("AIRLIGHT_WRITE_EXPECTED")) REQUIRE(write_file(path, message));
        const Result<std::string> expected = read_file(path);
        REQUIRE(expected);
        CHECK(message == *expected);
    }
}

TEST_CASE("a report's groups arrive with their units") {
    const Metar metar =
        parsed("METAR EDDF 171950Z 24015G25KT 210V270 4000 2000NE R25L/P1500N -SHRA BR FEW020 SCT045CB 18/09 Q1013 RERA NOSIG=");
    CHECK(metar.kind == ReportKind::routine);
    CHECK(metar.station == "EDDF");
    CHECK(metar.day == 17);
    CHECK(metar.hour == 19);
    CHECK(metar.minute == 50);
    CHECK(metar.wind->from_deg == 240);
    CHECK(*metar.wind->speed_mps == doctest::Approx(15 * 1852.0 / 3600.0).epsilon(1e-14));
    CHECK(*metar.wind->gust_mps == doctest::Approx(25 * 1852.0 / 3600.0).epsilon(1e-14));
    CHECK(metar.wind->varies_from_deg == 210);
    CHECK(metar.wind->varies_to_deg == 270);
    CHECK(metar.visibility == ReportedDistance{4.0 * km, Bound::exact});
    REQUIRE(metar.directional_visibility.size() == 1);
    CHECK(metar.directional_visibility[0].direction == "NE");
    CHECK(metar.directional_visibility[0].visibility.distance == 2.0 * km);
    REQUIRE(metar.runway_visual_range.size() == 1);
    CHECK(metar.runway_visual_range[0].runway == "25L");
    CHECK(metar.runway_visual_range[0].least == ReportedDistance{1.5 * km, Bound::at_least});
    CHECK(metar.runway_visual_range[0].tendency == 'N');
    REQUIRE(metar.weather.size() == 2);
    CHECK(metar.weather[0].intensity == Intensity::light);
    CHECK(metar.weather[0].descriptor == "SH");
    CHECK(metar.weather[0].has("RA"));
    CHECK(metar.weather[1].has("BR"));
    REQUIRE(metar.clouds.size() == 2);
    CHECK(metar.clouds[0].cover == Cover::few);
    CHECK(metar.clouds[0].base->in(m) == doctest::Approx(609.6).epsilon(1e-14));
    CHECK(metar.clouds[1].kind == "CB");
    CHECK(*metar.temperature_c == 18.0);
    CHECK(*metar.dew_point_c == 9.0);
    CHECK(*metar.qnh_hpa == 1013.0);
    REQUIRE(metar.recent_weather.size() == 1);
    CHECK(metar.recent_weather[0].has("RA"));
    CHECK(metar.trend == "NOSIG");
    CHECK(metar.remarks.empty());
}

TEST_CASE("visibility: metres, statute miles and fractions, with what is only a bound") {
    const auto visibility = [](std::string group) { return *parsed("METAR KSFO 171950Z 00000KT " + group + " 18/09 A2992").visibility; };
    constexpr Length mile = 1609.344 * m;
    CHECK(visibility("9999") == ReportedDistance{10.0 * km, Bound::at_least});
    CHECK(visibility("CAVOK") == ReportedDistance{10.0 * km, Bound::at_least});
    CHECK(visibility("0000") == ReportedDistance{50.0 * m, Bound::less_than});
    CHECK(visibility("0350NDV") == ReportedDistance{350.0 * m, Bound::exact});
    CHECK(visibility("3SM") == ReportedDistance{3.0 * mile, Bound::exact});
    CHECK(visibility("10SM") == ReportedDistance{10.0 * mile, Bound::at_least});
    CHECK(visibility("P6SM") == ReportedDistance{6.0 * mile, Bound::at_least});
    CHECK(visibility("1/2SM") == ReportedDistance{0.5 * mile, Bound::exact});
    CHECK(visibility("1 1/2SM") == ReportedDistance{1.5 * mile, Bound::exact});
    CHECK(visibility("2 3/4SM") == ReportedDistance{2.75 * mile, Bound::exact});
    CHECK(visibility("M1/4SM") == ReportedDistance{0.25 * mile, Bound::less_than});
    CHECK(visibility("5KM") == ReportedDistance{5.0 * km, Bound::exact});
}

TEST_CASE("a group of slashes leaves its value unset") {
    const Metar metar = kept("leeds-slashes");
    CHECK(metar.automatic);
    CHECK(!metar.wind->from_deg);
    CHECK(!metar.wind->speed_mps);
    CHECK(!metar.visibility);
    CHECK(metar.weather.empty());
    CHECK(metar.clouds.empty());
    CHECK(*metar.temperature_c == 7.0);
    CHECK(!kept("pressure-missing").qnh_hpa);
    CHECK(!kept("temperature-missing").temperature_c);
    CHECK(*kept("no-dew-point").temperature_c == 35.0);
    CHECK(!kept("no-dew-point").dew_point_c);
    const Metar clouds = kept("auto-cloud-missing");
    REQUIRE(clouds.clouds.size() == 2);
    CHECK(clouds.clouds[0].cover == Cover::not_measured);
    CHECK(clouds.clouds[0].base->in(m) == doctest::Approx(457.2).epsilon(1e-14));
    CHECK(clouds.clouds[1].kind == "CB");
    CHECK(!clouds.clouds[1].base);
}

TEST_CASE("the remarks refine temperature and pressure, and are kept") {
    const Metar metar = kept("san-francisco");
    CHECK(*metar.temperature_c == 17.2);
    CHECK(*metar.dew_point_c == 11.1);
    CHECK(*metar.sea_level_pressure_hpa == doctest::Approx(1016.2).epsilon(1e-14));
    CHECK(*metar.qnh_hpa == doctest::Approx(1016.26).epsilon(1e-5));  // 30.01 inHg
    CHECK(metar.remarks == "AO2 SLP162 T01720111");
    CHECK(*kept("fairbanks-cold").temperature_c == -40.6);
    CHECK(*parsed("METAR KSFO 171950Z 10SM 18/09 A2992 RMK SLP987").sea_level_pressure_hpa == doctest::Approx(998.7).epsilon(1e-14));
}

TEST_CASE("present weather: intensity, descriptor and phenomena of code table 4678") {
    const PresentWeather storm = kept("denver-thunder").weather.at(0);
    CHECK(storm.intensity == Intensity::heavy);
    CHECK(storm.descriptor == "TS");
    CHECK(storm.phenomena == std::vector<std::string>{"RA", "GR"});
    CHECK(kept("oklahoma-tornado").weather.at(0).has("FC"));
    CHECK(kept("johannesburg-storm").weather.at(0).intensity == Intensity::vicinity);
    CHECK(kept("fairbanks-cold").clouds.at(0).cover == Cover::sky_obscured);
    for (const char* code : {"MI", "BC", "PR", "DR", "BL", "SH", "TS", "FZ", "DZ", "RA", "SN", "SG", "IC", "PL", "GR",
                             "GS", "UP", "BR", "FG", "FU", "VA", "DU", "SA", "HZ", "PY", "PO", "SQ", "FC", "SS", "DS"}) {
        CAPTURE(code);
        CHECK(!weather_meaning(code).empty());
    }
    CHECK(weather_meaning("XX").empty());
    CHECK(weather_meaning("FU") == "smoke");
}

TEST_CASE("a missing report and a corrected one say so") {
    CHECK(kept("nil-report").nil);
    CHECK(kept("cor-after-type").corrected);
    CHECK(kept("cor-after-time").corrected);
    CHECK(kept("toronto-correction").corrected);
    CHECK(kept("speci-short").kind == ReportKind::special);
    CHECK(kept("madrid-haze").no_cloud == "NSC");
    CHECK(kept("over-scale-wind").wind->speed_at_least);
    CHECK(kept("resolute-blizzard").runway_visual_range.at(0).tendency == 'D');
    CHECK(kept("resolute-blizzard").runway_visual_range.at(0).least->distance.in(m) == doctest::Approx(304.8).epsilon(1e-14));
    CHECK(kept("istanbul-shear").supplementary == std::vector<std::string>{"WS RWY35L"});
}

// The psychrometric tables of the WMO guide: 23.37 hPa at 20 deg C, 6.11 at 0, 42.43 at 30; the form is within 0.3 %.
TEST_CASE("humidity: saturation pressure is the tables' and grows, air at its dew point is saturated") {
    CHECK(saturation_vapour_pressure_hpa(20.0) == doctest::Approx(23.37).epsilon(0.003));
    CHECK(saturation_vapour_pressure_hpa(0.0) == doctest::Approx(6.112).epsilon(0.003));
    CHECK(saturation_vapour_pressure_hpa(30.0) == doctest::Approx(42.43).epsilon(0.003));
    for (double t = -45.0; t < 60.0; t += 0.5) CHECK(saturation_vapour_pressure_hpa(t) < saturation_vapour_pressure_hpa(t + 0.5));
    CHECK(relative_humidity(18.0, 18.0) == 1.0);
    CHECK(relative_humidity(18.0, 19.0) == 1.0);
    CHECK(relative_humidity(20.0, 9.27) == doctest::Approx(0.5).epsilon(0.003));  // the dew point of half-saturated air at 20 deg C
    CHECK(!relative_humidity(kept("no-dew-point")));
    CHECK(*relative_humidity(kept("paris-fog")) == 1.0);
}
