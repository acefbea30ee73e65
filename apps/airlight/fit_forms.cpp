#include "fit_forms.h"

#include <fmt/format.h>

#include <algorithm>

#include "fit/dobashi1997.h"
#include "fit/hipiny2006.h"
#include "fit/hosek2012.h"
#include "fit/oneil2005.h"
#include "fit/perez1993.h"
#include "fit/preetham1999.h"
#include "models/turbidity.h"

namespace airlight::cli {

namespace {

// The atmosphere's own, if none was given.
Result<std::vector<double>> turbidities_of(const FitAsked& asked) {
    if (!asked.turbidities.empty()) return asked.turbidities;
    const Result<double> own = turbidity(asked.atmosphere);
    if (!own) return own.error();
    return std::vector<double>{*own};
}

// The ground, if none was given.
Result<Length> altitude_of(const FitAsked& asked) {
    if (asked.altitudes_m.size() > 1)
        return Error{"--altitude-m", "has several altitudes: a file of this model is for one", "Fit a file for each."};
    return (asked.altitudes_m.empty() ? 0.0 : asked.altitudes_m.front()) * m;
}

std::string comment(std::string_view model, const FitAsked& asked) {
    return fmt::format("# {} fitted by `airlight fit` to {}", model, asked.atmosphere.name);
}

Result<Fitted> perez(const FitAsked& asked, const Workplace& place) {
    const Result<Length> altitude = altitude_of(asked);
    if (!altitude) return altitude.error();
    const Result<PerezFit> fit =
        fit_perez1993(asked.atmosphere, asked.wavelengths, *altitude, asked.truth, place.team, place.store, place.progress);
    if (!fit) return fit.error();
    return Fitted{perez1993_csv(fit->data, comment("perez1993", asked) +
                                               "\n# radiance = scale (1 + a exp(b / cos theta)) (1 + c exp(d gamma) + e cos^2 gamma), "
                                               "W m-2 sr-1 nm-1; linear between suns"),
                  fit->residuals};
}

Result<Fitted> dobashi(const FitAsked& asked, const Workplace& place) {
    const Result<Length> altitude = altitude_of(asked);
    if (!altitude) return altitude.error();
    Dobashi1997Settings settings{.altitude = *altitude};
    if (asked.error) settings.error = *asked.error;
    if (!asked.variant.empty()) {
        const Result<SkyBasis> basis = sky_basis_named(asked.variant);
        if (!basis) return at("--variant", basis.error());
        settings.basis = *basis;
    }
    const Result<DobashiFit> fit =
        fit_dobashi1997(asked.atmosphere, asked.wavelengths, settings, asked.truth, place.team, place.store, place.progress);
    if (!fit) return fit.error();
    return Fitted{dobashi1997_csv(fit->data, comment("dobashi1997", asked) + fmt::format(", error {:g}", settings.error)), fit->residuals};
}

Result<Fitted> preetham(const FitAsked& asked, const Workplace& place) {
    const Result<Length> altitude = altitude_of(asked);
    if (!altitude) return altitude.error();
    const Result<std::vector<double>> turbidities = turbidities_of(asked);
    if (!turbidities) return turbidities.error();
    const Result<PreethamFit> fit =
        fit_preetham1999(asked.atmosphere, {*turbidities, *altitude, asked.truth}, place.team, place.store, place.progress);
    if (!fit) return fit.error();
    return Fitted{preetham1999_csv(fit->data, comment("preetham1999", asked)), fit->residuals};
}

Result<Fitted> oneil(const FitAsked& asked, const Workplace&) {
    const ONeilFit fit = fit_oneil2005(asked.atmosphere);
    return Fitted{oneil2005_csv(fit.data, comment("oneil2005", asked)), fit.residuals};
}

Result<Fitted> hipiny(const FitAsked& asked, const Workplace& place) {
    const Result<std::vector<double>> turbidities = turbidities_of(asked);
    if (!turbidities) return turbidities.error();
    HipinyFitSettings settings{{0.0, 2000.0, 6000.0, 14000.0, 30000.0}, *turbidities, asked.truth};
    if (!asked.altitudes_m.empty()) settings.altitudes_m = asked.altitudes_m;
    const Result<HipinyFit> fit = fit_hipiny2006(asked.atmosphere, settings, place.team, place.store, place.progress);
    if (!fit) return fit.error();
    return Fitted{hipiny2006_csv(fit->data, comment("hipiny2006", asked) + ", its aerosol scaled to each turbidity"), fit->residuals};
}

Result<Fitted> hosek(const FitAsked& asked, const Workplace& place) {
    const Result<Length> altitude = altitude_of(asked);
    if (!altitude) return altitude.error();
    const Result<std::vector<double>> turbidities = turbidities_of(asked);
    if (!turbidities) return turbidities.error();
    HosekFitSettings settings{*turbidities, {0.0, 1.0}, asked.wavelengths, *altitude, asked.truth};
    if (!asked.albedos.empty()) settings.albedos = asked.albedos;
    const Result<HosekFit> fit = fit_hosek2012(asked.atmosphere, settings, place.team, place.store, place.progress);
    if (!fit) return fit.error();
    return Fitted{hosek_csv(*fit, asked.atmosphere.name), fit->residuals};
}

constexpr FitForm forms[] = {
    {"perez", "perez1993", " --wavelengths --altitude-m ", true, "Perez's five coefficients and a scale at each wavelength and sun", perez},
    {"dobashi1997", "dobashi1997", " --wavelengths --altitude-m --variant --error ", true,
     "series of cosines (or samples, or spherical harmonics) for 21 suns", dobashi},
    {"preetham", "preetham1999", " --turbidities --altitude-m ", true, "luminance and chromaticity, coefficients linear in turbidity",
     preetham},
    {"oneil2005", "oneil2005", " ", false, "the scale function of the air's and the aerosol's scale height", oneil},
    {"hipiny2006", "hipiny2006", " --turbidities --altitude-m ", true, "luminance and chromaticity by sun, turbidity and altitude", hipiny},
    {"hosek", "hosek2012", " --wavelengths --turbidities --albedos --altitude-m ", true,
     "nine parameters and a mean at each wavelength, turbidity and albedo", hosek},
};

}  // namespace

std::span<const FitForm> fit_forms() { return forms; }

Result<const FitForm*> fit_form_named(const std::string& name) {
    const auto found =
        std::find_if(std::begin(forms), std::end(forms), [&](const FitForm& f) { return f.name == name || f.model == name; });
    if (found != std::end(forms)) return &*found;
    std::string names;
    for (const FitForm& form : forms) names.append(names.empty() ? "" : " ").append(form.name);
    return Error{"", fmt::format("\"{}\" is no model that can be fitted", name), fmt::format("Models are: {}.", names)};
}

}  // namespace airlight::cli
