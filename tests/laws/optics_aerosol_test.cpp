// The aerosol of kinds of places: published coefficients, humidity, wavelengths, and what is refused.

#include <doctest/doctest.h>

#include <cmath>

#include "optics/aerosol.h"

using namespace airlight;

namespace {

constexpr Wavelength green[] = {550.0 * nm};

double per_km(InverseLength coefficient) { return 1000.0 * coefficient.in(per_m); }

// alpha in extinction ~ wavelength^-alpha.
double angstrom_exponent(AerosolType type, double relative_humidity) {
    const Wavelength pair[] = {450.0 * nm, 700.0 * nm};
    const AerosolOptics aerosol = *aerosol_optics(type, relative_humidity, pair);
    return -std::log((extinction(aerosol, pair[1]) / extinction(aerosol, pair[0])).value) / std::log(700.0 / 450.0);
}

std::string refusal(AerosolType type, double relative_humidity, std::vector<Wavelength> wavelengths) {
    const Result<AerosolOptics> aerosol = aerosol_optics(type, relative_humidity, wavelengths);
    return aerosol ? std::string() : aerosol.error().message();
}

bool says(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("at 80 % humidity and 550 nm the types of aerosol have the coefficients that OPAC prints") {
    struct Printed {
        AerosolType type;
        double extinction_per_km, albedo, g;
    };
    // [HessKoepkeSchult1998, table 4]
    const Printed table[] = {{AerosolType::continental_clean, 0.026, 0.972, 0.709},
                             {AerosolType::continental_average, 0.075, 0.925, 0.703},
                             {AerosolType::continental_polluted, 0.175, 0.892, 0.698},
                             {AerosolType::urban, 0.353, 0.817, 0.689},
                             {AerosolType::desert, 0.145, 0.888, 0.729},
                             {AerosolType::maritime_clean, 0.090, 0.997, 0.772},
                             {AerosolType::maritime_polluted, 0.115, 0.975, 0.756}};
    for (const Printed& row : table) {
        CAPTURE(name(row.type));
        const AerosolOptics aerosol = *aerosol_optics(row.type, 80.0, green);
        // Half a digit of print, and 0.0005 more for OPAC's coarser integral over sizes (its own files differ from its table by as much).
        CHECK(std::abs(per_km(extinction(aerosol, green[0])) - row.extinction_per_km) < 0.001);
        CHECK(std::abs(single_scattering_albedo(aerosol, green[0]) - row.albedo) < 0.001);
        CHECK(std::abs(asymmetry(aerosol.phase, green[0]) - row.g) < 0.0015);
    }
}

TEST_CASE("polluted continental air has the coefficients that OPAC's program writes, with a fourth digit") {
    // OPAC 3.1, type copo, 80 %, 0.55 um: extinction 0.1746 1/km, albedo 0.8925, asymmetry 0.6977.
    const AerosolOptics aerosol = *aerosol_optics(AerosolType::continental_polluted, 80.0, green);
    CHECK(per_km(extinction(aerosol, green[0])) == doctest::Approx(0.1746).epsilon(1.5e-3));
    CHECK(single_scattering_albedo(aerosol, green[0]) == doctest::Approx(0.8925).epsilon(3e-4));
    CHECK(asymmetry(aerosol.phase, green[0]) == doctest::Approx(0.6977).epsilon(6e-4));
}

TEST_CASE("the tabulated phase function has the mean cosine of its particles") {
    for (const AerosolType type : {AerosolType::urban, AerosolType::desert}) {
        CAPTURE(name(type));
        double scattered = 0.0;
        double forward = 0.0;
        for (const AerosolShare& share : mixture_of(type)) {
            const LognormalSizes sizes = sizes_of(share.component, 50.0);
            const MieAngles no_angles({}, series_terms(sizes, green[0]));
            const MeanParticle mean = mean_particle(sizes, refractive_index_of(share.component, 50.0, green[0]), green[0], no_angles);
            scattered += (share.number * mean.scattering).in(per_m);
            forward += mean.g * (share.number * mean.scattering).in(per_m);
        }
        const AerosolOptics aerosol = *aerosol_optics(type, 50.0, green);
        CHECK(aerosol.scattering.at(green[0]).in(per_m) == doctest::Approx(scattered).epsilon(1e-12));
        // Straight lines between angles of a degree: 1e-4 of a smooth function, more at the forward peak of desert dust.
        CHECK(asymmetry(aerosol.phase, green[0]) == doctest::Approx(forward / scattered).epsilon(1e-3));
    }
}

TEST_CASE("moist air grows the particles that take up water: they scatter more and absorb a smaller share") {
    double previous_scattering = 0.0;
    double previous_albedo = 0.0;
    for (const double humidity : {0.0, 50.0, 65.0, 80.0, 95.0, 99.0}) {
        const AerosolOptics aerosol = *aerosol_optics(AerosolType::continental_average, humidity, green);
        CHECK(per_km(aerosol.scattering.at(green[0])) > previous_scattering);
        CHECK(single_scattering_albedo(aerosol, green[0]) > previous_albedo);
        previous_scattering = per_km(aerosol.scattering.at(green[0]));
        previous_albedo = single_scattering_albedo(aerosol, green[0]);
    }
    CHECK(sizes_of(AerosolComponent::soot, 95.0).mode_radius == sizes_of(AerosolComponent::soot, 0.0).mode_radius);
}

TEST_CASE("particles have their tabulated size and index at tabulated humidities and lie straight between") {
    CHECK(sizes_of(AerosolComponent::water_soluble, 80.0).mode_radius.in(um) == doctest::Approx(0.0306).epsilon(1e-14));
    CHECK(sizes_of(AerosolComponent::water_soluble, 75.0).mode_radius.in(um) == doctest::Approx(0.5 * (0.0285 + 0.0306)).epsilon(1e-14));
    CHECK(sizes_of(AerosolComponent::sea_salt_coarse, 99.0).radius_max.in(um) == doctest::Approx(100.0).epsilon(1e-14));
    CHECK(refractive_index_of(AerosolComponent::water_soluble, 50.0, 550.0 * nm).n == doctest::Approx(1.437).epsilon(1e-14));
    CHECK(refractive_index_of(AerosolComponent::water_soluble, 50.0, 550.0 * nm).k == doctest::Approx(0.003179).epsilon(1e-14));
    CHECK(refractive_index_of(AerosolComponent::mineral_coarse, 50.0, 425.0 * nm).k ==
          doctest::Approx(0.5 * (0.013 + 0.0085)).epsilon(1e-14));
    CHECK(name(AerosolComponent::water_soluble) == "water_soluble");
    CHECK(name(AerosolComponent::sulfate) == "sulfate");
}

TEST_CASE("fine continental aerosol is blue, coarse desert and sea aerosol is grey") {
    // [HessKoepkeSchult1998, table 4]: Angstrom exponents of 1.1 to 1.4 for continental air, below 0.3 for desert and clean sea air.
    CHECK(angstrom_exponent(AerosolType::continental_average, 80.0) > 1.1);
    CHECK(angstrom_exponent(AerosolType::urban, 80.0) > 1.1);
    CHECK(angstrom_exponent(AerosolType::desert, 80.0) < 0.3);
    CHECK(angstrom_exponent(AerosolType::maritime_clean, 80.0) < 0.3);
}

TEST_CASE("half the step of the integral over sizes moves a coefficient by less than 5e-4") {
    for (const AerosolType type : {AerosolType::urban, AerosolType::desert, AerosolType::maritime_clean}) {
        CAPTURE(name(type));
        const AerosolOptics usual = *aerosol_optics(type, 80.0, green);
        const AerosolOptics fine = *aerosol_optics(type, 80.0, green, 0.5 * default_log_step);
        CHECK((extinction(usual, green[0]) / extinction(fine, green[0])).value == doctest::Approx(1.0).epsilon(5e-4));
        CHECK(asymmetry(usual.phase, green[0]) == doctest::Approx(asymmetry(fine.phase, green[0])).epsilon(1e-3));
    }
}

TEST_CASE("a type of aerosol has a name that reads back, a mixture and a layer") {
    for (const AerosolType type : aerosol_types) {
        CHECK(*parse_aerosol_type(name(type)) == type);
        CHECK(mixture_of(type).size() >= 2);
        CHECK(layer_of(type).top > 0.0 * m);
    }
    CHECK(layer_of(AerosolType::maritime_clean).scale_height == 1.0 * km);
    CHECK(mixture_of(AerosolType::urban).back().number.in(per_cm3) == doctest::Approx(130000.0));
    CHECK(says(parse_aerosol_type("dessert").error().message(), "Did you mean desert?"));
}

TEST_CASE("what the aerosol is not known for is refused with the range that it is known for") {
    CHECK(says(refusal(AerosolType::urban, 100.0, {550.0 * nm}), "from 0 to 99 %"));
    CHECK(says(refusal(AerosolType::urban, -1.0, {550.0 * nm}), "from 0 to 99 %"));
    CHECK(says(refusal(AerosolType::urban, std::nan(""), {550.0 * nm}), "from 0 to 99 %"));
    CHECK(says(refusal(AerosolType::urban, 50.0, {}), "at least one wavelength"));
    CHECK(says(refusal(AerosolType::urban, 50.0, {200.0 * nm}), "250 to 1000 nm"));
    CHECK(says(refusal(AerosolType::urban, 50.0, {550.0 * nm, 500.0 * nm}), "500 nm does not lie above"));
    const AerosolShare negative[] = {{AerosolComponent::soot, -1.0 * per_cm3}};
    CHECK(says(mixture_optics(negative, 50.0, green).error().message(), "-1 particles of soot"));
    CHECK(says(mixture_optics({}, 50.0, green).error().message(), "zero in every direction"));
}
