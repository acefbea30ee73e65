#include "atmosphere/validate.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "core/overloaded.h"
#include "units/text.h"

namespace airlight {

namespace {

using Broken = std::optional<BrokenRule>;

std::string number_text(double value) { return fmt::format("{}", value); }
std::string quoted(const std::string& text) { return '"' + text + '"'; }

// The first of several checks that found something. `checks` are called in order, and only as far as needed.
template <class... Check>
Broken first_of(Check... checks) {
    Broken found;
    ((found = checks(), found.has_value()) || ...);
    return found;
}

Broken length_above_zero(std::string key, Length value, std::string remedy) {
    if (value.value > 0.0 && std::isfinite(value.value)) return {};
    return BrokenRule{std::move(key), quoted(length_text(value)), "it must be above 0 m", std::move(remedy)};
}

// Every sample of a spectrum lies at a wavelength above 0 and has a value that `allowed` takes.
template <class Y, class Allowed>
Broken spectrum_rule(std::string key, const SpectrumOf<Y>& spectrum, Allowed allowed, const char* rule, const char* remedy) {
    for (const auto& [wavelength, y] : spectrum.samples()) {
        if (!spectrum.is_constant() && !(wavelength.value > 0.0))
            return BrokenRule{key + ".wavelength_nm", number_text(wavelength.value), "it must be above 0", ""};
        if (allowed(y.value)) continue;
        const std::string place = spectrum.is_constant() ? "" : fmt::format(" (at {})", wavelength_text(wavelength));
        return BrokenRule{std::move(key), number_text(y.value) + place, rule, remedy};
    }
    return {};
}

bool finite_and_not_negative(double x) { return std::isfinite(x) && x >= 0.0; }

template <class Y>
Broken not_negative(std::string key, const SpectrumOf<Y>& spectrum) {
    return spectrum_rule(std::move(key), spectrum, finite_and_not_negative, "it must be 0 or more, and finite", "");
}

Broken rule_of(const ExponentialProfile& p) {
    return first_of(
        [&] {
            return length_above_zero("scale_height", p.scale_height,
                                     "Earth's air is near \"8 km\", its aerosol near \"1200 m\"; see docs/atmosphere-file.md.");
        },
        [&] { return length_above_zero("top", p.top, "Leave it out to let the profile reach the top of the atmosphere."); });
}

Broken altitudes_rise(const char* low_key, Length low, const char* high_key, Length high) {
    if (std::isfinite(low.value) && std::isfinite(high.value) && low < high) return {};
    return BrokenRule{high_key, quoted(length_text(high)), fmt::format("it must be above {}, {}", low_key, length_text(low)), ""};
}

Broken rule_of(const LayerProfile& p) { return altitudes_rise("low", p.low, "high", p.high); }

Broken rule_of(const TriangleProfile& p) {
    return first_of([&] { return altitudes_rise("low", p.low, "peak", p.peak); },
                    [&] { return altitudes_rise("peak", p.peak, "high", p.high); });
}

Broken rule_of(const TabulatedProfile& p) {
    for (const auto& [altitude, density] : p.densities.samples()) {
        if (altitude.value < 0.0)
            return BrokenRule{"altitude_m", number_text(altitude.value), "it must be 0 or more", "Altitudes are above the ground sphere."};
        if (!finite_and_not_negative(density.value))
            return BrokenRule{"density", fmt::format("{} (at {})", density.value, length_text(altitude)),
                              "it must be 0 or more, and finite", ""};
    }
    return {};
}

Broken asymmetry_rule(const SpectrumOf<Number>& g) {
    return spectrum_rule(
        "g", g, [](double x) { return std::abs(x) < 1.0; }, "it must be above -1 and below 1",
        "Haze is near 0.7; 0 scatters forward as much as backward.");
}

// The shape of a table, and that its rows integrate to one.
Broken table_rule(const TabulatedPhase& table) {
    const Result<PhaseFunction> normalised = tabulated_phase(table);
    if (!normalised) return BrokenRule{"value", "the table", normalised.error().what, normalised.error().remedy};
    const auto& rows = std::get<TabulatedPhase>(*normalised).values;
    for (std::size_t w = 0; w < rows.size(); ++w)
        for (std::size_t a = 0; a < rows[w].size(); ++a)
            if (std::abs(rows[w][a] - table.values[w][a]) > 1e-6 * rows[w][a])
                return BrokenRule{"value", fmt::format("the row at {}", wavelength_text(table.wavelengths[w])),
                                  "it must integrate to 1 over the sphere", "tabulated_phase() scales a table so that it does."};
    return {};
}

}  // namespace

std::optional<BrokenRule> broken_rule(const DensityProfile& profile) {
    return std::visit([](const auto& p) { return rule_of(p); }, profile);
}

std::optional<BrokenRule> broken_rule(const PhaseFunction& phase) {
    return std::visit(Overloaded{
                          [](const IsotropicPhase&) { return Broken{}; },
                          [](const RayleighPhase& p) {
                              const bool right = p.depolarisation >= 0.0 && p.depolarisation < 1.0;
                              return right ? Broken{}
                                           : Broken{{"depolarisation", number_text(p.depolarisation), "it must be 0 or more and below 1",
                                                     "Air is near 0.0279."}};
                          },
                          [](const HenyeyGreensteinPhase& p) { return asymmetry_rule(p.g); },
                          [](const CornetteShanksPhase& p) { return asymmetry_rule(p.g); },
                          [](const TabulatedPhase& p) { return table_rule(p); },
                      },
                      phase);
}

namespace {

Broken within(const std::string& outer, Broken broken) {
    if (broken) broken->key = outer + '.' + broken->key;
    return broken;
}

Broken rule_of(const Constituent& c) {
    return first_of([&] { return within("profile", broken_rule(c.profile)); }, [&] { return not_negative("scattering", c.scattering); },
                    [&] { return not_negative("absorption", c.absorption); }, [&] { return within("phase", broken_rule(c.phase)); });
}

Broken rule_of(const std::vector<Constituent>& constituents) {
    if (constituents.size() > max_constituents)
        return BrokenRule{"constituent", fmt::format("{} tables", constituents.size()),
                          fmt::format("there must be at most {}", max_constituents), "Join those that have the same profile."};
    std::set<std::string> names;
    for (const Constituent& c : constituents) {
        if (c.name.empty() || !names.insert(c.name).second)
            return BrokenRule{"constituent.name", quoted(c.name), "each constituent must have a name of its own", ""};
        if (Broken broken = rule_of(c)) return within(c.name, broken);
    }
    return {};
}

// A disk is nowhere darker than black: 1 - u_1 x - u_2 x^2 >= 0 for x = 1 - mu in [0, 1].
Broken limb_rule(const Sun& sun) {
    for (const auto* darkening : {&sun.limb_darkening_1, &sun.limb_darkening_2})
        for (const auto& sample : darkening->samples())
            for (int i = 0; i <= 100; ++i) {
                const double x = 0.01 * i;
                const double intensity =
                    1.0 - sun.limb_darkening_1.at(sample.x).value * x - sun.limb_darkening_2.at(sample.x).value * x * x;
                if (intensity >= -1e-12) continue;
                return BrokenRule{"sun.limb_darkening", fmt::format("the law at {}", wavelength_text(sample.x)),
                                  "it must leave the disk at 0 or brighter", "The sun's coefficients add up to less than 1."};
            }
    return {};
}

Broken rule_of(const Sun& sun) {
    if (!(sun.angular_radius >= 0.0 && sun.angular_radius < 0.5 * pi))
        return BrokenRule{"sun.angular_radius", quoted(angle_text(sun.angular_radius)), "it must be 0 deg or more and below 90 deg",
                          "From the Earth it is \"0.2666 deg\"."};
    return first_of([&] { return not_negative("sun.irradiance", sun.irradiance); }, [&] { return limb_rule(sun); });
}

Broken planet_rule(const Atmosphere& a) {
    if (!(a.bottom_radius >= min_bottom_radius && a.bottom_radius <= max_bottom_radius))
        return BrokenRule{"planet.radius", quoted(length_text(a.bottom_radius)),
                          fmt::format("it must be from {} to {}", length_text(min_bottom_radius), length_text(max_bottom_radius)),
                          "The Earth's is \"6371 km\"."};
    if (!(a.top_altitude.value > 0.0 && a.top_altitude <= a.bottom_radius))
        return BrokenRule{"planet.top", quoted(length_text(a.top_altitude)), "it must be above 0 m and at most the planet's radius",
                          "The Earth's air may end at \"100 km\"."};
    return {};
}

}  // namespace

Error BrokenRule::error() const { return Error{"", fmt::format("{} = {} is out of range: {}", key, value, rule), remedy}; }

std::optional<BrokenRule> broken_rule(const Atmosphere& atmosphere) {
    return first_of([&] { return planet_rule(atmosphere); },
                    [&] {
                        return spectrum_rule(
                            "ground.albedo", atmosphere.ground_albedo, [](double x) { return x >= 0.0 && x <= 1.0; },
                            "it must be from 0 to 1", "Grass is near 0.1, fresh snow near 0.95.");
                    },
                    [&] { return rule_of(atmosphere.sun); }, [&] { return rule_of(atmosphere.constituents); });
}

Result<Atmosphere> validated(Atmosphere atmosphere) {
    if (const auto broken = broken_rule(atmosphere)) return broken->error();
    return atmosphere;
}

namespace {

template <class Y>
Result<Done> spectrum_covers(const std::string& what, const SpectrumOf<Y>& spectrum, Wavelength first, Wavelength last) {
    if (spectrum.covers(first, last)) return Done{};
    return Error{"", fmt::format("{} has no data at every wavelength from {} to {}", what, wavelength_text(first), wavelength_text(last)),
                 fmt::format("It reaches from {} to {}.", wavelength_text(spectrum.samples().front().x),
                             wavelength_text(spectrum.samples().back().x))};
}

}  // namespace

Result<Done> covers(const Atmosphere& atmosphere, Wavelength first, Wavelength last) {
    const auto check = [&](const std::string& what, const auto& spectrum) { return spectrum_covers(what, spectrum, first, last); };
    for (const Constituent& c : atmosphere.constituents) {
        if (auto done = check(c.name + ".scattering", c.scattering); !done) return done;
        if (auto done = check(c.name + ".absorption", c.absorption); !done) return done;
        if (!covers(c.phase, first, last))
            return Error{"",
                         fmt::format("{}.phase has no data at every wavelength from {} to {}", c.name, wavelength_text(first),
                                     wavelength_text(last)),
                         ""};
    }
    if (auto done = check("ground.albedo", atmosphere.ground_albedo); !done) return done;
    if (auto done = check("sun.limb_darkening", atmosphere.sun.limb_darkening_1); !done) return done;
    if (auto done = check("sun.limb_darkening", atmosphere.sun.limb_darkening_2); !done) return done;
    return check("sun.irradiance", atmosphere.sun.irradiance);
}

}  // namespace airlight
