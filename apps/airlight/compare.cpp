// `airlight compare`: models of the sky beside the truth, as one page, CSV and JSON; and the project's own page of models.

#include "eval/compare.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "atmosphere/atmosphere_file.h"
#include "atmosphere/validate.h"
#include "command.h"
#include "core/files.h"
#include "eval/measured_sky.h"
#include "eval/models_page.h"
#include "eval/report.h"
#include "interrupt.h"
#include "units/text.h"

namespace airlight::cli {

namespace {

struct CompareOptions {
    std::vector<std::string> atmospheres = {"earth-clear"};
    std::vector<std::string> grounds = {"own"};
    std::vector<std::string> models;
    std::string against = "reference";
    std::vector<double> eyes_m = {0.0};
    std::vector<double> suns_deg = {30.0, 60.0, 85.0};
    std::string wavelengths = "standard";
    std::string band = "360:720";
    std::int64_t paths = 8192;
    std::uint64_t seed = 1;
    std::optional<double> turbidity;
    std::vector<std::string> data;
    std::string sizes;
    int orders = BakeSettings{}.orders;
    int size = 96;
    std::string cache;
    std::string command = "make models";
    std::string folder;
    std::string page;
    bool quiet = false;
};

constexpr std::string_view measured_word = "measured:";

Result<std::vector<Air>> airs_of(const CompareOptions& given) {
    std::vector<Air> airs;
    for (const std::string& name : given.atmospheres) {
        const Result<Atmosphere> atmosphere = atmosphere_named(name);
        if (!atmosphere) return atmosphere.error();
        for (const std::string& ground : given.grounds) {
            Result<Air> air = air_over(name, *atmosphere, ground);
            if (!air) return at("--ground", air.error());
            airs.push_back(std::move(*air));
        }
    }
    return airs;
}

Result<std::vector<Condition>> conditions_of(const CompareOptions& given) {
    std::vector<Condition> conditions;
    for (const double eye : given.eyes_m)
        for (const double sun : given.suns_deg) {
            if (const Result<Done> ok = check_view(eye * m, 0.0, sun * deg, 0.0); !ok) return ok.error();
            conditions.push_back({eye * m, sun});
        }
    return conditions;
}

// All but the reference itself, if none is named.
Result<std::vector<std::string>> models_of(const CompareOptions& given) {
    std::vector<std::string> keys = given.models;
    if (keys.empty())
        for (const Model& model : models())
            if (model.card.key != "reference") keys.emplace_back(model.card.key);
    for (const std::string& key : keys)
        if (!find_model(key)) return at("--models", make_sky(key, {}, {}).error());
    return keys;
}

Result<Done> take_data(const CompareOptions& given, CompareSettings& settings) {
    for (const std::string& pair : given.data) {
        const std::size_t equals = pair.find('=');
        if (equals == std::string::npos || !find_model(pair.substr(0, equals)))
            return Error{"--data", fmt::format("\"{}\" does not name a model and its file", pair),
                         "Write MODEL=FILE, such as hosek2012=set.csv."};
        settings.data[pair.substr(0, equals)] = pair.substr(equals + 1);
    }
    return Done{};
}

// The wavelengths and, if it is measured, the truth.
Result<Done> take_truth(const CompareOptions& given, CompareSettings& settings) {
    if (!given.against.starts_with(measured_word)) {
        if (given.against != "reference" && given.against != "tables")
            return Error{"--against", fmt::format("\"{}\" is none of: reference tables measured:FILE", given.against), ""};
        settings.against = given.against == "tables" ? Against::tables : Against::reference;
        const Result<WavelengthGrid> grid = parse_wavelength_grid(given.wavelengths);
        if (!grid) return at("--wavelengths", grid.error());
        settings.wavelengths = *grid;
        return Done{};
    }
    settings.against = Against::measured;
    const std::size_t colon = given.band.find(':');
    const Result<double> lowest = parse_number(given.band.substr(0, colon)),
                         highest = parse_number(colon == std::string::npos ? "" : given.band.substr(colon + 1));
    if (!lowest || !highest)
        return Error{"--band", fmt::format("\"{}\" is no range of wavelengths", given.band), "Write it in nm, such as 360:720."};
    Result<MeasuredSky> measured = read_measured_sky(given.against.substr(measured_word.size()), *lowest * nm, *highest * nm);
    if (!measured) return measured.error();
    const Result<WavelengthGrid> grid = WavelengthGrid::of(measured->wavelengths);
    if (!grid) return grid.error();
    settings.wavelengths = *grid;
    settings.measured = std::move(measured->skies);
    return Done{};
}

Result<Done> take_options(const CompareOptions& given, CompareSettings& settings) {
    settings.options.turbidity = given.turbidity;
    settings.options.reference.seed = given.seed;
    settings.options.bake.orders = given.orders;
    if (!given.sizes.empty()) {
        const Result<TableSizes> sizes = parse_table_sizes(given.sizes);
        if (!sizes) return at("--sizes", sizes.error());
        settings.options.bake.sizes = *sizes;
    }
    if (const Result<BakeSettings> ok = validated(settings.options.bake); !ok) return at("--orders", ok.error());
    if (given.paths < 1) return Error{"--paths", fmt::format("{} is out of range: it must be 1 or more", given.paths), ""};
    if (given.size != 0 && (given.size < 24 || given.size > 512))
        return Error{"--size", fmt::format("{} is out of range: it must be 24 to 512, or 0 for no pictures", given.size), ""};
    settings.paths = given.paths;
    settings.picture_size = given.size;
    return Done{};
}

Result<CompareSettings> settings_of(const CompareOptions& given) {
    CompareSettings settings;
    Result<std::vector<Air>> airs = airs_of(given);
    if (!airs) return airs.error();
    settings.airs = std::move(*airs);
    Result<std::vector<std::string>> keys = models_of(given);
    if (!keys) return keys.error();
    settings.models = std::move(*keys);
    Result<std::vector<Condition>> conditions = conditions_of(given);
    if (!conditions) return conditions.error();
    settings.conditions = std::move(*conditions);
    for (const auto take : {take_data, take_truth, take_options})
        if (const Result<Done> taken = take(given, settings); !taken) return taken.error();
    for (const Air& air : settings.airs)
        if (const Result<Done> covered = covers(air.atmosphere, settings.wavelengths.first(), settings.wavelengths.last()); !covered)
            return at(air.name, covered.error());
    settings.kept_tables = !given.cache.empty();
    if (settings.kept_tables) settings.options.cache.folder = given.cache;
    settings.aerial_perspective = settings.against == Against::reference;
    settings.single_scattering = !given.page.empty() && settings.against == Against::reference;
    return settings;
}

Result<Done> make_folder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) return Error{folder.string(), "cannot be made: " + failed.message(), "Choose another folder."};
    return can_write(folder / "report.html");
}

