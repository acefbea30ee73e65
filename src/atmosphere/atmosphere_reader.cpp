#include <fmt/format.h>

#include <algorithm>

#include "atmosphere/atmosphere_file.h"
#include "atmosphere/constituent_reader.h"
#include "atmosphere/ground.h"
#include "atmosphere/presets.h"
#include "atmosphere/sunlight.h"
#include "atmosphere/table_reader.h"
#include "atmosphere/validate.h"
#include "core/files.h"

namespace airlight {

namespace {

using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name) { return std::find(names.begin(), names.end(), name) != names.end(); }

void read_planet(TomlInput& file, Atmosphere& a, bool has_base) {
    auto planet = file.table("planet");
    if (!planet) {
        if (!file.has("planet") && !has_base)
            file.refuse_missing("planet", "Write [planet], radius = \"6371 km\", top = \"100 km\"; or start from base = \"earth-clear\".");
        return;
    }
    if (!has_base) {
        if (!planet->has("radius")) planet->refuse_missing("radius", "The Earth's is \"6371 km\".");
        if (!planet->has("top")) planet->refuse_missing("top", "The Earth's air may end at \"100 km\".");
    }
    if (const auto radius = planet->length("radius")) a.bottom_radius = *radius;
    if (const auto top = planet->length("top")) a.top_altitude = *top;
    planet->refuse_unknown_keys();
}

void read_ground(TomlInput& file, Atmosphere& a) {
    auto ground = file.table("ground");
    if (!ground) return;
    if (ground->is_text("albedo")) {
        const auto material = ground_material(*ground->text("albedo"));
        if (material) a.ground_albedo = *material;
        else ground->refuse("albedo", material.error().what, material.error().remedy);
    } else if (const auto albedo = read_numbers(*ground, "albedo")) {
        a.ground_albedo = *albedo;
    }
    ground->refuse_unknown_keys();
}

std::optional<SpectrumOf<SpectralIrradiance>> read_solar_spectrum(TomlInput& sun) {
    if (sun.is_text("spectrum")) {
        if (*sun.text("spectrum") == "astm-g173") return sun_at(1.0).irradiance;
        sun.refuse("spectrum", "the only spectrum with a name is \"astm-g173\"", "Or give a number in W m-2 nm-1, or a table.");
        return {};
    }
    if (!sun.is_table("spectrum")) {
        const auto constant = sun.number("spectrum");
        if (!constant) return {};
        return SpectrumOf<SpectralIrradiance>::constant(*constant * W_per_m2_nm);
    }
    auto table = sun.table("spectrum");
    auto curve = read_curve<Wavelength, SpectralIrradiance>(*table, "wavelength_nm", 1.0 * nm, "irradiance_W_m-2_nm-1", 1.0 * W_per_m2_nm);
    table->refuse_unknown_keys();
    return curve;
}

void read_sun(TomlInput& file, Atmosphere& a) {
    auto sun = file.table("sun");
    if (!sun) return;
    if (const auto distance = sun->number("distance_au")) {
        if (!(*distance >= 0.01 && *distance <= 1000.0))
            sun->refuse("distance_au", "it must be from 0.01 to 1000", "The Earth is at 1, Mars near 1.52.");
        else a.sun = sun_at(*distance);
    }
    if (const auto spectrum = read_solar_spectrum(*sun)) {
        if (sun->has("distance_au")) sun->refuse("spectrum", "distance_au has set the spectrum already", "Give only one of the two.");
        a.sun.irradiance = *spectrum;
    }
    if (const auto radius = sun->angle("angular_radius")) a.sun.angular_radius = *radius;
    if (const auto first = read_numbers(*sun, "limb_darkening_1")) a.sun.limb_darkening_1 = *first;
    if (const auto second = read_numbers(*sun, "limb_darkening_2")) a.sun.limb_darkening_2 = *second;
    sun->refuse_unknown_keys();
}

void remove_named(TomlInput& file, Atmosphere& a) {
    const auto names = file.texts("remove");
    if (!names) return;
    for (const std::string& name : *names)
        if (std::erase_if(a.constituents, [&](const Constituent& c) { return c.name == name; }) == 0)
            file.refuse("remove", fmt::format("the base has no constituent \"{}\"", name), "");
}

// The names by which errors and later files call the constituents of this one: its name, or else its kind.
Names name_constituents(std::vector<TomlInput>& tables) {
    Names names;
    for (TomlInput& table : tables) {
        const std::string kind = table.is_text("kind") ? *table.text("kind") : "constituent";
        names.push_back(table.is_text("name") ? *table.text("name") : kind);
        table.set_path(names.back());
        if (std::count(names.begin(), names.end(), names.back()) > 1)
            table.refuse("name", "two constituents of this file have this name", "Give each a name of its own.");
    }
    return names;
}

// Aerosols are made last, for their amount may depend on the air. Those of the base that the file does not name come
// first, then the file's, in its order.
void read_constituents(TomlInput& file, Atmosphere& a, std::vector<TomlInput> tables, const Names& replaced) {
    if (tables.size() > max_constituents)
        file.refuse("constituent", fmt::format("there must be at most {}", max_constituents), "Join those that have the same profile.");
    const Names names = name_constituents(tables);
    std::erase_if(a.constituents, [&](const Constituent& c) { return contains(names, c.name); });
    if (file.failed()) return;

    const auto is_aerosol = [](TomlInput& table) { return table.is_text("kind") && *table.text("kind") == "aerosol"; };
    std::vector<std::optional<Constituent>> made(tables.size());
    for (std::size_t i = 0; i < tables.size(); ++i)
        if (!is_aerosol(tables[i]) && !contains(replaced, names[i])) made[i] = read_constituent(tables[i]);
    Atmosphere gases = a;
    for (const auto& gas : made)
        if (gas) gases.constituents.push_back(*gas);
    const MolecularAir molecules = file.failed() ? MolecularAir{} : molecular_air(gases, 550.0 * nm);
    for (std::size_t i = 0; i < tables.size() && !file.failed(); ++i)
        if (is_aerosol(tables[i]) && !contains(replaced, names[i])) made[i] = read_aerosol(tables[i], molecules, a.top_altitude);
    for (auto& constituent : made)
        if (constituent) a.constituents.push_back(std::move(*constituent));
}

Result<Atmosphere> read_table(const toml::table& root, std::string_view name, const Names& replaced);

// The preset that the file starts from, without the constituents that the file replaces: aerosols take time to make.
Result<Atmosphere> preset_without(std::string_view name, const Names& replaced) {
    const Result<std::string_view> text = preset_text(name);
    if (!text) return text.error();
    return read_table(toml::parse(*text), name, replaced);
}

Atmosphere read_base(TomlInput& file, bool& has_base, const Names& replaced) {
    Atmosphere a;
    a.bottom_radius = 0.0 * m;
    a.top_altitude = 0.0 * m;
    a.sun = sun_at(1.0);
    const auto base = file.text("base");
    has_base = base.has_value();
    if (!base) return a;
    const Result<Atmosphere> found = preset_without(*base, replaced);
    if (found) return *found;
    file.refuse("base", found.error().what, found.error().remedy);
    return a;
}

// The line at which a rule of the whole description is broken, 0 if the file does not say the key.
unsigned line_of_key(const toml::table& root, std::string_view key) {
    const std::size_t dot = key.find('.');
    if (dot == std::string_view::npos) return 0;
    const std::string_view first = key.substr(0, dot);
    const std::string_view second = key.substr(dot + 1, key.find('.', dot + 1) - dot - 1);
    const toml::table* table = root.get_as<toml::table>(first);
    if (const auto* array = root.get_as<toml::array>("constituent"); !table && array)
        for (const toml::node& element : *array)
            if (const auto* candidate = element.as_table();
                candidate && (*candidate)[candidate->contains("name") ? "name" : "kind"].value_or(std::string_view{}) == first)
                table = candidate;
    if (!table) return 0;
    const toml::node* node = table->get(second);
    return static_cast<unsigned>(node ? node->source().begin.line : table->source().begin.line);
}

// `replaced`: names of constituents that whoever starts from this table has replaced; they are left out.
Result<Atmosphere> read_table(const toml::table& root, std::string_view name, const Names& replaced) {
    TomlFailure failure{std::string(name), {}};
    TomlInput file(root, "", failure);
    bool has_base = false;
    std::vector<TomlInput> tables = file.tables("constituent");
    Names named = name_constituents(tables);
    named.insert(named.end(), replaced.begin(), replaced.end());
    Atmosphere a = read_base(file, has_base, named);
    if (const auto title = file.text("name")) a.name = *title;
    read_planet(file, a, has_base);
    read_ground(file, a);
    read_sun(file, a);
    remove_named(file, a);
    if (!failure.first) read_constituents(file, a, std::move(tables), replaced);
    file.refuse_unknown_keys();
    if (failure.first) return *failure.first;
    const auto broken = broken_rule(a);
    if (!broken) return a;
    const unsigned line = line_of_key(root, broken->key);
    return at(line > 0 ? fmt::format("{}:{}", name, line) : std::string(name), broken->error());
}

}  // namespace

Result<Atmosphere> parse_atmosphere(std::string_view toml, std::string_view file) {
    const Result<toml::table> table = parse_toml(toml, file, "See docs/atmosphere-file.md.");
    if (!table) return table.error();
    return read_table(*table, file, {});
}

Result<Atmosphere> read_atmosphere(const std::filesystem::path& path) {
    const Result<std::string> text = read_file(path, max_atmosphere_file_bytes);
    if (!text) return text.error();
    return parse_atmosphere(*text, path.string());
}

Result<Atmosphere> atmosphere_named(const std::string& preset_or_path) {
    const Result<std::string_view> text = preset_text(preset_or_path);
    if (text) return preset(preset_or_path);
    std::error_code ignored;
    if (std::filesystem::exists(preset_or_path, ignored)) return read_atmosphere(preset_or_path);
    return Error{preset_or_path, "there is no file and no preset of this name", text.error().remedy};
}

}  // namespace airlight
