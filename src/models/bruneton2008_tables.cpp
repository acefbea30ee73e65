#include "models/bruneton2008_tables.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "models/optical_depths.h"
#include "transport/pack_arithmetic.h"

namespace airlight {

namespace {

// [BrunetonNeyret2008, section 4; Bruneton2017]
constexpr int irradiance_across = 64;
constexpr int irradiance_down = 16;
constexpr int nodes_per_piece = 12;

f32::Length metres(double x) { return f32::Length::of(static_cast<float>(x)); }
f32::Number number(double x) { return f32::Number(x); }
f64::Length exact_metres(double x) { return f64::Length::of(x); }

double fraction(int i, int size) { return static_cast<double>(i) / (size - 1); }

}  // namespace

Bruneton2008Tables::Bruneton2008Tables(const Tables::Pack& pack, const Bruneton2008Settings& settings) : pack_(pack), settings_(settings) {
    shape_ = f32::bruneton2008(metres(pack.air.shell.bottom_m), metres(pack.air.shell.top_m), settings.altitude, settings.view,
                               settings.sun, settings.nu);
    shape_.twilight = settings.twilight;
    for (std::size_t p = 0; p < pack.optics.parts.size(); ++p) {
        if (!pack.optics.parts[p].scatters) continue;
        if (pack.optics.parts[p].phase.is_rayleigh() && !air_) air_ = parts_.size();
        parts_.push_back(p);
    }
    multiple_ = zeros();
    for (std::size_t i = 0; i < parts_.size(); ++i) single_.push_back(zeros());
    filled_ = std::make_unique<std::once_flag[]>(static_cast<std::size_t>(shape_.altitude_size * shape_.view_size));
    transmittance_ = optical_depths(pack.air);
    fill_irradiance();
    if (!settings_.eight_bits) return;
    // The levels are shared out over the whole of each table.
    parallel_for(static_cast<std::size_t>(shape_.altitude_size * shape_.view_size), [&](std::size_t row) {
        const int r = static_cast<int>(row);
        std::call_once(filled_[row], [&] { fill_row(r % shape_.view_size, r / shape_.view_size); });
    });
    round_to_eight_bits(multiple_);
    for (const Values& values : single_) round_to_eight_bits(values);
}

std::size_t Bruneton2008Tables::texels() const {
    return static_cast<std::size_t>(shape_.altitude_size) * static_cast<std::size_t>(shape_.view_size) *
           static_cast<std::size_t>(shape_.sun_size) * static_cast<std::size_t>(shape_.nu_size);
}

Bruneton2008Tables::Values Bruneton2008Tables::zeros() const {
    return Values(static_cast<float*>(std::calloc(texels() * pack_size, sizeof(float))));
}

void Bruneton2008Tables::fill_irradiance() {
    const auto& source = pack_.tables.irradiance;
    for (int j = 0; j < irradiance_down; ++j)
        for (int i = 0; i < irradiance_across; ++i) {
            const float h = static_cast<float>(pack_.air.shell.top_m * fraction(j, irradiance_down));
            const f32::Number x = f32::sun_coordinate(number(-0.2 + 1.2 * fraction(i, irradiance_across)));
            const int size = source.size()[0];
            irradiance_.push_back(source.at({texels_at(f32::texture_coordinate(x, size).value, size), pack_.air.source_axis.at(h)}));
        }
}

double Bruneton2008Tables::view_cosine(int view, double altitude_m) const {
    const f64::Length h = exact_metres(altitude_m), bottom = exact_metres(pack_.air.shell.bottom_m),
                      top = exact_metres(pack_.air.shell.top_m);
    const int half = shape_.view_size / 2;
    const double horizon = f64::horizon_cosine(h, bottom).value;
    if (is_ground(view)) return std::min(f64::bruneton2008_ground_cosine(h, fraction(view, half), bottom).value, horizon - 1e-12);
    return std::max(f64::bruneton2008_sky_cosine(h, fraction(view - half, half), bottom, top).value, horizon + 1e-12);
}

void Bruneton2008Tables::fill_row(int view, int altitude) const {
    const PackAir& air = pack_.air;
    const double h = f64::bruneton2008_altitude_of_coordinate(fraction(altitude, shape_.altitude_size), exact_metres(air.shell.bottom_m),
                                                              exact_metres(air.shell.top_m))
                         .value;
    const double mu = view_cosine(view, h);
    const PreparedRay ray(air, h, mu, nodes_per_piece, pack_.tables.source.size());
    const Gathered higher{.single = false, .source = &pack_.tables.source, .diffuse_on_ground = nullptr, .direct_on_ground = false};
    for (int n = 0; n < shape_.nu_size; ++n)
        for (int s = 0; s < shape_.sun_size; ++s) {
            const double mu_s = f64::bruneton2008_chosen_sun_of_coordinate(fraction(s, shape_.sun_size), shape_.twilight).value;
            // Angles that view and sun cannot make go on as the nearest that they can.
            const double sines = std::sqrt(std::max(0.0, (1.0 - mu * mu) * (1.0 - mu_s * mu_s)));
            const double nu = std::clamp(2.0 * fraction(n, shape_.nu_size) - 1.0, mu * mu_s - sines, mu * mu_s + sines);
            RayLight light;
            light.multiple = ray.multiple(air, pack_.tables.transmittance, higher, static_cast<float>(mu_s), static_cast<float>(nu));
            light.single = single_light(air, pack_.tables.transmittance, ray, {h, mu, mu_s, nu}, nodes_per_piece);
            const std::size_t texel =
                ((static_cast<std::size_t>(altitude) * static_cast<std::size_t>(shape_.view_size) + static_cast<std::size_t>(view)) *
                     static_cast<std::size_t>(shape_.nu_size) +
                 static_cast<std::size_t>(n)) *
                    static_cast<std::size_t>(shape_.sun_size) +
                static_cast<std::size_t>(s);
            write(texel, light, nu);
        }
}

void Bruneton2008Tables::write(std::size_t texel, const RayLight& light, double nu) const {
    f32::RadianceSpectrum multiple = light.multiple;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        f32::IrradianceSpectrum single = light.single[parts_[i]];
        if (settings_.four_channels && air_ == i) {
            single += multiple / narrowed<f32::PhaseSpectrum>(pack_.optics.parts[parts_[i]].phase.at(nu));
            multiple = zero<f32::RadianceSpectrum>();
        }
        std::copy(single.v, single.v + pack_size, &single_[i][texel * pack_size]);
    }
    std::copy(multiple.v, multiple.v + pack_size, &multiple_[texel * pack_size]);
}