void print_summary(const Comparison& comparison) {
    fmt::print("air,model,answered,asked,relative_rmse_percent,truth_noise_percent,spectral_rmse_mW_m-2_sr-1_nm-1,ciede2000,direction_s\n");
    for (const AirRun& air : comparison.airs)
        for (const ModelRun& model : air.models) {
            const Summary s = summary(air, model);
            const std::string errors = s.answered == 0 ? ",,,"
                                                       : fmt::format("{:.3f},{:.3f},{:.4g},{:.3f}", 100.0 * s.relative_rmse,
                                                                     100.0 * s.noise, 1000.0 * s.spectral_rmse, s.colour_difference);
            fmt::print("{},{},{},{},{},{}\n", air.air.name, model.card.key, s.answered, s.asked, errors,
                       model.asking ? fmt::format("{:.3g}", model.asking->direction_seconds) : "");
        }
}

Result<Done> run(const CompareOptions& given) {
    const Interrupt interrupt;
    Result<CompareSettings> settings = settings_of(given);
    if (!settings) return settings.error();
    const std::filesystem::path folder = given.folder;
    settings->truth_folder = folder / "truth";
    for (const std::filesystem::path& needed : {folder, settings->truth_folder})
        if (const Result<Done> made = make_folder(needed); !made) return made.error();
    if (!given.page.empty())
        if (const Result<Done> possible = can_write(given.page); !possible) return possible.error();
    settings->warn = [](const Error& warning) { fmt::print(stderr, "warning: {}\n", warning.message()); };
    ProgressLine line(given.quiet);
    settings->progress = line.progress(interrupt.token());
    const Result<Comparison> comparison = compare(*settings);
    if (!comparison) return comparison.error();
    if (const Result<Done> written = write_report(folder, *comparison); !written) return written.error();
    if (!given.page.empty())
        if (const Result<Done> written = write_file(given.page, models_page(*comparison, given.command)); !written) return written.error();
    print_summary(*comparison);
    for (const char* name : {"report.html", "scores.csv", "scores.json"}) fmt::print("# {}\n", (folder / name).string());
    if (!given.page.empty()) fmt::print("# {}\n", given.page);
    return Done{};
}

