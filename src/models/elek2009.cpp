// elek2009: all orders of scattering in a small table that knows neither the sun's azimuth nor the planet's shadow. [Elek2009]
//
//   computes     light scattered once by each constituent, and all higher orders, by altitude, view and sun (16 x 64 x 32 texels, an
//                eighth of bruneton2008's table for each angle between view and sun); the ground under the sun and the sky;
//                the light before an object, by two look-ups
//   leaves out   the sun's azimuth along a ray: it is taken to stand at right angles to the view, which is the mean of all; the
//                planet's shadow: where the sun is below a point's horizon it shines along it; directions near the horizon
//                from a height, which texels on either side of it share
//   differs      Higher orders come from the table of their source (docs/theory.md, section 5), not from a sum of orders of the
//                table itself. Each wavelength, and each constituent, rather than RGB and two.
//   parameters   ModelOptions::bake: orders and sizes of the source
//   range        any eye; the sun to 90 degrees from the zenith, for without the shadow the sky would not grow dark, at the eye and
//                where a view from space enters the air; no view that the shadow touches, which would be lit where the truth is dark
//   cost         a bake of the source and tenths of a second; then one or two look-ups a direction
//   reference    the text is physics/models/elek2009.glsl
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

constexpr int altitudes = 16;
constexpr int views = 64;
constexpr int suns = 32;
constexpr int nodes_per_piece = 12;

constexpr ModelCard card{.key = "elek2009",
                         .paper = "Elek2009",
                         .scattering = "all orders",
                         .approach = "table of all light by altitude, view and sun, without the planet's shadow",
                         .precomputation = "seconds a pack of 16 wavelengths",
                         .memory = "2 MiB a pack, and 2 MiB for each constituent that scatters",
                         .highest_eye = anywhere,
                         .highest_sun_zenith_deg = 90.0,
                         .highest_view_zenith_deg = 180.0,
                         .aerial_perspective = true,
                         .refused = "views that enter the air where the sun is down, or that the planet's shadow touches"};

double fraction(int i, int size) { return static_cast<double>(i) / (size - 1); }

// [altitude][view][sun]
struct ElekTables {
    std::vector<f32::RadianceSpectrum> multiple;
    std::array<std::vector<f32::IrradianceSpectrum>, max_parts> single;  // of each constituent
};

// Light scattered once along a ray whose nodes stand in sunlight all, each constituent's.
std::array<f32::IrradianceSpectrum, max_parts> unshadowed_light(const TwoLookUpSky::Pack& pack, const RayNodes& nodes, double radius_m,
                                                                double mu_s, double nu) {
    const PackAir& air = pack.air;
    const Table2D<f32::Spectrum> depths(pack.depths, depths_across, depths_down);
    const f32::Length bottom = f32::Length::of(static_cast<float>(air.shell.bottom_m)),
                      top = f32::Length::of(static_cast<float>(air.shell.top_m));
    std::array<f32::IrradianceSpectrum, max_parts> light;
    light.fill(zero<f32::IrradianceSpectrum>());
    for (int n = 0; n < nodes.count; ++n) {
        const double there = (radius_m * mu_s + nu * static_cast<double>(nodes.distance_m[n])) /
                             (air.shell.bottom_m + static_cast<double>(nodes.altitude_m[n]));
        const f32::Length h = f32::Length::of(nodes.altitude_m[n]);
        const f32::Number sun = max(f32::Number(there), f32::horizon_cosine(h, bottom));
        const f32::Spectrum to_sun =
            look_up(depths, f32::bruneton2008_transmittance_place(h, sun, bottom, top, depths_across, depths_down));
        const f32::LengthSpectrum seen = exp(-(optical_depth_of(air, nodes.column_m[n]) + to_sun)) * f32::Length::of(nodes.length_m[n]);
        for (std::size_t p = 0; p < static_cast<std::size_t>(air.parts); ++p)
            light[p] += seen * air.scattering[p] * air.solar_irradiance * f32::Number(static_cast<double>(nodes.density[n][p]));
    }
    return light;
}

