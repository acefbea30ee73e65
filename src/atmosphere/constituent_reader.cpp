#include "atmosphere/constituent_reader.h"

#include "atmosphere/table_reader.h"

namespace airlight {

namespace {

// The profile of a gas: a table, or the name of a model atmosphere; that of the U.S. standard where not said.
struct GasInput {
    DensityProfile profile;
    std::span<const AirLevel> levels;  // of the model that was named, or of the standard
};

std::optional<GasInput> read_gas_profile(TomlInput& input, Gas gas) {
    std::string name = "us_standard";
    if (input.is_text("profile")) name = *input.text("profile");
    const auto levels = model_atmosphere(name);
    if (!levels) {
        input.refuse("profile", levels.error().what, levels.error().remedy);
        return {};
    }
    if (!input.has("profile") || input.is_text("profile")) return GasInput{gas_profile(*levels, gas).profile, *levels};
    const auto profile = read_profile(input, "profile");
    if (!profile) return {};
    if (!is_column_depth(column_depth(*profile, above_all_air))) {
        input.refuse("profile", column_depth_rule, "");
        return {};
    }
    return GasInput{*profile, *levels};
}

// A number that must lie in (low, high].
std::optional<double> number_within(TomlInput& input, std::string_view key, double low, double high) {
    const auto value = input.number(key);
    if (!value || (*value > low && *value <= high)) return value;
    input.refuse(key, fmt::format("it must be above {} and at most {}", low, high), "");
    return {};
}

std::optional<Constituent> read_air(TomlInput& input) {
    const auto gas = read_gas_profile(input, Gas::air);
    const auto pressure = number_within(input, "pressure_hpa", 0.0, 1e6);
    if (!gas || input.failed()) return {};
    return air_constituent(gas->profile, pressure.value_or(standard_pressure_hpa));
}

std::optional<Constituent> read_carbon_dioxide(TomlInput& input) {
    const auto profile = read_profile(input, "profile");
    if (!profile && !input.has("profile")) input.refuse_missing("profile", "Mars: { kind = \"exponential\", scale_height = \"11.1 km\" }.");
    if (!input.has("number_density_per_cm3"))
        input.refuse_missing("number_density_per_cm3", "It is that where the profile is 1; the ground of Mars has about 2.1e17.");
    const auto density = number_within(input, "number_density_per_cm3", 0.0, 1e25);
    if (!profile || !density) return {};
    return carbon_dioxide_constituent(*profile, *density * per_cm3);
}

// The greatest amounts and temperatures are far beyond any air's: they keep slips of the unit out.
std::optional<Constituent> read_absorber(TomlInput& input, Gas kind) {
    const auto gas = read_gas_profile(input, kind);
    const auto dobson = number_within(input, "column_dobson", -1e-300, 1e6);
    const auto temperature = number_within(input, "temperature_k", 0.0, 1e4);
    if (!gas || input.failed()) return {};
    const double column = dobson ? *dobson * dobson_unit_per_m2 : column_per_m2(gas->levels, kind);
    return absorber_constituent(kind, gas->profile, column, temperature ? *temperature : effective_temperature_k(gas->levels, kind));
}

std::optional<Constituent> read_generic(TomlInput& input) {
    Constituent made;
    const auto profile = read_profile(input, "profile");
    if (!profile && !input.has("profile"))
        input.refuse_missing("profile", "Give its density by altitude, such as { kind = \"exponential\", scale_height = \"8 km\" }.");
    if (const auto scattering = read_coefficients(input, "scattering")) made.scattering = *scattering;
    if (const auto absorption = read_coefficients(input, "absorption")) made.absorption = *absorption;
    if (const auto phase = read_phase(input, "phase")) made.phase = *phase;
    if (!profile) return {};
    made.profile = *profile;
    return made;
}

}  // namespace

std::optional<Constituent> read_constituent(TomlInput& input) {
    const auto name = input.text("name");
    const auto kind = input.need(&TomlInput::text, "kind", fmt::format("It is one of: {}.", constituent_kinds));
    if (!kind) return {};
    std::optional<Constituent> made;
    if (*kind == "air") made = read_air(input);
    else if (*kind == "carbon_dioxide") made = read_carbon_dioxide(input);
    else if (*kind == "ozone") made = read_absorber(input, Gas::ozone);
    else if (*kind == "nitrogen_dioxide") made = read_absorber(input, Gas::nitrogen_dioxide);
    else if (*kind == "generic") made = read_generic(input);
    else input.refuse_word("kind", constituent_kinds);
    input.refuse_unknown_keys();
    if (made) made->name = name.value_or(*kind);
    return made;
}

namespace {

std::optional<AerosolAmount> read_angstrom(TomlInput& amount) {
    auto table = amount.table("angstrom");
    if (!table) return {};
    const auto alpha = table->need(&TomlInput::number, "alpha", "Haze is near 1.3, desert dust near 0.2.");
    const auto beta = table->need(&TomlInput::number, "beta", "It is the vertical optical depth at 1000 nm: 0.05 is clear, 0.2 hazy.");
    table->refuse_unknown_keys();
    if (!alpha || !beta) return {};
    return AngstromLaw{*beta, *alpha};
}

std::optional<AerosolAmount> read_visibility(TomlInput& amount) {
    const auto distance = amount.length("visibility");
    const auto contrast = amount.number("contrast");
    if (contrast && !amount.has("visibility"))
        amount.refuse("contrast", "it says how far a visibility is, and none is given",
                      "Give the visibility too, or leave the contrast out.");
    if (!distance) return {};
    return Visibility{*distance, contrast.value_or(range_contrast)};
}

constexpr std::string_view amount_remedy =
    "Give one of: optical_depth_550 = 0.12, visibility = \"23 km\", turbidity = 3, angstrom = { alpha = 1.3, beta = 0.05 }, extinction_550 "
    "= \"1e-4 1/m\", times_typical = 1.";

// Which key of the table was given, so that what is wrong with its value is said of it.
struct AmountInput {
    std::string_view key;
    AerosolAmount amount;
};

std::optional<AmountInput> read_amount(TomlInput& amount) {
    std::vector<AmountInput> given;
    if (const auto x = amount.number("optical_depth_550")) given.push_back({"optical_depth_550", OpticalDepth550{*x}});
    if (const auto x = read_visibility(amount)) given.push_back({"visibility", *x});
    if (const auto x = amount.number("turbidity")) given.push_back({"turbidity", Turbidity{*x}});
    if (const auto x = read_angstrom(amount)) given.push_back({"angstrom", *x});
    if (const auto x = amount.inverse_length("extinction_550")) given.push_back({"extinction_550", GroundExtinction550{*x}});
    if (const auto x = amount.number("times_typical")) given.push_back({"times_typical", TypicalAmount{*x}});
    amount.refuse_unknown_keys();
    if (amount.failed()) return {};
    if (given.size() == 1) return given.front();
    if (given.empty()) amount.refuse_missing("optical_depth_550", amount_remedy);
    else amount.refuse(given[1].key, fmt::format("{} has said how much already", given[0].key), "Give only one of the two.");
    return {};
}

// An aerosol without a type: all of its optics is given.
std::optional<AerosolMatter> read_given_matter(TomlInput& input) {
    AerosolMatter matter;
    matter.extinction = angstrom_extinction(1.3);
    const auto alpha = number_within(input, "alpha", -10.0, 10.0);
    if (alpha) matter.extinction = angstrom_extinction(*alpha);
    if (!input.has("single_scattering_albedo"))
        input.refuse_missing("single_scattering_albedo", "Give it, such as 0.9, or give the type of the aerosol.");
    const auto albedo = read_numbers(input, "single_scattering_albedo");
    if (!input.has("phase"))
        input.refuse_missing("phase", "Give it, such as { kind = \"henyey_greenstein\", g = 0.76 }, or give the type of the aerosol.");
    const auto phase = read_phase(input, "phase");
    if (!albedo || !phase) return {};
    for (const auto& sample : albedo->samples())
        if (!(sample.y.value >= 0.0 && sample.y.value <= 1.0)) {
            input.refuse("single_scattering_albedo", fmt::format("{} is out of range: it must be from 0 to 1", sample.y.value), "");
            return {};
        }
    matter.single_scattering_albedo = *albedo;
    matter.phase = *phase;
    return matter;
}

// One of OPAC's types: only the phase function may be given beside it, and then takes the place of Mie's.
struct TypeInput {
    AerosolType type;
    AerosolMatter matter;
};

std::optional<TypeInput> read_typed_matter(TomlInput& input) {
    const auto word = input.text("type");
    const auto humidity = input.number("relative_humidity_percent");
    const auto phase = input.has("phase") ? read_phase(input, "phase") : std::nullopt;
    if (!word || input.failed()) return {};
    const Result<AerosolType> type = parse_aerosol_type(*word);
    if (!type) {
        input.refuse("type", type.error().what, type.error().remedy);
        return {};
    }
    Result<AerosolMatter> matter = opac_matter(*type, humidity.value_or(usual_relative_humidity));
    if (!matter) {
        input.refuse("relative_humidity_percent", matter.error().what, matter.error().remedy);
        return {};
    }
    if (phase) matter->phase = *phase;
    return TypeInput{*type, *std::move(matter)};
}

// How its density falls with altitude: as the file says, or else as OPAC has it for the type.
std::optional<DensityProfile> read_aerosol_profile(TomlInput& input, const std::optional<AerosolType>& type) {
    if (input.has("profile")) return read_profile(input, "profile");
    if (type) return opac_profile(*type);
    input.refuse_missing("profile", "Give its density by altitude, such as { kind = \"exponential\", scale_height = \"1.2 km\" }.");
    return {};
}

std::optional<AmountInput> read_amount_table(TomlInput& input) {
    auto table = input.table("amount");
    if (!table && !input.has("amount")) input.refuse_missing("amount", amount_remedy);
    if (!table) return {};
    return read_amount(*table);
}

}  // namespace

std::optional<Constituent> read_aerosol(TomlInput& input, const MolecularAir& molecules, Length top) {
    const auto name = input.text("name");
    input.text("kind");
    std::optional<AerosolType> type;
    std::optional<AerosolMatter> matter;
    if (input.has("type")) {
        if (auto typed = read_typed_matter(input)) {
            type = typed->type;
            matter = std::move(typed->matter);
        }
    } else {
        matter = read_given_matter(input);
    }
    const auto profile = read_aerosol_profile(input, type);
    const auto amount = read_amount_table(input);
    input.refuse_unknown_keys();
    if (!profile || !matter || !amount || input.failed()) return {};
    Result<Constituent> made = aerosol_constituent(*matter, *profile, amount->amount, molecules, top);
    if (!made) {
        input.table("amount")->refuse(amount->key, made.error().what, made.error().remedy);
        return {};
    }
    made->name = name.value_or("aerosol");
    return *made;
}

}  // namespace airlight
