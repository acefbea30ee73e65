#include "atmosphere/aerosol.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/overloaded.h"
#include "units/text.h"

namespace airlight {

namespace {

constexpr Wavelength reference_wavelength = 550.0 * nm;
// Four times coarser than the optics' own step, and as much faster: extinction and albedo stay within 1e-3.
constexpr double log_step = 4.0 * default_log_step;

std::vector<Wavelength> wavelengths_of(const SpectrumOf<Number>& a, const SpectrumOf<Number>& b) {
    std::vector<Wavelength> all;
    for (const auto* curve : {&a, &b})
        if (!curve->is_constant())
            for (const auto& sample : curve->samples()) all.push_back(sample.x);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

// Constituent whose extinction at 550 nm, where the profile is 1, is `reference`.
Constituent with_extinction(const AerosolMatter& matter, const DensityProfile& profile, InverseLength reference) {
    Constituent aerosol{"aerosol", profile};
    aerosol.phase = matter.phase;
    const auto part = [&](Wavelength w, bool scattered) {
        const Number albedo = matter.single_scattering_albedo.at(w);
        return reference * matter.extinction.at(w) * (scattered ? albedo : Number(1.0) - albedo);
    };
    const std::vector<Wavelength> wavelengths = wavelengths_of(matter.extinction, matter.single_scattering_albedo);
    if (wavelengths.empty()) {
        aerosol.scattering = SpectrumOf<InverseLength>::constant(part(reference_wavelength, true));
        aerosol.absorption = SpectrumOf<InverseLength>::constant(part(reference_wavelength, false));
        return aerosol;
    }
    std::vector<SpectrumOf<InverseLength>::Sample> scattering, absorption;
    for (const Wavelength w : wavelengths) {
        scattering.push_back({w, part(w, true)});
        absorption.push_back({w, part(w, false)});
    }
    aerosol.scattering = *SpectrumOf<InverseLength>::of(std::move(scattering));
    aerosol.absorption = *SpectrumOf<InverseLength>::of(std::move(absorption));
    return aerosol;
}

// Far beyond any air; within these bounds every coefficient is a finite number.
constexpr std::string_view amount_rule = "it must be from 0 to 1e6";
constexpr Length least_visibility = 0.001 * m;
constexpr double least_ground_density = 1e-6;
bool is_amount(double value) { return value >= 0.0 && value <= 1e6; }

Error out_of_range(std::string value, std::string_view rule, std::string remedy = {}) {
    return Error{"", fmt::format("{} is out of range: {}", value, rule), std::move(remedy)};
}

// Extinction at 550 nm that the amount asks for at the ground, from what the eye sees of it.
Result<InverseLength> ground_extinction(const Visibility& v, const MolecularAir& molecules) {
    if (!(v.distance >= least_visibility))
        return out_of_range("a visibility of " + length_text(v.distance), "it must be at least " + length_text(least_visibility));
    if (!(v.contrast > 0.0 && v.contrast < 1.0))
        return out_of_range(fmt::format("a contrast of {}", v.contrast), "it must be above 0 and below 1",
                            "Koschmieder's is 0.02, that of weather stations 0.05.");
    return aerosol_extinction_of_visibility(v.distance, molecules.scattering_at_ground, v.contrast);
}

Result<double> depth_550(const OpticalDepth550& d) {
    if (is_amount(d.value)) return d.value;
    return out_of_range(fmt::format("an optical depth of {}", d.value), amount_rule);
}
Result<double> depth_550(const Turbidity& t, const MolecularAir& molecules) {
    if (t.value >= 1.0 && is_amount(t.value)) return aerosol_depth_of_turbidity(t.value, molecules.optical_depth);
    return out_of_range(fmt::format("a turbidity of {}", t.value), "it must be from 1 to 1e6",
                        "1 is air without any aerosol, 2 clear, 6 hazy, 10 thick haze.");
}

}  // namespace

Result<AerosolMatter> opac_matter(AerosolType type, double relative_humidity) {
    constexpr double wavelengths_nm[] = {300, 340, 380, 420, 460, 500, 550, 600, 650, 700, 750, 800, 850, 900, 950, 1000};
    std::vector<Wavelength> wavelengths;
    for (const double w : wavelengths_nm) wavelengths.push_back(w * nm);
    const Result<AerosolOptics> optics = aerosol_optics(type, relative_humidity, wavelengths, log_step);
    if (!optics) return optics.error();

    AerosolMatter matter;
    matter.typical_extinction_550 = extinction(*optics, reference_wavelength);
    std::vector<SpectrumOf<Number>::Sample> relative, albedo;
    for (const Wavelength w : wavelengths) {
        relative.push_back({w, extinction(*optics, w) / matter.typical_extinction_550});
        albedo.push_back({w, single_scattering_albedo(*optics, w)});
    }
    matter.extinction = *SpectrumOf<Number>::of(std::move(relative));
    matter.single_scattering_albedo = *SpectrumOf<Number>::of(std::move(albedo));
    matter.phase = optics->phase;
    return matter;
}

Result<InverseLength> opac_extinction_550(AerosolType type, double relative_humidity) {
    const Result<AerosolOptics> optics = aerosol_optics(type, relative_humidity, std::span(&reference_wavelength, 1), log_step);
    if (!optics) return optics.error();
    return extinction(*optics, reference_wavelength);
}

DensityProfile opac_profile(AerosolType type) {
    const AerosolLayer layer = layer_of(type);
    return ExponentialProfile{layer.scale_height, layer.top};
}

SpectrumOf<Number> angstrom_extinction(double alpha) {
    std::vector<SpectrumOf<Number>::Sample> samples;
    for (int w = 300; w <= 1000; w += 10) samples.push_back({w * nm, angstrom_factor(alpha, reference_wavelength, w * nm)});
    return *SpectrumOf<Number>::of(std::move(samples));
}

Result<Constituent> aerosol_constituent(const AerosolMatter& matter, const DensityProfile& profile, const AerosolAmount& amount,
                                        const MolecularAir& molecules, Length top) {
    const Length depth = column_depth(profile, top);
    const double at_ground = relative_density(profile, 0.0 * m);
    if (!is_column_depth(depth)) return out_of_range("the profile", column_depth_rule);
    const auto of_depth = [&](const AerosolMatter& made, const Result<double>& optical_depth) -> Result<Constituent> {
        if (!optical_depth) return optical_depth.error();
        return with_extinction(made, profile, *optical_depth / depth);
    };
    return std::visit(
        Overloaded{
            [&](const OpticalDepth550& d) { return of_depth(matter, depth_550(d)); },
            [&](const Turbidity& t) { return of_depth(matter, depth_550(t, molecules)); },
            [&](const Visibility& v) -> Result<Constituent> {
                if (!(at_ground >= least_ground_density))
                    return out_of_range("the profile", "to set a visibility it must hold some aerosol at the ground");
                const Result<InverseLength> extinction = ground_extinction(v, molecules);
                if (!extinction) return extinction.error();
                return with_extinction(matter, profile, *extinction / at_ground);
            },
            [&](const AngstromLaw& law) -> Result<Constituent> {
                if (!is_amount(law.beta)) return out_of_range(fmt::format("a beta of {}", law.beta), amount_rule);
                if (!(std::abs(law.alpha) <= 10.0))
                    return out_of_range(fmt::format("an alpha of {}", law.alpha), "it must be from -10 to 10",
                                        "Haze is near 1.3, desert dust near 0.2.");
                AerosolMatter made = matter;
                made.extinction = angstrom_extinction(law.alpha);
                return with_extinction(made, profile, optical_depth(law, reference_wavelength) / depth);
            },
            [&](const GroundExtinction550& e) -> Result<Constituent> {
                if (is_amount(e.value.value)) return with_extinction(matter, profile, e.value);
                return out_of_range("an extinction of " + inverse_length_text(e.value), "it must be from 0 to 1e6 1/m");
            },
            [&](const TypicalAmount& t) -> Result<Constituent> {
                if (!(matter.typical_extinction_550.value > 0.0))
                    return Error{"", "only an aerosol of a type has a typical amount", "Give its type, or another kind of amount."};
                if (is_amount(t.factor)) return with_extinction(matter, profile, t.factor * matter.typical_extinction_550);
                return out_of_range(fmt::format("a factor of {}", t.factor), amount_rule);
            },
        },
        amount);
}

}  // namespace airlight
