// The coefficients of hosek2012 that the project ships, against the Monte Carlo of the air they were fitted to.
// What is measured: the root of the mean square of (model - truth) / truth, over directions of equal solid angle, the standard
// wavelengths, suns 5 to 90 degrees high and turbidities 2 to 6, in between and at those of the fit; the noise of the Monte Carlo taken off.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "atmosphere/presets.h"
#include "fit/truth.h"
#include "spectrum/wavelength_grid.h"

using namespace airlight;

namespace {

struct Squares {
    double sum = 0.0;
    double count = 0.0;
    void add(double model, double truth, double error) {
        if (error > 0.1 * truth) return;  // too noisy to be divided by
        sum += (std::pow(model - truth, 2) - error * error) / (truth * truth);
        count += 1.0;
    }
    double root() const { return std::sqrt(std::max(0.0, sum / count)); }
};

void add_sky(Squares& squares, const Sky& model, const Sky& truth, double elevation_deg) {
    const double sun = (90.0 - elevation_deg) * deg;
    for (const FitDirection& d : fit_directions(sun, 5, 5)) {
        if (d.weight < 1.0) continue;
        const View view{0.0 * m, d.direction.view_zenith, sun, d.direction.relative_azimuth};
        const auto fitted = model.radiance(view), there = truth.radiance(view);
        REQUIRE(fitted);
        REQUIRE(there);
        for (std::size_t w = 0; w < model.wavelengths().size(); ++w)
            squares.add(fitted->radiance_W_m2_sr_nm[w], there->radiance_W_m2_sr_nm[w], there->standard_error[w]);
    }
}

}  // namespace

TEST_CASE("the shipped coefficients of hosek2012 are within 10 % of the reference, as the published ones are of theirs") {
    const bool full = std::getenv("AIRLIGHT_TRUTH") != nullptr;
    const WavelengthGrid grid = WavelengthGrid::standard();
    ModelOptions options;
    options.reference.paths = full ? 8192 : 2048;
    for (const double turbidity : full ? std::vector<double>{2.0, 2.5, 3.0, 4.0, 4.5, 5.5, 6.0} : std::vector<double>{2.5, 6.0}) {
        Atmosphere air = *with_turbidity(*preset("earth-clear"), turbidity);
        air.ground_albedo = SpectrumOf<Number>::constant(0.3);
        const auto model = make_sky("hosek2012", air, {grid.begin(), grid.end()}, options);
        const auto truth = make_sky("reference", air, {grid.begin(), grid.end()}, options);
        REQUIRE(model);
        REQUIRE(truth);
        Squares squares;
        for (const double elevation_deg :
             full ? std::vector<double>{5.0, 7.0, 14.0, 25.0, 40.0, 60.0, 85.0} : std::vector<double>{7.0, 40.0})
            add_sky(squares, **model, **truth, elevation_deg);
        fmt::print("  turbidity {}: {:.2f} % from the reference\n", turbidity, 100.0 * squares.root());
        CHECK(squares.root() < 0.1);
    }
}
