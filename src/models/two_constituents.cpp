#include "models/two_constituents.h"

#include <cmath>

#include "core/quadrature.h"

namespace airlight {

namespace {

// The altitude at which as much of a constituent lies above as below, in the mean.
double mean_altitude_m(const DensityProfile& profile, Length top) {
    if (const auto* exponential = std::get_if<ExponentialProfile>(&profile)) return exponential->scale_height.value;
    std::vector<double> ends_m = {0.0};
    for (const Length kink : kinks(profile))
        if (kink > 0.0 * m && kink < top) ends_m.push_back(kink.value);
    ends_m.push_back(top.value);
    double moment = 0.0, column = 0.0;
    for (std::size_t i = 0; i + 1 < ends_m.size(); ++i) {
        const GaussRule rule = gauss_rule(32, ends_m[i], ends_m[i + 1]);
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
            const double mass = rule.weights[k] * relative_density(profile, rule.nodes[k] * m);
            column += mass;
            moment += mass * rule.nodes[k];
        }
    }
    return column > 0.0 ? moment / column : top.value;
}

// The constituents of one kind as one exponential.
struct Kind {
    double scale_height_m = 8000.0;  // of no meaning where there is none
    f64::ScatteringSpectrum scattering{f64::ScatteringSpectrum::Scalar::of(0.0)};
    f64::ScatteringSpectrum extinction{f64::ScatteringSpectrum::Scalar::of(0.0)};
    std::vector<f64::Spectrum> shares;
};

Kind merged(const Atmosphere& atmosphere, const AirOptics& optics, bool molecules) {
    const Length top = atmosphere.top_altitude;
    Kind kind;
    kind.shares.assign(optics.parts.size(), f64::Spectrum(f64::Number(0.0)));
    std::vector<double> columns_m(optics.parts.size(), 0.0);
    double weight = 0.0, moment = 0.0;
    for (std::size_t p = 0; p < optics.parts.size(); ++p) {
        const AirOptics::Part& part = optics.parts[p];
        if (!part.scatters || std::holds_alternative<RayleighPhase>(atmosphere.constituents[p].phase) != molecules) continue;
        columns_m[p] = column_depth(part.profile, top).value;
        const double depth = part.extinction.v[pack_size / 2] * columns_m[p];
        weight += depth;
        moment += depth * mean_altitude_m(part.profile, top);
    }
    if (!(weight > 0.0)) return kind;
    kind.scale_height_m = moment / weight;
    const double column_m = kind.scale_height_m * -std::expm1(-top.value / kind.scale_height_m);
    for (std::size_t p = 0; p < optics.parts.size(); ++p) {
        const f64::Number dense = columns_m[p] / column_m;
        kind.scattering += optics.parts[p].scattering * dense;
        kind.extinction += optics.parts[p].extinction * dense;
    }
    for (std::size_t p = 0; p < optics.parts.size(); ++p)
        for (int w = 0; w < pack_size; ++w)
            if (kind.scattering.v[w] > 0.0)
                kind.shares[p].v[w] = optics.parts[p].scattering.v[w] * columns_m[p] / (column_m * kind.scattering.v[w]);
    return kind;
}

}  // namespace

f64::PhaseSpectrum TwoConstituents::mean_phase(const std::vector<f64::Spectrum>& shares, double nu) const {
    f64::PhaseSpectrum sum(0.0 * f64::per_sr);
    for (std::size_t p = 0; p < shares.size(); ++p)
        if (shares[p].v[0] > 0.0 || shares[p].v[pack_size - 1] > 0.0) sum += optics.parts[p].phase.at(nu) * shares[p];
    return sum;
}

TwoConstituents two_constituents(const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths) {
    AirOptics optics = air_optics(atmosphere, wavelengths);
    Kind molecules = merged(atmosphere, optics, true), aerosol = merged(atmosphere, optics, false);
    const auto length = [](double metres) { return f64::Length::of(metres); };
    const f64::ExponentialAir air = f64::exponential_air(optics.bottom_radius, optics.top_altitude, length(molecules.scale_height_m),
                                                         length(aerosol.scale_height_m), molecules.extinction, aerosol.extinction);
    return {air, molecules.scattering, aerosol.scattering, std::move(optics), std::move(molecules.shares), std::move(aerosol.shares)};
}

}  // namespace airlight
