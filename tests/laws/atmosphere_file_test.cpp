// Atmosphere files: what is written reads back to the same description, and what is wrong is said with its line.

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "atmosphere/atmosphere_file.h"
#include "atmosphere/coefficients.h"
#include "atmosphere/presets.h"
#include "atmosphere/validate.h"
#include "core/files.h"
#include "tools/temporary_folder.h"

using namespace airlight;

namespace {

std::mt19937_64 dice(20260102);
double random_number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(dice); }

template <class Y>
SpectrumOf<Y> random_spectrum(double high, Y unit) {
    if (random_number(0, 1) < 0.3) return SpectrumOf<Y>::constant(random_number(0, high) * unit);
    std::vector<typename SpectrumOf<Y>::Sample> samples;
    double wavelength = 300.0;
    for (int i = 0; i < 5; ++i) samples.push_back({(wavelength += random_number(1, 100)) * nm, random_number(0, high) * unit});
    return *SpectrumOf<Y>::of(samples);
}

DensityProfile random_profile() {
    const double a = random_number(0, 1e4), b = a + random_number(1, 1e4), c = b + random_number(1, 1e4);
    switch (std::uniform_int_distribution<int>(0, 4)(dice)) {
        case 0:
            return ExponentialProfile{b * m};
        case 1:
            return ExponentialProfile{b * m, c * m};
        case 2:
            return LayerProfile{a * m, b * m};
        case 3:
            return TriangleProfile{a * m, b * m, c * m};
        default:
            return TabulatedProfile{*Curve<Length, Number>::of({{a * m, random_number(0, 1)}, {b * m, random_number(0, 1)}, {c * m, 0.0}})};
    }
}

PhaseFunction random_phase() {
    switch (std::uniform_int_distribution<int>(0, 4)(dice)) {
        case 0:
            return IsotropicPhase{};
        case 1:
            return RayleighPhase{random_number(0, 0.1)};
        case 2:
            return HenyeyGreensteinPhase{random_spectrum<Number>(0.99, 1.0)};
        case 3:
            return CornetteShanksPhase{random_spectrum<Number>(0.99, 1.0)};
        default: {
            TabulatedPhase table{{0.0, random_number(0.1, 3.0), pi}, {400.0 * nm, random_number(401, 800) * nm}, {}};
            for (int w = 0; w < 2; ++w) table.values.push_back({random_number(0, 9), random_number(0.1, 1), random_number(0, 1)});
            return *tabulated_phase(table);
        }
    }
}

Atmosphere random_atmosphere() {
    Atmosphere a;
    a.name = "odd \"name\" with \\ and \n a new line";
    a.bottom_radius = random_number(1e5, 7e7) * m;
    a.top_altitude = random_number(1e3, 1e5) * m;
    a.ground_albedo = random_spectrum<Number>(1.0, 1.0);
    a.sun.irradiance = random_spectrum<SpectralIrradiance>(2.0, 1.0 * W_per_m2_nm);
    a.sun.angular_radius = random_number(0, 0.1);
    a.sun.limb_darkening_1 = random_spectrum<Number>(0.5, 1.0);
    a.sun.limb_darkening_2 = random_spectrum<Number>(0.5, 1.0);
    const int count = std::uniform_int_distribution<int>(0, 8)(dice);
    for (int i = 0; i < count; ++i)
        a.constituents.push_back({"c" + std::to_string(i), random_profile(), random_spectrum<InverseLength>(1e-4, 1.0 * per_m),
                                  random_spectrum<InverseLength>(1e-4, 1.0 * per_m), random_phase()});
    return a;
}

std::string message(const std::string& text) {
    const Result<Atmosphere> a = parse_atmosphere(text, "earth.toml");
    return a ? "" : a.error().message();
}

const std::string head = "[planet]\nradius = \"6371 km\"\ntop = \"100 km\"\n";  // three lines

}  // namespace

