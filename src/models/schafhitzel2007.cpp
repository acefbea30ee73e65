// schafhitzel2007: all of single scattering, computed ahead by height, view and sun. [SchafhitzelFalkErtl2007]
//
//   computes     light scattered once by each constituent, in a table of three dimensions (32 heights x 128 views x 32 suns); the
//                light before an object, by two look-ups; the ground under the sun
//   leaves out   all orders of scattering beyond the first; the azimuth of the sun along a ray: the table is that of the plane
//                through the zenith and the sun, where the model is exact, and it misplaces the planet's shadow to the side
//   differs      The phase function stays out of the table for the sky too, as in the paper it does for objects: the table has no
//                azimuth to know it by. The light from behind an object is dimmed by the air before it, which the survey's
//                equation leaves out [Lopes2015, eq. 60]. Heights, views and suns by the maps of bruneton2008; rays are integrated
//                along nodes that follow the density. Each wavelength, and each constituent, rather than RGB and two.
//   parameters   none
//   range        any eye; the sun to 101.5 degrees from the zenith (cosine -0.2), at the eye and where a view from space enters the
//                air; no view that the planet's shadow touches, where the light of the sun's plane stands for the dark beside it
//   cost         a second a pack of 16 wavelengths; then one or two look-ups a direction
//   reference    the text is physics/models/schafhitzel2007.glsl
#include <cmath>
#include <memory>

#include "core/parallel.h"
#include "models/list.h"
#include "models/optical_depths.h"
#include "models/two_look_ups.h"
#include "physics/models/f32.h"
#include "physics/models/f64.h"
#include "transport/pack_arithmetic.h"

namespace airlight {

namespace {

constexpr int altitudes = 32;
constexpr int views = 128;
constexpr int suns = 32;
constexpr int nodes_per_piece = 12;

constexpr double lowest_sun = -0.2;  // of bruneton2008_sun_coordinate()

constexpr ModelCard card{.key = "schafhitzel2007",
                         .paper = "SchafhitzelFalkErtl2007",
                         .scattering = "single",
                         .approach = "table of all light by height, view and sun",
                         .precomputation = "a second a pack of 16 wavelengths",
                         .memory = "8 MiB a pack for each constituent that scatters",
                         .highest_eye = anywhere,
                         .highest_sun_zenith_deg = 101.5,
                         .highest_view_zenith_deg = 180.0,
                         .aerial_perspective = true,
                         .refused = "views that the planet's shadow touches"};

double fraction(int i, int size) { return static_cast<double>(i) / (size - 1); }

// One table for each constituent: [altitude][view][sun].
using SingleTables = std::array<std::vector<f32::IrradianceSpectrum>, max_parts>;

void fill_ray(const TwoLookUpSky::Pack& pack, int altitude, int view, SingleTables& tables) {
    const f64::Length bottom = f64::Length::of(pack.air.shell.bottom_m), top = f64::Length::of(pack.air.shell.top_m);
    const f64::Length h = f64::bruneton2008_altitude_of_coordinate(fraction(altitude, altitudes), bottom, top);
    const double horizon = f64::horizon_cosine(h, bottom).value;
    constexpr int half = views / 2;
    // The texels at the horizon stand on their sides of it.
    const double mu = view < half
                          ? std::min(f64::bruneton2008_ground_cosine(h, fraction(view, half), bottom).value, horizon - 1e-12)
                          : std::max(f64::bruneton2008_sky_cosine(h, fraction(view - half, half), bottom, top).value, horizon + 1e-12);
    const PreparedRay ray(pack.air, h.value, mu, nodes_per_piece, {2, 2, 2, 2});
    for (int s = 0; s < suns; ++s) {
        const double mu_s = f64::bruneton2008_sun_of_coordinate(fraction(s, suns)).value;
        const double nu = std::min(mu * mu_s + std::sqrt((1.0 - mu * mu) * (1.0 - mu_s * mu_s)), 1.0);
        const auto light = single_light(pack.air, pack.transmittance, ray, {h.value, mu, mu_s, nu}, nodes_per_piece);
        const auto texel = static_cast<std::size_t>((altitude * views + view) * suns + s);
        for (std::size_t p = 0; p < max_parts; ++p)
            if (!tables[p].empty()) tables[p][texel] = light[p];
    }
}

std::shared_ptr<const SingleTables> filled(const TwoLookUpSky::Pack& pack) {
    auto tables = std::make_shared<SingleTables>();
    for (const std::size_t p : pack.phases.parts()) (*tables)[p].resize(altitudes * views * suns);
    parallel_for(altitudes * views,
                 [&](std::size_t ray) { fill_ray(pack, static_cast<int>(ray) / views, static_cast<int>(ray) % views, *tables); });
    return tables;
}

TwoLookUpSky::Pack pack_of(const Atmosphere& atmosphere, const std::vector<Wavelength>& wavelengths) {
    const AirOptics optics = air_optics(atmosphere, wavelengths);
    const TableSizes sizes;
    PackAir air = pack_air(optics, sizes);
    Table<f32::Spectrum, 2> transmittance = transmittance_table(air, sizes.transmittance_mu);
    std::vector<f32::Spectrum> depths = optical_depths(air);
    TwoLookUpSky::Pack pack{PackPhases(optics), std::move(air), std::move(transmittance), std::move(depths), {}, {}};
    const f32::Schafhitzel2007 shape =
        f32::schafhitzel2007(f32::Length::of(static_cast<float>(pack.air.shell.bottom_m)),
                             f32::Length::of(static_cast<float>(pack.air.shell.top_m)), altitudes, views, suns);
    pack.light = [shape, tables = filled(pack)](const AirView& view) {
        AirLight light;
        light.multiple = zero<f32::RadianceSpectrum>();
        light.single.fill(zero<f32::IrradianceSpectrum>());
        const f32::Length h = f32::Length::of(static_cast<float>(view.altitude_m));
        const f32::Number mu(view.mu), mu_s(view.mu_s);
        for (std::size_t p = 0; p < max_parts; ++p)
            if (const auto& table = (*tables)[p]; !table.empty())
                light.single[p] = f32::schafhitzel2007_light({table, suns, views, altitudes}, shape, h, mu, mu_s, view.ground);
        return light;
    };
    pack.sky_on_level = [](double, double) { return zero<f32::IrradianceSpectrum>(); };
    return pack;
}

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions&) {
    std::vector<TwoLookUpSky::Pack> all;
    for (const std::vector<Wavelength>& pack : packs(wavelengths)) all.push_back(pack_of(atmosphere, pack));
    return std::unique_ptr<Sky>(std::make_unique<TwoLookUpSky>(card, atmosphere, std::move(wavelengths), std::move(all), lowest_sun));
}

}  // namespace

Model schafhitzel2007_model() { return {card, make}; }

}  // namespace airlight
