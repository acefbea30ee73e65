// The page of a comparison. Its style and its script are report.css and report.js, which are compiled in.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "eval/drawn.h"
#include "eval/report.h"

namespace airlight {

namespace {

// One pair {name, text} a file.
struct PageFile {
    std::string_view name, text;
};
constexpr PageFile page_files[] = {
#include "page_files.inc"
};
std::string_view page_file(std::string_view name) {
    return std::find_if(std::begin(page_files), std::end(page_files), [&](const PageFile& f) { return f.name == name; })->text;
}

// A cell that sorts by a number; what has none sorts last.
std::string number_cell(double value, const std::string& text) { return fmt::format("<td data-v=\"{:.6g}\">{}</td>", value, text); }
std::string no_cell(std::string_view text = "–") { return fmt::format("<td data-v=\"1e300\">{}</td>", text); }

std::string mean_cell(const Summary& s, double value, const std::string& text) {
    return s.answered > 0 ? number_cell(value, text) : no_cell();
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string summary_row(const AirRun& air, const ModelRun& model, const std::string& anchor, bool kept_tables) {
    const Summary all = summary(air, model);
    const Summary day = summary(air, model, [](const Condition& c) { return c.sun_zenith_deg <= end_of_day_deg; });
    const Summary dusk = summary(air, model, [](const Condition& c) { return c.sun_zenith_deg > end_of_day_deg; });
    std::string row = fmt::format("<tr><th scope=\"row\" data-v=\"{0}\"><a href=\"#{1}\">{0}</a></th>", model.card.key, anchor);
    row += mean_cell(day, day.relative_rmse, percent_text(day.relative_rmse));
    row += mean_cell(dusk, dusk.relative_rmse, percent_text(dusk.relative_rmse));
    row += mean_cell(all, all.spectral_rmse, fmt::format("{:.3g}", 1000.0 * all.spectral_rmse));
    row += mean_cell(all, all.luminance_rmse, percent_text(all.luminance_rmse));
    row += mean_cell(all, all.chromaticity_rmse, fmt::format("{:.4f}", all.chromaticity_rmse));
    row += mean_cell(all, all.colour_difference, fmt::format("{:.2f}", all.colour_difference));
    row += number_cell(-all.answered, fmt::format("{} of {}", all.answered, all.asked));
    if (model.refusal.empty()) {
        row += kept_tables ? no_cell() : number_cell(model.making.core_seconds, time_text(model.making.core_seconds));
        row += number_cell(static_cast<double>(model.making.bytes), bytes_text(model.making.bytes));
    } else {
        row += no_cell() + no_cell();
    }
    if (model.asking) {
        row += number_cell(model.asking->direction_seconds, time_text(model.asking->direction_seconds));
        row += number_cell(picture_seconds(*model.asking), time_text(picture_seconds(*model.asking)));
    } else {
        row += no_cell() + no_cell();
    }
    return row + fmt::format("<td class=\"words\">{}</td></tr>\n", html_text(model.card.scattering));
}

std::string anchor_of(std::size_t air, const ModelRun& model) { return fmt::format("m{}-{}", air, model.card.key); }

std::string summary_table(const AirRun& air, std::size_t index, bool kept_tables) {
    std::string html =
        "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>model</th><th>by day<br>%</th><th>twilight<br>%</th>"
        "<th>spectral<br>mW m⁻² sr⁻¹ nm⁻¹</th><th>luminance<br>%</th><th>u′v′</th><th>ΔE₀₀</th><th>answered</th><th>ahead<br>core time</th>"
        "<th>memory</th><th>a direction</th><th>200 × 100<br>picture</th><th class=\"words\">scattering</th></tr></thead><tbody>\n";
    for (const std::size_t i : nearest_first(air)) html += summary_row(air, air.models[i], anchor_of(index, air.models[i]), kept_tables);
    return html + "</tbody></table></div>\n";
}

// Models that answer any of it: light in per cent and transmittance for each distance.
std::string aerial_table(const AirRun& air, std::size_t index) {
    if (air.aerial.empty()) return "";
    std::string html =
        "<h3>Aerial perspective</h3><p class=\"note\">To points at three distances, by day, from within the air: what the air adds "
        "(root-mean-square relative error in %, less the truth’s own variance) and what it lets through (root-mean-square difference).</p>"
        "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>model</th>";
    for (const double distance : aerial_distances_m)
        html += fmt::format("<th>{0:g} km<br>light, %</th><th>{0:g} km<br>transmittance</th>", distance / 1000.0);
    html += "</tr></thead><tbody>\n";
    for (const std::size_t m : nearest_first(air)) {
        const ModelRun& model = air.models[m];
        if (!model.aerial || std::none_of(model.aerial->at.begin(), model.aerial->at.end(), [](const auto& s) { return s.answered > 0; }))
            continue;
        html += fmt::format("<tr><th scope=\"row\" data-v=\"{0}\"><a href=\"#{1}\">{0}</a></th>", model.card.key, anchor_of(index, model));
        for (const AerialScore& s : model.aerial->at)
            html += s.answered == 0 ? no_cell() + no_cell()
                                    : number_cell(s.light_rmse, percent_text(s.light_rmse) + (s.answered < s.asked ? "*" : "")) +
                                          number_cell(s.transmittance_rmse, fmt::format("{:.4f}", s.transmittance_rmse));
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

// A number of the heat table on its colour: white at 1 %, full at 100 %.
std::string heat_cell(const Score& score, const std::string& title) {
    const double share = std::clamp(0.5 * std::log10(std::max(1e-4, score.relative_rmse) / 0.01), 0.0, 1.0);
    const std::string part = score.answered < score.asked ? "*" : "";
    return fmt::format("<td data-v=\"{:.6g}\" style=\"--heat:{:.0f}%\" class=\"heat\" title=\"{}\">{}{}</td>", score.relative_rmse,
                       100.0 * share, html_text(title), percent_text(score.relative_rmse), part);
}

std::string heat_table(const AirRun& air, std::size_t index) {
    std::string html = "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>model</th>";
    for (const SkyTruth& truth : air.truths) html += fmt::format("<th>{}</th>", html_text(truth.name));
    html += "</tr></thead><tbody>\n";
    for (const std::size_t m : nearest_first(air)) {
        const ModelRun& model = air.models[m];
        html += fmt::format("<tr><th scope=\"row\" data-v=\"{0}\"><a href=\"#{1}\">{0}</a></th>", model.card.key, anchor_of(index, model));
        for (std::size_t i = 0; i < air.truths.size(); ++i) {
            if (i >= model.cells.size() || !model.cells[i].verdict.sky) {
                const std::string why = i < model.cells.size() ? model.cells[i].verdict.refusal : first_line(model.refusal);
                html += fmt::format("<td data-v=\"1e300\" title=\"{}\">–</td>", html_text(why));
                continue;
            }
            const Score& score = *model.cells[i].verdict.sky;
            html += heat_cell(score, fmt::format("truth ±{} %, bias {:+.1f} %, {} of {} directions", percent_text(score.noise),
                                                 100.0 * score.bias, score.answered, score.asked));
        }
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string figure(const Drawn& drawn, std::string_view kind, std::string_view caption) {
    const std::string body = drawn.uri.empty()
                                 ? fmt::format("<div class=\"none\">{}</div>", html_text(drawn.refusal))
                                 : fmt::format("<img class=\"{}\" alt=\"{}\" src=\"{}\">", kind, html_text(caption), drawn.uri);
    return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>", body, html_text(caption));
}

std::string picture_row(std::string_view name, const std::vector<Drawn>& pictures) {
    if (pictures.empty()) return "";
    std::string html = fmt::format("<h4>{}</h4><div class=\"pictures\">", html_text(name));
    const auto views = picture_views();
    for (std::size_t i = 0; i < pictures.size(); ++i) html += figure(pictures[i], views[i].towards_sun ? "view" : "sky", views[i].title);
    return html + "</div>\n";
}

std::string pictures(const AirRun& air) {
    if (air.pictures.empty()) return "";
    std::string html = fmt::format(
        "<details open><summary>Pictures, {}</summary><p class=\"note\">45° north at equinox. Every column has one exposure, metered on "
        "the tables' "
        "picture: what is brighter here is brighter there.</p>\n",
        html_text(condition_text({air.picture_altitude, 45.0}).substr(0, condition_text({air.picture_altitude, 45.0}).find(','))));
    html += picture_row("truth (tables)", air.pictures);
    for (const ModelRun& model : air.models) html += picture_row(model.card.key, model.pictures);
    return html + "</details>\n";
}

void add_numbers(std::string& html, std::string_view side, const std::optional<Score>& score) {
    if (!score) return;
    // A measured truth does not say its error.
    const std::string noise = score->noise > 0.0 ? fmt::format(" (truth ±{} %)", percent_text(score->noise)) : "";
    html += fmt::format("<dt>{}</dt><dd><b>{} %</b>{}, bias {:+.1f} %, {} of {} directions<br>", side, percent_text(score->relative_rmse),
                        noise, 100.0 * score->bias, score->answered, score->asked);
    html += fmt::format("{:.3g} mW m⁻² sr⁻¹ nm⁻¹; luminance {} %; u′v′ {:.4f}; ΔE₀₀ {:.2f}</dd>", 1000.0 * score->spectral_rmse,
                        percent_text(score->luminance_rmse), score->chromaticity_rmse, score->colour_difference);
}

std::string lux(const Illuminance& light) {
    return fmt::format("{:.4g} lx ({:.4g} direct)", light.direct_lx + light.diffuse_lx, light.direct_lx);
}

std::string cell_map(const AirRun& air, const SkyTruth& truth, const Cell& cell, bool measured) {
    if (measured) {
        std::vector<SkyDot> dots;
        for (std::size_t i = 0; i < truth.directions.size(); ++i)
            dots.push_back(
                {truth.directions[i].direction.view_zenith, truth.directions[i].direction.relative_azimuth, cell.verdict.excess[i]});
        return "<figure>" + dots_svg(dots, 128) + "<figcaption>error, luminance</figcaption></figure>";
    }
    if (cell.map.uri.empty() && cell.map.refusal.empty()) return "";
    const bool space = truth.condition.altitude > air.air.atmosphere.top_altitude;
    return figure(cell.map, space ? "limb" : "map", space ? "error, limb" : "error, luminance");
}

std::string cell_card(const AirRun& air, const ModelRun& model, std::size_t i, bool measured) {
    const SkyTruth& truth = air.truths[i];
    const Cell& cell = model.cells[i];
    std::string html = fmt::format("<article><h4>{}</h4>", html_text(truth.name));
    const bool answers = cell.verdict.sky || cell.verdict.ground;
    if (!cell.verdict.refusal.empty()) html += fmt::format("<p class=\"refusal\">{}</p>", html_text(cell.verdict.refusal));
    if (!answers) return html + "</article>\n";
    html += "<div class=\"cell\">" + cell_map(air, truth, cell, measured);
    if (!cell.profile.empty()) html += profile_svg({air.profile_grids[i].axis, air.profile_grids[i].at, air.profiles[i], cell.profile});
    html += "</div><dl>";
    add_numbers(html, "above the horizon", cell.verdict.sky);
    add_numbers(html, "below the horizon", cell.verdict.ground);
    if (air.illuminances[i]) {
        html += fmt::format("<dt>horizontal illuminance</dt><dd>{}; truth {}</dd>",
                            cell.verdict.horizontal ? lux(*cell.verdict.horizontal) : html_text(cell.verdict.horizontal_refusal),
                            lux(*air.illuminances[i]));
    }
    return html + "</dl></article>\n";
}

std::string model_details(const AirRun& air, std::size_t index, const ModelRun& model, bool measured) {
    const ModelCard& c = model.card;
    std::string html = fmt::format("<details id=\"{}\"><summary>{}</summary>", anchor_of(index, model), c.key);
    html +=
        fmt::format("<p class=\"note\">{}. Scattering: {}. Ahead: {}. Memory: {}.{}</p>\n", html_text(c.approach), html_text(c.scattering),
                    html_text(c.precomputation), html_text(c.memory), c.paper.empty() ? "" : fmt::format(" [{}]", html_text(c.paper)));
    if (!model.refusal.empty()) html += fmt::format("<p class=\"refusal\">{}</p>", html_text(model.refusal));
    html += "<div class=\"cells\">";
    for (std::size_t i = 0; i < model.cells.size(); ++i) html += cell_card(air, model, i, measured);
    return html + "</div></details>\n";
}

std::string method(const Comparison& comparison) {
    std::string html = fmt::format("<p>The truth is {}.", truth_text(comparison));
    if (comparison.against == Against::reference) html += fmt::format(" It has {}.", paths_text(comparison.paths));
    html +=
        " Percentages are root-mean-square relative errors over directions above the horizon and wavelengths, less the truth’s own "
        "variance; directions "
        "within 1° of the sun are left out, and so is what is darker than 10⁻⁸ of the solar irradiance. By day: sun up to 85° from the "
        "zenith. "
        "Means over conditions are quadratic, over those that the model answers: * marks where it answers some directions only, – where "
        "none; "
        "the reason stands in the model’s part below. ΔE₀₀ is CIEDE2000, white being D65 as bright as the brightest direction. "
        "Times are of processor cores, a direction’s on one. Maps: blue is too dark, red too bright, full colour at 50 %, grey no answer; "
        "profiles: thick the "
        "truth, thin the model.";
    html += comparison.against == Against::measured ? " Profiles take the tables for the truth."
                                                    : " Maps and profiles take the tables for the truth.";
    return html + "</p>\n<p class=\"scale\"></p>\n";
}

}  // namespace

std::string report_html(const Comparison& comparison) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\">"
        "<meta name=\"color-scheme\" content=\"light dark\"><title>Models of the sky, judged</title>\n";
    html +=
        fmt::format("<style>{}</style></head><body>\n<h1>Models of the sky, judged</h1>\n{}", page_file("report.css"), method(comparison));
    for (std::size_t i = 0; i < comparison.airs.size(); ++i) {
        const AirRun& air = comparison.airs[i];
        html += fmt::format("<section><h2>{}</h2>\n<h3>In short</h3>\n{}<h3>By condition, %</h3>\n{}", html_text(air.air.name),
                            summary_table(air, i, comparison.kept_tables), heat_table(air, i));
        html += aerial_table(air, i) + pictures(air) + "<h3>Model by model</h3>\n";
        for (const ModelRun& model : air.models) html += model_details(air, i, model, comparison.against == Against::measured);
        html += "</section>\n";
    }
    return html + fmt::format("<script>{}</script>\n</body></html>\n", page_file("report.js"));
}

}  // namespace airlight
