#include "transport/ray_light.h"

#include <algorithm>
#include <cmath>

#include "transport/pack_arithmetic.h"

namespace airlight {

namespace {

AIRLIGHT_INLINE Texels sun_texels(float mu_s, int size) {
    return texels_at(f32::texture_coordinate(f32::sun_coordinate(mu_s), size).value, size);
}
AIRLIGHT_INLINE Texels azimuth_texels(float cos_phi, int size) {
    return texels_at(f32::texture_coordinate(f32::azimuth_coordinate(cos_phi), size).value, size);
}
AIRLIGHT_INLINE Texels view_texels(float mu, int size) {
    return texels_at(f32::texture_coordinate(f32::view_coordinate(mu), size).value, size);
}

// Light that the ground sends up where the ray ends.
f32::RadianceSpectrum light_from_ground(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, const Gathered& what,
                                        float mu_s) {
    f32::IrradianceSpectrum sum = zero<f32::IrradianceSpectrum>();
    if (what.direct_on_ground) sum += direct_irradiance(air, transmittance, 0.0f, mu_s);
    if (what.diffuse_on_ground) {
        const auto& size = what.diffuse_on_ground->size();
        sum += what.diffuse_on_ground->geometric_at({sun_texels(mu_s, size[0]), Texels{0, 0, 0.0f}});
    }
    return sum * air.ground_albedo * (1.0 / f32::pi * f32::per_sr);
}

// Of the sun's zenith angle, down to which its rays have grazed no dense air.
float clear_horizon_cosine(const Shell& shell, float altitude_m) {
    const float edge = static_cast<float>(shadow_edges.back() * shell.top_m);
    return f32::horizon_cosine(f32::Length::of(std::max(altitude_m - edge, 0.0f)),
                               f32::Length::of(static_cast<float>(shell.bottom_m) + edge))
        .value;
}

}  // namespace

RayLight gather(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, const Gathered& what, const RayNodes& nodes, float nu) {
    RayLight light;
    light.multiple = zero<f32::RadianceSpectrum>();
    std::array<f32::LengthSpectrum, max_parts> lit_length;  // of each part's air, as if of density one
    lit_length.fill(zero<f32::LengthSpectrum>());
    for (int n = 0; n < nodes.count; ++n) {
        const f32::LengthSpectrum seen = transmittance_of(air, nodes.column_m[n]) * f32::Length::of(nodes.length_m[n]);
        if (what.single) {
            const f32::LengthSpectrum weight = seen * sun_transmittance(air, transmittance, nodes.altitude_m[n], nodes.mu_s[n]);
            for (int p = 0; p < air.parts; ++p) lit_length[static_cast<std::size_t>(p)] += weight * f32::Number(nodes.density[n][p]);
        }
        if (what.source) {
            const auto& size = what.source->size();
            const float cos_phi = f32::relative_azimuth_cosine(nodes.mu[n], nodes.mu_s[n], nu).value;
            const f32::RadianceSpectrum source =
                what.source->geometric_at({sun_texels(nodes.mu_s[n], size[0]), azimuth_texels(cos_phi, size[1]),
                                           view_texels(nodes.mu[n], size[2]), air.source_axis.at(nodes.altitude_m[n])});
            light.multiple += source * (weighted_sum(air.scattering, nodes.density[n], air.parts) * seen);
        }
    }
    for (std::size_t p = 0; p < max_parts; ++p)
        light.single[p] =
            static_cast<int>(p) < air.parts ? lit_length[p] * air.scattering[p] * air.solar_irradiance : zero<f32::IrradianceSpectrum>();
    light.transmittance = transmittance_of(air, nodes.total_column_m);
    if (nodes.meets_ground) light.multiple += light_from_ground(air, transmittance, what, nodes.end_mu_s) * light.transmittance;
    return light;
}

PreparedRay::PreparedRay(const PackAir& air, double altitude_m, double mu, int nodes_per_piece, const std::array<int, 4>& source_size)
    : radius_m_(static_cast<float>(air.shell.bottom_m + altitude_m)) {
    RayNodes nodes;
    // A sun in the direction of the ray itself casts no shadow across it.
    sample_ray(air.shell, {altitude_m, mu, mu, 1.0}, air.densities, air.opacity, nodes_per_piece, nodes);
    meets_ground_ = nodes.meets_ground;
    end_distance_m_ = nodes.end_distance_m;
    end_inverse_radius_ = static_cast<float>(1.0 / (air.shell.bottom_m + nodes.end_altitude_m));
    transmittance_ = transmittance_of(air, nodes.total_column_m);
    for (int n = 0; n < nodes.count; ++n) {
        Node node;
        node.seen = transmittance_of(air, nodes.column_m[n]) * f32::Length::of(nodes.length_m[n]);
        node.scattering = node.seen * weighted_sum(air.scattering, nodes.density[n], air.parts);
        std::copy(nodes.density[n], nodes.density[n] + max_parts, node.density.begin());
        node.altitude_m = nodes.altitude_m[n];
        node.mu = nodes.mu[n];
        node.sine = std::sqrt(std::max(0.0f, 1.0f - node.mu * node.mu));
        node.distance_m = nodes.distance_m[n];
        node.inverse_radius = static_cast<float>(1.0 / (air.shell.bottom_m + node.altitude_m));
        node.horizon = f32::horizon_cosine(f32::Length::of(node.altitude_m), f32::Length::of(static_cast<float>(air.shell.bottom_m))).value;
        node.clear_horizon = clear_horizon_cosine(air.shell, node.altitude_m);
        node.view = view_texels(node.mu, source_size[2]);
        node.altitude = air.source_axis.at(node.altitude_m);
        nodes_.push_back(node);
    }
}

f32::RadianceSpectrum PreparedRay::multiple(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, const Gathered& what,
                                            float mu_s, float nu) const {
    f32::RadianceSpectrum light = zero<f32::RadianceSpectrum>();
    if (what.source) {
        const auto& size = what.source->size();
        for (const Node& node : nodes_) {
            const float at = std::clamp(sun_cosine(node, mu_s, nu), -1.0f, 1.0f);
            const float sines = node.sine * std::sqrt(std::max(0.0f, 1.0f - at * at));
            const float cos_phi = sines > 1e-6f ? (nu - node.mu * at) / sines : 1.0f;
            light +=
                what.source->at({sun_texels(at, size[0]), azimuth_texels(cos_phi, size[1]), node.view, node.altitude}) * node.scattering;
        }
    }
    if (meets_ground_) {
        const float end = std::clamp((radius_m_ * mu_s + nu * end_distance_m_) * end_inverse_radius_, -1.0f, 1.0f);
        light += light_from_ground(air, transmittance, what, end) * transmittance_;
    }
    return light;
}

PreparedRay::Lit PreparedRay::lit(const PackAir& air, float mu_s, float nu) const {
    bool any = false;
    bool all = true;
    for (const Node& node : nodes_) {
        const float sun = sun_cosine(node, mu_s, nu);  // its difference from a horizon's is at least the sine of its height above that
        any = any || sun - node.horizon > -air.sun_angular_radius;
        all = all && sun - node.clear_horizon > air.sun_angular_radius;
    }
    return all ? Lit::all : any ? Lit::part : Lit::nothing;
}

void PreparedRay::single(const PackAir& air, const Table<f32::Spectrum, 2>& transmittance, float mu_s, float nu,
                         std::array<f32::IrradianceSpectrum, max_parts>& light) const {
    std::array<f32::LengthSpectrum, max_parts> lit_length;
    lit_length.fill(zero<f32::LengthSpectrum>());
    for (const Node& node : nodes_) {
        const float at = std::clamp(sun_cosine(node, mu_s, nu), -1.0f, 1.0f);
        const f32::LengthSpectrum weight = node.seen * sun_transmittance(air, transmittance, node.altitude_m, at);
        for (int p = 0; p < air.parts; ++p)
            lit_length[static_cast<std::size_t>(p)] += weight * f32::Number(node.density[static_cast<std::size_t>(p)]);
    }
    for (std::size_t p = 0; p < static_cast<std::size_t>(air.parts); ++p)
        light[p] = lit_length[p] * air.scattering[p] * air.solar_irradiance;
}

}  // namespace airlight
