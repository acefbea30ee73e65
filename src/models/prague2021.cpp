// prague2021: a fitted model of the sky from the ground to 15 km, past sunset, with polluted air. [Wilkie2021]
//
//   computes     spectral radiance as sums of products of functions of the angle from the sun and of the zenith angle (after sunset,
//                of the angle from the planet's shadow), linear between visibilities, albedos, altitudes and elevations; transmittance
//                from its own tables. Channels are steps in wavelength (40 nm in the published set), not interpolated, as published
//   leaves out   views below the horizontal; polarisation, which the data set may hold; the sun's own spectrum (radiances are
//                absolute, of the data's sun)
//   parameters   data: the authors' data set (prague2021_data.h), which is not shipped; the visibility (meteorological range, contrast
//                0.02) on the ground at 550 nm (20 to 131.8 km in the published set) and the ground's albedo from the atmosphere; the
//                eye 0 to 15 km; the sun to 94.2 deg from the zenith. The eye is taken 50 m higher than it is, as published
//   cost         the data of two visibilities is read and kept; sixteen sums a wavelength
//   reference    no text: the tables are too large for a picture's pass
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/list.h"
#include "models/prague2021_data.h"
#include "optics/aerosol_laws.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "prague2021",
                         .paper = "Wilkie2021",
                         .scattering = "fitted to all orders",
                         .approach = "tensor products in angles around the sun and the zenith, by altitude and visibility",
                         .precomputation = "none: a data set of its authors is read",
                         .memory = "two visibilities of the data set",
                         .highest_eye = 15.0 * km,
                         .highest_sun_zenith_deg = 94.2,
                         .highest_view_zenith_deg = 90.0};

// Of the model's own planet. [Wilkie2021]
constexpr double radius_m = 6378000.0;
constexpr double air_m = 100000.0;
constexpr double lift_m = 50.0;                   // of the eye
constexpr double longest_arc_m = 1571524.413613;  // on the ground, from the eye to below where a level ray leaves the air

// A place between the values of an axis, held to its ends.
struct Between {
    std::size_t low, high;
    double weight;  // of high
};
Between between_on(const std::vector<double>& axis, double x) {
    const double held = std::clamp(x, axis.front(), axis.back());
    const auto above = static_cast<std::size_t>(std::upper_bound(axis.begin() + 1, axis.end(), held) - axis.begin());
    if (axis.size() == 1 || above == axis.size()) return {axis.size() - 1, axis.size() - 1, 0.0};
    return {above - 1, above, (held - axis[above - 1]) / (axis[above] - axis[above - 1])};
}

// The angles that the model sees a direction by.
struct Angles {
    double from_sun;
    double zenith;  // such that the horizon of a high eye is at 90 degrees
    double shadow;  // from the direction of the planet's shadow
};

Angles angles_of(const View& view) {
    const double distance = radius_m + view.altitude.value + lift_m;
    const double lift = std::sqrt(distance * distance - radius_m * radius_m) / distance;
    const double up = std::cos(view.view_zenith) + lift, side = std::sin(view.view_zenith);
    const double length = std::hypot(up, side);
    // The shadow's direction stands a right angle beyond the sun, over the zenith.
    const double along = side * std::cos(view.relative_azimuth), elevation = pi - view.sun_zenith;
    const double cosine = (along * std::cos(elevation) + up * std::sin(elevation)) / length;
    return {std::acos(view_sun_cosine(view)), std::acos(std::clamp(up / length, -1.0, 1.0)), std::acos(std::clamp(cosine, -1.0, 1.0))};
}

class Prague2021 : public PublishedSky {
public:
    Prague2021(const ModelCard& of_data, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, Prague2021Data data,
               double visibility_km)
        : PublishedSky(of_data, atmosphere, std::move(wavelengths)), data_(std::move(data)), visibility_km_(visibility_km) {}

    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override {
        if (const Result<Done> ok = within_range({altitude, view_zenith, 0.0, 0.0}); !ok) return ok.error();
        const Cell cell = cell_of(altitude.value + lift_m, view_zenith, distance.value);
        const Between v = between_on(data_.transmittance.visibilities_km, visibility_km_),
                      h = between_on(data_.transmittance.altitudes_m, altitude.value + lift_m);
        std::vector<double> seen;
        for (const Wavelength w : wavelengths()) {
            const std::size_t channel = channel_of(w);
            const auto at = [&](std::size_t visibility) {
                return std::lerp(root(visibility, h.low, cell, channel), root(visibility, h.high, cell, channel), h.weight);
            };
            const double r = std::lerp(at(v.low), at(v.high), v.weight);
            seen.push_back(std::min(1.0, r * r));
        }
        return seen;
    }

private:
    std::size_t channel_of(Wavelength w) const {
        return static_cast<std::size_t>((w.in(nm)-data_.radiance.first_nm) / data_.radiance.width_nm);
    }