void fill_ray(const TwoLookUpSky::Pack& pack, const PackTables& baked, int altitude, int view, ElekTables& tables) {
    const double h = f64::altitude_of_coordinate(fraction(altitude, altitudes), f64::Length::of(pack.air.shell.top_m)).value;
    const double mu = f64::elek2009_cosine_of_coordinate(fraction(view, views)).value;
    const PreparedRay ray(pack.air, h, mu, nodes_per_piece, baked.source.size());
    RayNodes nodes;
    // A sun in the direction of the ray itself casts no shadow across it.
    sample_ray(pack.air.shell, {h, mu, mu, 1.0}, pack.air.densities, pack.air.opacity, nodes_per_piece, nodes);
    const Gathered higher{.single = false, .source = &baked.source, .diffuse_on_ground = nullptr, .direct_on_ground = false};
    for (int s = 0; s < suns; ++s) {
        const double mu_s = std::pow(fraction(s, suns), 3.0);
        const double nu = mu * mu_s;
        const auto texel = static_cast<std::size_t>((altitude * views + view) * suns + s);
        tables.multiple[texel] = ray.multiple(pack.air, pack.transmittance, higher, static_cast<float>(mu_s), static_cast<float>(nu));
        const auto light = unshadowed_light(pack, nodes, pack.air.shell.bottom_m + h, mu_s, nu);
        for (std::size_t p = 0; p < max_parts; ++p)
            if (!tables.single[p].empty()) tables.single[p][texel] = light[p];
    }
}

std::shared_ptr<const ElekTables> filled(const TwoLookUpSky::Pack& pack, const PackTables& baked) {
    auto tables = std::make_shared<ElekTables>();
    tables->multiple.resize(altitudes * views * suns);
    for (const std::size_t p : pack.phases.parts()) tables->single[p].resize(altitudes * views * suns);
    parallel_for(altitudes * views,
                 [&](std::size_t ray) { fill_ray(pack, baked, static_cast<int>(ray) / views, static_cast<int>(ray) % views, *tables); });
    return tables;
}

TwoLookUpSky::Pack pack_of(std::shared_ptr<const Tables> baked, std::size_t index) {
    const Tables::Pack& from = baked->packs()[index];
    TwoLookUpSky::Pack pack{PackPhases(from.optics), from.air, from.tables.transmittance, optical_depths(from.air), {}, {}};
    const f32::Elek2009 shape = f32::elek2009(f32::Length::of(static_cast<float>(pack.air.shell.top_m)), altitudes, views, suns);
    pack.light = [shape, tables = filled(pack, from.tables)](const AirView& view) {
        const f32::Length h = f32::Length::of(static_cast<float>(view.altitude_m));
        const f32::Number mu(view.mu), mu_s(view.mu_s);
        AirLight light;
        light.multiple = f32::elek2009_multiple({tables->multiple, suns, views, altitudes}, shape, h, mu, mu_s);
        light.single.fill(zero<f32::IrradianceSpectrum>());
        for (std::size_t p = 0; p < max_parts; ++p)
            if (const auto& table = tables->single[p]; !table.empty())
                light.single[p] = f32::elek2009_single({table, suns, views, altitudes}, shape, h, mu, mu_s);
        return light;
    };
    pack.sky_on_level = [baked, index](double altitude_m, double mu_s) {
        const Tables::Pack& p = baked->packs()[index];
        const int size = p.tables.irradiance.size()[0];
        return p.tables.irradiance.at({texels_at(f32::texture_coordinate(f32::sun_coordinate(f32::Number(mu_s)), size).value, size),
                                       p.air.source_axis.at(static_cast<float>(altitude_m))});
    };
    return pack;
}

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    Result<Tables> tables = cached_tables(atmosphere, wavelengths, options.bake, options.cache, options.progress);
    if (!tables) return tables.error();
    const auto baked = std::make_shared<const Tables>(std::move(*tables));
    std::vector<TwoLookUpSky::Pack> all;
    for (std::size_t i = 0; i < baked->packs().size(); ++i) all.push_back(pack_of(baked, i));
    return std::unique_ptr<Sky>(std::make_unique<TwoLookUpSky>(card, atmosphere, std::move(wavelengths), std::move(all), 0.0));
}

}  // namespace

Model elek2009_model() { return {card, make}; }

}  // namespace airlight
