#include "eval/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>
#include <thread>

#include "core/parallel.h"
#include "eval/drawn.h"
#include "eval/truth_file.h"
#include "sky/reference_sky.h"

namespace airlight {

namespace {

constexpr int map_size = 48;
constexpr double seconds_for_a_picture = 5.0, seconds_for_a_map = 0.5;

std::vector<Wavelength> wavelengths_of(const CompareSettings& settings) {
    return {settings.wavelengths.begin(), settings.wavelengths.end()};
}

Error interrupted() { return {"", "the comparison was interrupted", "Run the same command again: what was finished is kept."}; }

// The truths of one air by the reference: read if they are on disk, else computed and written.
class ReferenceTruths {
public:
    ReferenceTruths(const CompareSettings& settings, const Air& air)
        : settings_(settings), air_(air), wavelengths_(wavelengths_of(settings)) {}

    // Truths that are on disk already.
    void read() {
        for (const Condition& condition : settings_.conditions) {
            truths_.emplace_back();
            const std::filesystem::path path = truth_path(settings_.truth_folder, origin(condition));
            std::error_code absent;
            if (!std::filesystem::exists(path, absent)) continue;
            Result<SkyTruth> truth = read_truth(path, origin(condition), air_.atmosphere, condition);
            if (truth) truths_.back() = std::move(*truth);
            else settings_.warn(truth.error());
        }
    }
    double paths_missing() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < truths_.size(); ++i)
            if (!truths_[i]) sum += paths(settings_.conditions[i]);
        return sum;
    }
    // `progress` is told shares of paths_missing().
    Result<std::vector<SkyTruth>> complete(const Progress& progress) {
        const Result<Reference> reference = Reference::of(air_.atmosphere, wavelengths_);
        if (!reference) return at(air_.name, reference.error());
        const double all = std::max(1.0, paths_missing());
        double done = 0.0;
        std::vector<SkyTruth> truths;
        for (std::size_t i = 0; i < truths_.size(); ++i) {
            const Condition& condition = settings_.conditions[i];
            if (!truths_[i]) {
                const double share = paths(condition) / all;
                Result<SkyTruth> truth = compute(*reference, condition, part_of(progress, done, share));
                if (!truth) return truth.error();
                done += share;
                truths_[i] = std::move(*truth);
            }
            truths.push_back(std::move(*truths_[i]));
        }
        return truths;
    }

private:
    double paths(const Condition& condition) const { return static_cast<double>(paths_for(settings_.paths, condition)); }
    TruthOrigin origin(const Condition& condition) const {
        return truth_origin(air_.atmosphere, wavelengths_, condition, paths_for(settings_.paths, condition),
                            settings_.options.reference.seed);
    }
    Result<SkyTruth> compute(const Reference& reference, const Condition& condition, const Progress& progress) const {
        ReferenceSettings how = settings_.options.reference;
        how.paths = paths_for(settings_.paths, condition);
        const ReferenceSky sky(reference, air_.atmosphere.bottom_radius, how, {.stop = progress.stop});
        Result<SkyTruth> truth = truth_by(sky, air_.atmosphere, condition, progress);
        if (!truth) return progress.stop.stop_requested() ? interrupted() : at(air_.name, truth.error());
        const TruthOrigin from = origin(condition);
        if (const Result<Done> kept = write_truth(truth_path(settings_.truth_folder, from), from, *truth); !kept)
            settings_.warn(kept.error());
        return truth;
    }

    const CompareSettings& settings_;
    const Air& air_;
    std::vector<Wavelength> wavelengths_;
    std::vector<std::optional<SkyTruth>> truths_;
};

// Everything of one air, with its truths at hand.
class AirJudge {
public:
    AirJudge(const CompareSettings& settings, const Air& air)
        : settings_(settings),
          weights_(settings.wavelengths, air.atmosphere.sun.irradiance),
          converter_(RgbSpace::srgb, WhitePoint::d65),
          run_{.air = air} {}