TEST_CASE("a written description reads back to the same bits") {
    for (int i = 0; i < 100; ++i) {
        const Atmosphere a = *validated(random_atmosphere());
        const std::string text = atmosphere_text(a, {"a comment"});
        CAPTURE(text);
        const Result<Atmosphere> read = parse_atmosphere(text, "written.toml");
        if (!read) FAIL(read.error().message());
        REQUIRE(*read == a);
    }
}

TEST_CASE("every preset is a valid description of its own name that covers the visible and survives being written") {
    REQUIRE(preset_names().size() >= 1);
    for (const std::string_view name : preset_names()) {
        CAPTURE(name);
        const Result<Atmosphere> a = preset(name);
        if (!a) FAIL(a.error().message());
        CHECK(a->name == name);
        CHECK(covers(*a, 360.0 * nm, 830.0 * nm));
        const Result<Atmosphere> read = parse_atmosphere(atmosphere_text(*a), "written.toml");
        if (!read) FAIL(read.error().message());
        CHECK(*read == *a);
    }
    CHECK(preset("earth-claer").error().remedy == "Did you mean \"earth-clear\"?");
}

TEST_CASE("a file is written whole, and read again") {
    const test::TemporaryFolder scratch;
    const std::filesystem::path& folder = scratch.path;
    const Atmosphere a = *preset("earth-rayleigh");
    REQUIRE(write_atmosphere(folder / "a.toml", a));
    CHECK(*read_atmosphere(folder / "a.toml") == a);
    CHECK(*atmosphere_named((folder / "a.toml").string()) == a);
    CHECK(*atmosphere_named("earth-rayleigh") == a);
    CHECK(atmosphere_named("earth-raleigh").error().remedy == "Did you mean \"earth-rayleigh\"?");
    CHECK(!write_atmosphere(folder / "absent" / "a.toml", a));
}