void Bruneton2008Tables::round_to_eight_bits(const Values& values) const {
    for (std::size_t w = 0; w < pack_size; ++w) {
        float largest = 0.0f;
        for (std::size_t t = 0; t < texels(); ++t) largest = std::max(largest, values[t * pack_size + w]);
        if (!(largest > 0.0f)) continue;
        const float levels = 255.0f / largest;
        for (std::size_t t = 0; t < texels(); ++t) {
            float& value = values[t * pack_size + w];
            value = static_cast<float>(static_cast<int>(value * levels + 0.5f)) / levels;
        }
    }
}

void Bruneton2008Tables::need(const f32::Bruneton2008Place& place) const {
    const Filtered<float> view = filtered(place.view, shape_.view_size), altitude = filtered(place.altitude, shape_.altitude_size);
    for (const std::size_t k : {altitude.low, altitude.high})
        for (const std::size_t i : {view.low, view.high})
            std::call_once(filled_[k * static_cast<std::size_t>(shape_.view_size) + i],
                           [&] { fill_row(static_cast<int>(i), static_cast<int>(k)); });
}

AirLight Bruneton2008Tables::light(const AirView& view) const {
    const f32::Bruneton2008Place place =
        f32::bruneton2008_place(shape_, metres(view.altitude_m), number(view.mu), number(view.mu_s), number(view.nu), view.ground);
    need(place);
    AirLight light;
    light.multiple = f32::bruneton2008_multiple(table<f32::RadianceSpectrum>(multiple_), place);
    for (std::size_t i = 0; i < parts_.size(); ++i)
        light.single[i] = f32::bruneton2008_single(table<f32::IrradianceSpectrum>(single_[i]), place);
    if (settings_.four_channels && air_) colour_mie(light);
    return light;
}

