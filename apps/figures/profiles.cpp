// Densities by altitude and along paths. [Nielsen2003, fig. 5.2 to 5.4, C.1]

#include <cmath>
#include <vector>

#include "atmosphere/constituents.h"
#include "atmosphere/model_atmosphere.h"
#include "figure.h"
#include "physics/models/f64.h"
#include "transport/ray_nodes.h"

namespace airlight::figures {

namespace {

// Of the Earth's air by eq. 5.9 of the thesis, and of its zenith column by eq. 5.10.
constexpr double scale_height_m = 8400.0;
constexpr double column_scale_height_m = 10000.0;

double exponential(double altitude_m, double scale_m) {
    return f64::exponential_density(f64::Length::of(altitude_m), f64::Length::of(scale_m)).value;
}

// The integral of an exponential density between two altitudes, over their distance.
double mean_exponential(double low_m, double high_m, double scale_m) {
    return scale_m * (exponential(low_m, scale_m) - exponential(high_m, scale_m)) / (high_m - low_m);
}

// Columns out of air whose density falls exponentially, around a sphere, in km.
class ExactColumns {
public:
    explicit ExactColumns(double scale_m) : densities_(std::vector<DensityProfile>{ExponentialProfile{scale_m * m}}, top_m * m) {}

    double column_km(double altitude_m, double mu) const {
        RayNodes nodes;
        sample_ray({.bottom_m = 6360e3, .top_m = top_m}, {.altitude_m = altitude_m, .mu = mu, .mu_s = 1.0, .nu = mu}, densities_, {},
                   RayNodes::max_per_piece, nodes);
        return 1e-3 * nodes.total_column_m[0];
    }

private:
    static constexpr double top_m = 200e3;
    DensityTable densities_;
};

}  // namespace

Result<Table> density_profile(const Settings& settings) {
    const Result<std::span<const AirLevel>> levels = model_atmosphere("us_standard");
    if (!levels) return levels.error();
    const GasProfile air = gas_profile(*levels, Gas::air);
    const double column_m = column_depth(air.profile, 120.0 * km).in(m);
    Table table{{"altitude_km", "standard", "exponential_8_4km", "exponential_10km", "same_column_scale_height_km"}, {}};
    for (int i = 0; i < settings.points; ++i) {
        const double h = 60e3 * i / (settings.points - 1);
        table.rows.push_back({{},
                              {1e-3 * h, relative_density(air.profile, h * m), exponential(h, scale_height_m),
                               exponential(h, column_scale_height_m), 1e-3 * column_m}});
    }
    return table;
}

Result<Table> mean_density(const Settings& settings) {
    const double object_m = 1500.0;  // the thesis' point on the ground below the eye
    f64::ExponentialAir air{};
    air.air_scale_height = f64::Length::of(scale_height_m);
    air.aerosol_scale_height = f64::Length::of(scale_height_m);
    Table table{{"eye_km", "exact", "by_mean_altitude", "by_ends"}, {}};
    for (int i = 0; i < settings.points; ++i) {
        const double eye_m = 2000.0 + 28000.0 * i / (settings.points - 1);
        const f64::Length from = f64::Length::of(eye_m), to = f64::Length::of(object_m), distance = f64::Length::of(eye_m - object_m);
        table.rows.push_back({{},
                              {1e-3 * eye_m, mean_exponential(object_m, eye_m, scale_height_m),
                               (f64::nielsen2003_by_altitude(air, from, to, distance).air / distance).value,
                               (f64::nielsen2003_by_ends(air, from, to, distance).air / distance).value}});
    }
    return table;
}

Result<Table> sky_columns(const Settings& settings) {
    constexpr double eyes_km[] = {0.0, 10.0, 20.0, 30.0};
    const ExactColumns exact(column_scale_height_m);
    Table table{{"sine_of_elevation", "parameter", "nielsen_0km", "nielsen_10km", "nielsen_20km", "nielsen_30km", "exact_0km", "exact_10km",
                 "exact_20km", "exact_30km"},
                {}};
    for (int i = 0; i < settings.points; ++i) {
        // Dense at the horizon, where columns change fast.
        const double t = static_cast<double>(i) / (settings.points - 1), mu = t * t;
        std::vector<double> row = {mu, std::pow(mu, 0.2)};
        for (const double eye : eyes_km)
            row.push_back(
                1e-3 *
                f64::nielsen2003_sky_column(f64::Length::of(column_scale_height_m), f64::Length::of(1e3 * eye), f64::Number(mu)).value);
        for (const double eye : eyes_km) row.push_back(exact.column_km(1e3 * eye, mu));
        table.rows.push_back({{}, std::move(row)});
    }
    return table;
}

}  // namespace airlight::figures
