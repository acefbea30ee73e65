#include "fit/truth.h"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "atmosphere/coefficients.h"
#include "core/parallel.h"
#include "models/turbidity.h"

namespace airlight {

namespace {

using Numbers = std::vector<double>;

// Raised when the same views get other numbers, so that older jobs are not taken for new ones.
constexpr std::string_view version = "true sky 1";

TableKey key_of(const Atmosphere& atmosphere, std::span<const View> views, std::span<const Wavelength> wavelengths,
                const TruthSettings& s) {
    JobKey key(version);
    key.add(s.truth == Truth::tables ? table_key(atmosphere, wavelengths, s.bake) : description_key(atmosphere, wavelengths));
    if (s.truth == Truth::reference)
        key.add(fmt::format("reference {} {} {} {}", s.reference.paths, s.reference.seed, s.reference.first_order, s.reference.last_order));
    for (const View& v : views) key.add(Numbers{v.altitude.value, v.view_zenith, v.sun_zenith, v.relative_azimuth});
    return key.hash();
}

Result<Numbers> radiances(const Atmosphere& atmosphere, std::span<const View> views, std::vector<Wavelength> wavelengths,
                          const TruthSettings& s, const Progress& progress) {
    const std::size_t n = wavelengths.size();
    ModelOptions options;
    options.bake = s.bake;
    options.cache.enabled = false;  // nothing is kept but the job itself: a fit leaves no gigabytes of tables behind
    options.reference = s.reference;
    options.progress = progress;
    const Result<std::unique_ptr<Sky>> sky =
        make_sky(s.truth == Truth::tables ? "tables" : "reference", atmosphere, std::move(wavelengths), options);
    if (!sky) return sky.error();
    Numbers all(views.size() * n);
    std::vector<std::optional<Error>> errors(views.size());
    parallel_for(views.size(), [&](std::size_t i) {
        const Result<RadianceEstimate> seen = (*sky)->radiance(views[i]);
        if (seen) std::copy(seen->radiance_W_m2_sr_nm.begin(), seen->radiance_W_m2_sr_nm.end(), all.begin() + static_cast<long>(i * n));
        else errors[i] = seen.error();
    });
    for (const std::optional<Error>& error : errors)
        if (error) return *error;
    return all;
}

// The views of a sky in the parts that are one job each.
std::vector<std::span<const View>> parts_of(std::span<const View> views, Truth truth) {
    if (truth == Truth::tables) return {views};
    std::vector<std::span<const View>> parts;
    for (std::size_t first = 0, i = 1; i <= views.size(); ++i)
        if (i == views.size() || views[i].sun_zenith != views[first].sun_zenith) {
            parts.push_back(views.subspan(first, i - first));
            first = i;
        }
    return parts;
}

}  // namespace

Result<std::vector<Numbers>> true_radiances(std::span<const TrueSky> skies, std::span<const Wavelength> wavelengths,
                                            const TruthSettings& settings, Team& team, const JobStore& store, const Progress& progress) {
    std::vector<Job> jobs;
    std::vector<std::size_t> sky_of;
    for (std::size_t s = 0; s < skies.size(); ++s)
        for (const std::span<const View> views : parts_of(skies[s].views, settings.truth)) {
            jobs.push_back(
                {key_of(skies[s].atmosphere, views, wavelengths, settings), [&settings, &skies, s, views, wavelengths](const Progress& p) {
                     return radiances(skies[s].atmosphere, views, {wavelengths.begin(), wavelengths.end()}, settings, p);
                 }});
            sky_of.push_back(s);
        }
    const Result<std::vector<Numbers>> parts =
        team.computed(jobs, store, settings.truth == Truth::tables ? "tables of the skies" : "reference of the skies", progress);
    if (!parts) return parts.error();
    std::vector<Numbers> all(skies.size());
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        if ((*parts)[i].size() % wavelengths.size() != 0) return Error{"", "a finished job has the wrong size", "Choose another --cache."};
        all[sky_of[i]].insert(all[sky_of[i]].end(), (*parts)[i].begin(), (*parts)[i].end());
    }
    return all;
}

Result<Atmosphere> with_turbidity(Atmosphere atmosphere, double wanted) {
    const Result<double> own = turbidity(atmosphere);
    if (!own) return own.error();
    if (!(wanted >= 1.0)) return Error{"", fmt::format("a turbidity of {:g} is out of range: it must be 1 or more", wanted), ""};
    if (wanted == *own) return atmosphere;
    if (!(*own > 1.0))
        return Error{atmosphere.name, fmt::format("has no aerosol, so its turbidity cannot be {:g}", wanted), "Add one to its file."};
    for (Constituent& c : atmosphere.constituents)
        if (!std::holds_alternative<RayleighPhase>(c.phase) && c.scattering.at(550.0 * nm) > 0.0 * per_m)
            c = scaled(std::move(c), (wanted - 1.0) / (*own - 1.0));
    return atmosphere;
}

std::vector<FitDirection> fit_directions(double sun_zenith, int rings, int azimuths) {
    std::vector<FitDirection> all;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < azimuths; ++j) all.push_back({{std::acos((i + 0.5) / rings), pi * (j + 0.5) / azimuths}, 1.0});
    for (int j = 0; j < azimuths; j += 2) all.push_back({{std::acos(0.3 / rings), pi * (j + 0.5) / azimuths}, 0.5});
    // Around the sun, in the parts of circles that are above the horizon: gamma from it, psi from straight up.
    for (const double gamma : {2.0 * deg, 4.0 * deg, 8.0 * deg, 14.0 * deg})
        for (const double psi : {0.0, 60.0 * deg, 120.0 * deg, 180.0 * deg}) {
            const double mu = std::cos(gamma) * std::cos(sun_zenith) + std::sin(gamma) * std::sin(sun_zenith) * std::cos(psi);
            if (!(mu > 0.002) || !(mu < 0.9999)) continue;
            const double zenith = std::acos(mu);
            const double x = std::cos(gamma) * std::sin(sun_zenith) - std::sin(gamma) * std::cos(sun_zenith) * std::cos(psi);
            all.push_back({{zenith, std::atan2(std::sin(gamma) * std::sin(psi), x)}, 0.3});
        }
    return all;
}

}  // namespace airlight
