#include "models/two_look_ups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/optical_depths.h"
#include "physics/models/f32.h"
#include "physics/models/f64.h"
#include "transport/pack_arithmetic.h"

namespace airlight {

namespace {

f64::Length metres(double x) { return f64::Length::of(x); }

// What is seen from the start less what is seen from the end.
AirLight between(const AirLight& start, const AirLight& end, const f32::Spectrum& transmittance, int parts) {
    AirLight light;
    light.multiple = max(start.multiple - end.multiple * transmittance, zero<f32::RadianceSpectrum>());
    for (std::size_t p = 0; p < static_cast<std::size_t>(parts); ++p)
        light.single[p] = f32::schafhitzel2007_between(start.single[p], end.single[p], transmittance);
    return light;
}

f32::Spectrum transmittance_of_piece(const TwoLookUpSky::Pack& pack, const AirPiece& piece) {
    const f32::Length bottom = f32::Length::of(static_cast<float>(pack.air.shell.bottom_m)),
                      top = f32::Length::of(static_cast<float>(pack.air.shell.top_m));
    return f32::bruneton2008_transmittance({pack.depths, depths_across, depths_down}, f32::bruneton2008(bottom, top, 2, 2, 2, 2),
                                           depths_across, depths_down, f32::Length::of(static_cast<float>(piece.start.altitude_m)),
                                           f32::Number(piece.start.mu), f32::Length::of(static_cast<float>(piece.length_m)),
                                           piece.start.ground);
}

f32::RadianceSpectrum ground(const TwoLookUpSky::Pack& pack, double mu_s) {
    const f32::IrradianceSpectrum light =
        pack.sky_on_level(0.0, mu_s) + direct_irradiance(pack.air, pack.transmittance, 0.0f, static_cast<float>(mu_s));
    return light * pack.air.ground_albedo * (1.0 / f32::pi * f32::per_sr);
}

template <class S>
void append(const S& spectrum, const TwoLookUpSky::Pack& pack, std::vector<double>& to) {
    for (int w = 0; w < pack.phases.wavelength_count(); ++w) to.push_back(static_cast<double>(spectrum.v[w]));
}

}  // namespace

std::optional<AirPiece> air_piece(const Shell& shell, const View& view, double distance_m) {
    const Ray from_eye{view.altitude.in(m), std::cos(view.view_zenith), std::cos(view.sun_zenith), view_sun_cosine(view)};
    Ray ray = from_eye;
    if (!enter_air(shell, ray)) return std::nullopt;
    // The way to the air is empty.
    const double empty = from_eye.altitude_m > shell.top_m
                             ? -(shell.bottom_m + from_eye.altitude_m) * from_eye.mu + (shell.bottom_m + shell.top_m) * ray.mu
                             : 0.0;
    if (!(distance_m > empty)) return std::nullopt;
    const f64::Length h = metres(ray.altitude_m), bottom = metres(shell.bottom_m), top = metres(shell.top_m);
    const bool ground = f64::meets_ground(h, ray.mu, bottom);
    const double whole = (ground ? f64::distance_to_ground(h, ray.mu, bottom) : f64::distance_to_top(h, ray.mu, bottom, top)).value;
    AirPiece piece;
    piece.start = {ray.altitude_m, ray.mu, ray.mu_s, ray.nu, ground};
    piece.whole = distance_m - empty >= whole;
    piece.length_m = piece.whole ? whole : distance_m - empty;
    const f64::Length t = metres(piece.length_m);
    const f64::Length h_t = clamp(f64::altitude_at(h, ray.mu, t, bottom), metres(0.0), top);
    piece.end = {h_t.value, f64::cosine_at(h, ray.mu, t, h_t, bottom).value, f64::sun_cosine_at(h, ray.mu_s, ray.nu, t, h_t, bottom).value,
                 ray.nu, ground};
    return piece;
}

bool shadow_touches(const Shell& shell, const AirPiece& piece) {
    // At t along the ray: behind the planet if along = r mu_s + nu t < 0, and in the cylinder if r_t^2 - along^2 < R^2, that is
    // a t^2 + 2 b t + c < 0.
    const AirView& s = piece.start;
    const double r = shell.bottom_m + s.altitude_m, along = r * s.mu_s;
    const double a = (1.0 - s.nu) * (1.0 + s.nu), b = r * s.mu - along * s.nu;
    const double c = s.altitude_m * (shell.bottom_m + r) - along * along;
    const double hair = -1e-9 * r * r;
    // The part of the ray that is behind the planet.
    double low = 0.0, high = piece.length_m;
    if (s.nu < 0.0) low = std::max(low, -along / s.nu);
    else if (s.nu > 0.0) high = std::min(high, -along / s.nu);
    else if (along >= 0.0) return false;
    if (low > high) return false;
    const double deepest = a > 0.0 ? std::clamp(-b / a, low, high) : (b < 0.0 ? high : low);
    return (a * deepest + 2.0 * b) * deepest + c < hair;
}

std::array<f32::IrradianceSpectrum, max_parts> single_light(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance,
                                                            const PreparedRay& prepared, const Ray& ray, int nodes_per_piece) {
    std::array<f32::IrradianceSpectrum, max_parts> light;
    light.fill(zero<f32::IrradianceSpectrum>());
    const auto mu_s = static_cast<float>(ray.mu_s), nu = static_cast<float>(ray.nu);
    const PreparedRay::Lit lit = prepared.lit(air, mu_s, nu);
    if (lit == PreparedRay::Lit::all) prepared.single(air, transmittance, mu_s, nu, light);
    if (lit != PreparedRay::Lit::part) return light;
    RayNodes nodes;
    sample_ray(air.shell, ray, air.densities, air.opacity, nodes_per_piece, nodes);
    return gather(air, transmittance, {.single = true, .source = nullptr, .diffuse_on_ground = nullptr, .direct_on_ground = false}, nodes,
                  nu)
        .single;
}

TwoLookUpSky::TwoLookUpSky(const ModelCard& card, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths,
                           std::vector<Pack> packs, double lowest_sun)
    : PublishedSky(card, atmosphere, std::move(wavelengths)), packs_(std::move(packs)), lowest_sun_(lowest_sun) {}

Result<Done> TwoLookUpSky::answerable(const std::optional<AirPiece>& piece) const {
    if (!piece) return Done{};  // without air there is no light, which is right
    const char* remedy = "`airlight models` shows the range of each model.";
    constexpr double hair = 1e-9;
    if (piece->start.mu_s < lowest_sun_ - hair)
        return Error{
            name(),
            fmt::format("does not answer views that enter the air with the sun beyond {:.1f} deg from the zenith: its tables end there",
                        std::acos(lowest_sun_) / deg),
            remedy};
    if (shadow_touches(shell(), *piece))
        return Error{name(), "does not answer views that the planet's shadow touches: tables without azimuth cannot say where it falls",
                     remedy};
    return Done{};
}

Result<Done> TwoLookUpSky::answerable(const View& view) const { return answerable(air_piece(shell(), view, 1e30)); }

Result<std::vector<double>> TwoLookUpSky::transmittance(Length altitude, double view_zenith, Length distance) const {
    const View view{altitude, view_zenith, 0.0, 0.0};  // only the way matters, not the sun
    if (const Result<Done> ok = within_range(view); !ok) return ok.error();
    const std::optional<AirPiece> piece = air_piece(shell(), view, distance.in(m));
    std::vector<double> seen;
    for (const Pack& pack : packs_) append(piece ? transmittance_of_piece(pack, *piece) : f32::Spectrum(f32::Number(1.0)), pack, seen);
    return seen;
}

Result<AerialPerspective> TwoLookUpSky::aerial_perspective(const View& view, Length distance) const {
    if (const Result<Done> ok = within_range(view); !ok) return ok.error();
    const std::optional<AirPiece> piece = air_piece(shell(), view, distance.in(m));
    if (const Result<Done> ok = answerable(piece); !ok) return ok.error();
    AerialPerspective air;
    for (const Pack& pack : packs_) {
        f32::Spectrum seen(f32::Number(1.0));
        f32::RadianceSpectrum light = zero<f32::RadianceSpectrum>();
        if (piece) {
            seen = transmittance_of_piece(pack, *piece);
            AirLight all = pack.light(piece->start);
            if (!piece->whole) all = between(all, pack.light(piece->end), seen, pack.air.parts);
            light = pack.phases.radiance(all, piece->start.nu);
        }
        append(seen, pack, air.transmittance);
        append(light, pack, air.inscattered_W_m2_sr_nm);
    }
    return air;
}

std::vector<double> TwoLookUpSky::sky_radiance(const View& view) const {
    const std::optional<AirPiece> piece = air_piece(shell(), view, 1e30);
    std::vector<double> seen;
    for (const Pack& pack : packs_) {
        f32::RadianceSpectrum light = zero<f32::RadianceSpectrum>();
        if (piece) {
            light = pack.phases.radiance(pack.light(piece->start), piece->start.nu);
            if (piece->start.ground) light += ground(pack, piece->end.mu_s) * transmittance_of_piece(pack, *piece);
        }
        append(light, pack, seen);
    }
    return seen;
}

}  // namespace airlight
