// Published models against the measured sky of a real day and the exact light of its air, beside what the published programs
// of the same models reach there [Kider2014; Bruneton2017]: root-mean-square differences in mW m-2 sr-1 nm-1.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "bakes.h"
#include "models/model.h"
#include "views.h"

using namespace airlight;
using truth::Row;

namespace {

struct Expected {
    const char* key;
    double measured, exact;  // of the published program
    double within;           // a fraction of these
    const char* data = "";   // a file of the folder of figures
};
// By turbidity 2.53, which was fitted to that day.
constexpr Expected expected[] = {
    {"preetham1999", 88.7, 88.2, 0.15},
    {"nishita1993", 26.5, 25.1, 0.15},
    {"oneil2005", 49.8, 48.6, 0.15},
    {"hosek2012", 41.6, 39.8, 0.15, "hosek_wilkie_2012_spectral.csv"},
};

// The published data set that a row needs, beside the folder of the other figures; empty if it needs none.
std::filesystem::path data_of(const Expected& e) { return *e.data ? truth::folder() / "../figures" / e.data : std::filesystem::path(); }

// A measured day: its sky, its air, and the exact light of that air.
struct Day {
    std::vector<Row> measured = truth::rows("measured_sky.csv"), bands = truth::rows("measured_sky_atmosphere.csv"),
                     exact = truth::rows("exact_sky.csv");
    bool absent() const {
        return truth::absent(measured, "measured_sky.csv") || truth::absent(bands, "measured_sky_atmosphere.csv") ||
               truth::absent(exact, "exact_sky.csv");
    }
    // Those that are judged: up to 720 nm.
    std::vector<Wavelength> wavelengths() const {
        std::vector<double> judged;
        for (const Row& band : bands)
            if (const double w = band["wavelength_nm"]; w <= 720.0) judged.push_back(w);
        return truth::in_nm(judged);
    }
};

double against_measured(const Sky& sky, const std::vector<Row>& rows) {
    double sum = 0.0;
    int count = 0;
    for (const Row& row : rows) {
        const RadianceEstimate seen = *sky.radiance(truth::ground_view_of(row));
        for (std::size_t w = 0; w < sky.wavelengths().size(); ++w, ++count)
            sum += std::pow(1000.0 * (seen.radiance_W_m2_sr_nm[w] - row[fmt::format("{}", sky.wavelengths()[w].in(nm))]), 2);
    }
    return std::sqrt(sum / count);
}

double against_exact(const Sky& sky, const std::vector<Row>& rows) {
    double sum = 0.0;
    for (const Row& row : rows) {
        const auto at = std::find_if(sky.wavelengths().begin(), sky.wavelengths().end(),
                                     [&](Wavelength w) { return std::abs(w.in(nm)-row["wavelength_nm"]) < 1e-6; });
        const double seen =
            sky.radiance(truth::ground_view_of(row))->radiance_W_m2_sr_nm[static_cast<std::size_t>(at - sky.wavelengths().begin())];
        sum += std::pow(1000.0 * (seen - row["radiance_W_m-2_sr-1_nm-1"]), 2);
    }
    return std::sqrt(sum / static_cast<double>(rows.size()));
}

}  // namespace

// The published program of nishita1996 is at 18.2 (15.9). Its search for the nearest of the eight directions compares with the one
// that the outer loop counts, so that the light of two of them, up and down, stands for all. With that slip (the light of the upper
// half of the sphere from above, of the lower from below, and phase functions at the directions themselves) the model here is at
// 15.6 (13.4), a trial that no test repeats; without it, at this.
constexpr Expected nearer[] = {{"nishita1996", 12.2, 10.2, 0.03}};

TEST_CASE("published models are as far from a measured sky as their published programs are") {
    const Day day;
    if (day.absent()) return;
    std::vector<Expected> all(std::begin(expected), std::end(expected));
    all.insert(all.end(), std::begin(nearer), std::end(nearer));
    for (const Expected& e : all) {
        CAPTURE(e.key);
        if (*e.data && !std::filesystem::exists(data_of(e))) {
            fmt::print("  {}: {} is absent\n", e.key, e.data);
            continue;
        }
        const auto sky = make_sky(e.key, truth::measured_sky(day.bands), day.wavelengths(), {.turbidity = 2.53, .data = data_of(e)});
        REQUIRE(sky);
        const double to_measured = against_measured(**sky, day.measured), to_exact = against_exact(**sky, day.exact);
        fmt::print("  {}: {:.1f} from the measured sky (expected {:.1f}), {:.1f} from the exact one ({:.1f})\n", e.key, to_measured,
                   e.measured, to_exact, e.exact);
        CHECK(to_measured == doctest::Approx(e.measured).epsilon(e.within));
        CHECK(to_exact == doctest::Approx(e.exact).epsilon(e.within));
    }
}

TEST_CASE("models of all orders are as near to a measured sky as the measurement allows, and nearer to the exact one") {
    struct AtMost {
        const char* key;
        double measured, exact;
    };
    // The measurement and the fit of its air are 11 apart. The published program of bruneton2008 is 3.6 from the exact sky.
    constexpr AtMost limits[] = {{"bruneton2008", 11.6, 1.5}, {"airlight", 11.6, 1.0}};
    const Day day;
    if (day.absent()) return;
    for (const AtMost& limit : limits) {
        CAPTURE(limit.key);
        const auto sky = make_sky(limit.key, truth::measured_sky(day.bands), day.wavelengths(),
                                  {.bake = truth::bake_settings(), .cache = {.enabled = false}});
        REQUIRE(sky);
        const double to_measured = against_measured(**sky, day.measured), to_exact = against_exact(**sky, day.exact);
        fmt::print("  {}: {:.2f} from the measured sky, {:.2f} from the exact one\n", limit.key, to_measured, to_exact);
        CHECK(to_measured <= limit.measured);
        CHECK(to_exact <= limit.exact);
    }
}
