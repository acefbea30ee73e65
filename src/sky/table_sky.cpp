#include "sky/table_sky.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "sky/phased_light.h"
#include "sky/view_ray.h"
#include "transport/ray_light.h"

namespace airlight {

namespace {

constexpr int nodes_per_piece = 24;

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

TableSky::TableSky(std::shared_ptr<const Tables> tables) : tables_(std::move(tables)) {}

Result<RadianceEstimate> TableSky::radiance(const View& view) const {
    if (const Result<Done> ok = check_view(view.altitude, view.view_zenith, view.sun_zenith, view.relative_azimuth); !ok) return ok.error();
    RadianceEstimate estimate;
    for (const Tables::Pack& pack : tables_->packs()) {
        const std::optional<Ray> ray = ray_of(pack.air.shell, view);
        const double nu = view_sun_cosine(view);
        for (int w = 0; w < pack.optics.wavelength_count; ++w) estimate.radiance_W_m2_sr_nm.push_back(0.0);
        if (!ray) continue;
        const f32::RadianceSpectrum radiance = with_phases(pack.optics, light_along(pack, *ray), nu);
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
        const f32::IrradianceSpectrum diffuse = pack.tables.irradiance.at({sun, air.source_axis.at(h)});
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
    for (const Tables::Pack& pack : tables_->packs()) {
        f32::Spectrum transmittance(f32::Number(1.0));
        f32::RadianceSpectrum inscattered(f32::RadianceSpectrum::Scalar::of(0.0f));
        if (const std::optional<Ray> ray = ray_of(pack.air.shell, view, distance.value)) {
            const RayLight light = light_along(
                pack, *ray, {.single = true, .source = &pack.tables.source, .diffuse_on_ground = nullptr, .direct_on_ground = false});
            transmittance = light.transmittance;
            inscattered = with_phases(pack.optics, light, ray->nu);
        }
        for (int w = 0; w < pack.optics.wavelength_count; ++w) {
            air.transmittance.push_back(transmittance.v[w]);
            air.inscattered_W_m2_sr_nm.push_back(inscattered.v[w]);
        }
    }
    return air;
}

namespace {

// Texels of the dome: zenith angles from the sky's edge to the horizon and from there to the nadir, by azimuth.
constexpr int sky_angles = 160;
constexpr int ground_angles = 96;
constexpr int azimuths = 91;

// The light without phase functions on a grid of directions that crowds, above and below, towards the horizon.
class TableDome : public SkyDome {
public:
    TableDome(std::shared_ptr<const Tables> tables, Length altitude, double sun_zenith)
        : tables_(std::move(tables)), sun_zenith_(sun_zenith) {
        const Shell& shell = tables_->packs()[0].air.shell;
        const double r = shell.bottom_m + altitude.value;
        horizon_ = pi - std::asin(std::min(1.0, shell.bottom_m / r));
        const double top = shell.bottom_m + shell.top_m;
        edge_ = r <= top ? 0.0 : pi - std::asin(top / r);
        cells_.resize(tables_->packs().size());
        for (std::size_t p = 0; p < cells_.size(); ++p) cells_[p].resize(static_cast<std::size_t>((sky_angles + ground_angles) * azimuths));
        parallel_for(static_cast<std::size_t>(sky_angles + ground_angles), [&](std::size_t i) {
            for (int j = 0; j < azimuths; ++j) fill(altitude, static_cast<int>(i), j);
        });
    }

    void radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const override {
        std::fill(radiance.begin(), radiance.end(), 0.0f);
        if (view_zenith < edge_) return;
        const double nu = view_sun_cosine({0.0 * m, view_zenith, sun_zenith_, relative_azimuth});
        const bool sky = view_zenith <= horizon_;
        const double s =
            sky ? std::sqrt((horizon_ - view_zenith) / (horizon_ - edge_)) : std::sqrt((view_zenith - horizon_) / (pi - horizon_));
        const int count = sky ? sky_angles : ground_angles;
        const Place row = place(s, count, sky ? 0 : sky_angles);
        const double turn = std::abs(std::remainder(relative_azimuth, 2.0 * pi)) / pi;
        const Place column = place(turn, azimuths, 0);
        std::size_t first = 0;
        for (std::size_t p = 0; p < cells_.size(); ++p) {
            const Tables::Pack& pack = tables_->packs()[p];
            const f32::RadianceSpectrum value = with_phases(pack.optics, interpolated(cells_[p], pack.air.parts, row, column), nu);
            for (int w = 0; w < pack.optics.wavelength_count; ++w) radiance[first++] = value.v[w];
        }
    }

private:
    struct Place {
        int low;
        float weight;  // of the next
    };
    static Place place(double s, int count, int offset) {
        const double x = std::clamp(s, 0.0, 1.0) * (count - 1);
        const int low = std::min(static_cast<int>(x), count - 2);
        return {offset + low, static_cast<float>(x - low)};
    }

    double zenith_of(int i) const {
        // A hair off the horizon itself, on its own side.
        const bool sky = i < sky_angles;
        const double s =
            std::max(1e-6, sky ? static_cast<double>(i) / (sky_angles - 1) : static_cast<double>(i - sky_angles) / (ground_angles - 1));
        return sky ? horizon_ - (horizon_ - edge_) * s * s * (1.0 - 1e-12) : horizon_ + (pi - horizon_) * s * s;
    }

    void fill(Length altitude, int i, int j) {
        const View view{altitude, zenith_of(i), sun_zenith_, pi * j / (azimuths - 1)};
        for (std::size_t p = 0; p < cells_.size(); ++p) {
            const Tables::Pack& pack = tables_->packs()[p];
            RayLight& cell = cells_[p][static_cast<std::size_t>(i * azimuths + j)];
            const std::optional<Ray> ray = ray_of(pack.air.shell, view);
            if (ray) cell = light_along(pack, *ray);
            else cell = RayLight{};
        }
    }

    static RayLight interpolated(const std::vector<RayLight>& cells, int parts, Place row, Place column) {
        RayLight sum{};
        for (int corner = 0; corner < 4; ++corner) {
            const bool down = (corner & 1) != 0;
            const bool right = (corner & 2) != 0;
            const float weight = (down ? row.weight : 1.0f - row.weight) * (right ? column.weight : 1.0f - column.weight);
            const RayLight& cell = cells[static_cast<std::size_t>((row.low + down) * azimuths + column.low + right)];
            for (int w = 0; w < pack_size; ++w) sum.multiple.v[w] += weight * cell.multiple.v[w];
            for (int part = 0; part < parts; ++part)
                for (int w = 0; w < pack_size; ++w)
                    sum.single[static_cast<std::size_t>(part)].v[w] += weight * cell.single[static_cast<std::size_t>(part)].v[w];
        }
        return sum;
    }

    std::shared_ptr<const Tables> tables_;
    double sun_zenith_;
    double horizon_;                            // zenith angle of the ground's edge
    double edge_;                               // zenith angle where the air begins: 0 within it
    std::vector<std::vector<RayLight>> cells_;  // [pack][angle * azimuths + azimuth]
};

}  // namespace

Result<std::unique_ptr<SkyDome>> TableSky::dome(Length altitude, double sun_zenith) const {
    if (const Result<Done> ok = check_view(altitude, 0.0, sun_zenith, 0.0); !ok) return ok.error();
    return std::unique_ptr<SkyDome>(std::make_unique<TableDome>(tables_, altitude, sun_zenith));
}

}  // namespace airlight
