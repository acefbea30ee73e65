#include "air_inputs.h"

#include <filesystem>

#include "atmosphere/atmosphere_file.h"
#include "atmosphere/weather_to_atmosphere.h"
#include "core/files.h"

namespace airlight::cli {

namespace {

constexpr std::size_t max_report_bytes = 1 << 16;

// The report itself, or the text of the file that is named.
Result<std::string> report_text(const std::string& text_or_path) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(text_or_path, ignored)) return read_file(text_or_path, max_report_bytes);
    return text_or_path;
}

}  // namespace

CLI::Option* add_air_inputs(CLI::App& app, AirInputs& inputs) {
    CLI::Option* name =
        app.add_option("atmosphere", inputs.atmosphere, "a preset's name, or a file as docs/atmosphere-file.md describes it")
            ->option_text("<preset|file>");
    app.add_option("--metar", inputs.metar, "the same air under the weather of this report: its text, or a file")
        ->option_text("<text|file>");
    app.add_option("--aerosol", inputs.aerosol, "what the place's aerosol is, where the report does not say")
        ->option_text("<type>")
        ->capture_default_str();
    return name;
}

Result<AskedAir> asked_air(const AirInputs& inputs) {
    Result<Atmosphere> base = atmosphere_named(inputs.atmosphere);
    if (!base) return base.error();
    if (inputs.metar.empty()) return AskedAir{*std::move(base), {}};
    const Result<AerosolType> usual = parse_aerosol_type(inputs.aerosol);
    if (!usual) return at("--aerosol", usual.error());
    Result<AskedAir> under = air_under(*std::move(base), inputs.metar, *usual);
    if (!under) return at("--metar", under.error());
    return under;
}

Result<AskedAir> air_under(Atmosphere base, const std::string& text_or_file, AerosolType usual_aerosol) {
    const Result<std::string> text = report_text(text_or_file);
    if (!text) return text.error();
    const Result<Metar> report = parse_metar(*text);
    if (!report) return report.error();
    Result<AtmosphereUnderWeather> under = atmosphere_under(std::move(base), *report, {usual_aerosol});
    if (!under) return under.error();
    return AskedAir{std::move(under->atmosphere), std::move(under->decisions)};
}

}  // namespace airlight::cli
