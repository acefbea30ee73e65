// `airlight fit`: a fitted model of the sky made for any atmosphere, as a file that the model reads.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numeric>

#include "air_inputs.h"
#include "command.h"
#include "core/files.h"
#include "fit/hosek2012.h"
#include "interrupt.h"
#include "models/turbidity.h"
#include "spectrum/wavelength_grid.h"
#include "units/text.h"

namespace airlight::cli {

namespace {

struct FitOptions {
    std::string form;
    AirInputs air;
    std::string output;
    std::string against = "tables";
    std::string turbidities;
    std::string albedos = "0,1";
    std::string wavelengths = "standard";
    std::string sizes = "32x12x24x24";
    int orders = BakeSettings{}.orders;
    std::int64_t paths = 4096;
    std::uint64_t seed = 1;
    std::string cache;
    bool quiet = false;
};

// What every fit is told.
struct Asked {
    Atmosphere atmosphere;
    std::vector<Wavelength> wavelengths;
    std::vector<double> turbidities;  // empty: the atmosphere's own
    std::vector<double> albedos;
    TruthSettings truth;
};

// What every fit gives: the file, and how far it is from the truth.
struct Fitted {
    std::string text;
    Residuals residuals;
};

// "2,4,6": rising numbers within a range.
Result<std::vector<double>> rising_numbers(const std::string& text, double low, double high, const char* option) {
    std::vector<double> numbers;
    for (std::size_t first = 0; first <= text.size();) {
        const std::size_t end = std::min(text.find(',', first), text.size());
        const Result<double> number = parse_number(std::string_view(text).substr(first, end - first));
        if (!number) return at(option, number.error());
        if (!(*number >= low && *number <= high))
            return Error{option, fmt::format("{:g} is out of range: it must be {:g} to {:g}", *number, low, high), ""};
        if (!numbers.empty() && !(*number > numbers.back()))
            return Error{option, fmt::format("{:g} does not lie above the number before it", *number), "Sort them and remove doubles."};
        numbers.push_back(*number);
        first = end + 1;
    }
    return numbers;
}

Result<TruthSettings> truth_of(const FitOptions& given) {
    TruthSettings truth;
    if (given.against == "reference") truth.truth = Truth::reference;
    else if (given.against != "tables") return Error{"--against", fmt::format("\"{}\" is neither tables nor reference", given.against), ""};
    const Result<TableSizes> sizes = parse_table_sizes(given.sizes);
    if (!sizes) return at("--sizes", sizes.error());
    const Result<BakeSettings> bake = validated(BakeSettings{.sizes = *sizes, .orders = given.orders});
    if (!bake) return at("--orders", bake.error());
    if (given.paths < 1) return Error{"--paths", fmt::format("{} is out of range: it must be 1 or more", given.paths), ""};
    truth.bake = *bake;
    truth.reference = {.paths = given.paths, .seed = given.seed};
    return truth;
}

Result<Asked> asked_of(const FitOptions& given) {
    Result<AskedAir> air = asked_air(given.air);
    if (!air) return air.error();
    const Result<WavelengthGrid> grid = parse_wavelength_grid(given.wavelengths);
    if (!grid) return at("--wavelengths", grid.error());
    const Result<TruthSettings> truth = truth_of(given);
    if (!truth) return truth.error();
    Asked asked{std::move(air->atmosphere), {grid->begin(), grid->end()}, {}, {}, *truth};
    if (!given.turbidities.empty()) {
        Result<std::vector<double>> turbidities = rising_numbers(given.turbidities, 1.0, 1000.0, "--turbidities");
        if (!turbidities) return turbidities.error();
        asked.turbidities = std::move(*turbidities);
    }
    Result<std::vector<double>> albedos = rising_numbers(given.albedos, 0.0, 1.0, "--albedos");
    if (!albedos) return albedos.error();
    asked.albedos = std::move(*albedos);
    return asked;
}

// Work that every fit needs: who computes, where finished jobs are kept, who is told.
struct Workplace {
    Team& team;
    JobStore store;
    Progress progress;
};

Result<Fitted> hosek(const Asked& asked, const Workplace& place) {
    // The model answers for an eye on the ground alone, and its file has no place for another altitude.
    HosekFitSettings settings{asked.turbidities, asked.albedos, asked.wavelengths, 0.0 * m, asked.truth};
    if (settings.turbidities.empty()) {
        const Result<double> own = turbidity(asked.atmosphere);
        if (!own) return own.error();
        settings.turbidities = {*own};
    }
    const Result<HosekFit> fit = fit_hosek2012(asked.atmosphere, settings, place.team, place.store, place.progress);
    if (!fit) return fit.error();
    return Fitted{hosek_csv(*fit, asked.atmosphere.name), fit->residuals};
}

struct Form {
    std::string_view name;  // as people call it
    std::string_view model;
    Result<Fitted> (*fit)(const Asked& asked, const Workplace& place);
};
constexpr Form forms[] = {
    {"hosek", "hosek2012", hosek},
};

Result<const Form*> form_named(const std::string& name) {
    const auto found = std::find_if(std::begin(forms), std::end(forms), [&](const Form& f) { return f.name == name || f.model == name; });
    if (found != std::end(forms)) return &*found;
    std::string names;
    for (const Form& form : forms) names.append(names.empty() ? "" : " ").append(form.name);
    return Error{"", fmt::format("\"{}\" is no model that can be fitted", name), fmt::format("Models are: {}.", names)};
}

std::filesystem::path jobs_folder(const FitOptions& given) {
    const std::filesystem::path cache = given.cache.empty() ? default_cache_folder() : std::filesystem::path(given.cache);
    return cache.empty() ? cache : cache / "jobs";
}

Result<Done> fit(const FitOptions& given) {
    const Interrupt interrupt;
    Team team;
    const Result<const Form*> form = form_named(given.form);
    if (!form) return form.error();
    const Result<Asked> asked = asked_of(given);
    if (!asked) return asked.error();
    if (const Result<Done> possible = can_write(given.output); !possible) return possible.error();
    ProgressLine line(given.quiet || !team.leads());
    const Result<Fitted> fitted = (*form)->fit(*asked, {team, JobStore(jobs_folder(given)), line.progress(interrupt.token())});
    if (!team.leads()) return Done{};
    if (!fitted) return fitted.error();
    if (const Result<Done> saved = write_file(given.output, fitted->text); !saved) return saved.error();
    fmt::print("condition,relative_rms\n");
    for (const ResidualLine& residual : fitted->residuals) fmt::print("\"{}\",{:.4f}\n", residual.condition, residual.relative_rms);
    return Done{};
}

}  // namespace

Command fit_command(CLI::App& airlight) {
    const auto given = std::make_shared<FitOptions>();
    CLI::App* app = airlight.add_subcommand("fit", "Fit a model of the sky to an atmosphere, as a file for --data.");
    app->add_option("model", given->form, "hosek")->option_text("<model>")->required();
    app->add_option("--atmosphere", given->air.atmosphere, "a preset or a file; see docs/atmosphere-file.md")
        ->option_text("<preset|file>")
        ->required();
    app->add_option("-o,--output", given->output, "the file of the fitted model")->option_text("<file>")->required();
    app->add_option("--metar", given->air.metar, "the same air under the weather of this report: its text, or a file")
        ->option_text("<text|file>");
    app->add_option("--aerosol", given->air.aerosol, "what the place's aerosol is, where the report does not say")
        ->option_text("<type>")
        ->capture_default_str();
    app->add_option("--turbidities", given->turbidities, "2,4,6: the aerosol scaled to each (default: the atmosphere's own)")
        ->option_text("<list>");
    app->add_option("--albedos", given->albedos, "of the ground")->option_text("<list>")->capture_default_str();
    app->add_option("--wavelengths", given->wavelengths, "in nm: 450,550,650 or 360:830:16 (first, last, count)")
        ->option_text("<grid>")
        ->capture_default_str();
    app->add_option("--against", given->against, "the truth that is fitted to: tables, or reference (Monte Carlo)")
        ->option_text("<truth>")
        ->capture_default_str();
    app->add_option("--orders", given->orders, "tables: orders of scattering computed, the rest extrapolated")
        ->option_text("<n>")
        ->capture_default_str();
    app->add_option("--sizes", given->sizes, "tables: texels of sun x azimuth x view x altitude")
        ->option_text("<sizes>")
        ->capture_default_str();
    app->add_option("--paths", given->paths, "reference: paths in each direction")->option_text("<n>")->capture_default_str();
    app->add_option("--seed", given->seed, "reference: the same seed gives the same digits")->option_text("<n>")->capture_default_str();
    app->add_option("--cache", given->cache, "where finished jobs are kept (default: $XDG_CACHE_HOME/airlight or ~/.cache/airlight)")
        ->option_text("<folder>");
    app->add_flag("--quiet", given->quiet, "no progress on standard error");
    app->footer(
        help_footer("CSV: condition, relative_rms, the root of the mean square of (model - truth) / truth over the sky.\n"
                    "        Ctrl-C stops, and the same command goes on from there. A build with MPI runs under mpirun: rank 0\n"
                    "        hands out jobs to the others, so give it one rank more than machines.",
                    "airlight fit hosek --atmosphere earth-clear --wavelengths 550 --albedos 0.2 --sizes 8x4x8x8 --orders 2 --cache tables "
                    "-o fit.csv"));
    return {app, [given] { return fit(*given); }};
}

}  // namespace airlight::cli
