#include <fmt/format.h>

#include "atmosphere/atmosphere_file.h"
#include "core/files.h"
#include "core/overloaded.h"
#include "units/text.h"

namespace airlight {

namespace {

// A basic string of TOML: quotes, backslashes and control characters escaped.
std::string toml_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') out += '\\';
        if (byte < 0x20 || byte == 0x7f) out += fmt::format("\\u{:04X}", byte);
        else out += c;
    }
    return out + '"';
}

std::string array_text(const std::vector<double>& values) {
    std::string out = "[";
    for (const double value : values) out += (out.size() > 1 ? ", " : "") + fmt::format("{}", value);
    return out + ']';
}

template <class X, class Y, class Part>
std::vector<double> column(const Curve<X, Y>& curve, Part part) {
    std::vector<double> values;
    for (const auto& sample : curve.samples()) values.push_back(part(sample));
    return values;
}

template <class X, class Y>
std::string columns_text(const Curve<X, Y>& curve, std::string_view x_key, std::string_view y_key) {
    return fmt::format("{} = {}, {} = {}", x_key, array_text(column(curve, [](const auto& s) { return s.x.value; })), y_key,
                       array_text(column(curve, [](const auto& s) { return s.y.value; })));
}

// `constant` if the curve is one everywhere, else a table of wavelengths and values.
template <class Y>
std::string spectrum_text(const SpectrumOf<Y>& spectrum, std::string_view value_key, const std::string& constant) {
    if (spectrum == SpectrumOf<Y>::constant(spectrum.samples().front().y)) return constant;
    return fmt::format("{{ {} }}", columns_text(spectrum, "wavelength_nm", value_key));
}

std::string numbers_text(const SpectrumOf<Number>& spectrum) {
    return spectrum_text(spectrum, "value", fmt::format("{}", spectrum.samples().front().y.value));
}

std::string coefficients_text(const SpectrumOf<InverseLength>& spectrum) {
    return spectrum_text(spectrum, "value_per_m", toml_string(inverse_length_text(spectrum.samples().front().y)));
}

std::string profile_text(const DensityProfile& profile) {
    const auto length = [](Length x) { return toml_string(length_text(x)); };
    return std::visit(Overloaded{
                          [&](const ExponentialProfile& p) {
                              const std::string top =
                                  p == ExponentialProfile{p.scale_height} ? "" : fmt::format(", top = {}", length(p.top));
                              return fmt::format("{{ kind = \"exponential\", scale_height = {}{} }}", length(p.scale_height), top);
                          },
                          [&](const LayerProfile& p) {
                              return fmt::format("{{ kind = \"layer\", low = {}, high = {} }}", length(p.low), length(p.high));
                          },
                          [&](const TriangleProfile& p) {
                              return fmt::format("{{ kind = \"triangle\", low = {}, peak = {}, high = {} }}", length(p.low), length(p.peak),
                                                 length(p.high));
                          },
                          [&](const TabulatedProfile& p) {
                              return fmt::format("{{ kind = \"tabulated\", {} }}", columns_text(p.densities, "altitude_m", "density"));
                          },
                      },
                      profile);
}

// Degrees if every angle survives them, else radians.
std::string angles_text(const std::vector<double>& angles) {
    std::vector<double> degrees;
    for (const double angle : angles) degrees.push_back(angle / deg);
    for (std::size_t i = 0; i < angles.size(); ++i)
        if (degrees[i] * deg != angles[i]) return "angle_rad = " + array_text(angles);
    return "angle_deg = " + array_text(degrees);
}

std::string tabulated_phase_text(const TabulatedPhase& p) {
    std::vector<double> wavelengths;
    for (const Wavelength w : p.wavelengths) wavelengths.push_back(w.value);
    std::string out =
        fmt::format("kind = \"tabulated\"\n{}\nwavelength_nm = {}\nvalue_per_sr = [\n", angles_text(p.angles), array_text(wavelengths));
    for (const auto& row : p.values) out += "  " + array_text(row) + ",\n";
    return out + "]\n";
}

std::string phase_text(const PhaseFunction& phase) {
    return std::visit(
        Overloaded{
            [](const IsotropicPhase&) { return std::string("kind = \"isotropic\"\n"); },
            [](const RayleighPhase& p) { return fmt::format("kind = \"rayleigh\"\ndepolarisation = {}\n", p.depolarisation); },
            [](const HenyeyGreensteinPhase& p) { return fmt::format("kind = \"henyey_greenstein\"\ng = {}\n", numbers_text(p.g)); },
            [](const CornetteShanksPhase& p) { return fmt::format("kind = \"cornette_shanks\"\ng = {}\n", numbers_text(p.g)); },
            [](const TabulatedPhase& p) { return tabulated_phase_text(p); },
        },
        phase);
}

std::string constituent_text(const Constituent& c) {
    return fmt::format(
        "\n[[constituent]]\nname = {}\nkind = \"generic\"\nprofile = {}\nscattering = {}\nabsorption = {}\n[constituent.phase]\n{}",
        toml_string(c.name), profile_text(c.profile), coefficients_text(c.scattering), coefficients_text(c.absorption),
        phase_text(c.phase));
}

std::string sun_text(const Sun& sun) {
    return fmt::format("[sun]\nangular_radius = {}\nspectrum = {}\nlimb_darkening_1 = {}\nlimb_darkening_2 = {}\n",
                       toml_string(angle_text(sun.angular_radius)),
                       spectrum_text(sun.irradiance, "irradiance_W_m-2_nm-1", fmt::format("{}", sun.irradiance.samples().front().y.value)),
                       numbers_text(sun.limb_darkening_1), numbers_text(sun.limb_darkening_2));
}

}  // namespace

std::string atmosphere_text(const Atmosphere& a, const std::vector<std::string>& comments) {
    std::string out;
    for (const std::string& line : comments) out += "# " + line + '\n';
    out += fmt::format("name = {}\n\n[planet]\nradius = {}\ntop = {}\n\n[ground]\nalbedo = {}\n\n", toml_string(a.name),
                       toml_string(length_text(a.bottom_radius)), toml_string(length_text(a.top_altitude)), numbers_text(a.ground_albedo));
    out += sun_text(a.sun);
    for (const Constituent& c : a.constituents) out += constituent_text(c);
    return out;
}

Result<Done> write_atmosphere(const std::filesystem::path& path, const Atmosphere& atmosphere, const std::vector<std::string>& comments) {
    return write_file(path, atmosphere_text(atmosphere, comments));
}

}  // namespace airlight
