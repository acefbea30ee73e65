#include "sky/table_sky.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sky/gathered_dome.h"
#include "sky/view_ray.h"
#include "transport/ray_light.h"

namespace airlight {

namespace {

constexpr int nodes_per_piece = 24;
// Of domes by day and where the edge of the planet's shadow may be seen.
constexpr GatheredDome::Grid day_grid{.sky_rows = 96, .ground_rows = 32, .azimuths = 33},
    shadow_grid{.sky_rows = 160, .ground_rows = 96, .azimuths = 91};

RayLight light_along(const Tables::Pack& pack, const Ray& ray, const Gathered& what) {
    static thread_local RayNodes nodes;
    sample_ray(pack.air.shell, ray, pack.air.densities, pack.air.opacity, nodes_per_piece, nodes);
    return gather(pack.air, pack.tables.transmittance, what, nodes, static_cast<float>(ray.nu));
}
RayLight light_along(const Tables::Pack& pack, const Ray& ray) {
    return light_along(
        pack, ray, {.single = true, .source = &pack.tables.source, .diffuse_on_ground = &pack.tables.irradiance, .direct_on_ground = true});
}

}  // namespace

TableSky::TableSky(std::shared_ptr<const Tables> tables) : tables_(std::move(tables)) {
    for (const Tables::Pack& pack : tables_->packs()) phases_.push_back(std::make_shared<const PackPhases>(pack.optics));
}

Result<RadianceEstimate> TableSky::radiance(const View& view) const {
    if (const Result<Done> ok = check_view(view.altitude, view.view_zenith, view.sun_zenith, view.relative_azimuth); !ok) return ok.error();
    RadianceEstimate estimate;
    for (std::size_t p = 0; p < phases_.size(); ++p) {
        const Tables::Pack& pack = tables_->packs()[p];
        const std::optional<Ray> ray = ray_of(pack.air.shell, view);
        for (int w = 0; w < pack.optics.wavelength_count; ++w) estimate.radiance_W_m2_sr_nm.push_back(0.0);
        if (!ray) continue;
        const f32::RadianceSpectrum radiance = phases_[p]->radiance(light_along(pack, *ray), view_sun_cosine(view));
        double* first =
            &estimate.radiance_W_m2_sr_nm[estimate.radiance_W_m2_sr_nm.size() - static_cast<std::size_t>(pack.optics.wavelength_count)];
        for (int w = 0; w < pack.optics.wavelength_count; ++w) first[w] = radiance.v[w];
    }
    estimate.standard_error.assign(estimate.radiance_W_m2_sr_nm.size(), 0.0);
    return estimate;
}

Result<IrradianceEstimate> TableSky::irradiance(Length altitude, double sun_zenith) const {
    if (const Result<Done> ok = check_view(altitude, 0.0, sun_zenith, 0.0); !ok) return ok.error();
    IrradianceEstimate estimate;
    const float mu_s = static_cast<float>(std::cos(sun_zenith));
    for (const Tables::Pack& pack : tables_->packs()) {
        const PackAir& air = pack.air;
        const bool in_air = altitude.value <= air.shell.top_m;
        const float h = static_cast<float>(std::min(altitude.value, air.shell.top_m));
        const auto& size = pack.tables.irradiance.size();
        const Texels sun = texels_at(f32::texture_coordinate(f32::sun_coordinate(mu_s), size[0]).value, size[0]);
        const f32::IrradianceSpectrum diffuse = pack.tables.irradiance.geometric_at({sun, air.source_axis.at(h)});
        const f32::IrradianceSpectrum direct = direct_irradiance(air, pack.tables.transmittance, h, mu_s);
        for (int w = 0; w < pack.optics.wavelength_count; ++w) {
            estimate.direct_W_m2_nm.push_back(direct.v[w]);
            estimate.diffuse_W_m2_nm.push_back(in_air ? diffuse.v[w] : 0.0);
        }
    }
    estimate.standard_error.assign(estimate.diffuse_W_m2_nm.size(), 0.0);
    return estimate;
}

Result<std::vector<double>> TableSky::transmittance(Length altitude, double view_zenith, Length distance) const {
    if (const Result<Done> ok = check_view(altitude, view_zenith, 0.0, 0.0); !ok) return ok.error();
    std::vector<double> transmittance;
    RayNodes nodes;
    for (const Tables::Pack& pack : tables_->packs()) {
        // Only the way matters: let the sun stand behind, where no shadow cuts the ray.
        std::optional<Ray> ray = ray_of(pack.air.shell, {altitude, view_zenith, 0.0, 0.0}, distance.value);
        f32::Spectrum seen(f32::Number(1.0));
        if (ray) {
            ray->mu_s = 1.0;
            ray->nu = ray->mu;
            sample_ray(pack.air.shell, *ray, pack.air.densities, pack.air.opacity, nodes_per_piece, nodes);
            seen = transmittance_of(pack.air, nodes.total_column_m);
        }
        for (int w = 0; w < pack.optics.wavelength_count; ++w) transmittance.push_back(seen.v[w]);
    }
    return transmittance;
}

Result<AerialPerspective> TableSky::aerial_perspective(const View& view, Length distance) const {
    if (const Result<Done> ok = check_view(view.altitude, view.view_zenith, view.sun_zenith, view.relative_azimuth); !ok) return ok.error();
    AerialPerspective air;
    for (std::size_t p = 0; p < phases_.size(); ++p) {
        const Tables::Pack& pack = tables_->packs()[p];
        f32::Spectrum transmittance(f32::Number(1.0));
        f32::RadianceSpectrum inscattered(f32::RadianceSpectrum::Scalar::of(0.0f));
        if (const std::optional<Ray> ray = ray_of(pack.air.shell, view, distance.value)) {
            const RayLight light = light_along(
                pack, *ray, {.single = true, .source = &pack.tables.source, .diffuse_on_ground = nullptr, .direct_on_ground = false});
            transmittance = light.transmittance;
            inscattered = phases_[p]->radiance(light, ray->nu);
        }
        for (int w = 0; w < pack.optics.wavelength_count; ++w) {
            air.transmittance.push_back(transmittance.v[w]);
            air.inscattered_W_m2_sr_nm.push_back(inscattered.v[w]);
        }
    }
    return air;
}

Result<std::unique_ptr<SkyDome>> TableSky::dome(Length altitude, double sun_zenith) const {
    if (const Result<Done> ok = check_view(altitude, 0.0, sun_zenith, 0.0); !ok) return ok.error();
    const auto gather_row = [&](std::size_t p, std::span<const View> row, std::span<GatheredDome::Cell> cells) {
        const Tables::Pack& pack = tables_->packs()[p];
        for (std::size_t j = 0; j < row.size(); ++j)
            if (const std::optional<Ray> ray = ray_of(pack.air.shell, row[j]))
                GatheredDome::put(light_along(pack, *ray), *phases_[p], j, cells);
    };
    const PackAir& air = tables_->packs()[0].air;
    const DomeEye eye{air.shell, air.densities.jumps_m(), altitude, sun_zenith};
    return std::unique_ptr<SkyDome>(std::make_unique<GatheredDome>(eye, eye.sees_shadow() ? shadow_grid : day_grid, phases_, gather_row));
}

}  // namespace airlight
