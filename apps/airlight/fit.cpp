// `airlight fit`: a fitted model of the sky made for any atmosphere, as a file that the model reads.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "air_inputs.h"
#include "command.h"
#include "core/files.h"
#include "fit_forms.h"
#include "interrupt.h"
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
    std::string albedos;
    std::string altitudes;
    std::string variant;
    std::optional<double> error;
    std::string wavelengths = "standard";
    std::string sizes = "32x12x24x24";
    int orders = BakeSettings{}.orders;
    std::int64_t paths = 4096;
    std::uint64_t seed = 1;
    std::string cache;
    bool quiet = false;
    std::vector<std::string> said;  // the names of all options that were given
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

Result<FitAsked> asked_of(const FitOptions& given) {
    Result<AskedAir> air = asked_air(given.air);
    if (!air) return air.error();
    const Result<WavelengthGrid> grid = parse_wavelength_grid(given.wavelengths);
    if (!grid) return at("--wavelengths", grid.error());
    const Result<TruthSettings> truth = truth_of(given);
    if (!truth) return truth.error();
    FitAsked asked{std::move(air->atmosphere), {grid->begin(), grid->end()}, {}, {}, {}, given.variant, given.error, *truth};
    if (given.error && !(*given.error > 0.0 && *given.error < 1.0))
        return Error{"--error", fmt::format("{:g} is out of range: it must be above 0 and below 1", *given.error), ""};
    const struct {
        const std::string& text;
        double low, high;
        const char* option;
        std::vector<double>& numbers;
    } lists[] = {{given.turbidities, 1.0, 1000.0, "--turbidities", asked.turbidities},
                 {given.albedos, 0.0, 1.0, "--albedos", asked.albedos},
                 {given.altitudes, 0.0, asked.atmosphere.top_altitude.in(m), "--altitude-m", asked.altitudes_m}};
    for (const auto& list : lists) {
        if (list.text.empty()) continue;
        Result<std::vector<double>> numbers = rising_numbers(list.text, list.low, list.high, list.option);
        if (!numbers) return numbers.error();
        list.numbers = std::move(*numbers);
    }
    return asked;
}

// Fails if something was said that the form does not take: it would be passed over.
Result<Done> takes_all(const FitForm& form, const std::vector<std::string>& said) {
    constexpr std::string_view of_some = " --wavelengths --turbidities --albedos --altitude-m --variant --error ";
    constexpr std::string_view of_truth = " --against --orders --sizes --paths --seed ";
    const auto in = [](std::string_view words, const std::string& word) { return words.find(" " + word + " ") != std::string_view::npos; };
    for (const std::string& option : said)
        if ((in(of_some, option) && !in(form.takes, option)) || (in(of_truth, option) && !form.of_skies))
            return Error{option, fmt::format("is nothing that a fit of {} takes", form.model), "Leave it out."};
    return Done{};
}

std::filesystem::path jobs_folder(const FitOptions& given) {
    const std::filesystem::path cache = given.cache.empty() ? default_cache_folder() : std::filesystem::path(given.cache);
    return cache.empty() ? cache : cache / "jobs";
}

Result<Done> fit(const FitOptions& given) {
    const Interrupt interrupt;
    Team team;
    const Result<const FitForm*> form = fit_form_named(given.form);
    if (!form) return form.error();
    if (const Result<Done> ok = takes_all(**form, given.said); !ok) return ok.error();
    const Result<FitAsked> asked = asked_of(given);
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
    app->add_option("model", given->form, "one of those below")->option_text("<model>")->required();
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
    app->add_option("--albedos", given->albedos, "of the ground (default: 0,1)")->option_text("<list>");
    app->add_option("--altitude-m", given->altitudes,
                    "of the eye above the ground; the model answers there alone. hipiny2006: a list (default: 0,2000,6000,14000,30000)")
        ->option_text("<m>");
    app->add_option("--variant", given->variant, "dobashi1997: cosines, samples or harmonics (default: cosines)")->option_text("<name>");
    app->add_option("--error", given->error, "dobashi1997: the share of a band's square that a series may leave (default: 1e-4)")
        ->option_text("<x>");
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
    std::string forms = "Models, and what is taken beside the atmosphere and the truth:\n";
    for (const FitForm& form : fit_forms())
        forms += fmt::format("  {:<12} {}{}\n", form.name, form.says,
                             form.takes == " " ? "" : fmt::format(":\n               {}", form.takes.substr(1, form.takes.size() - 2)));
    app->footer(
        forms + "\n" +
        help_footer("CSV: condition, relative_rms, the root of the mean square of (model - truth) / truth over the sky.\n"
                    "        Ctrl-C stops, and the same command goes on from there. A build with MPI runs under mpirun: rank 0\n"
                    "        hands out jobs to the others, so give it one rank more than machines.",
                    "airlight fit hosek --atmosphere earth-clear --wavelengths 550 --albedos 0.2 --sizes 8x4x8x8 --orders 2 --cache tables "
                    "-o fit.csv"));
    return {app, [given, app] {
                for (const CLI::Option* option : app->get_options())
                    if (option->count() > 0) given->said.push_back(option->get_name());
                return fit(*given);
            }};
}

}  // namespace airlight::cli