    std::vector<double> sky_radiance(const View& view) const override {
        const Prague2021Radiance& r = data_.radiance;
        const Angles angles = angles_of(view);
        const double elevation_deg = 90.0 - view.sun_zenith / deg;
        const Between sun = between_on(r.sun_breaks, angles.from_sun),
                      zenith = between_on(r.zenith_breaks, elevation_deg < 0.0 ? angles.shadow : angles.zenith),
                      emphasis = between_on(r.emphasis_breaks, angles.zenith);
        const Between axes[4] = {between_on(r.visibilities_km, visibility_km_),
                                 {},
                                 between_on(r.altitudes_m, view.altitude.value + lift_m),
                                 between_on(r.elevations_deg, elevation_deg)};
        std::vector<double> seen;
        for (const Wavelength w : wavelengths()) {
            const Between albedo = between_on(r.albedos, atmosphere().ground_albedo.at(w).value);
            double sum = 0.0;
            for (int corner = 0; corner < 16; ++corner) {
                std::size_t place[4];
                double weight = 1.0;
                for (int i = 0; i < 4; ++i) {
                    const Between& axis = i == 1 ? albedo : axes[i];
                    const bool high = ((corner >> i) & 1) != 0;
                    place[i] = high ? axis.high : axis.low;
                    weight *= high ? axis.weight : 1.0 - axis.weight;
                }
                if (weight > 0.0) sum += weight * products(place, channel_of(w), sun, zenith, emphasis);
            }
            seen.push_back(sum);
        }
        return seen;
    }

    // At one visibility, albedo, altitude and elevation of the data.
    double products(const std::size_t (&place)[4], std::size_t channel, const Between& sun, const Between& zenith,
                    const Between& emphasis) const {
        const Prague2021Radiance& r = data_.radiance;
        const std::size_t configuration =
            (((place[0] * r.albedos.size() + place[1]) * r.altitudes_m.size() + place[2]) * r.elevations_deg.size() + place[3]) *
                static_cast<std::size_t>(r.channels) +
            channel;
        const float* c = &r.data[configuration * r.coefficients()];
        const auto at = [](const float* of, const Between& b) { return std::lerp(double{of[b.low]}, double{of[b.high]}, b.weight); };
        double sum = 0.0;
        for (int i = 0; i < r.rank; ++i, c += r.sun_breaks.size() + r.zenith_breaks.size())
            sum += at(c, sun) * at(c + r.sun_breaks.size(), zenith);
        return std::max(0.0, sum * at(c, emphasis));
    }

    // Where a way ends, on the grid of the transmittance: by altitude and by the arc on the ground.
    struct Cell {
        Between altitude, distance;
    };

    Cell cell_of(double altitude_m, double zenith, double distance_m) const {
        const double start = radius_m + altitude_m, mu = std::cos(zenith);
        const double edge = radius_m + air_m;
        const double to_edge = std::sqrt(edge * edge - start * start * (1.0 - mu * mu)) - start * mu;
        const double way = std::min(to_edge, distance_m);
        const double x = way * std::sin(zenith), y = start + way * mu, r = std::hypot(x, y);
        const double altitude = std::cbrt(std::clamp((r - radius_m) / air_m, 0.0, 1.0));
        const double arc = std::min(1.0, std::pow(std::atan2(x, y) * radius_m / longest_arc_m, 0.25));
        return {on_grid(altitude, data_.transmittance.grid_altitudes, 3), on_grid(arc, data_.transmittance.distances, 4)};
    }

