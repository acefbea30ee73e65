#include "models/hillaire2020_tables.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "models/optical_depths.h"
#include "transport/pack_arithmetic.h"
#include "transport/pack_tables.h"

namespace airlight {

namespace {

// Sizes and steps of the paper. [Hillaire2020, section 5, table 1]
constexpr int multiple_size = 32;
constexpr int sky_view_columns = 192;
constexpr int sky_view_rows = 108;
constexpr int steps = 40;
// Ours: the air by altitude.
constexpr int medium_size = 256;

f32::Length metres(double x) { return f32::Length::of(static_cast<float>(x)); }
double fraction(int i, int size) { return static_cast<double>(i) / (size - 1); }

}  // namespace

Hillaire2020Tables::Hillaire2020Tables(AirOptics optics) : optics_(std::move(optics)) {
    sky_ = f32::hillaire2020(metres(optics_.bottom_radius.value), metres(optics_.top_altitude.value),
                             narrowed<f32::Spectrum>(optics_.ground_albedo), medium_size, depths_across, depths_down, multiple_size);
    sun_ = narrowed<f32::IrradianceSpectrum>(optics_.solar_irradiance);
    f64::Spectrum sum = f64::Spectrum(f64::Number(0.0));
    for (std::size_t p = 0; p < optics_.parts.size(); ++p) {
        const AirOptics::Part& part = optics_.parts[p];
        const bool air = part.phase.is_rayleigh();
        if (part.scatters && air && !has_air_) air_part_ = p, has_air_ = true;
        const f64::Length column = f64::Length::of(column_depth(part.profile, Length::of(optics_.top_altitude.value)).value);
        aerosol_share_.push_back(part.scatters && !air ? part.scattering * column : f64::Spectrum(f64::Number(0.0)));
        sum += aerosol_share_.back();
    }
    for (f64::Spectrum& share : aerosol_share_) share = share / max(sum, f64::Spectrum(f64::Number(1e-300)));
    fill_medium();
    transmittance_ = optical_depths(pack_air(optics_, {}));
    fill_multiple();
}

void Hillaire2020Tables::fill_medium() {
    medium_.assign(3 * medium_size, f32::ScatteringSpectrum(f32::ScatteringSpectrum::Scalar::of(0.0f)));
    for (int i = 0; i < medium_size; ++i) {
        const Length h = Length::of(f64::altitude_of_coordinate(fraction(i, medium_size), optics_.top_altitude).value);
        for (const AirOptics::Part& part : optics_.parts) {
            const f64::Number density = relative_density(part.profile, h);
            const std::size_t row = part.phase.is_rayleigh() ? 0 : 1;
            const auto column = static_cast<std::size_t>(i);
            if (part.scatters) medium_[row * medium_size + column] += narrowed<f32::ScatteringSpectrum>(part.scattering * density);
            medium_[2 * medium_size + column] += narrowed<f32::ScatteringSpectrum>(part.extinction * density);
        }
    }
}

void Hillaire2020Tables::fill_multiple() {
    multiple_.resize(multiple_size * multiple_size);
    parallel_for(multiple_size * multiple_size, [&](std::size_t texel) {
        const int i = static_cast<int>(texel) % multiple_size, j = static_cast<int>(texel) / multiple_size;
        multiple_[texel] = f32::hillaire2020_series(
            orders(optics_.top_altitude.value * fraction(j, multiple_size), 2.0 * fraction(i, multiple_size) - 1.0));
    });
}

Table2D<f32::ScatteringSpectrum> Hillaire2020Tables::medium() const { return {medium_, medium_size, 3}; }
Table2D<f32::Spectrum> Hillaire2020Tables::transmittance() const { return {transmittance_, depths_across, depths_down}; }

f32::Hillaire2020Orders Hillaire2020Tables::orders(double altitude_m, double mu_s) const {
    return f32::hillaire2020_orders(sky_, medium(), transmittance(), metres(altitude_m), f32::Number(mu_s));
}

f32::PhaseSpectrum Hillaire2020Tables::air_phase(double nu) const {
    return has_air_ ? narrowed<f32::PhaseSpectrum>(optics_.parts[air_part_].phase.at(nu)) : f32::PhaseSpectrum(0.0 * f32::per_sr);
}

f32::PhaseSpectrum Hillaire2020Tables::aerosol_phase(double nu) const {
    f64::PhaseSpectrum sum = f64::PhaseSpectrum(0.0 * f64::per_sr);
    for (std::size_t p = 0; p < optics_.parts.size(); ++p)
        if (optics_.parts[p].scatters && !optics_.parts[p].phase.is_rayleigh()) sum += optics_.parts[p].phase.at(nu) * aerosol_share_[p];
    return narrowed<f32::PhaseSpectrum>(sum);
}

Hillaire2020Tables::Light Hillaire2020Tables::light(const Ray& ray) const {
    const f32::Length h = metres(ray.altitude_m);
    const f32::Number mu(ray.mu), mu_s(ray.mu_s), nu(ray.nu);
    const double end = (f64::meets_ground(f64::Length::of(ray.altitude_m), ray.mu, optics_.bottom_radius)
                            ? f64::distance_to_ground(f64::Length::of(ray.altitude_m), ray.mu, optics_.bottom_radius)
                            : f64::distance_to_top(f64::Length::of(ray.altitude_m), ray.mu, optics_.bottom_radius, optics_.top_altitude))
                           .value;
    const f32::Hillaire2020Light seen =
        f32::hillaire2020_march(sky_, medium(), transmittance(), {multiple_, multiple_size, multiple_size}, h, mu, mu_s, nu,
                                metres(std::min(ray.limit_m, end)), steps, air_phase(ray.nu), aerosol_phase(ray.nu));
    return {seen.inscattered * sun_, seen.transmittance};
}

f32::RadianceSpectrum Hillaire2020Tables::radiance(const Ray& ray) const {
    const Light seen = light(ray);
    const f64::Length h = f64::Length::of(ray.altitude_m);
    if (!f64::meets_ground(h, ray.mu, optics_.bottom_radius)) return seen.inscattered;
    const f64::Length distance = f64::distance_to_ground(h, ray.mu, optics_.bottom_radius);
    const f64::Number mu_g = f64::sun_cosine_at(h, ray.mu_s, ray.nu, distance, 0.0 * f64::m, optics_.bottom_radius);
    return seen.inscattered + f32::hillaire2020_ground(sky_, transmittance(), f32::Number(mu_g.value)) * sun_ * seen.transmittance;
}

std::vector<f32::RadianceSpectrum> Hillaire2020Tables::sky_view(double altitude_m, double sun_zenith) const {
    std::vector<f32::RadianceSpectrum> table(sky_view_columns * sky_view_rows);
    const f64::Length h = f64::Length::of(altitude_m);
    const double horizon = f64::horizon_cosine(h, optics_.bottom_radius).value;
    const double mu_s = std::cos(sun_zenith);
    parallel_for(sky_view_rows, [&](std::size_t row) {
        const double zenith = f64::hillaire2020_zenith_of_row(h, static_cast<int>(row), optics_.bottom_radius, sky_view_rows).value;
        // The two rows at the horizon stand on their sides of it.
        const double mu = row < sky_view_rows / 2 ? std::max(std::cos(zenith), horizon + 1e-7) : std::min(std::cos(zenith), horizon - 1e-7);
        for (int column = 0; column < sky_view_columns; ++column) {
            const double cos_azimuth = f64::azimuth_cosine_of_coordinate(fraction(column, sky_view_columns)).value;
            const double nu = std::clamp(mu * mu_s + std::sqrt((1.0 - mu * mu) * (1.0 - mu_s * mu_s)) * cos_azimuth, -1.0, 1.0);
            table[row * sky_view_columns + static_cast<std::size_t>(column)] = radiance({altitude_m, mu, mu_s, nu});
        }
    });
    return table;
}

f32::RadianceSpectrum Hillaire2020Tables::seen_in(const std::vector<f32::RadianceSpectrum>& sky_view, double altitude_m, double mu,
                                                  double cos_azimuth) const {
    return look_up(Table2D<f32::RadianceSpectrum>(sky_view, sky_view_columns, sky_view_rows),
                   f32::hillaire2020_sky_view_place(metres(altitude_m), f32::Number(mu), f32::Number(cos_azimuth), sky_.bottom,
                                                    sky_view_columns, sky_view_rows));
}

}  // namespace airlight
