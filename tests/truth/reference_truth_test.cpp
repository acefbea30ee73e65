// The Monte Carlo reference against independent programs: discrete ordinates in the flat limit, another Monte Carlo on the
// sphere, and the exact light of a real day's air. Each case prints its figures.
// The light version takes every n-th row; `make truth` takes all rows, with more paths.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "views.h"

using namespace airlight;
using truth::absent;
using truth::in_nm;
using truth::lane_of;
using truth::name_of;
using truth::Row;
using truth::view_of;

namespace {

// The deviation of our figures from others', row by row.
struct Comparison {
    int rows = 0, beyond = 0;
    double sum_deviation = 0.0, sum_chi_square = 0.0, worst_excess = 0.0, sum_standard_error = 0.0;
    std::string worst_row;

    // `sigmas` standard errors and one in a hundred are allowed.
    void add(const std::string& name, double ours, double our_error, double theirs, double their_error, double sigmas) {
        const double error = std::hypot(our_error, their_error);
        const double excess = (std::abs(ours - theirs) - 0.01 * theirs) / error;
        ++rows;
        sum_deviation += std::abs(ours / theirs - 1.0);
        sum_standard_error += error / theirs;
        sum_chi_square += (ours - theirs) * (ours - theirs) / (error * error);
        if (excess > sigmas) {
            ++beyond;
            fmt::print("    beyond: {}: {:.5e} +- {:.1e} against {:.5e} +- {:.1e} ({:+.2f} %)\n", name, ours, our_error, theirs,
                       their_error, 100.0 * (ours / theirs - 1.0));
        }
        if (excess > worst_excess) {
            worst_excess = excess;
            worst_row = name;
        }
    }
    void print(const char* what) const {
        fmt::print(
            "  {}: {} rows, mean absolute deviation {:.3f} %, mean standard error {:.3f} %, chi-square per row {:.3f}, beyond the bound "
            "{}\n",
            what, rows, 100.0 * sum_deviation / rows, 100.0 * sum_standard_error / rows, sum_chi_square / rows, beyond);
    }
};

double angle_to_sun(const Row& row) {
    const double v = row["view_zenith_deg"] * deg, s = row["sun_zenith_deg"] * deg, a = row["relative_azimuth_deg"] * deg;
    return std::acos(std::clamp(std::cos(v) * std::cos(s) + std::sin(v) * std::sin(s) * std::cos(a), -1.0, 1.0)) / deg;
}

// Rows of the three skies with the same geometry are wavelengths of one estimate; slabs are one each.
std::map<std::string, std::vector<const Row*>> by_geometry(const std::vector<Row>& rows) {
    std::map<std::string, std::vector<const Row*>> groups;
    for (const Row& row : rows)
        groups[row.text("case").starts_with("sky") ? fmt::format("{} {} {} {}", row["sun_zenith_deg"], row["eye_altitude_m"],
                                                                 row["view_zenith_deg"], row["relative_azimuth_deg"])
                                                   : name_of(row)]
            .push_back(&row);
    return groups;
}

}  // namespace

TEST_CASE("in the flat limit the reference agrees with discrete ordinates") {
    const std::vector<Row> rows = truth::rows("plane_parallel.csv");
    if (absent(rows, "plane_parallel.csv")) return;
    const Length radius = 1e11 * m;
    constexpr std::int64_t paths = 16384;
    const std::size_t stride = truth::full() ? 1 : 13;
    const std::map<std::string, std::vector<const Row*>> geometries = by_geometry(rows);
    const Reference skies = *Reference::of(truth::sky(radius), in_nm(truth::sky_wavelengths_nm));
    std::map<std::string, Reference> slabs;
    Comparison all, near_sun;
    std::size_t index = 0;
    for (const auto& [key, group] : geometries) {
        if (index++ % stride != 0) continue;
        const Row& first = *group.front();
        const bool sky = first.text("case").starts_with("sky");
        if (!sky && !slabs.contains(first.text("case")))
            slabs.emplace(first.text("case"),
                          *Reference::of(truth::slab(first.text("case"), first["ground_albedo"], radius), {550.0 * nm}));
        const Reference& reference = sky ? skies : slabs.at(first.text("case"));
        const RadianceEstimate estimate = *reference.radiance(view_of(first), {.paths = paths, .seed = 20260101 + index});
        for (const Row* row : group) {
            const std::size_t lane = lane_of(*row);
            (angle_to_sun(*row) < 3.0 ? near_sun : all)
                .add(name_of(*row), estimate.radiance_W_m2_sr_nm[lane], estimate.standard_error[lane],
                     (*row)["radiance_per_irradiance_sr-1"], 0.0, 4.5);
        }
    }
    all.print("plane_parallel.csv");
    if (near_sun.rows > 0) near_sun.print("  within 3 degrees of the sun (not judged)");
    CHECK(all.sum_deviation / all.rows <= 0.005);
    CHECK(all.beyond == 0);
}

