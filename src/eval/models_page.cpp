#include "eval/models_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "eval/report.h"

namespace airlight {

namespace {

constexpr double frame_seconds = 1.0 / 30.0;

// Suns apart by what lights the air: whole columns, long columns, the air above the Earth's shadow.
struct SunRange {
    const char* name;
    double low_deg, high_deg;
    bool holds(const Condition& c) const { return c.sun_zenith_deg > low_deg && c.sun_zenith_deg <= high_deg; }
};
constexpr SunRange sun_ranges[] = {
    {"high sun, to 60°", -1.0, 60.0}, {"low sun, to 85°", 60.0, end_of_day_deg}, {"twilight, beyond 85°", end_of_day_deg, 180.0}};

std::vector<double> altitudes_m(const AirRun& air) {
    std::set<double> altitudes;
    for (const SkyTruth& truth : air.truths) altitudes.insert(truth.condition.altitude.in(m));
    return {altitudes.begin(), altitudes.end()};
}

std::vector<double> suns_deg(const AirRun& air) {
    std::set<double> suns;
    for (const SkyTruth& truth : air.truths) suns.insert(truth.condition.sun_zenith_deg);
    return {suns.begin(), suns.end()};
}

std::string altitude_text(double altitude_m) {
    return altitude_m < 1000.0 ? fmt::format("{:g} m", altitude_m) : fmt::format("{:g} km", altitude_m / 1000.0);
}

std::string percent_or_dash(const Summary& s) {
    if (s.answered == 0) return "–";
    return percent_text(s.relative_rmse) + (s.answered < s.asked || s.partly > 0 ? "*" : "");
}

std::vector<const ModelRun*> ordered(const AirRun& air) {
    std::vector<const ModelRun*> models;
    for (const std::size_t i : nearest_first(air)) models.push_back(&air.models[i]);
    return models;
}

std::string orders_text(Orders orders) {
    switch (orders) {
        case Orders::none:
            return "none";
        case Orders::single:
            return "single";
        case Orders::several:
            return "several";
        case Orders::fitted:
            return "fitted";
    }
    return "";
}

// What a column of numbers is the mean over.
struct Column {
    std::string name;
    std::function<bool(const Condition&)> holds;
};

// A column an eye, or, if there is only one, a column a sun.
std::vector<Column> columns_of(const AirRun& air) {
    std::vector<Column> columns;
    const std::vector<double> eyes = altitudes_m(air);
    if (eyes.size() > 1) {
        for (const double eye : eyes)
            columns.push_back({altitude_text(eye) + ", all suns", [eye](const Condition& c) { return c.altitude.in(m) == eye; }});
        return columns;
    }
    for (const double sun : suns_deg(air))
        columns.push_back({fmt::format("sun {:g}°", sun), [sun](const Condition& c) { return c.sun_zenith_deg == sun; }});
    return columns;
}

std::string order_table(const Comparison& comparison, const AirRun& air) {
    const std::vector<Column> columns = columns_of(air);
    std::string text = "| model | orders | by day |";
    std::string rule = "|---|---|---:|";
    for (const Column& column : columns) {
        text += fmt::format(" {} |", column.name);
        rule += "---:|";
    }
    text += " noise | luminance | u′v′ | ΔE₀₀ | picture, one core | ahead, core time | memory |\n" + rule +
            "---:|---:|---:|---:|---:|---:|---:|\n";
    for (const ModelRun* model : ordered(air)) {
        const Summary day = summary(air, *model, common_ground(air));
        text += fmt::format("| `{}` | {} | {} |", model->card.key, orders_text(orders_of(model->card)), percent_or_dash(day));
        for (const Column& column : columns) text += fmt::format(" {} |", percent_or_dash(summary(air, *model, column.holds)));
        if (day.answered > 0)
            text += fmt::format(" {} | {} | {:.4f} | {:.2f} |", percent_text(day.noise), percent_text(day.luminance_rmse),
                                day.chromaticity_rmse, day.colour_difference);
        else text += " | | | |";
        text += model->asking ? fmt::format(" {} |", time_text(picture_seconds(*model->asking))) : " – |";
        const bool made = model->refusal.empty();
        text += fmt::format(" {} | {} |\n", made && !comparison.kept_tables ? time_text(model->making.core_seconds) : "–",
                            made ? bytes_text(model->making.bytes) : "–");
    }
    return text;
}

// "12.3 / 0.004": light in per cent, transmittance; * where some views are refused.
std::string aerial_cell(const AerialScore& score) {
    if (score.answered == 0) return "–";
    return fmt::format("{} / {:.4f}{}", percent_text(score.light_rmse), score.transmittance_rmse, score.answered < score.asked ? "*" : "");
}

// Models by the error of the light at the middle distance.
std::string aerial_table(const AirRun& air) {
    if (air.aerial.empty()) return "";
    std::vector<const ModelRun*> models;
    for (const ModelRun& model : air.models)
        if (model.aerial &&
            std::any_of(model.aerial->at.begin(), model.aerial->at.end(), [](const AerialScore& s) { return s.answered > 0; }))
            models.push_back(&model);
    const auto error = [](const ModelRun* model) { return model->aerial->at[1].answered > 0 ? model->aerial->at[1].light_rmse : 1e300; };
    std::stable_sort(models.begin(), models.end(), [&](const ModelRun* a, const ModelRun* b) { return error(a) < error(b); });
    std::string text = "| aerial perspective |", rule = "|---|";
    for (const double distance : aerial_distances_m) {
        text += fmt::format(" to {} |", altitude_text(distance));
        rule += "---:|";
    }
    text += "\n" + rule + "\n";
    for (const ModelRun* model : models) {
        text += fmt::format("| `{}` |", model->card.key);
        for (const AerialScore& score : model->aerial->at) text += fmt::format(" {} |", aerial_cell(score));
        text += "\n";
    }
    double highest_sun = 0.0;
    for (const AerialTruth& truth : air.aerial) highest_sun = std::max(highest_sun, truth.view.sun_zenith / deg);
    std::string noise;
    for (const AerialScore& score : models.empty() ? AerialVerdict{}.at : models.front()->aerial->at)
        noise += fmt::format("{}{}", noise.empty() ? "" : ", ", percent_text(score.noise));
    return fmt::format(
        "What the air adds before points at three distances (root-mean-square relative error in %, the truth's noise of {} % taken off) "
        "and "
        "what it lets through (root-mean-square difference), over the horizon towards the sun and away from it and 4° below it, from eyes "
        "in "
        "the air with the sun {:g}° from the zenith at most:\n\n{}\n",
        noise, highest_sun, text);
}

// Errors on the common ground of the models with these orders, increasing.
std::vector<double> errors_of(const AirRun& air, Orders orders) {
    std::vector<double> errors;
    for (const ModelRun& model : air.models) {
        const Summary s = summary(air, model, common_ground(air));
        if (orders_of(model.card) == orders && s.answered > 0) errors.push_back(s.relative_rmse);
    }
    std::sort(errors.begin(), errors.end());
    return errors;
}

std::string range_text(const std::vector<double>& errors) {
    if (errors.size() < 2) return errors.empty() ? "nothing, for there is none that answers" : percent_text(errors.front()) + " %";
    return fmt::format("{} to {} %, the middle one {} %", percent_text(errors.front()), percent_text(errors.back()),
                       percent_text(errors[errors.size() / 2]));
}

std::string names(const std::vector<const ModelRun*>& models) {
    std::string text;
    for (const ModelRun* model : models) text += fmt::format("{}`{}`", text.empty() ? "" : ", ", model->card.key);
    return text.empty() ? "none" : text;
}

// What the truth itself says of the order, and which models are out of it.
std::string floor_explained(const AirRun& air, double floor) {
    std::vector<const ModelRun*> lucky, poor;
    for (const ModelRun* model : ordered(air)) {
        const Summary s = summary(air, *model, common_ground(air));
        const Orders orders = orders_of(model->card);
        if (s.answered == 0 || orders == Orders::none) continue;
        if (orders == Orders::single && s.relative_rmse < floor) lucky.push_back(model);
        if (orders != Orders::single && s.relative_rmse > floor) poor.push_back(model);
    }
    std::string text = fmt::format(
        " The cause is in the truth itself: light that was scattered once alone, by the reference and so without any other error, is off "
        "by "
        "{} %. That is the floor of single scattering, and what is above it is a model's own.",
        percent_text(floor));
    text += fmt::format(" Single-scattering models below the floor, by constants or approximations that make up for the missing light: {}.",
                        names(lucky));
    return text +
           fmt::format(
               " Of several orders or fitted, and yet worse than exact single scattering, by their approximations or because they were "
               "fitted to other air: {}.",
               names(poor));
}

// Models that are fast enough, each with its errors at its best and at its worst altitude, all suns.
std::string real_time(const AirRun& air) {
    std::string text;
    for (const ModelRun* model : ordered(air)) {
        if (!model->asking || picture_seconds(*model->asking) > frame_seconds) continue;
        std::vector<double> errors;
        for (const double eye : altitudes_m(air)) {
            const Summary s = summary(air, *model, [eye](const Condition& c) { return c.altitude.in(m) == eye; });
            if (s.answered > 0) errors.push_back(s.relative_rmse);
        }
        if (errors.empty()) continue;
        const auto [least, most] = std::minmax_element(errors.begin(), errors.end());
        text += fmt::format("{}`{}` ({} to {} % at {} of {} altitudes)", text.empty() ? "" : ", ", model->card.key, percent_text(*least),
                            percent_text(*most), errors.size(), altitudes_m(air).size());
    }
    return fmt::format(
        "Real-time here is a picture of 200 x 100 directions for a new eye and sun within {:.0f} ms on one core. The nearest first: {}.",
        1000.0 * frame_seconds, text.empty() ? "none" : text);
}

// Why the order is as it is, by what the comparison itself found.
std::string order_explained(const AirRun& air) {
    std::string text = fmt::format(
        "Models that compute several orders of scattering are off by {}; those of single scattering by {}; formulas that were fitted to "
        "such "
        "light by {}.",
        range_text(errors_of(air, Orders::several)), range_text(errors_of(air, Orders::single)),
        range_text(errors_of(air, Orders::fitted)));
    const Summary once = air.single ? summary(air, *air.single, common_ground(air)) : Summary{};
    if (once.answered > 0) text += floor_explained(air, once.relative_rmse);
    text += "\n";
    // With one eye the table says it all.
    if (altitudes_m(air).size() > 1) text += fmt::format("\n{}\n", real_time(air));
    return text;
}

std::string range_line(const ModelCard& card) {
    const std::string eye = card.highest_eye < anywhere
                                ? (card.highest_eye > 0.0 * m ? "eyes to " + altitude_text(card.highest_eye.in(m)) : "eyes on the ground")
                                : "eyes anywhere";
    return fmt::format("{}, sun to {:g}°, views to {:g}°, {}{}{}", eye, card.highest_sun_zenith_deg, card.highest_view_zenith_deg,
                       card.aerial_perspective ? "with aerial perspective" : "no aerial perspective", card.refused.empty() ? "" : "; not ",
                       card.refused);
}

std::string cost_line(const ModelRun& model) {
    if (!model.refusal.empty()) return "";
    std::string text =
        fmt::format("Cost: {} of core time ahead, {} kept", time_text(model.making.core_seconds), bytes_text(model.making.bytes));
    if (model.asking)
        text += fmt::format("; {} before the first direction of an eye and a sun, {} a direction", time_text(model.asking->dome_seconds),
                            time_text(model.asking->direction_seconds));
    return text + ".\n";
}

std::string error_table(const AirRun& air, const ModelRun& model) {
    const std::vector<double> eyes = altitudes_m(air);
    std::string text = fmt::format("\n| {} |", air.air.name), rule = "|---|";
    for (const double eye : eyes) {
        text += fmt::format(" {} |", altitude_text(eye));
        rule += "---:|";
    }
    text += "\n" + rule + "\n";
    for (const SunRange& range : sun_ranges) {
        if (std::none_of(air.truths.begin(), air.truths.end(), [&](const SkyTruth& t) { return range.holds(t.condition); })) continue;
        text += fmt::format("| {} |", range.name);
        for (const double eye : eyes)
            text += fmt::format(" {} |", percent_or_dash(summary(
                                             air, model, [&](const Condition& c) { return c.altitude.in(m) == eye && range.holds(c); })));
        text += "\n";
    }
    return text;
}

// The reasons for which a model does not answer, each once.
std::string refusals(const Comparison& comparison, std::size_t index) {
    std::set<std::string> reasons;
    for (const AirRun& air : comparison.airs) {
        const ModelRun& model = air.models[index];
        if (!model.refusal.empty()) reasons.insert(fmt::format("{}: {}", air.air.name, model.refusal.substr(0, model.refusal.find('\n'))));
        for (const Cell& cell : model.cells)
            if (!cell.verdict.refusal.empty()) reasons.insert(cell.verdict.refusal);
    }
    std::string text;
    for (const std::string& reason : reasons) text += fmt::format("{}{}", text.empty() ? "Where it has no figure: " : "; ", reason);
    return text.empty() ? "" : text + ".\n";
}

std::string model_section(const Comparison& comparison, std::size_t index) {
    const ModelCard& c = comparison.airs.front().models[index].card;
    std::string text = fmt::format("### {}\n{}. Scattering: {}. Ahead: {}; memory: {}. Answers {}.{}\n", c.key, c.approach, c.scattering,
                                   c.precomputation, c.memory, range_line(c), c.paper.empty() ? "" : fmt::format(" [{}]", c.paper));
    std::string cost, tables;
    for (const AirRun& air : comparison.airs) {
        const ModelRun& model = air.models[index];
        if (!model.asking) continue;
        if (cost.empty()) cost = cost_line(model);
        tables += error_table(air, model);
    }
    return text + cost + refusals(comparison, index) + tables + "\n";
}

std::string head(const Comparison& comparison, const std::string& command) {
    std::string suns, eyes;
    for (const double sun : suns_deg(comparison.airs.front())) suns += fmt::format("{}{:g}°", suns.empty() ? "" : ", ", sun);
    for (const double eye : altitudes_m(comparison.airs.front())) eyes += fmt::format("{}{}", eyes.empty() ? "" : ", ", altitude_text(eye));
    return fmt::format(
        "# Every model of the sky against the truth\nWritten by `{}`, all of it; how the figures are made: `src/eval`.\n\n"
        "The truth is {} ({}), at {} "
        "wavelengths from {:g} to {:g} nm, "
        "with the eye at {} and the sun {} from the zenith. Percentages are root-mean-square relative errors over directions above the "
        "horizon (twelve from the zenith to 0.3°; from space six "
        "across the limb) and wavelengths, less the truth's own variance, which is the column of noise. Means over conditions are "
        "quadratic, over those that a model answers: * says that "
        "there are others, or directions that it refuses, – that it answers none. By day is the lowest eye with the sun up to {:g}°, which "
        "nearly every model answers: by "
        "it they are in order, and of it are noise, "
        "luminance (relative, %), chromaticity (u′v′) and CIEDE2000. Models of exponential air are hundreds of per cent off in twilight "
        "and "
        "above haze that ends at an altitude, for they cannot express it: docs/accuracy.md shows the same models in air that they can.\n\n",
        command, truth_text(comparison), paths_text(comparison.paths), comparison.wavelengths.size(), comparison.wavelengths.first().in(nm),
        comparison.wavelengths.last().in(nm), eyes, suns, end_of_day_deg);
}

}  // namespace

Orders orders_of(const ModelCard& card) {
    const auto says = [&](std::string_view word) { return card.scattering.find(word) != std::string_view::npos; };
    if (says("fit")) return Orders::fitted;
    if (says("orders") || says("multiple") || says("second")) return Orders::several;
    return says("single") ? Orders::single : Orders::none;
}

std::string models_page(const Comparison& comparison, const std::string& command) {
    std::string text = head(comparison, command);
    for (const AirRun& air : comparison.airs)
        text +=
            fmt::format("## In order: {}\n{}\n{}\n{}", air.air.name, order_explained(air), order_table(comparison, air), aerial_table(air));
    // With one eye the tables above say it all.
    if (altitudes_m(comparison.airs.front()).size() == 1) return text;
    text += "## Model by model, in %\n";
    for (std::size_t i = 0; i < comparison.airs.front().models.size(); ++i) text += model_section(comparison, i);
    return text;
}

}  // namespace airlight
