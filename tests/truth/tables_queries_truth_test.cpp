// Any question to the sky from tables is answered by numbers: 10^7 random ones in `make truth`, 10^5 in the light version.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <random>

#include "bakes.h"
#include "core/parallel.h"

using namespace airlight;

namespace {

// Draws from the whole domain, its ends included more often than chance would.
class Draw {
public:
    explicit Draw(std::size_t seed) : engine_(seed) {}
    Length altitude(Length top) {
        switch (engine_() % 16) {
            case 0:
                return 0.0 * m;
            case 1:
                return 1e8 * m;
            case 2:
                return top;
            default:
                return std::pow(10.0, -3.0 + 11.0 * unit_(engine_)) * m;
        }
    }
    double zenith() {
        switch (engine_() % 16) {
            case 0:
                return 0.0;
            case 1:
                return pi;
            case 2:
                return 0.5 * pi;
            default:
                return std::acos(2.0 * unit_(engine_) - 1.0);
        }
    }
    // Every second view is within a degree of the horizon.
    double view_zenith(double horizon) {
        return engine_() % 2 == 0 ? zenith() : std::clamp(horizon + deg * std::pow(unit_(engine_) * 2.0 - 1.0, 5.0), 0.0, pi);
    }
    double azimuth() { return 4.0 * pi * (unit_(engine_) - 0.5); }

private:
    std::mt19937_64 engine_;
    std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

bool is_radiance(double value) { return std::isfinite(value) && value >= 0.0; }

// A batch of questions: `single` to radiance(), each from another eye, and `in_dome` to one dome.
struct Batch {
    const TableSky& sky;
    Length bottom, top;
    int single, in_dome;

    double horizon(Length altitude) const { return pi - std::asin(bottom.value / (bottom + altitude).value); }
    // How many were not answered by radiance, drawn from `seed`.
    int bad_answers(std::size_t seed) const {
        Draw draw(seed);
        int bad = 0;
        for (int i = 0; i < single; ++i) {
            const Length altitude = draw.altitude(top);
            const View view{altitude, draw.view_zenith(horizon(altitude)), draw.zenith(), draw.azimuth()};
            const auto seen = sky.radiance(view);
            const bool good = seen && std::all_of(seen->radiance_W_m2_sr_nm.begin(), seen->radiance_W_m2_sr_nm.end(), is_radiance);
            bad += good ? 0 : 1;
            if (!good)
                fmt::print("    radiance(): altitude {} m, view {}, sun {}, azimuth {} rad, seed {}\n", altitude.value, view.view_zenith,
                           view.sun_zenith, view.relative_azimuth, seed);
        }
        const Length altitude = draw.altitude(top);
        const double sun = draw.zenith();
        const auto dome = *sky.dome(altitude, sun);
        std::vector<float> seen(sky.wavelengths().size());
        for (int i = 0; i < in_dome; ++i) {
            const double view = draw.view_zenith(horizon(altitude)), azimuth = draw.azimuth();
            dome->radiance(view, azimuth, seen);
            if (std::all_of(seen.begin(), seen.end(), is_radiance)) continue;
            ++bad;
            fmt::print("    dome(): altitude {} m, view {}, sun {}, azimuth {} rad, seed {}\n", altitude.value, view, sun, azimuth, seed);
        }
        return bad;
    }
};

}  // namespace

TEST_CASE("no query of the whole domain is answered by a negative, an infinity or no number") {
    for (const char* name : {"earth-hazy", "mars"}) {
        const Atmosphere atmosphere = *preset(name);
        const TableSky sky = truth::full() ? truth::preset_sky(name)
                                           : truth::table_sky(atmosphere, truth::sixteen_wavelengths(), truth::light_bake(4, 8, 8));
        const Batch batch{sky, atmosphere.bottom_radius, atmosphere.top_altitude, truth::full() ? 10'000 : 5000,
                          truth::full() ? 90'000 : 45'000};
        std::vector<int> bad(truth::full() ? 50 : 1);
        parallel_for(bad.size(), [&](std::size_t i) { bad[i] = batch.bad_answers(20260104 + i); });
        const int sum = std::accumulate(bad.begin(), bad.end(), 0);
        fmt::print("  {}: {} queries, {} bad answers\n", name, bad.size() * static_cast<std::size_t>(batch.single + batch.in_dome), sum);
        CHECK(sum == 0);
    }
}
