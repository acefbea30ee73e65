#include "atmosphere/weather_to_atmosphere.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "atmosphere/coefficients.h"
#include "atmosphere/validate.h"
#include "units/text.h"

namespace airlight {

namespace {

constexpr Wavelength reference_wavelength = 550.0 * nm;
constexpr double mist_humidity = 95.0;                    // percent, and more in mist; fog is saturated air [WMO2018]
constexpr Length least_visibility = 50.0 * m;             // the least that a METAR tells apart
constexpr Length fog_scale_height = 200.0 * m;            // radiation fog is 100 to 300 m deep
constexpr Length precipitation_height = 1000.0 * m;       // where the cloud base is not reported
constexpr double droplet_asymmetry = 0.86;                // droplets of water much larger than the wavelength [vandeHulst1957, sec. 13.2]
constexpr Length visibility_without_aerosol = 50.0 * km;  // "at least 10 km" over a base that has no aerosol

// Weather at the place itself: not in the vicinity, shallow or in patches.
bool reported(const Metar& report, std::initializer_list<std::string_view> codes) {
    return std::any_of(report.weather.begin(), report.weather.end(), [&](const PresentWeather& group) {
        if (group.intensity == Intensity::vicinity || group.descriptor == "MI" || group.descriptor == "BC" || group.descriptor == "PR")
            return false;
        return std::any_of(codes.begin(), codes.end(), [&](std::string_view code) { return group.has(code); });
    });
}

bool is_aerosol(const Constituent& c) {
    if (std::holds_alternative<RayleighPhase>(c.phase)) return false;
    return std::any_of(c.scattering.samples().begin(), c.scattering.samples().end(), [](const auto& s) { return s.y.value > 0.0; });
}

// What the particles between the eye and the distance are.
enum class Obscuration { haze, fog, precipitation };

struct Matter {
    Obscuration obscuration;
    AerosolType type;
    double relative_humidity;  // percent
};

AerosolType type_of(const Metar& report, AerosolType usual, std::vector<std::string>& decisions) {
    const auto decide = [&](AerosolType type, std::string_view why) {
        decisions.push_back(fmt::format("aerosol: {}, {}", name(type), why));
        return type;
    };
    if (reported(report, {"DU", "SA", "DS", "SS", "PO", "VA"})) return decide(AerosolType::desert, "for dust, sand or ash is reported");
    if (reported(report, {"FU"})) return decide(AerosolType::urban, "for smoke is reported");
    if (reported(report, {"HZ"})) return decide(AerosolType::continental_polluted, "for haze is reported");
    if (reported(report, {"PY"})) return decide(AerosolType::maritime_clean, "for spray is reported");
    return decide(usual, "the usual one of the place");
}

double humidity_of(const Metar& report, std::vector<std::string>& decisions) {
    const auto fraction = relative_humidity(report);
    double percent = fraction ? 100.0 * *fraction : usual_relative_humidity;
    std::string why = fraction ? "from temperature and dew point" : "assumed, for temperature or dew point is missing";
    const bool fog = reported(report, {"FG"});
    const double least = fog ? greatest_relative_humidity : reported(report, {"BR"}) ? mist_humidity : 0.0;
    if (percent < least) {
        percent = least;
        why = fog ? "for fog is reported" : "for mist is reported";
    }
    percent = std::clamp(percent, 0.0, greatest_relative_humidity);
    decisions.push_back(fmt::format("relative humidity: {:.0f} %, {}", percent, why));
    return percent;
}

Matter matter_of(const Metar& report, const WeatherOptions& options, std::vector<std::string>& decisions) {
    Matter matter{Obscuration::haze, type_of(report, options.usual_aerosol, decisions), humidity_of(report, decisions)};
    const bool dry = reported(report, {"DU", "SA", "DS", "SS", "PO", "VA", "FU", "HZ"});
    if (reported(report, {"FG"})) matter.obscuration = Obscuration::fog;
    else if (!dry && !reported(report, {"BR"}) && reported(report, {"DZ", "RA", "SN", "SG", "IC", "PL", "GR", "GS", "UP"}))
        matter.obscuration = Obscuration::precipitation;
    return matter;
}

void scale_air(Atmosphere& a, const Metar& report, std::vector<std::string>& decisions) {
    const auto pressure = report.sea_level_pressure_hpa ? report.sea_level_pressure_hpa : report.qnh_hpa;
    if (!pressure) {
        decisions.push_back("air: as in the base, for no pressure is reported");
        return;
    }
    for (Constituent& c : a.constituents)
        if (std::holds_alternative<RayleighPhase>(c.phase)) c = scaled(std::move(c), *pressure / standard_pressure_hpa);
    decisions.push_back(fmt::format("air: scaled by {:.4f} to {:.1f} hPa at sea level", *pressure / standard_pressure_hpa, *pressure));
}

// Takes the aerosol out, and returns the vertical optical depth that it had.
double take_aerosol(Atmosphere& a) {
    double depth = 0.0;
    for (const Constituent& c : a.constituents)
        if (is_aerosol(c)) depth += optical_depth(c, a.top_altitude, reference_wavelength).value;
    std::erase_if(a.constituents, is_aerosol);
    return depth;
}

// How much more light the type's particles take at this humidity than at the usual one.
Result<double> growth(const Matter& matter, const AerosolMatter& grown) {
    const Result<InverseLength> usual = opac_extinction_550(matter.type, usual_relative_humidity);
    if (!usual) return usual.error();
    return (grown.typical_extinction_550 / *usual).value;
}

// By day a report's visibility is the meteorological optical range, or close to it. [WMO2018, ch. 9]
InverseLength particles_within(Length visibility, const MolecularAir& air) {
    return max(extinction_of_visibility(visibility, optical_range_contrast) - air.scattering_at_ground, 0.0 * per_m);
}

// Droplets and flakes are so large that they scatter every wavelength alike and absorb none.
Constituent droplets(std::string droplets_name, const DensityProfile& profile, InverseLength at_ground) {
    Constituent made{std::move(droplets_name), profile};
    made.scattering = SpectrumOf<InverseLength>::constant(at_ground);
    made.phase = HenyeyGreensteinPhase{SpectrumOf<Number>::constant(droplet_asymmetry)};
    return made;
}

Length lowest_cloud(const Metar& report) {
    Length lowest = precipitation_height;
    bool found = false;
    for (const ReportedCloud& cloud : report.clouds)
        if (cloud.base && *cloud.base > 0.0 * m && (!found || *cloud.base < lowest)) {
            lowest = *cloud.base;
            found = true;
        }
    return lowest;
}

// One report being turned into air: what was read so far.
struct Work {
    Atmosphere& atmosphere;
    const Metar& report;
    std::vector<std::string>& decisions;
    Matter matter;
    AerosolMatter grown;  // the type's optics at the humidity
    double base_optical_depth;
    MolecularAir air;
};

// The aerosol that the base has, grown in the humidity, but no more than leaves the visibility `at_least` (0: not known).
InverseLength background(const Work& work, double growth_factor, Length at_least) {
    const DensityProfile profile = opac_profile(work.matter.type);
    const Length depth = column_depth(profile, work.atmosphere.top_altitude);
    InverseLength extinction = work.base_optical_depth * growth_factor / depth;
    if (!(extinction.value > 0.0)) extinction = particles_within(max(visibility_without_aerosol, at_least), work.air);
    return at_least > 0.0 * m ? min(extinction, particles_within(at_least, work.air)) : extinction;
}

void put_aerosol(Work& work, InverseLength at_ground) {
    const auto aerosol = aerosol_constituent(work.grown, opac_profile(work.matter.type), GroundExtinction550{at_ground}, work.air,
                                             work.atmosphere.top_altitude);
    if (!aerosol || !(at_ground.value > 0.0)) return;
    work.decisions.push_back(fmt::format("aerosol: vertical optical depth {:.3f} at 550 nm",
                                         optical_depth(*aerosol, work.atmosphere.top_altitude, reference_wavelength).value));
    work.atmosphere.constituents.push_back(*aerosol);
}

void put_droplets(Work& work, InverseLength at_ground) {
    const bool fog = work.matter.obscuration == Obscuration::fog;
    const DensityProfile profile = fog ? DensityProfile(ExponentialProfile{fog_scale_height, 5.0 * fog_scale_height})
                                       : DensityProfile(LayerProfile{0.0 * m, lowest_cloud(work.report)});
    work.atmosphere.constituents.push_back(droplets(fog ? "fog" : "precipitation", profile, at_ground));
    work.decisions.push_back(fog ? fmt::format("fog: droplets with a scale height of {}", length_text(fog_scale_height))
                                 : fmt::format("precipitation: drops or flakes up to {}", length_text(lowest_cloud(work.report))));
}

// The extinction that the reported visibility leaves to particles, split between aerosol and droplets.
void put_visibility(Work& work, double growth_factor) {
    std::optional<ReportedDistance> visibility = work.report.visibility;
    if (work.report.cavok) visibility = ReportedDistance{10.0 * km, Bound::at_least};
    if (!visibility || visibility->bound == Bound::at_least) {
        const Length least = visibility ? max(visibility->distance, least_visibility) : 0.0 * m;
        work.decisions.push_back(
            visibility ? fmt::format("visibility: at least {} at a contrast of {}, so the base's aerosol, {:.2f} times for humidity",
                                     length_text(least), optical_range_contrast, growth_factor)
                       : fmt::format("visibility: not reported, so the base's aerosol, {:.2f} times for humidity", growth_factor));
        return put_aerosol(work, background(work, growth_factor, least));
    }
    const Length seen = max(visibility->distance, least_visibility);
    const InverseLength particles = particles_within(seen, work.air);
    work.decisions.push_back(
        fmt::format("visibility: {}{} at a contrast of {}, extinction of particles at the ground {:.4g} 1/km at 550 nm",
                    visibility->bound == Bound::less_than ? "less than " : "", length_text(visibility->distance), optical_range_contrast,
                    particles.value * 1e3));
    if (work.matter.obscuration == Obscuration::haze) return put_aerosol(work, particles);
    const InverseLength haze = min(background(work, growth_factor, 0.0 * m), particles);
    put_aerosol(work, haze);
    if (particles > haze) put_droplets(work, particles - haze);
}

}  // namespace

Result<AtmosphereUnderWeather> atmosphere_under(Atmosphere base, const Metar& report, const WeatherOptions& options) {
    if (report.nil) return Error{"METAR " + report.station, "the report is NIL: it says nothing of the weather", "Take an earlier one."};
    AtmosphereUnderWeather result{std::move(base), report.clouds, {}};
    Atmosphere& a = result.atmosphere;
    if (!report.station.empty()) a.name += " under " + report.station;
    scale_air(a, report, result.decisions);
    const Matter matter = matter_of(report, options, result.decisions);
    Result<AerosolMatter> grown = opac_matter(matter.type, matter.relative_humidity);
    if (!grown) return grown.error();
    const Result<double> factor = growth(matter, *grown);
    if (!factor) return factor.error();
    const double base_depth = take_aerosol(a);
    Work work{a, report, result.decisions, matter, *std::move(grown), base_depth, molecular_air(a, reference_wavelength)};
    put_visibility(work, *factor);
    for (const ReportedCloud& cloud : result.clouds)
        if (cloud.base) result.decisions.push_back(fmt::format("cloud at {}: kept beside the description", length_text(*cloud.base)));
    if (const auto broken = broken_rule(a)) return at("METAR " + report.station, broken->error());
    return result;
}

}  // namespace airlight