TEST_CASE("on the sphere the reference agrees with another Monte Carlo, at twilight and from space") {
    const std::vector<Row> rows = truth::rows("spherical.csv");
    if (absent(rows, "spherical.csv")) return;
    const std::int64_t paths = truth::full() ? 65536 : 8192;
    const Reference skies = *Reference::of(truth::sky(6360.0 * km), in_nm(truth::sky_wavelengths_nm));
    const std::map<std::string, std::vector<const Row*>> geometries = by_geometry(rows);
    Comparison all, dark;
    std::size_t index = 0;
    for (const auto& [key, group] : geometries) {
        if (index++ % (truth::full() ? 1 : 5) != 0) continue;
        const RadianceEstimate estimate = *skies.radiance(view_of(*group.front()), {.paths = paths, .seed = 7 + index});
        for (const Row* row : group) {
            const std::size_t lane = lane_of(*row);
            ((*row)["radiance_per_irradiance_sr-1"] < 1e-6 ? dark : all)
                .add(name_of(*row), estimate.radiance_W_m2_sr_nm[lane], estimate.standard_error[lane],
                     (*row)["radiance_per_irradiance_sr-1"], (*row)["standard_error"], 4.0);
        }
    }
    all.print("spherical.csv");
    if (dark.rows > 0) dark.print("  below 1e-6 sr-1 (not judged)");
    CHECK(all.beyond == 0);
    // The light version has so few rows that chance alone would move this by a sixth.
    if (truth::full()) CHECK(all.sum_chi_square / all.rows <= 1.3);
}

TEST_CASE("the reference agrees with the exact light of a measured day's air") {
    const std::vector<Row> rows = truth::rows("exact_sky.csv");
    const std::vector<Row> bands = truth::rows("measured_sky_atmosphere.csv");
    if (absent(rows, "exact_sky.csv") || absent(bands, "measured_sky_atmosphere.csv")) return;
    std::vector<double> wavelengths;
    for (const Row& row : rows)
        if (std::find(wavelengths.begin(), wavelengths.end(), row["wavelength_nm"]) == wavelengths.end())
            wavelengths.push_back(row["wavelength_nm"]);
    const Reference reference = *Reference::of(truth::measured_sky(bands), in_nm(wavelengths));
    std::map<std::string, std::vector<const Row*>> geometries;
    for (const Row& row : rows)
        geometries[fmt::format("{} {} {}", row.text("time"), row["view_zenith_deg"], row["view_azimuth_deg"])].push_back(&row);
    Comparison all;
    double sum_square = 0.0;
    std::size_t index = 0;
    for (const auto& [key, group] : geometries) {
        if (index++ % (truth::full() ? 1 : 5) != 0) continue;
        const Row& first = *group.front();
        const RadianceEstimate estimate =
            *reference.radiance(truth::ground_view_of(first), {.paths = truth::full() ? 65536 : 8192, .seed = 11 + index});
        for (const Row* row : group) {
            const std::size_t lane =
                static_cast<std::size_t>(std::find(wavelengths.begin(), wavelengths.end(), (*row)["wavelength_nm"]) - wavelengths.begin());
            const double theirs = (*row)["radiance_W_m-2_sr-1_nm-1"];
            all.add(key, estimate.radiance_W_m2_sr_nm[lane], estimate.standard_error[lane], theirs, (*row)["standard_error"], 4.0);
            sum_square += std::pow(estimate.radiance_W_m2_sr_nm[lane] - theirs, 2);
        }
    }
    all.print("exact_sky.csv");
    fmt::print("  root-mean-square difference {:.3f} mW m-2 sr-1 nm-1\n", 1000.0 * std::sqrt(sum_square / all.rows));
    CHECK(all.sum_chi_square / all.rows <= 1.3);
}