// The last wavelength, the reddest, is the one whose Mie scattering is kept.
void Bruneton2008Tables::colour_mie(AirLight& light) const {
    const std::size_t red = static_cast<std::size_t>(pack_.optics.wavelength_count) - 1;
    const f32::IrradianceSpectrum rayleigh = light.single[*air_];
    const f32::ScatteringSpectrum& air = pack_.air.scattering[parts_[*air_]];
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (i == *air_) continue;
        const f32::ScatteringSpectrum& mie = pack_.air.scattering[parts_[i]];
        const f32::Spectrum ratio = mie / air * f32::Number(static_cast<double>(air.v[red] / std::max(mie.v[red], 1e-30f)));
        const float quotient = rayleigh.v[red] > 0.0f ? light.single[i].v[red] / rayleigh.v[red] : 0.0f;
        light.single[i] = f32::bruneton2008_proportional_mie(rayleigh, f32::Number::of(quotient), ratio);
    }
}

f32::RadianceSpectrum Bruneton2008Tables::radiance(const AirLight& light, double nu) const {
    f32::RadianceSpectrum sum = light.multiple;
    for (std::size_t i = 0; i < parts_.size(); ++i)
        sum += light.single[i] * narrowed<f32::PhaseSpectrum>(pack_.optics.parts[parts_[i]].phase.at(nu));
    return max(sum, zero<f32::RadianceSpectrum>());
}

f32::Spectrum Bruneton2008Tables::transmittance(const AirView& view, double distance_m) const {
    return f32::bruneton2008_transmittance({transmittance_, depths_across, depths_down}, shape_, depths_across, depths_down,
                                           metres(view.altitude_m), number(view.mu), metres(distance_m), view.ground);
}

f32::RadianceSpectrum Bruneton2008Tables::ground(double mu_s) const {
    return f32::bruneton2008_ground({transmittance_, depths_across, depths_down}, {irradiance_, irradiance_across, irradiance_down}, shape_,
                                    depths_across, depths_down, irradiance_across, irradiance_down, number(mu_s),
                                    pack_.air.solar_irradiance, pack_.air.ground_albedo);
}

f32::IrradianceSpectrum Bruneton2008Tables::irradiance(double altitude_m, double mu_s) const {
    const f32::Length top = shape_.top;
    return look_up(Table2D<f32::IrradianceSpectrum>(irradiance_, irradiance_across, irradiance_down),
                   f32::bruneton2008_irradiance_place(metres(altitude_m), number(mu_s), top, irradiance_across, irradiance_down));
}

Bruneton2008Tables::Slice Bruneton2008Tables::sky_slice(double altitude_m, double mu_s) const {
    Slice slice{shape_.view_size / 2, shape_.nu_size, {}, {}};
    const auto count = static_cast<std::size_t>(slice.views * slice.nus);
    slice.multiple.resize(count);
    slice.single.assign(parts_.size(), std::vector<f32::IrradianceSpectrum>(count));
    parallel_for(static_cast<std::size_t>(slice.views), [&](std::size_t i) {
        f32::Bruneton2008Place place = f32::bruneton2008_place(shape_, metres(altitude_m), number(1.0), number(mu_s), number(-1.0), false);
        place.view = f32::texture_coordinate(fraction(static_cast<int>(i) + slice.views, shape_.view_size), shape_.view_size);
        need(place);
        // Each texel of nu by itself.
        const f32::Number first = place.low;
        place.weight = 0.0;
        for (int n = 0; n < slice.nus; ++n) {
            place.low = first + number(static_cast<double>(n) / slice.nus);
            place.high = place.low;
            const std::size_t texel = i * static_cast<std::size_t>(slice.nus) + static_cast<std::size_t>(n);
            slice.multiple[texel] = f32::bruneton2008_multiple(table<f32::RadianceSpectrum>(multiple_), place);
            for (std::size_t p = 0; p < parts_.size(); ++p)
                slice.single[p][texel] = f32::bruneton2008_single(table<f32::IrradianceSpectrum>(single_[p]), place);
        }
    });
    return slice;
}

}  // namespace airlight
