// airlight: single scattering marched along each ray, higher orders from a small table of their source. docs/theory.md, section 10.1
//
//   computes     radiance, transmittance, aerial perspective, irradiance of the ground; from the ground to space, the sun to 30
//                degrees below the horizon
//   leaves out   polarisation, refraction; of the sun's disk all but the part above the horizon and its share of the light
//   parameters   those of the tables that it is made of (models/tables.cpp); constituents with more than seven jumps of density
//                altogether lose the upper ones
//   cost         a bake of tables (seconds a pack of sixteen wavelengths, or from the cache), packed into 16 bits;
//                some ten microseconds a ray; by day six milliseconds a dome, and less than a tenth of a microsecond a direction of a row
//   reference    the text is physics/models/airlight.glsl; accuracy and speed: docs/models.md
#include <algorithm>
#include <cmath>
#include <optional>

#include "models/airlight_row.h"
#include "models/list.h"
#include "sky/gathered_dome.h"
#include "sky/view_ray.h"

namespace airlight {

namespace {

constexpr ModelCard card{
    .key = "airlight",
    .paper = "",
    .scattering = "single exact; higher orders from a small table",
    .approach = "single scattering marched per ray, higher orders from a packed table of the logarithm of their source",
    .precomputation = "seconds a pack of 16 wavelengths",
    .memory = "at most 4 MiB a pack",
    .highest_eye = anywhere,
    .aerial_perspective = true};

constexpr int ray_nodes = 12;
constexpr int dome_nodes = 8;
// Of domes by day and where the edge of the planet's shadow may be seen.
constexpr GatheredDome::Grid day_grid{.sky_rows = 40, .ground_rows = 20, .azimuths = 17},
    shadow_grid{.sky_rows = 64, .ground_rows = 48, .azimuths = 65};

struct Pack {
    AirlightTables tables;
    Shell shell;
    std::vector<double> jumps_m;  // of density
};

f32::Number number(double x) { return f32::Number::of(static_cast<float>(x)); }

// The text's ray of a view.
std::optional<f32::AirlightRay> text_ray_of(const Shell& shell, const View& view, double distance_m = 1e30) {
    const std::optional<Ray> ray = ray_of(shell, view, distance_m);
    if (!ray) return std::nullopt;
    f32::AirlightRay r;
    r.h = f32::Length::of(static_cast<float>(ray->altitude_m));
    r.mu = number(ray->mu);
    r.mu_s = number(std::clamp(ray->mu_s, -1.0, 1.0));
    r.nu = number(ray->nu);
    r.limit = f32::Length::of(static_cast<float>(ray->limit_m));
    return r;
}

class AirlightSky : public PublishedSky {
public:
    AirlightSky(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const Tables& tables)
        : PublishedSky(card, atmosphere, std::move(wavelengths)) {
        for (const Tables::Pack& pack : tables.packs()) {
            const auto jumps = pack.air.densities.jumps_m();
            packs_.push_back({airlight_tables(pack, ray_nodes), pack.air.shell, {jumps.begin(), jumps.end()}});
            phases_.push_back(std::make_shared<const PackPhases>(pack.optics));
        }
    }

    Result<IrradianceEstimate> irradiance(Length altitude, double sun_zenith) const override;
    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override;
    Result<AerialPerspective> aerial_perspective(const View& view, Length distance) const override;
    Result<std::unique_ptr<SkyDome>> dome(Length altitude, double sun_zenith) const override;

private:
    std::vector<double> sky_radiance(const View& view) const override {
        std::vector<double> radiance;
        for (std::size_t p = 0; p < packs_.size(); ++p) {
            f32::RadianceSpectrum seen(f32::RadianceSpectrum::Scalar::of(0.0f));
            if (const auto ray = text_ray_of(packs_[p].shell, view))
                seen = phases_[p]->radiance(packs_[p].tables.light(*ray), view_sun_cosine(view));
            radiance.insert(radiance.end(), seen.v, seen.v + phases_[p]->wavelength_count());
        }
        return radiance;
    }

