// airlight: single scattering marched along each ray, higher orders from a small table of their source. docs/theory.md, section 10.1
//
//   computes     radiance, transmittance, aerial perspective, irradiance of the ground; from the ground to space, the sun to 30
//                degrees below the horizon
//   leaves out   polarisation, refraction; of the sun's disk all but the part above the horizon and its share of the light
//   parameters   those of the tables that it is made of (models/tables.cpp); constituents with more than seven jumps of density
//                altogether lose the upper ones
//   cost         a bake of tables (seconds a pack of sixteen wavelengths, or from the cache), packed into 16 bits;
//                some ten microseconds a ray, some tenths of one a direction of a dome
//   reference    the text is physics/models/airlight.glsl; accuracy and speed: docs/models.md
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "models/airlight_tables.h"
#include "models/list.h"
#include "sky/phased_light.h"
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

struct Pack {
    AirOptics optics;
    AirlightTables tables;
    Shell shell;
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
        : PublishedSky(card, atmosphere, std::move(wavelengths)), rule_(airlight_rule(ray_nodes)) {
        for (const Tables::Pack& pack : tables.packs()) packs_.push_back({pack.optics, airlight_tables(pack), pack.air.shell});
    }

    Result<IrradianceEstimate> irradiance(Length altitude, double sun_zenith) const override;
    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override;
    Result<AerialPerspective> aerial_perspective(const View& view, Length distance) const override;
    Result<std::unique_ptr<SkyDome>> dome(Length altitude, double sun_zenith) const override;

private:
    std::vector<double> sky_radiance(const View& view) const override {
        std::vector<double> radiance;
        for (const Pack& pack : packs_) {
            f32::RadianceSpectrum seen(f32::RadianceSpectrum::Scalar::of(0.0f));
            if (const auto ray = text_ray_of(pack.shell, view))
                seen = with_phases(pack.optics, pack.tables.light(rule_, *ray), view_sun_cosine(view));
            radiance.insert(radiance.end(), seen.v, seen.v + pack.optics.wavelength_count);
        }
        return radiance;
    }

    f32::AirlightRule rule_;
    std::vector<Pack> packs_;
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
    for (const Pack& pack : packs_) {
        f32::Spectrum transmittance(f32::Number(1.0));
        f32::RadianceSpectrum inscattered(f32::RadianceSpectrum::Scalar::of(0.0f));
        if (auto ray = text_ray_of(pack.shell, view, distance.value)) {
            // Just short of the ground, whose light is not the air's.
            const f32::Length bottom = pack.tables.air.bottom;
            if (f32::meets_ground(ray->h, ray->mu, bottom))
                ray->limit = min(ray->limit, 0.9999999 * f32::distance_to_ground(ray->h, ray->mu, bottom));
            const f32::AirlightLight light = pack.tables.light(rule_, *ray);
            transmittance = light.transmittance;
            inscattered = with_phases(pack.optics, light, view_sun_cosine(view));
        }
        air.transmittance.insert(air.transmittance.end(), transmittance.v, transmittance.v + pack.optics.wavelength_count);
        air.inscattered_W_m2_sr_nm.insert(air.inscattered_W_m2_sr_nm.end(), inscattered.v, inscattered.v + pack.optics.wavelength_count);
    }
    return air;
}

Result<IrradianceEstimate> AirlightSky::irradiance(Length altitude, double sun_zenith) const {
    Result<IrradianceEstimate> estimate = PublishedSky::irradiance(altitude, sun_zenith);
    if (!estimate || altitude > 0.0 * m) return estimate;
    // On the ground the bake's own sum over the sky is kept.
    std::size_t first = 0;
    for (const Pack& pack : packs_) {
        const f32::IrradianceSpectrum diffuse = pack.tables.diffuse_on_ground(static_cast<float>(std::cos(sun_zenith)));
        for (int w = 0; w < pack.optics.wavelength_count; ++w) estimate->diffuse_W_m2_nm[first++] = diffuse.v[w];
    }
    return estimate;
}

// A grid of directions around one eye: rows of zenith angles, crowded above and below towards the horizon, by azimuths over half
// a turn. Each holds the light without phase functions, which is smooth; between them it is cubic (Catmull and Rom).
class AirlightDome : public SkyDome {
public:
    AirlightDome(const std::vector<Pack>& packs, Length altitude, double sun_zenith) : packs_(packs), sun_zenith_(sun_zenith) {
        const Shell& shell = packs[0].shell;
        const double r = shell.bottom_m + altitude.value, top = shell.bottom_m + shell.top_m;
        horizon_ = pi - std::asin(std::min(1.0, shell.bottom_m / r));
        edge_ = r <= top ? 0.0 : pi - std::asin(top / r);
        const f32::AirlightRule rule = airlight_rule(dome_nodes);
        for (const Pack& pack : packs) cells_.emplace_back(static_cast<std::size_t>(rows * azimuths * (1 + pack.tables.air.parts)));
        parallel_for(static_cast<std::size_t>(rows), [&](std::size_t i) {
            for (int j = 0; j < azimuths; ++j) fill(rule, altitude, static_cast<int>(i), j);
        });
    }

