// Laws of the figures that `make figures` draws, computed small.

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <numeric>

#include "figures/figure.h"
#include "image/png.h"
#include "tools/temporary_folder.h"
#include "units/units.h"

using namespace airlight;
using figures::Table;

namespace {

// Of one run of the tests: figures share tables of light.
const std::filesystem::path& folder() {
    static const test::TemporaryFolder made;
    return made.path;
}

Table figure(std::string_view name) {
    const figures::Figure* found = figures::find_figure(name);
    REQUIRE(found != nullptr);
    const Result<Table> table = found->make(figures::small(folder()));
    if (!table) FAIL(table.error().message());
    return *table;
}

// The luminance of each picture, [rows][columns].
std::vector<std::vector<double>> sheet(std::string_view name) {
    const Table table = figure(name);
    const std::vector<double> luminance = table.column("luminance_cd_m2");
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        if (i == 0 || table.rows[i].words[0] != table.rows[i - 1].words[0]) rows.emplace_back();
        rows.back().push_back(luminance[i]);
    }
    return rows;
}

bool falls(const std::vector<double>& values) {
    return std::adjacent_find(values.begin(), values.end(), [](double a, double b) { return !(b < a); }) == values.end();
}

void check_rises_along_rows(std::string_view name) {
    for (const std::vector<double>& row : sheet(name))
        for (std::size_t i = 1; i < row.size(); ++i) CHECK(row[i] > row[i - 1]);
}

}  // namespace

TEST_CASE("figures: the density at the mean altitude is too low and the mean of the ends too high, by twice as much on a short path") {
    // An exponential is convex: Hermite's and Hadamard's inequality; the leading errors are those of the midpoint and trapezoid rules.
    const Table table = figure("mean_density");
    const std::vector<double> exact = table.column("exact"), middle = table.column("by_mean_altitude"), ends = table.column("by_ends");
    for (std::size_t i = 0; i < exact.size(); ++i) {
        CHECK(middle[i] < exact[i]);
        CHECK(exact[i] < ends[i]);
    }
    // Over 500 m of 8400 the next terms are in proportion 1e-3.
    CHECK((ends[0] - exact[0]) / (exact[0] - middle[0]) == doctest::Approx(2.0).epsilon(2e-3));
}

TEST_CASE("figures: the standard atmosphere holds as much air as the exponential of its own scale height") {
    const Table table = figure("density_profile");
    const std::vector<double> h = table.column("altitude_km"), density = table.column("standard");
    double column = 0.0;  // to 60 km; above there are 2e-4 of it
    for (std::size_t i = 1; i < h.size(); ++i) {
        // Exponential between the samples.
        const double decay = std::log(density[i - 1] / density[i]);
        column += (h[i] - h[i - 1]) * (density[i - 1] - density[i]) / decay;
    }
    CHECK(column == doctest::Approx(table.column("same_column_scale_height_km")[0]).epsilon(0.01));
    CHECK(falls(density));
}

TEST_CASE("figures: towards the zenith Nielsen's column is exact, at the horizon it is the same at every altitude") {
    const Table table = figure("sky_columns");
    for (const char* eye : {"0km", "10km", "20km", "30km"}) {
        const std::vector<double> nielsen = table.column(std::string("nielsen_") + eye), exact = table.column(std::string("exact_") + eye);
        CHECK(nielsen.back() == doctest::Approx(exact.back()).epsilon(1e-4));
        CHECK(nielsen.front() == doctest::Approx(1.05 * 190.0));
        CHECK(falls(exact));
    }
    // A horizontal ray in exponential air: sqrt(pi H R / 2) (1 + 3 H / (8 R)), R the radius at the eye. Chapman's function, to order
    // (H / R)^2.
    const double series = std::sqrt(0.5 * pi * 10.0 * 6360.0) * (1.0 + 3.0 * 10.0 / (8.0 * 6360.0));
    CHECK(table.column("exact_0km").front() == doctest::Approx(series).epsilon(1e-3));
}

TEST_CASE("figures: each phase function integrates to one, and those of the aerosol have its mean cosine") {
    const Result<Table> table =
        figures::phase_functions({.folder = folder(), .points = 3601});  // 0.025 degrees: Mie's forward peak is narrow
    REQUIRE(bool(table));
    const std::vector<double> angle = table->column("angle_deg");
    const auto moment = [&](const char* name, int power) {
        const std::vector<double> phase = table->column(name);
        double sum = 0.0;
        for (std::size_t i = 1; i + 1 < angle.size(); ++i) {
            const double a = angle[i] * deg;
            sum += phase[i] * std::pow(std::cos(a), power) * 2.0 * pi * std::sin(a) * (angle[1] - angle[0]) * deg;
        }
        return sum;
    };
    for (const char* name : {"rayleigh", "softened_rayleigh", "henyey_greenstein_0_2", "henyey_greenstein", "cornette_shanks", "mie"})
        CHECK(moment(name, 0) == doctest::Approx(1.0).epsilon(1e-3));
    for (const char* name : {"henyey_greenstein", "cornette_shanks", "mie"})
        CHECK(moment(name, 1) == doctest::Approx(table->column("mean_cosine")[0]).epsilon(1e-3));
}

TEST_CASE("figures: the zenith darkens as the eye climbs, and the horizon that is seen does not") {
    const Table table = figure("sky_by_altitude");
    CHECK(falls(table.column("zenith_cd_m2")));
    const std::vector<double> horizon = table.column("horizon_cd_m2"), zenith = table.column("zenith_cd_m2");
    CHECK(horizon.back() > 0.5 * horizon.front());
    CHECK(zenith.back() < 1e-3 * zenith.front());
}

TEST_CASE("figures: multiple scattering adds light in every scene") { check_rises_along_rows("scattering_orders"); }

TEST_CASE("figures: with more molecules or a deeper layer of aerosol the sky is brighter") {
    check_rises_along_rows("rayleigh_coefficient");
    check_rises_along_rows("mie_scale_height");
}

TEST_CASE("figures: more aerosol makes the halo brighter, and the less so the higher the eye") {
    std::vector<double> gain;
    for (const std::vector<double>& row : sheet("mie_coefficient")) gain.push_back(row.back() / row.front());
    CHECK(falls(gain));
    CHECK(gain.back() > 1.0);
}

TEST_CASE("figures: a sheet's pictures are there, of the size that was asked for") {
    const Table table = figure("sky_from_altitudes");
    CHECK(table.rows.size() == 6);
    for (const char* name : {"sky_from_altitudes-0-0.png", "sky_from_altitudes-2-1.png"}) {
        const Result<PngLevels> picture = read_png(folder() / name);
        REQUIRE(bool(picture));
        CHECK(picture->width == 24);
    }
}

TEST_CASE("figures: a table as CSV has a line a row, and an empty cell where there is no number") {
    const Table table{{"word", "number", "none"}, {{{"a"}, {0.5, std::nan("")}}}};
    CHECK(figures::csv(table) == "word,number,none\na,0.5,\n");
}