    // The grid is even in a root; between its lines the quantity itself is even.
    static Between on_grid(double value, int count, int power) {
        const int low = std::min(static_cast<int>(value * count), count - 1);
        if (low == count - 1) return {static_cast<std::size_t>(low), static_cast<std::size_t>(low), 0.0};
        const double from = std::pow(static_cast<double>(low) / count, power), to = std::pow((low + 1.0) / count, power);
        const double weight = std::clamp((std::pow(value, power) - from) / (to - from), 0.0, 1.0);
        return {static_cast<std::size_t>(low), static_cast<std::size_t>(low) + 1, weight};
    }

    // The root of a transmittance, which the data holds.
    double root(std::size_t visibility, std::size_t altitude, const Cell& cell, std::size_t channel) const {
        const Prague2021Transmittance& t = data_.transmittance;
        const auto rank = static_cast<std::size_t>(t.rank);
        const float* v =
            &t.v[((visibility * t.altitudes_m.size() + altitude) * static_cast<std::size_t>(data_.radiance.channels) + channel) * rank];
        const auto at = [&](std::size_t a, std::size_t d) {
            const float* u =
                &t.u[((altitude * static_cast<std::size_t>(t.distances) + d) * static_cast<std::size_t>(t.grid_altitudes) + a) * rank];
            double sum = 0.0;
            for (std::size_t i = 0; i < rank; ++i) sum += double{u[i]} * double{v[i]};
            return sum;
        };
        const auto along = [&](std::size_t a) {
            return std::max(0.0, std::lerp(at(a, cell.distance.low), at(a, cell.distance.high), cell.distance.weight));
        };
        return std::lerp(along(cell.altitude.low), along(cell.altitude.high), cell.altitude.weight);
    }

    Prague2021Data data_;
    double visibility_km_;
};

// The card with what this data set can answer.
ModelCard card_of(const Prague2021Radiance& data) {
    ModelCard c = card;
    c.highest_eye = data.altitudes_m.back() * m;
    c.highest_sun_zenith_deg = 90.0 - data.elevations_deg.front();
    return c;
}

// Koschmieder's, on the ground at 550 nm.
double visibility_km(const Atmosphere& atmosphere) {
    InverseLength extinction = 0.0 * per_m;
    for (const Constituent& c : atmosphere.constituents) {
        const double density = relative_density(c.profile, 0.0 * m);
        extinction += density * (c.scattering.at(550.0 * nm) + c.absorption.at(550.0 * nm));
    }
    return extinction > 0.0 * per_m ? visibility_of_extinction(extinction, range_contrast).in(km) : 1e9;
}

Result<Done> covers(const Prague2021Radiance& data, std::span<const Wavelength> wavelengths) {
    const double last = data.first_nm + data.channels * data.width_nm;
    for (const Wavelength w : wavelengths)
        if (!(w.in(nm) >= data.first_nm && w.in(nm) < last))
            return Error{std::string(card.key),
                         fmt::format("does not answer {:g} nm: its data is for {:g} to {:g} nm", w.in(nm), data.first_nm, last),
                         "Choose wavelengths within, as --wavelengths 360:720:10."};
    return Done{};
}

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    if (options.data.empty())
        return Error{std::string(card.key), "has no data of its own: it needs the data set of its authors",
                     "Give its .dat file by --data <file>."};
    const double visibility = visibility_km(atmosphere);
    Result<Prague2021Data> data = read_prague2021(options.data, visibility);
    if (!data) return at("--data", data.error());
    if (const Result<Done> ok = covers(data->radiance, wavelengths); !ok) return ok.error();
    const std::vector<double>& albedos = data->radiance.albedos;
    for (const Wavelength w : wavelengths) {
        const double albedo = atmosphere.ground_albedo.at(w).value;
        if (albedo < albedos.front() || albedo > albedos.back())
            return Error{std::string(card.key),
                         fmt::format("does not answer a ground albedo of {:.3g}: its data is for {:g} to {:g}", albedo, albedos.front(),
                                     albedos.back()),
                         ""};
    }
    const ModelCard of_data = card_of(data->radiance);
    return std::unique_ptr<Sky>(std::make_unique<Prague2021>(of_data, atmosphere, std::move(wavelengths), std::move(*data), visibility));
}

}  // namespace

Model prague2021_model() { return {card, make}; }

}  // namespace airlight