    // The tables draw the truth, and are it if so asked.
    Result<AirRun> judge(std::vector<SkyTruth> truths, const Progress& progress) {
        run_.truths = std::move(truths);
        const bool asked = std::find(settings_.models.begin(), settings_.models.end(), "tables") != settings_.models.end();
        if (asked || settings_.against == Against::tables || settings_.picture_size > 0) {
            Result<std::unique_ptr<Sky>> made = make("tables", tables_making_, part_of(progress, 0.0, 0.2));
            if (progress.stop.stop_requested()) return interrupted();
            if (!made) return at(run_.air.name, made.error());
            tables_ = std::move(*made);
        }
        if (settings_.against == Against::tables)
            for (const Condition& condition : settings_.conditions) {
                Result<SkyTruth> truth = truth_by(*tables_, run_.air.atmosphere, condition, {.stop = progress.stop});
                if (!truth) return truth.error();
                run_.truths.push_back(std::move(*truth));
            }
        for (const SkyTruth& truth : run_.truths)
            run_.illuminances.push_back(truth.irradiance ? std::optional(illuminance(*truth.irradiance, weights_)) : std::nullopt);
        if (settings_.picture_size > 0)
            if (const Result<Done> drawn = draw_truth(); !drawn) return at(run_.air.name, drawn.error());
        if (settings_.single_scattering)
            if (const Result<Done> done = judge_single_scattering(progress.stop); !done) return done.error();
        if (settings_.aerial_perspective)
            if (const Result<Done> done = look_at_points(progress.stop); !done) return done.error();
        for (std::size_t i = 0; i < settings_.models.size(); ++i) {
            if (progress.stop.stop_requested()) return interrupted();
            const double share = 0.8 / static_cast<double>(settings_.models.size());
            run_.models.push_back(model_run(settings_.models[i], part_of(progress, 0.2 + share * static_cast<double>(i), share)));
        }
        if (progress.stop.stop_requested()) return interrupted();
        return std::move(run_);
    }

private:
    // Unless tables are kept nothing comes from a cache: what is computed ahead is measured.
    Result<std::unique_ptr<Sky>> make(const std::string& key, MakingCost& cost, const Progress& progress) const {
        ModelOptions options = settings_.options;
        options.cache.enabled = settings_.kept_tables;
        options.reference.paths = settings_.paths;
        options.progress.stop = progress.stop;
        options.progress.report = [progress](std::string_view, double fraction) { progress.report("models", 0.5 * fraction); };
        if (const auto data = settings_.data.find(key); data != settings_.data.end()) options.data = data->second;
        return measured_making([&] { return make_sky(key, run_.air.atmosphere, wavelengths_of(settings_), options); }, cost);
    }

    Result<Done> judge_single_scattering(const std::stop_token& stop) {
        const Result<Reference> reference = Reference::of(run_.air.atmosphere, wavelengths_of(settings_));
        if (!reference) return at(run_.air.name, reference.error());
        const ReferenceSettings how{.paths = settings_.paths, .seed = settings_.options.reference.seed + 1, .last_order = 1};
        const ReferenceSky sky(*reference, run_.air.atmosphere.bottom_radius, how, {.stop = stop});
        run_.single = ModelRun{.card = find_model("reference")->card};
        for (const SkyTruth& truth : run_.truths) {
            if (stop.stop_requested()) return interrupted();
            const bool by_day = truth.condition.sun_zenith_deg <= end_of_day_deg;
            run_.single->cells.push_back({.verdict = by_day ? judged(sky, truth, run_.air.atmosphere.sun, weights_) : Verdict{}});
        }
        return Done{};
    }

    // The truths of aerial perspective; they take seconds, and are not kept.
    Result<Done> look_at_points(const std::stop_token& stop) {
        const Result<Reference> reference = Reference::of(run_.air.atmosphere, wavelengths_of(settings_));
        if (!reference) return at(run_.air.name, reference.error());
        const ReferenceSettings how{.paths = settings_.paths, .seed = settings_.options.reference.seed};
        for (const SkyTruth& truth : run_.truths) {
            if (!aerial_judged(run_.air.atmosphere, truth.condition)) continue;
            Result<std::vector<AerialTruth>> seen = aerial_truths(*reference, run_.air.atmosphere, truth.condition, how, {.stop = stop});
            if (!seen) return stop.stop_requested() ? interrupted() : at(run_.air.name, seen.error());
            run_.aerial.insert(run_.aerial.end(), seen->begin(), seen->end());
        }
        return Done{};
    }

    std::size_t bands() const { return static_cast<std::size_t>(settings_.wavelengths.size()); }

    Result<Done> draw_truth() {
        if (!run_.truths.empty()) run_.picture_altitude = run_.truths.front().condition.altitude;
        for (const PictureView& view : picture_views()) {
            exposures_.push_back(1.0);
            const Result<Image> image =
                picture(*tables_, run_.air.atmosphere.sun, view, run_.picture_altitude, settings_.picture_size, tools());
            if (image) exposures_.back() = picture_exposure(*image, converter_);
            run_.pictures.push_back(drawn(image, exposures_.back()));
        }
        for (const SkyTruth& truth : run_.truths) {
            grids_.push_back(map_grid(run_.air.atmosphere, truth.condition, map_size));
            run_.profile_grids.push_back(profile_grid(run_.air.atmosphere, truth.condition));
            maps_.push_back({});
            run_.profiles.emplace_back();
            if (const Result<Done> looked = look(*tables_, maps_.size() - 1, maps_.back(), run_.profiles.back()); !looked)
                return looked.error();
        }
        return Done{};
    }