TEST_CASE("what is wrong in a file is said with its line, its key, its value and the rule") {
    struct Case {
        const char* text;
        const char* said;
    };
    const Case cases[] = {
        {"[[constituent]]\nname = \"haze\"\nkind = \"generic\"\nprofile = { kind = \"exponential\", scale_height = \"-1200 m\" }\n",
         "earth.toml:7: haze.profile.scale_height = \"-1200 m\": it must be above 0 m\n  Earth's air is near \"8 km\""},
        {"[[constituent]]\nkind = \"generic\"\nprofile = { kind = \"exponential\", scale_heigth = \"1200 m\" }\n",
         "generic.profile.scale_heigth is no key that this table has\n  Did you mean \"scale_height\"?"},
        {"[[constituent]]\nkind = \"generic\"\nprofile = { kind = \"layer\", low = \"1 km\", high = \"1 km\" }\n",
         "earth.toml:6: generic.profile.high = \"1 km\": it must be above low, 1 km"},
        {"[[constituent]]\nkind = \"generic\"\nprofile = { kind = \"layr\" }\n",
         "earth.toml:6: generic.profile.kind = \"layr\": it must be one of: exponential layer triangle tabulated\n  Did you mean "
         "\"layer\"?"},
        {"[[constituent]]\nkind = \"generic\"\nprofile = \"us_standard\"\n", "generic.profile = \"us_standard\": it must be a table"},
        {"[[constituent]]\nkind = \"aier\"\n",
         "earth.toml:5: aier.kind = \"aier\": it must be one of: air carbon_dioxide ozone nitrogen_dioxide aerosol generic\n  Did you mean "
         "\"air\"?"},
        {"[[constituent]]\nname = \"x\"\n", "earth.toml:4: x.kind is missing"},
        {"[[constituent]]\nkind = \"air\"\npresure_hpa = 1000\n",
         "earth.toml:6: air.presure_hpa is no key that this table has\n  Did you mean \"pressure_hpa\"?"},
        {"[[constituent]]\nkind = \"air\"\npressure_hpa = -1\n", "earth.toml:6: air.pressure_hpa = -1: it must be above 0"},
        {"[[constituent]]\nkind = \"air\"\npressure_hpa = nan\n", "earth.toml:6: air.pressure_hpa = nan: it must be a finite number"},
        {"[[constituent]]\nkind = \"air\"\nprofile = \"tropcal\"\n",
         "earth.toml:6: air.profile = \"tropcal\": \"tropcal\" is no model atmosphere\n  Did you mean \"tropical\"?"},
        {"[[constituent]]\nkind = \"air\"\n[[constituent]]\nkind = \"air\"\n", "two constituents of this file have this name"},
        {"[[constituent]]\nkind = \"generic\"\nprofile = { kind = \"exponential\", scale_height = \"8 km\" }\nscattering = \"-1 1/m\"\n",
         "earth.toml:7: generic.scattering = -1 is out of range: it must be 0 or more"},
        {"[[constituent]]\nkind = \"generic\"\nprofile = { kind = \"exponential\", scale_height = \"8 km\" }\nscattering = 1e-5\n",
         "earth.toml:7: generic.scattering = 1e-05: it must be a number and a unit in quotes\n  Write a number and a unit of inverse "
         "length"},
        {"[[constituent]]\nkind = \"generic\"\nprofile = { kind = \"exponential\", scale_height = \"8 km\" }\nphase = { kind = "
         "\"henyey_greenstein\", g = 1.0 }\n",
         "earth.toml:7: generic.phase.g = 1: it must be above -1 and below 1"},
        {"[[constituent]]\nkind = \"generic\"\nprofile = { kind = \"exponential\", scale_height = \"8 km\" }\nscattering = { wavelength_nm "
         "= [400, 500], value_per_m = [1e-5] }\n",
         "earth.toml:7: generic.scattering.value_per_m = an array: it has 1 values, but wavelength_nm has 2"},
        {"[[constituent]]\nkind = \"generic\"\nprofile = { kind = \"exponential\", scale_height = \"8 km\" }\nscattering = { wavelength_nm "
         "= [500, 400], value_per_m = [1e-5, 1e-5] }\n",
         "earth.toml:7: generic.scattering.wavelength_nm = an array: sample 2 does not lie above the one before it"},
        {"[[constituent]]\nkind = \"generic\"\nprofile = { kind = \"tabulated\", altitude_m = [0, \"x\"], density = [1, 0] }\n",
         "generic.profile.altitude_m has \"x\" in it: it must hold finite numbers only"},
        {"[[constituent]]\nkind = \"aerosol\"\nprofile = { kind = \"exponential\", scale_height = \"1 km\" }\nsingle_scattering_albedo = "
         "0.9\nphase = { kind = \"isotropic\" }\namount = { visibility = \"500 km\" }\n",
         "earth.toml:9: aerosol.amount.visibility = \"500 km\": a visibility of 500 km is out of range: in air without any aerosol one "
         "sees"},
        {"[[constituent]]\nkind = \"aerosol\"\nprofile = { kind = \"exponential\", scale_height = \"1 km\" }\nsingle_scattering_albedo = "
         "0.9\nphase = { kind = \"isotropic\" }\namount = { visibility = \"5 km\", turbidity = 2 }\n",
         "visibility has said how much already"},
        {"[[constituent]]\nkind = \"aerosol\"\nprofile = { kind = \"exponential\", scale_height = \"1 km\" }\nsingle_scattering_albedo = "
         "0.9\nphase = { kind = \"isotropic\" }\namount = { visibility = \"5 km\", contrast = 1 }\n",
         "a contrast of 1 is out of range: it must be above 0 and below 1"},
        {"[[constituent]]\nkind = \"aerosol\"\nprofile = { kind = \"exponential\", scale_height = \"1 km\" }\nsingle_scattering_albedo = "
         "0.9\nphase = { kind = \"isotropic\" }\namount = { turbidity = 2, contrast = 0.05 }\n",
         "earth.toml:9: aerosol.amount.contrast = 0.05: it says how far a visibility is, and none is given"},
        {"[[constituent]]\nkind = \"aerosol\"\nprofile = { kind = \"exponential\", scale_height = \"1 km\" }\nsingle_scattering_albedo = "
         "1.9\nphase = { kind = \"isotropic\" }\namount = { turbidity = 2 }\n",
         "earth.toml:7: aerosol.single_scattering_albedo = 1.9: 1.9 is out of range: it must be from 0 to 1"},
        {"[[constituent]]\nkind = \"aerosol\"\nprofile = { kind = \"exponential\", scale_height = \"1 km\" }\nsingle_scattering_albedo = "
         "0.9\nphase = { kind = \"isotropic\" }\namount = { angstrom = { alpha = 1, beta = 1e308 } }\n",
         "earth.toml:9: aerosol.amount.angstrom = a table: a beta of 1e+308 is out of range: it must be from 0 to 1e6"},
        {"[[constituent]]\nkind = \"air\"\nprofile = { kind = \"layer\", low = \"1e9 km\", high = \"2e9 km\" }\n",
         "earth.toml:6: air.profile = a table: below the top it must hold"},
        {"[ground]\nalbedo = 1.5\n", "earth.toml:5: ground.albedo = 1.5 is out of range: it must be from 0 to 1"},
        {"[ground]\nalbedo = \"gras\"\n", "earth.toml:5: ground.albedo = \"gras\": \"gras\" is no ground\n  Did you mean \"grass\"?"},
        {"[sun]\nspectrum = \"sun\"\n", "earth.toml:5: sun.spectrum = \"sun\": the only spectrum with a name"},
        {"[sun]\nangular_radius = \"90 deg\"\n", "earth.toml:5: sun.angular_radius"},
        {"[sun]\ndistance_au = 0\n", "earth.toml:5: sun.distance_au = 0: it must be from 0.01 to 1000"},
        {"[grund]\nalbedo = 0.1\n", "earth.toml:4: grund is no key that this table has\n  Did you mean \"ground\"?"},
        {"[ground\n", "earth.toml:4: it is not TOML:"},
        {"constituent = 3\n", "planet.constituent is no key"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.said);
        const std::string said = message(head + c.text);
        CAPTURE(said);
        CHECK(said.find(c.said) != std::string::npos);
    }
    CHECK(message("").find("planet is missing") != std::string::npos);
    CHECK(message("[planet]\nradius = \"6371\"\ntop = \"1 km\"\n").find("earth.toml:2: planet.radius = \"6371\"") == 0);
    CHECK(message("[planet]\nradius = \"50 km\"\ntop = \"1 km\"\n")
              .find("earth.toml:2: planet.radius = \"50 km\" is out of range: it must be from 100 km") == 0);
    CHECK(message("base = \"earth\"\n").find("earth.toml:1: base = \"earth\": \"earth\" is no preset") == 0);
    CHECK(message("base = \"earth-rayleigh\"\nremove = [\"ozone\"]\n")
              .find("earth.toml:2: remove = an array: the base has no constituent \"ozone\"") == 0);
}

