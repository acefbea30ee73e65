// The sky from tables against independent figures: the exact light and the measured light of a real day, and another Monte Carlo
// on the sphere. The light version bakes small tables; `make truth` bakes those of the default sizes.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "bakes.h"
#include "views.h"

using namespace airlight;
using truth::Row;

namespace {

struct RootMeanSquare {
    double sum = 0.0;
    int count = 0;
    void add(double difference) {
        sum += difference * difference;
        ++count;
    }
    double value() const { return std::sqrt(sum / count); }
};

}  // namespace

// Of 0.23, most is the standard error of the figures; discrete ordinates are at 1.6 from them, the analytic skies at 16 to 88.
TEST_CASE("tables agree with the exact light of a measured day's air to 1 mW m-2 sr-1 nm-1") {
    const std::vector<Row> rows = truth::rows("exact_sky.csv"), bands = truth::rows("measured_sky_atmosphere.csv");
    if (truth::absent(rows, "exact_sky.csv") || truth::absent(bands, "measured_sky_atmosphere.csv")) return;
    std::set<double> distinct;
    for (const Row& row : rows) distinct.insert(row["wavelength_nm"]);
    const std::vector<double> wavelengths(distinct.begin(), distinct.end());
    const TableSky sky = truth::table_sky(truth::measured_sky(bands), truth::in_nm(wavelengths));
    RootMeanSquare difference, standard_error;
    double relative = 0.0;
    for (const Row& row : rows) {
        const auto lane = static_cast<std::size_t>(std::distance(distinct.begin(), distinct.find(row["wavelength_nm"])));
        const double theirs = row["radiance_W_m-2_sr-1_nm-1"], ours = sky.radiance(truth::ground_view_of(row))->radiance_W_m2_sr_nm[lane];
        difference.add(1000.0 * (ours - theirs));
        standard_error.add(1000.0 * row["standard_error"]);
        relative += std::abs(ours / theirs - 1.0) / static_cast<double>(rows.size());
    }
    fmt::print(
        "  exact_sky.csv: {} rows, root-mean-square difference {:.3f} mW m-2 sr-1 nm-1 (standard error of the figures {:.3f}), mean "
        "absolute deviation {:.3f} %\n",
        difference.count, difference.value(), standard_error.value(), 100.0 * relative);
    CHECK(difference.value() <= 1.0);
}

// 11 is the floor that the measurement and the fit of its aerosol set: discrete ordinates in the same air are at 11.6.
TEST_CASE("tables are as near to a measured sky as discrete ordinates are") {
    const std::vector<Row> rows = truth::rows("measured_sky.csv"), bands = truth::rows("measured_sky_atmosphere.csv");
    if (truth::absent(rows, "measured_sky.csv") || truth::absent(bands, "measured_sky_atmosphere.csv")) return;
    std::vector<double> wavelengths;
    for (std::size_t i = 0; i < bands.size(); i += truth::full() ? 1 : 2)
        if (const double w = bands[i]["wavelength_nm"]; w <= 720.0) wavelengths.push_back(w);
    const TableSky sky = truth::table_sky(truth::measured_sky(bands), truth::in_nm(wavelengths));
    RootMeanSquare all;
    std::map<std::string, RootMeanSquare> by_time;
    for (const Row& row : rows) {
        const RadianceEstimate seen = *sky.radiance(truth::ground_view_of(row));
        for (std::size_t w = 0; w < wavelengths.size(); ++w) {
            const double difference = 1000.0 * (seen.radiance_W_m2_sr_nm[w] - row[fmt::format("{}", wavelengths[w])]);
            all.add(difference);
            by_time[row.text("time")].add(difference);
        }
    }
    for (const auto& [time, one] : by_time)
        fmt::print("  measured_sky.csv: {} root-mean-square difference {:.2f} mW m-2 sr-1 nm-1\n", time, one.value());
    fmt::print("  measured_sky.csv: all times, {} values, {:.2f} mW m-2 sr-1 nm-1\n", all.count, all.value());
    CHECK(all.value() <= 11.6);
}

// Rows below 1e-6 sr-1 are too noisy to judge by. The light version judges by day and within the air, with tables in proportion.
TEST_CASE("on the sphere tables agree with another Monte Carlo, at twilight and from space") {
    const std::vector<Row> rows = truth::rows("spherical.csv");
    if (truth::absent(rows, "spherical.csv")) return;
    const TableSky sky = truth::table_sky(truth::sky(6360.0 * km), truth::in_nm(truth::sky_wavelengths_nm),
                                          truth::full() ? truth::bake_settings() : truth::light_bake(12, 24, 32));
    struct Group {
        int rows = 0;
        double square = 0.0, variance = 0.0;
    };
    std::map<std::string, Group> groups;
    int beyond = 0;
    for (const Row& row : rows) {
        const double theirs = row["radiance_per_irradiance_sr-1"], error = row["standard_error"];
        if (theirs < 1e-6 || (!truth::full() && (row["sun_zenith_deg"] > 85.0 || row["eye_altitude_m"] > 1e4))) continue;
        const double ours = sky.radiance(truth::view_of(row))->radiance_W_m2_sr_nm[truth::lane_of(row)];
        Group& group =
            groups[fmt::format("{} sun {:>4} eye {:>3} km", row.text("case"), row["sun_zenith_deg"], row["eye_altitude_m"] / 1000.0)];
        ++group.rows;
        group.square += std::pow(ours / theirs - 1.0, 2);
        group.variance += std::pow(error / theirs, 2);
        if (std::abs(ours - theirs) <= 4.0 * error + 0.01 * theirs) continue;
        ++beyond;
        fmt::print("    beyond: {}: {:.4e} against {:.4e} +- {:.1e} ({:+.2f} %)\n", truth::name_of(row), ours, theirs, error,
                   100.0 * (ours / theirs - 1.0));
    }
    for (const auto& [name, group] : groups)
        fmt::print("  {} {:>3} rows: root-mean-square deviation {:5.2f} %, standard error of the figures {:5.2f} %\n", name, group.rows,
                   100.0 * std::sqrt(group.square / group.rows), 100.0 * std::sqrt(group.variance / group.rows));
    CHECK(beyond == 0);
}