    void radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const override {
        std::fill(radiance.begin(), radiance.end(), 0.0f);
        if (view_zenith < edge_) return;
        const double nu = view_sun_cosine({0.0 * m, view_zenith, sun_zenith_, relative_azimuth});
        const bool sky = view_zenith <= horizon_;
        const double s =
            sky ? std::sqrt((horizon_ - view_zenith) / (horizon_ - edge_)) : std::sqrt((view_zenith - horizon_) / (pi - horizon_));
        const Stencil row = sky ? stencil(s, 0, sky_rows, false) : stencil(s, sky_rows, ground_rows, false);
        const Stencil column = stencil(std::abs(std::remainder(relative_azimuth, 2.0 * pi)) / pi, 0, azimuths, true);
        std::size_t first = 0;
        for (std::size_t p = 0; p < packs_.size(); ++p) {
            const Pack& pack = packs_[p];
            const f32::RadianceSpectrum value = with_phases(pack.optics, interpolated(p, row, column), nu);
            for (int w = 0; w < pack.optics.wavelength_count; ++w) radiance[first++] = std::max(value.v[w], 0.0f);
        }
    }

private:
    static constexpr int sky_rows = 64;
    static constexpr int ground_rows = 24;
    static constexpr int rows = sky_rows + ground_rows;
    static constexpr int azimuths = 17;

    using Cell = f32::RadianceSpectrum;

    // Four neighbours and their weights.
    struct Stencil {
        std::array<int, 4> at;
        std::array<float, 4> weight;
    };
    // Of s between 0 and 1 among `count` places from `first`; beyond the ends are the ends, or (at azimuths) mirror images.
    static Stencil stencil(double s, int first, int count, bool mirrored) {
        const double x = std::clamp(s, 0.0, 1.0) * (count - 1);
        const int low = std::min(static_cast<int>(x), count - 2);
        const float t = static_cast<float>(x - low);
        Stencil stencil{};
        for (int k = 0; k < 4; ++k) {
            int i = low - 1 + k;
            if (i < 0) i = mirrored ? 1 : 0;
            if (i >= count) i = mirrored ? count - 2 : count - 1;
            stencil.at[static_cast<std::size_t>(k)] = first + i;
        }
        stencil.weight = {0.5f * t * ((2.0f - t) * t - 1.0f), 0.5f * (t * t * (3.0f * t - 5.0f) + 2.0f),
                          0.5f * t * ((4.0f - 3.0f * t) * t + 1.0f), 0.5f * t * t * (t - 1.0f)};
        return stencil;
    }

    double zenith_of(int i) const {
        // A hair off the horizon itself, on its own side.
        const bool sky = i < sky_rows;
        const double s =
            std::max(1e-4, sky ? static_cast<double>(i) / (sky_rows - 1) : static_cast<double>(i - sky_rows) / (ground_rows - 1));
        return sky ? horizon_ - (horizon_ - edge_) * s * s * (1.0 - 1e-12) : horizon_ + (pi - horizon_) * s * s;
    }

    void fill(const f32::AirlightRule& rule, Length altitude, int i, int j) {
        const View view{altitude, zenith_of(i), sun_zenith_, pi * j / (azimuths - 1)};
        for (std::size_t p = 0; p < packs_.size(); ++p) {
            const AirlightTables& tables = packs_[p].tables;
            const auto ray = text_ray_of(packs_[p].shell, view);
            if (!ray) continue;
            const f32::AirlightLight light = tables.light(rule, *ray);
            Cell* cell = &cells_[p][static_cast<std::size_t>((i * azimuths + j) * (1 + tables.air.parts))];
            cell[0] = light.multiple;
            for (int part = 0; part < tables.air.parts; ++part)
                std::copy(light.single[part].v, light.single[part].v + pack_size, cell[1 + part].v);
        }
    }

    f32::AirlightLight interpolated(std::size_t p, const Stencil& row, const Stencil& column) const {
        const int spectra = 1 + packs_[p].tables.air.parts;
        std::array<Cell, 1 + f32::airlight_parts> sum;
        sum.fill(Cell(Cell::Scalar::of(0.0f)));
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < 4; ++b) {
                const float weight = row.weight[a] * column.weight[b];
                const Cell* cell = &cells_[p][static_cast<std::size_t>((row.at[a] * azimuths + column.at[b]) * spectra)];
                for (int k = 0; k < spectra; ++k)
                    for (int w = 0; w < pack_size; ++w) sum[static_cast<std::size_t>(k)].v[w] += weight * cell[k].v[w];
            }
        f32::AirlightLight light;
        light.multiple = sum[0];
        for (int k = 1; k < spectra; ++k)
            std::copy(sum[static_cast<std::size_t>(k)].v, sum[static_cast<std::size_t>(k)].v + pack_size, light.single[k - 1].v);
        return light;
    }

    const std::vector<Pack>& packs_;
    double sun_zenith_;
    double horizon_;                        // zenith angle of the ground's edge
    double edge_;                           // zenith angle where the air begins: 0 within it
    std::vector<std::vector<Cell>> cells_;  // [pack][(row * azimuths + azimuth) * spectra + spectrum]
};

Result<std::unique_ptr<SkyDome>> AirlightSky::dome(Length altitude, double sun_zenith) const {
    if (const Result<Done> ok = within_range({altitude, 0.0, sun_zenith, 0.0}); !ok) return ok.error();
    return std::unique_ptr<SkyDome>(std::make_unique<AirlightDome>(packs_, altitude, sun_zenith));
}

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<Tables> tables = cached_tables(atmosphere, wavelengths, options.bake, options.cache, options.progress);
    if (!tables) return tables.error();
    return std::unique_ptr<Sky>(std::make_unique<AirlightSky>(atmosphere, std::move(wavelengths), *tables));
}

}  // namespace

Model airlight_model() { return {card, make}; }

}  // namespace airlight