TEST_CASE("text that no one would write is refused, not crashed on") {
    CHECK(!message(std::string(100000, '[')).empty());
    CHECK(!message("x = " + std::string(100000, '[')).empty());
    CHECK(!message("name = \"\xff\xfe\"\n").empty());
    CHECK(!message(std::string("name = \"a\0b\"", 12)).empty());
}

TEST_CASE("a file that starts from a preset says only what differs") {
    const Atmosphere base = *preset("earth-rayleigh");
    const auto a = parse_atmosphere(
        "base = \"earth-rayleigh\"\nname = \"mine\"\n[ground]\nalbedo = 0.5\n[[constituent]]\nkind = \"air\"\npressure_hpa = "
        "506.625\n[[constituent]]\nkind = \"ozone\"\n",
        "mine.toml");
    if (!a) FAIL(a.error().message());
    CHECK(a->name == "mine");
    CHECK(a->bottom_radius == base.bottom_radius);
    CHECK(a->sun == base.sun);
    CHECK(a->ground_albedo == SpectrumOf<Number>::constant(0.5));
    REQUIRE(a->constituents.size() == 2);
    // Half the pressure is half the air.
    CHECK(std::abs(optical_depth(a->constituents[0], 100.0 * km, 550.0 * nm).value / optical_depth(base, 550.0 * nm).value - 0.5) < 1e-9);
    CHECK(parse_atmosphere("base = \"earth-rayleigh\"\nremove = [\"air\"]\n", "x")->constituents.empty());
}