void add_condition_options(CLI::App& app, CompareOptions& given) {
    app.add_option("--atmosphere", given.atmospheres, "presets or files; several with commas")
        ->option_text("<names>")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--ground", given.grounds, "own, black, or a material such as grass and snow; several with commas")
        ->option_text("<names>")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--eyes-m", given.eyes_m, "altitudes of the eye; space is fine")
        ->option_text("<m,...>")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--suns", given.suns_deg, "zenith angles of the sun, 0 to 180")
        ->option_text("<deg,...>")
        ->delimiter(',')
        ->capture_default_str();
}

}  // namespace

Command compare_command(CLI::App& airlight) {
    const auto given = std::make_shared<CompareOptions>();
    CLI::App* app = airlight.add_subcommand("compare", "Judge models of the sky: their errors beside the truth, and their cost.");
    app->add_option("-o,--output", given->folder, "where the report goes; finished truths are kept there")
        ->option_text("<folder>")
        ->required();
    app->add_option("--models", given->models, "keys of `airlight models`, with commas (default: all but the reference)")
        ->option_text("<keys>")
        ->delimiter(',');
    app->add_option("--against", given->against, "reference, tables, or measured:FILE (CSV, see src/eval/measured_sky.h)")
        ->option_text("<truth>")
        ->capture_default_str();
    add_condition_options(*app, *given);
    app->add_option("--wavelengths", given->wavelengths, "in nm: 450,550,650 or 360:830:16 (first, last, count)")
        ->option_text("<grid>")
        ->capture_default_str();
    app->add_option("--band", given->band, "measured skies: wavelengths that count, in nm")->option_text("<nm:nm>")->capture_default_str();
    app->add_option("--paths", given->paths,
                    "reference: paths a direction; 24 times as many with the sun beyond 80 deg, 192 beyond 98, 768 from space beyond 85")
        ->option_text("<n>")
        ->capture_default_str();
    app->add_option("--seed", given->seed, "reference: the same seed gives the same digits")->option_text("<n>")->capture_default_str();
    app->add_option("--turbidity", given->turbidity, "models of turbidity: instead of that of the atmosphere")->option_text("<T>");
    app->add_option("--data", given->data, "a model's data set; may be given several times")->option_text("<key=file>");
    app->add_option("--orders", given->orders, "tables: orders of scattering computed, the rest extrapolated")
        ->option_text("<n>")
        ->capture_default_str();
    app->add_option("--sizes", given->sizes, "tables: texels of sun x azimuth x view x altitude (default: 64x16x32x32)")
        ->option_text("<sizes>");
    app->add_option("--size", given->size, "of pictures, in pixels; 0 leaves out pictures, maps and profiles")
        ->option_text("<n>")
        ->capture_default_str();
    app->add_option("--table", given->page, "also write the page of models, as docs/models.md is written")->option_text("<file.md>");
    app->add_option("--by", given->command, "the command that the page of models names as its own")
        ->option_text("<command>")
        ->capture_default_str();
    app->add_option("--cache", given->cache, "keep tables there, for all models and runs; what they cost is then not told")
        ->option_text("<folder>");
    app->add_flag("--quiet", given->quiet, "no progress on standard error");
    app->footer(help_footer(
        "CSV, one row an air and model: means over the conditions that it answers; then lines that begin with #, the files:\n"
        "        report.html (needs no network), scores.csv and scores.json. Ctrl-C stops, and the same command goes on from there.",
        "airlight compare --models preetham1999,tables --suns 40 --paths 256 --sizes 16x8x16x8 --orders 3 --size 24 -o compared"));
    return {app, [given] { return run(*given); }};
}

}  // namespace airlight::cli