    std::vector<Pack> packs_;
    PhasesOfPacks phases_;
};

Result<std::vector<double>> AirlightSky::transmittance(Length altitude, double view_zenith, Length distance) const {
    // The sun in the view itself: no shadow cuts the ray.
    const Result<AerialPerspective> air = aerial_perspective({altitude, view_zenith, view_zenith, 0.0}, distance);
    if (!air) return air.error();
    return air->transmittance;
}

Result<AerialPerspective> AirlightSky::aerial_perspective(const View& view, Length distance) const {
    if (const Result<Done> ok = within_range(view); !ok) return ok.error();
    AerialPerspective air;
    for (std::size_t p = 0; p < packs_.size(); ++p) {
        const Pack& pack = packs_[p];
        f32::Spectrum transmittance(f32::Number(1.0));
        f32::RadianceSpectrum inscattered(f32::RadianceSpectrum::Scalar::of(0.0f));
        if (auto ray = text_ray_of(pack.shell, view, distance.value)) {
            // Just short of the ground, whose light is not the air's.
            const f32::Length bottom = pack.tables.air.bottom;
            if (f32::meets_ground(ray->h, ray->mu, bottom))
                ray->limit = min(ray->limit, 0.9999999 * f32::distance_to_ground(ray->h, ray->mu, bottom));
            const f32::AirlightLight light = pack.tables.light(*ray);
            transmittance = light.transmittance;
            inscattered = phases_[p]->radiance(light, view_sun_cosine(view));
        }
        air.transmittance.insert(air.transmittance.end(), transmittance.v, transmittance.v + phases_[p]->wavelength_count());
        air.inscattered_W_m2_sr_nm.insert(air.inscattered_W_m2_sr_nm.end(), inscattered.v, inscattered.v + phases_[p]->wavelength_count());
    }
    return air;
}

Result<IrradianceEstimate> AirlightSky::irradiance(Length altitude, double sun_zenith) const {
    Result<IrradianceEstimate> estimate = PublishedSky::irradiance(altitude, sun_zenith);
    if (!estimate || altitude > 0.0 * m) return estimate;
    // On the ground the bake's own sum over the sky is kept.
    std::size_t first = 0;
    for (std::size_t p = 0; p < packs_.size(); ++p) {
        const f32::IrradianceSpectrum diffuse = packs_[p].tables.diffuse_on_ground(static_cast<float>(std::cos(sun_zenith)));
        for (int w = 0; w < phases_[p]->wavelength_count(); ++w) estimate->diffuse_W_m2_nm[first++] = diffuse.v[w];
    }
    return estimate;
}

Result<std::unique_ptr<SkyDome>> AirlightSky::dome(Length altitude, double sun_zenith) const {
    if (const Result<Done> ok = within_range({altitude, 0.0, sun_zenith, 0.0}); !ok) return ok.error();
    std::vector<f32::AirlightAir> airs;
    for (const Pack& pack : packs_) {
        airs.push_back(pack.tables.air);
        airs.back().rule = airlight_rule(dome_nodes);
    }
    const auto gather_row = [&](std::size_t p, std::span<const View> row, std::span<GatheredDome::Cell> cells) {
        std::vector<f32::AirlightRay> rays;
        for (const View& view : row)
            if (const auto ray = text_ray_of(packs_[p].shell, view)) rays.push_back(*ray);
        if (rays.size() != row.size()) return;  // none of them meets the air
        const std::vector<f32::AirlightLight> lights = airlight_row(airs[p], packs_[p].tables, rays);
        for (std::size_t j = 0; j < row.size(); ++j) GatheredDome::put(lights[j], *phases_[p], j, cells);
    };
    const DomeEye eye{packs_[0].shell, packs_[0].jumps_m, altitude, sun_zenith};
    return std::unique_ptr<SkyDome>(std::make_unique<GatheredDome>(eye, eye.sees_shadow() ? shadow_grid : day_grid, phases_, gather_row));
}

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<Tables> tables = cached_tables(atmosphere, wavelengths, options.bake, options.cache, options.progress);
    if (!tables) return tables.error();
    return std::unique_ptr<Sky>(std::make_unique<AirlightSky>(atmosphere, std::move(wavelengths), *tables));
}

}  // namespace

Model airlight_model() { return {card, make}; }

}  // namespace airlight