TEST_CASE("the Rayleigh Earth has the optical depth that Bodhaine tabulates") {
    const Atmosphere a = *preset("earth-rayleigh");
    // [Bodhaine1999, eq. 30], in the last digit of the published figures; the air above 100 km holds 3e-7 of it.
    const double published[][2] = {{400, 0.3602}, {500, 0.1434}, {550, 0.0971}, {600, 0.0681}};
    for (const auto& [wavelength, depth] : published) CHECK(std::abs(optical_depth(a, wavelength * nm).value / depth - 1.0) < 0.003);
}

TEST_CASE("an aerosol has the optical depth, the visibility and the turbidity that were asked for") {
    const auto made = [](const std::string& amount) {
        const std::string text =
            "base = \"earth-rayleigh\"\n[[constituent]]\nkind = \"aerosol\"\nprofile = { kind = \"exponential\", scale_height = \"1.2 km\" "
            "}\n"
            "single_scattering_albedo = 0.9\nphase = { kind = \"henyey_greenstein\", g = 0.7 }\namount = { " +
            amount + " }\n";
        auto a = parse_atmosphere(text, "aerosol.toml");
        if (!a) FAIL(a.error().message());
        return *a;
    };
    const Wavelength w = 550.0 * nm;
    const auto depth = [&](const Atmosphere& a, Wavelength at) { return optical_depth(a.constituents[1], a.top_altitude, at).value; };
    CHECK(std::abs(depth(made("optical_depth_550 = 0.2"), w) - 0.2) < 1e-9);
    CHECK(std::abs(extinction(made("visibility = \"23 km\""), 0.0 * m, w).value * 23000.0 - std::log(50.0)) < 1e-9);
    CHECK(std::abs(extinction(made("visibility = \"23 km\", contrast = 0.05"), 0.0 * m, w).value * 23000.0 - std::log(20.0)) < 1e-9);
    const Atmosphere turbid = made("turbidity = 3");
    CHECK(std::abs(optical_depth(turbid, w).value / optical_depth(turbid.constituents[0], turbid.top_altitude, w).value - 3.0) < 1e-9);
    const Atmosphere angstrom = made("angstrom = { alpha = 1.3, beta = 0.1 }");
    CHECK(std::abs(depth(angstrom, 1000.0 * nm) - 0.1) < 1e-9);
    CHECK(std::abs(depth(angstrom, 500.0 * nm) - 0.1 * std::pow(2.0, 1.3)) < 1e-9);
    CHECK(std::abs(extinction(made("extinction_550 = \"0.1 1/km\"").constituents[1], w).value - 1e-4) < 1e-12);
    CHECK(std::abs(single_scattering_albedo(angstrom.constituents[1], w) - 0.9) < 1e-12);
}

TEST_CASE("the examples of docs/atmosphere-file.md are atmospheres") {
    const std::string text = *read_file(std::filesystem::path(AIRLIGHT_SOURCE_DIR) / "docs/atmosphere-file.md");
    const std::string opening = "```toml\n";
    int examples = 0;
    for (std::size_t start = text.find(opening); start != std::string::npos; start = text.find(opening, start + 1)) {
        const std::size_t first = start + opening.size();
        const Result<Atmosphere> a = parse_atmosphere(text.substr(first, text.find("```", first) - first), "docs/atmosphere-file.md");
        if (!a) FAIL(a.error().message());
        ++examples;
    }
    CHECK(examples == 2);
}
