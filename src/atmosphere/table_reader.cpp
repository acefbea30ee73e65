#include "atmosphere/table_reader.h"

#include "atmosphere/validate.h"

namespace airlight {

namespace {

// The part that was read from `table`, unless it breaks a rule: then a failure at the key that gave it.
template <class Part>
std::optional<Part> kept_if_right(TomlInput& table, std::optional<Part> part) {
    if (!part || table.failed()) return {};
    const auto broken = broken_rule(*part);
    if (!broken) return part;
    table.refuse(broken->key, broken->rule, broken->remedy);
    return {};
}

template <class Y>
std::optional<SpectrumOf<Y>> read_spectrum_table(TomlInput& input, std::string_view key, std::string_view value_key, Y unit) {
    auto table = input.table(key);
    if (!table) return {};
    auto curve = read_curve<Wavelength, Y>(*table, "wavelength_nm", 1.0 * nm, value_key, unit);
    table->refuse_unknown_keys();
    return curve;
}

}  // namespace

std::optional<SpectrumOf<Number>> read_numbers(TomlInput& input, std::string_view key) {
    if (input.is_table(key)) return read_spectrum_table<Number>(input, key, "value", 1.0);
    const auto value = input.number(key);
    if (!value) return {};
    return SpectrumOf<Number>::constant(*value);
}

std::optional<SpectrumOf<InverseLength>> read_coefficients(TomlInput& input, std::string_view key) {
    if (input.is_table(key)) return read_spectrum_table<InverseLength>(input, key, "value_per_m", 1.0 * per_m);
    const auto value = input.inverse_length(key);
    if (!value) return {};
    return SpectrumOf<InverseLength>::constant(*value);
}

namespace {

constexpr std::string_view length_example = "Give a length, such as \"8 km\".";

std::optional<DensityProfile> exponential_profile(TomlInput& table) {
    const auto scale_height = table.need(&TomlInput::length, "scale_height", length_example);
    const auto top = table.length("top");
    if (!scale_height) return {};
    return ExponentialProfile{*scale_height, top.value_or(ExponentialProfile{}.top)};
}

std::optional<DensityProfile> layer_profile(TomlInput& table) {
    const auto low = table.need(&TomlInput::length, "low", length_example);
    const auto high = table.need(&TomlInput::length, "high", length_example);
    if (!low || !high) return {};
    return LayerProfile{*low, *high};
}

std::optional<DensityProfile> triangle_profile(TomlInput& table) {
    const auto low = table.need(&TomlInput::length, "low", length_example);
    const auto peak = table.need(&TomlInput::length, "peak", length_example);
    const auto high = table.need(&TomlInput::length, "high", length_example);
    if (!low || !peak || !high) return {};
    return TriangleProfile{*low, *peak, *high};
}

std::optional<DensityProfile> tabulated_profile(TomlInput& table) {
    const auto densities = read_curve<Length, Number>(table, "altitude_m", 1.0 * m, "density", 1.0);
    if (!densities) return {};
    return TabulatedProfile{*densities};
}

}  // namespace

std::optional<DensityProfile> read_profile(TomlInput& input, std::string_view key) {
    auto table = input.table(key);
    if (!table) return {};
    const auto kind = table->need(&TomlInput::text, "kind", "Write kind = \"exponential\", \"layer\", \"triangle\" or \"tabulated\".");
    if (!kind) return {};
    std::optional<DensityProfile> profile;
    if (*kind == "exponential") profile = exponential_profile(*table);
    else if (*kind == "layer") profile = layer_profile(*table);
    else if (*kind == "triangle") profile = triangle_profile(*table);
    else if (*kind == "tabulated") profile = tabulated_profile(*table);
    else table->refuse_word("kind", "exponential layer triangle tabulated");
    table->refuse_unknown_keys();
    return kept_if_right(*table, std::move(profile));
}

namespace {

template <class Phase>
std::optional<PhaseFunction> asymmetric_phase(TomlInput& table) {
    if (!table.has("g")) table.refuse_missing("g", "Give the asymmetry, such as g = 0.76.");
    const auto g = read_numbers(table, "g");
    if (!g) return {};
    return Phase{*g};
}

std::optional<std::vector<double>> read_angles(TomlInput& table) {
    if (table.has("angle_rad")) return table.numbers("angle_rad");
    auto angles = table.need(&TomlInput::numbers, "angle_deg", "Give the scattering angles, 0 first and 180 last.");
    if (angles)
        for (double& angle : *angles) angle *= deg;
    return angles;
}

// Rows that integrate to one already keep their bits; others are scaled.
PhaseFunction normalised_unless_it_is(const TabulatedPhase& table, PhaseFunction normalised) {
    const auto& rows = std::get<TabulatedPhase>(normalised).values;
    for (std::size_t w = 0; w < rows.size(); ++w)
        for (std::size_t a = 0; a < rows[w].size(); ++a)
            if (std::abs(rows[w][a] - table.values[w][a]) > 1e-9 * rows[w][a]) return normalised;
    return table;
}

std::optional<PhaseFunction> tabulated_phase_of(TomlInput& table) {
    const auto angles = read_angles(table);
    const auto wavelengths = table.need(&TomlInput::numbers, "wavelength_nm", "Give one wavelength for each row of value_per_sr.");
    const auto rows = table.need(&TomlInput::rows, "value_per_sr", "Give one array of values by angle for each wavelength.");
    if (!angles || !wavelengths || !rows) return {};
    TabulatedPhase read{*angles, {}, *rows};
    for (const double w : *wavelengths) read.wavelengths.push_back(w * nm);
    const Result<PhaseFunction> normalised = tabulated_phase(read);
    if (normalised) return normalised_unless_it_is(read, *normalised);
    table.refuse("value_per_sr", normalised.error().what, normalised.error().remedy);
    return {};
}

}  // namespace

std::optional<PhaseFunction> read_phase(TomlInput& input, std::string_view key) {
    auto table = input.table(key);
    if (!table) return {};
    const auto kind = table->need(&TomlInput::text, "kind",
                                  "Write kind = \"henyey_greenstein\", \"cornette_shanks\", \"rayleigh\", \"isotropic\" or \"tabulated\".");
    if (!kind) return {};
    std::optional<PhaseFunction> phase;
    if (*kind == "isotropic") phase = IsotropicPhase{};
    else if (*kind == "rayleigh") phase = RayleighPhase{table->number("depolarisation").value_or(0.0)};
    else if (*kind == "henyey_greenstein") phase = asymmetric_phase<HenyeyGreensteinPhase>(*table);
    else if (*kind == "cornette_shanks") phase = asymmetric_phase<CornetteShanksPhase>(*table);
    else if (*kind == "tabulated") phase = tabulated_phase_of(*table);
    else table->refuse_word("kind", "henyey_greenstein cornette_shanks rayleigh isotropic tabulated");
    table->refuse_unknown_keys();
    return kept_if_right(*table, std::move(phase));
}

}  // namespace airlight
