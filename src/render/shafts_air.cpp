#include "render/shafts_air.h"

#include <array>
#include <cmath>
#include <vector>

#include "physics/f64.h"
#include "transport/air_optics.h"
#include "transport/columns.h"

namespace airlight::render {

namespace {

constexpr unsigned first_texture = 8;
constexpr int altitudes = 256, angles = 256, sun_altitudes = 64, sun_cosines = 128;

// What the channels of a screen see most of.
const std::array<Wavelength, 3> wavelengths = {465.0 * nm, 545.0 * nm, 610.0 * nm};
// Red, green and blue, in the order of `wavelengths`.
constexpr std::array<int, 3> of_channel = {2, 1, 0};

AirOptics optics_of(const Atmosphere& air) { return air_optics(air, wavelengths); }

double coordinate(int texel, int texels) { return static_cast<double>(texel) / (texels - 1); }

template <class Spectrum>
void put(std::vector<float>& texels, const Spectrum& s) {
    for (const int w : of_channel) texels.push_back(static_cast<float>(s.v[w]));
    texels.push_back(0.0f);
}

std::vector<const AirOptics::Part*> scattering_parts(const AirOptics& air) {
    std::vector<const AirOptics::Part*> parts;
    for (const AirOptics::Part& part : air.parts)
        if (part.scatters) parts.push_back(&part);
    return parts;
}

gpu::Texture profiles_of(const AirOptics& air) {
    const std::vector<const AirOptics::Part*> scattering = scattering_parts(air);
    const auto altitude = [&](int i) { return f64::altitude_of_coordinate(coordinate(i, altitudes), air.top_altitude); };
    std::vector<float> texels;
    for (int i = 0; i < altitudes; ++i) {
        f64::ScatteringSpectrum extinction(0.0 / m);
        for (const AirOptics::Part& part : air.parts)
            extinction = extinction + part.extinction * relative_density(part.profile, altitude(i));
        put(texels, extinction);
    }
    for (const AirOptics::Part* part : scattering)
        for (int i = 0; i < altitudes; ++i) put(texels, part->scattering * relative_density(part->profile, altitude(i)));
    return gpu::Texture({altitudes, static_cast<int>(scattering.size()) + 1}, texels);
}

gpu::Texture phases_of(const AirOptics& air) {
    const std::vector<const AirOptics::Part*> scattering = scattering_parts(air);
    std::vector<float> texels, reference(4 * angles, 0.0f);
    for (const AirOptics::Part* part : scattering)
        for (int i = 0; i < angles; ++i) {
            const double root = coordinate(i, angles);
            put(texels, part->phase.at(std::cos(root * root * pi)));
            texels.back() = part->phase.is_rayleigh() ? 0.0f : 1.0f;
            for (std::size_t c = 0; c < 3; ++c)
                reference[static_cast<std::size_t>(4 * i) + c] += texels.back() * texels[texels.size() - 4 + c];
        }
    texels.insert(texels.end(), reference.begin(), reference.end());
    return gpu::Texture({angles, static_cast<int>(scattering.size()) + 1}, texels);
}

gpu::Texture sun_depth_of(const AirOptics& air) {
    std::vector<DensityProfile> profiles;
    for (const AirOptics::Part& part : air.parts) profiles.push_back(part.profile);
    const Columns columns(profiles, air.bottom_radius, air.top_altitude);
    std::vector<float> texels;
    for (int j = 0; j < sun_altitudes; ++j)
        for (int i = 0; i < sun_cosines; ++i) {
            const f64::Length h = f64::altitude_of_coordinate(coordinate(j, sun_altitudes), air.top_altitude);
            const f64::Number mu =
                f64::transmittance_cosine_of_coordinate(h, coordinate(i, sun_cosines), air.bottom_radius, air.top_altitude);
            const ColumnSet column = columns.to_top(h.in(m), mu.value);
            for (const int w : of_channel) {
                double depth = 0.0;
                for (std::size_t p = 0; p < air.parts.size(); ++p) depth += air.parts[p].extinction.v[w] * column.v[p];
                texels.push_back(static_cast<float>(depth));
            }
            texels.push_back(0.0f);
        }
    return gpu::Texture({sun_cosines, sun_altitudes}, texels);
}

}  // namespace

ShaftsAir::ShaftsAir(const Atmosphere& atmosphere)
    : profiles_(profiles_of(optics_of(atmosphere))),
      phases_(phases_of(optics_of(atmosphere))),
      sun_depth_(sun_depth_of(optics_of(atmosphere))) {}

void ShaftsAir::bind() const {
    unsigned binding = first_texture;
    for (const gpu::Texture* texture : {&profiles_, &phases_, &sun_depth_}) texture->bind_sampler(binding++);
}

}  // namespace airlight::render
