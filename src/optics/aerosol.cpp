#include "optics/aerosol.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/parallel.h"

namespace airlight {

namespace {

struct NumberRow {
    AerosolComponent component;
    double number_cm3;
};

struct TypeRow {
    AerosolType type;
    std::string_view name;
    double scale_height_km;
    double top_km;
    NumberRow numbers[4];  // those not used are zero
};

constexpr TypeRow type_rows[] = {
#include "aerosol_types.inc"
};

const TypeRow& row_of(AerosolType type) {
    return *std::find_if(std::begin(type_rows), std::end(type_rows), [&](const TypeRow& row) { return row.type == type; });
}

std::optional<Error> out_of_range(std::span<const AerosolShare> mixture, double relative_humidity,
                                  std::span<const Wavelength> wavelengths) {
    if (!(relative_humidity >= 0.0 && relative_humidity <= greatest_relative_humidity))
        return Error{"",
                     fmt::format("a relative humidity of {} % is out of range: the aerosol is known from 0 to {} %", relative_humidity,
                                 greatest_relative_humidity),
                     "Above it fog forms; give 99 % for the dampest haze."};
    if (wavelengths.empty()) return Error{"", "an aerosol needs at least one wavelength", ""};
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        if (!(first_aerosol_wavelength <= wavelengths[i] && wavelengths[i] <= last_aerosol_wavelength))
            return Error{"", fmt::format("{} nm is out of range: the aerosol is known from 250 to 1000 nm", wavelengths[i].in(nm)), ""};
        if (i > 0 && !(wavelengths[i - 1] < wavelengths[i]))
            return Error{"", fmt::format("the wavelength {} nm does not lie above the one before it", wavelengths[i].in(nm)),
                         "Sort them and remove doubles."};
    }
    for (const AerosolShare& share : mixture)
        if (!(share.number >= 0.0 * per_m3 && std::isfinite(share.number.value)))
            return Error{"",
                         fmt::format("{} particles of {} in a cubic centimetre are out of range: give 0 or more", share.number.in(per_cm3),
                                     name(share.component)),
                         ""};
    return std::nullopt;
}

// The functions of angle, for the longest series that the mixture needs.
MieAngles angles_for(std::span<const AerosolShare> mixture, double relative_humidity, Wavelength shortest) {
    std::vector<double> cosines;
    for (const double angle : aerosol_phase_angles()) cosines.push_back(std::cos(angle));
    std::size_t terms = 1;
    for (const AerosolShare& share : mixture) terms = std::max(terms, series_terms(sizes_of(share.component, relative_humidity), shortest));
    return MieAngles(cosines, terms);
}

// mean_particle() of each component at each wavelength: [wavelength][component].
std::vector<std::vector<MeanParticle>> mean_particles(std::span<const AerosolShare> mixture, double relative_humidity,
                                                      std::span<const Wavelength> wavelengths, double log_step) {
    const MieAngles angles = angles_for(mixture, relative_humidity, wavelengths.front());
    std::vector<std::vector<MeanParticle>> means(wavelengths.size(), std::vector<MeanParticle>(mixture.size()));
    parallel_for(wavelengths.size() * mixture.size(), [&](std::size_t i) {
        const std::size_t w = i / mixture.size();
        const AerosolComponent component = mixture[i % mixture.size()].component;
        means[w][i % mixture.size()] =
            mean_particle(sizes_of(component, relative_humidity), refractive_index_of(component, relative_humidity, wavelengths[w]),
                          wavelengths[w], angles, log_step);
    });
    return means;
}

}  // namespace

std::string_view name(AerosolType type) { return row_of(type).name; }

Result<AerosolType> parse_aerosol_type(std::string_view text) {
    std::string all;
    for (const TypeRow& row : type_rows) {
        if (row.name == text) return row.type;
        all += all.empty() ? "" : " ";
        all += row.name;
    }
    const std::string near = nearest_word(text, all);
    return Error{"", fmt::format("'{}' is no type of aerosol", text),
                 near.empty() ? fmt::format("There are: {}.", all) : fmt::format("Did you mean {}?", near)};
}

AerosolLayer layer_of(AerosolType type) { return {row_of(type).scale_height_km * km, row_of(type).top_km * km}; }

std::vector<AerosolShare> mixture_of(AerosolType type) {
    std::vector<AerosolShare> mixture;
    for (const NumberRow& row : row_of(type).numbers)
        if (row.number_cm3 > 0.0) mixture.push_back({row.component, row.number_cm3 * per_cm3});
    return mixture;
}

InverseLength extinction(const AerosolOptics& aerosol, Wavelength wavelength) {
    return aerosol.scattering.at(wavelength) + aerosol.absorption.at(wavelength);
}

double single_scattering_albedo(const AerosolOptics& aerosol, Wavelength wavelength) {
    return (aerosol.scattering.at(wavelength) / extinction(aerosol, wavelength)).value;
}

Result<AerosolOptics> aerosol_optics(AerosolType type, double relative_humidity, std::span<const Wavelength> wavelengths, double log_step) {
    return mixture_optics(mixture_of(type), relative_humidity, wavelengths, log_step);
}

Result<AerosolOptics> mixture_optics(std::span<const AerosolShare> mixture, double relative_humidity,
                                     std::span<const Wavelength> wavelengths, double log_step) {
    assert(log_step > 0.0);
    if (const std::optional<Error> error = out_of_range(mixture, relative_humidity, wavelengths)) return *error;
    const std::vector<std::vector<MeanParticle>> means = mean_particles(mixture, relative_humidity, wavelengths, log_step);

    std::vector<SpectrumOf<InverseLength>::Sample> scattering;
    std::vector<SpectrumOf<InverseLength>::Sample> absorption;
    TabulatedPhase phase{aerosol_phase_angles(), {wavelengths.begin(), wavelengths.end()}, {}};
    for (std::size_t w = 0; w < wavelengths.size(); ++w) {
        scattering.push_back({wavelengths[w], 0.0 * per_m});
        absorption.push_back({wavelengths[w], 0.0 * per_m});
        phase.values.emplace_back(phase.angles.size(), 0.0);
        for (std::size_t c = 0; c < mixture.size(); ++c) {
            scattering.back().y += mixture[c].number * means[w][c].scattering;
            absorption.back().y += mixture[c].number * means[w][c].absorption;
            for (std::size_t a = 0; a < phase.angles.size(); ++a)
                phase.values[w][a] += mixture[c].number.value * means[w][c].scattering_m2_sr[a];
        }
    }
    Result<PhaseFunction> normalised = tabulated_phase(std::move(phase));
    if (!normalised) return normalised.error();
    return AerosolOptics{*SpectrumOf<InverseLength>::of(std::move(scattering)), *SpectrumOf<InverseLength>::of(std::move(absorption)),
                         *std::move(normalised)};
}

std::vector<double> aerosol_phase_angles() {
    constexpr int forward_steps = 60;
    std::vector<double> angles;
    for (int i = 0; i < forward_steps; ++i) angles.push_back(10.0 * deg * i * i / (forward_steps * forward_steps));
    for (int degrees = 10; degrees < 180; ++degrees) angles.push_back(degrees * deg);
    angles.push_back(pi);
    return angles;
}

}  // namespace airlight