    // Luminances over the map and along the profile of a condition; the error of a sky that does not answer.
    Result<Done> look(const Sky& sky, std::size_t i, std::vector<double>& map, std::vector<double>& profile) const {
        const Condition& condition = run_.truths[i].condition;
        const Result<std::unique_ptr<SkyDome>> dome = sky.dome(condition.altitude, condition.sun_zenith_deg * deg);
        if (!dome) return dome.error();
        profile = luminances(**dome, bands(), run_.profile_grids[i].directions, weights_);
        std::vector<Direction> seen;
        for (const std::optional<Direction>& direction : grids_[i].directions)
            if (direction) seen.push_back(*direction);
        map = luminances(**dome, bands(), seen, weights_);
        return Done{};
    }

    ModelRun model_run(const std::string& key, const Progress& progress) const {
        ModelRun run{.card = find_model(key)->card};
        progress.report("models", 0.0);
        std::unique_ptr<Sky> own;
        if (key == "tables") {
            run.making = tables_making_;
        } else {
            Result<std::unique_ptr<Sky>> made = make(key, run.making, progress);
            if (!made) {
                run.refusal = made.error().message();
                return run;
            }
            own = std::move(*made);
        }
        const Sky& sky = own ? *own : *tables_;
        run.cells.resize(run_.truths.size());
        parallel_for(run_.truths.size(), [&](std::size_t i) {
            if (!progress.stop.stop_requested()) run.cells[i].verdict = judged(sky, run_.truths[i], run_.air.atmosphere.sun, weights_);
        });
        if (!run_.aerial.empty()) run.aerial = judged_aerial(sky, run_.aerial);
        for (std::size_t i = 0; i < run.cells.size() && !progress.stop.stop_requested(); ++i) {
            const Verdict& verdict = run.cells[i].verdict;
            if (!verdict.sky && !verdict.ground) continue;
            if (!run.asking) {
                const Result<AskingCost> cost = asking_cost(sky, run_.truths[i].condition);
                if (cost) run.asking = *cost;
            }
            if (settings_.picture_size > 0) draw_cell(sky, i, run);
            progress.report("models", 0.6 + 0.3 * static_cast<double>(i + 1) / static_cast<double>(run.cells.size()));
        }
        if (settings_.picture_size > 0) draw_pictures(sky, run);
        return run;
    }

    // How many directions may be looked at within a time.
    static double affordable_directions(const ModelRun& run, double seconds) {
        const double cores = std::max(1u, std::thread::hardware_concurrency());
        return run.asking ? seconds * cores / std::max(1e-9, run.asking->direction_seconds) : 0.0;
    }

    void draw_cell(const Sky& sky, std::size_t i, ModelRun& run) const {
        Cell& cell = run.cells[i];
        if (affordable_directions(run, seconds_for_a_map) < static_cast<double>(grids_[i].directions.size())) {
            cell.map.refusal = too_slow(run);
            return;
        }
        std::vector<double> map;
        if (const Result<Done> looked = look(sky, i, map, cell.profile); !looked) {
            cell.map.refusal = looked.error().what;
            return;
        }
        std::vector<std::optional<double>> deviations;
        std::size_t next = 0;
        for (const std::optional<Direction>& direction : grids_[i].directions) {
            deviations.emplace_back();
            if (!direction) continue;
            const double truth = maps_[i][next], found = map[next];
            ++next;
            if (truth > 0.0 && found > 0.0) deviations.back() = found / truth - 1.0;
        }
        const Result<std::string> uri = map_uri(grids_[i].width, grids_[i].height, deviations);
        if (uri) cell.map.uri = *uri;
        else cell.map.refusal = uri.error().what;
    }

    void draw_pictures(const Sky& sky, ModelRun& run) const {
        const int size = std::min(settings_.picture_size, static_cast<int>(std::sqrt(affordable_directions(run, seconds_for_a_picture))));
        for (std::size_t i = 0; i < picture_views().size(); ++i) {
            if (size < 24) run.pictures.push_back({"", too_slow(run)});
            else
                run.pictures.push_back(
                    drawn(picture(sky, run_.air.atmosphere.sun, picture_views()[i], run_.picture_altitude, size, tools()), exposures_[i]));
        }
    }

