// The judge: models beside the truth, under many conditions, with what they cost.
// Uses all models, the truth and the scores; reports are made of what it finds (report.h, models_page.h).
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "eval/aerial.h"
#include "eval/cost.h"
#include "eval/score.h"
#include "eval/views.h"
#include "models/model.h"

namespace airlight {

enum class Against { reference, tables, measured };

struct CompareSettings {
    std::vector<Air> airs;
    std::vector<std::string> models;  // keys
    Against against = Against::reference;
    std::vector<Condition> conditions = {};  // computed truths
    std::vector<SkyTruth> measured = {};     // measured ones
    std::int64_t paths = 8192;               // of the reference, by day (paths_for())
    WavelengthGrid wavelengths = WavelengthGrid::standard();
    ModelOptions options = {};                               // of all models
    std::map<std::string, std::filesystem::path> data = {};  // of one model: its data set
    bool aerial_perspective = false;                         // whether it is judged, too, by day and against the reference
    bool single_scattering = false;                          // whether the reference also says what single scattering alone gives
    bool kept_tables = false;                                // whether tables come from options.cache: nobody then knows what they cost
    int picture_size = 96;                                   // pixels across; 0: no pictures, maps and profiles
    std::filesystem::path truth_folder = {};                 // finished truths are kept there
    std::function<void(const Error& warning)> warn = [](const Error&) {};
    Progress progress = {};
};

// A picture as a data URI, or why there is none.
struct Drawn {
    std::string uri = {};
    std::string refusal = {};
};

// A model under one condition.
struct Cell {
    Verdict verdict = {};
    Drawn map = {};
    std::vector<double> profile = {};  // luminance over the profile's grid; empty if there is none
};

struct ModelRun {
    ModelCard card;
    std::string refusal = {};  // why it cannot be made for this air; else empty
    MakingCost making = {};
    std::optional<AskingCost> asking = {};
    std::vector<Cell> cells = {};  // one a truth
    std::optional<AerialVerdict> aerial = {};
    std::vector<Drawn> pictures = {};
};

// All models in one air.
struct AirRun {
    Air air = {};
    Length picture_altitude = 0.0 * m;
    std::vector<SkyTruth> truths = {};
    std::vector<std::optional<Illuminance>> illuminances = {};  // of the truths
    std::vector<ProfileGrid> profile_grids = {};
    std::vector<std::vector<double>> profiles = {};  // of the tables
    std::vector<Drawn> pictures = {};                // by the tables
    std::vector<ModelRun> models = {};
    std::vector<AerialTruth> aerial = {};  // of all conditions under which it is judged
    std::optional<ModelRun> single = {};   // light scattered once alone, by the reference: the floor of single scattering, by day
};

struct Comparison {
    Against against;
    WavelengthGrid wavelengths;
    std::int64_t paths;
    bool kept_tables;  // so that core time ahead is not what it would be
    std::vector<AirRun> airs;
};

// Fails if a model is unknown, the truth cannot be had, or `progress` asks to stop: finished truths are then on disk. A model that
// cannot be made, or does not answer, is no failure: its reason is in its cells.
Result<Comparison> compare(const CompareSettings& settings);

// What a model was found to be, over several conditions: the quadratic mean of its relative errors.
struct Summary {
    int asked = 0, answered = 0;  // conditions
    int partly = 0;               // of those answered: in some directions only
    double relative_rmse = 0.0, noise = 0.0, luminance_rmse = 0.0, chromaticity_rmse = 0.0, colour_difference = 0.0, spectral_rmse = 0.0;
};
constexpr double end_of_day_deg = 85.0;  // of the sun's zenith angle

// Above the horizon, of conditions for which `wanted` is true; a condition counts as answered if any direction is.
Summary summary(
    const AirRun& air, const ModelRun& model, const std::function<bool(const Condition&)>& wanted = [](const Condition&) { return true; });

// On the lowest eye by day (sun to 85 degrees): what nearly every model answers, so that all are ordered by the same sky.
std::function<bool(const Condition&)> common_ground(const AirRun& air);

// Models by their error on the common ground, the nearest first; then those that do not answer there.
std::vector<std::size_t> nearest_first(const AirRun& air);

}  // namespace airlight