    static std::string too_slow(const ModelRun& run) {
        if (!run.asking) return "answers none of these conditions";
        return fmt::format("too slow for a picture: {:.3g} s a direction", run.asking->direction_seconds);
    }

    static Drawn drawn(const Result<Image>& image, double exposure) {
        if (!image) return {"", image.error().what};
        const Result<std::string> uri = picture_uri(*image, exposure);
        return uri ? Drawn{*uri, ""} : Drawn{"", uri.error().what};
    }
    PictureTools tools() const { return {weights_, converter_}; }

    const CompareSettings& settings_;
    ColourWeights weights_;
    RgbConverter converter_;
    AirRun run_;
    std::unique_ptr<Sky> tables_;
    MakingCost tables_making_;
    std::vector<double> exposures_;
    std::vector<MapGrid> grids_;
    std::vector<std::vector<double>> maps_;
};

// The truths of all airs before any model: the long part first, in one measure of progress.
Result<std::vector<std::vector<SkyTruth>>> truths_of(const CompareSettings& settings) {
    std::vector<std::vector<SkyTruth>> truths(settings.airs.size(), settings.measured);
    if (settings.against != Against::reference) return truths;
    std::vector<ReferenceTruths> made;
    double all = 0.0, done = 0.0;
    for (const Air& air : settings.airs) {
        made.emplace_back(settings, air).read();
        all += made.back().paths_missing();
    }
    for (std::size_t i = 0; i < made.size(); ++i) {
        const double share = made[i].paths_missing() / std::max(1.0, all);
        Result<std::vector<SkyTruth>> complete = made[i].complete(part_of(settings.progress, done, share));
        if (!complete) return complete.error();
        truths[i] = std::move(*complete);
        done += share;
    }
    return truths;
}

}  // namespace

Result<Comparison> compare(const CompareSettings& settings) {
    for (const std::string& key : settings.models)
        if (!find_model(key)) return make_sky(key, settings.airs.front().atmosphere, wavelengths_of(settings)).error();
    Result<std::vector<std::vector<SkyTruth>>> truths = truths_of(settings);
    if (!truths) return truths.error();
    Comparison comparison{settings.against, settings.wavelengths, settings.paths, settings.kept_tables, {}};
    const double share = 1.0 / static_cast<double>(settings.airs.size());
    for (std::size_t i = 0; i < settings.airs.size(); ++i) {
        AirJudge judge(settings, settings.airs[i]);
        Result<AirRun> run = judge.judge(std::move((*truths)[i]), part_of(settings.progress, static_cast<double>(i) * share, share));
        if (!run) return run.error();
        comparison.airs.push_back(std::move(*run));
    }
    return comparison;
}

Summary summary(const AirRun& air, const ModelRun& model, const std::function<bool(const Condition&)>& wanted) {
    Summary s;
    for (std::size_t i = 0; i < air.truths.size(); ++i) {
        if (!wanted(air.truths[i].condition)) continue;
        ++s.asked;
        if (i >= model.cells.size() || !model.cells[i].verdict.sky) continue;
        const Score& score = *model.cells[i].verdict.sky;
        ++s.answered;
        s.partly += score.answered < score.asked;
        s.relative_rmse += score.relative_rmse * score.relative_rmse;
        s.noise += score.noise * score.noise;
        s.luminance_rmse += score.luminance_rmse * score.luminance_rmse;
        s.chromaticity_rmse += score.chromaticity_rmse * score.chromaticity_rmse;
        s.spectral_rmse += score.spectral_rmse * score.spectral_rmse;
        s.colour_difference += score.colour_difference;
    }
    const double n = std::max(1, s.answered);
    for (double* mean : {&s.relative_rmse, &s.noise, &s.luminance_rmse, &s.chromaticity_rmse, &s.spectral_rmse})
        *mean = std::sqrt(*mean / n);
    s.colour_difference /= n;
    return s;
}

std::function<bool(const Condition&)> common_ground(const AirRun& air) {
    Length lowest = anywhere;
    for (const SkyTruth& truth : air.truths) lowest = std::min(lowest, truth.condition.altitude);
    return [lowest](const Condition& c) { return c.altitude == lowest && c.sun_zenith_deg <= end_of_day_deg; };
}

std::vector<std::size_t> nearest_first(const AirRun& air) {
    std::vector<std::size_t> order;
    std::vector<double> errors;
    for (const ModelRun& model : air.models) {
        const Summary s = summary(air, model, common_ground(air));
        errors.push_back(s.answered > 0 ? s.relative_rmse : std::numeric_limits<double>::infinity());
        order.push_back(order.size());
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return errors[a] < errors[b]; });
    return order;
}

}  // namespace airlight
