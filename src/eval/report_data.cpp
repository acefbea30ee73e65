// The CSV and the JSON of a comparison.
#include <fmt/format.h>

#include <cmath>

#include "core/files.h"
#include "eval/report.h"

namespace airlight {

namespace {

std::string quoted_csv(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' ? ' ' : c);
    return quoted + '"';
}

std::string quoted_json(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text)
        if (c == '"' || c == '\\') quoted += {'\\', c};
        else if (static_cast<unsigned char>(c) < 0x20) quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else quoted += c;
    return quoted + '"';
}

// A row of the CSV from where the score begins.
std::string score_cells(const std::optional<Score>& score) {
    if (!score) return ",,,,,,,,,";
    return fmt::format("{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.5g},{:.4g},{:.4g},{:.4g}", score->asked, score->answered,
                       100.0 * score->relative_rmse, 100.0 * score->plain_rmse, 100.0 * score->noise, 100.0 * score->bias,
                       score->spectral_rmse, 100.0 * score->luminance_rmse, score->chromaticity_rmse, score->colour_difference);
}

std::string global_lx(const std::optional<Illuminance>& light) {
    return light ? fmt::format("{:.6g}", light->direct_lx + light->diffuse_lx) : "";
}

void add_csv(std::string& csv, const AirRun& air, const ModelRun& model) {
    const std::string cost =
        fmt::format("{:.4g},{},{}", model.making.core_seconds, model.making.bytes,
                    model.asking ? fmt::format("{:.4g},{:.4g}", model.asking->dome_seconds, model.asking->direction_seconds) : ",");
    for (std::size_t i = 0; i < air.truths.size(); ++i) {
        const Condition& condition = air.truths[i].condition;
        const Cell empty{};
        const Cell& cell = i < model.cells.size() ? model.cells[i] : empty;
        const std::string refusal = quoted_csv(model.refusal.empty() ? cell.verdict.refusal : model.refusal);
        for (const bool sky : {true, false}) {
            const std::optional<Score>& score = sky ? cell.verdict.sky : cell.verdict.ground;
            if (!sky && !score) continue;
            csv += fmt::format("{},{},{},{:g},{:g},{},{},{},{},{},{}\n", quoted_csv(air.air.name), model.card.key,
                               quoted_csv(air.truths[i].name), condition.altitude.in(m), condition.sun_zenith_deg, sky ? "sky" : "ground",
                               score_cells(score), global_lx(cell.verdict.horizontal), global_lx(air.illuminances[i]), cost, refusal);
        }
    }
}

std::string json_score(const std::optional<Score>& s) {
    if (!s) return "null";
    return fmt::format(
        R"({{"asked":{},"answered":{},"relative_rmse":{:.6g},"plain_rmse":{:.6g},"noise":{:.6g},"bias":{:.6g},"spectral_rmse_W_m-2_sr-1_nm-1":{:.6g},)"
        R"("luminance_rmse":{:.6g},"chromaticity_rmse_uv":{:.6g},"ciede2000":{:.6g}}})",
        s->asked, s->answered, s->relative_rmse, s->plain_rmse, s->noise, s->bias, s->spectral_rmse, s->luminance_rmse,
        s->chromaticity_rmse, s->colour_difference);
}

std::string json_light(const std::optional<Illuminance>& light) {
    if (!light) return "null";
    return fmt::format(R"({{"direct_lx":{:.6g},"diffuse_lx":{:.6g}}})", light->direct_lx, light->diffuse_lx);
}

// The parts with commas between them.
template <class Items, class Text>
std::string json_list(const Items& items, const Text& text) {
    std::string list = "[";
    for (const auto& item : items) list.append(list.size() > 1 ? "," : "").append(text(item));
    return list.append("]");
}

// One entry a distance; null where it was not judged.
std::string json_aerial(const std::optional<AerialVerdict>& verdict) {
    if (!verdict) return "null";
    std::size_t d = 0;
    return json_list(verdict->at, [&](const AerialScore& s) {
        return fmt::format(
            R"({{"distance_m":{:g},"asked":{},"answered":{},"relative_rmse":{:.6g},"noise":{:.6g},"transmittance_rmse":{:.6g}}})",
            aerial_distances_m[d++], s.asked, s.answered, s.light_rmse, s.noise, s.transmittance_rmse);
    });
}

std::string json_model(const ModelRun& model) {
    return fmt::format(
        R"({{"key":{},"refusal":{},"precomputation_core_s":{:.4g},"memory_bytes":{},"dome_s":{},"direction_s":{},"aerial_perspective":{},"cells":{}}})",
        quoted_json(model.card.key), quoted_json(model.refusal), model.making.core_seconds, model.making.bytes,
        model.asking ? fmt::format("{:.4g}", model.asking->dome_seconds) : "null",
        model.asking ? fmt::format("{:.4g}", model.asking->direction_seconds) : "null", json_aerial(model.aerial),
        json_list(model.cells, [](const Cell& cell) {
            return fmt::format(R"({{"sky":{},"ground":{},"refusal":{},"horizontal":{},"horizontal_refusal":{}}})",
                               json_score(cell.verdict.sky), json_score(cell.verdict.ground), quoted_json(cell.verdict.refusal),
                               json_light(cell.verdict.horizontal), quoted_json(cell.verdict.horizontal_refusal));
        }));
}

std::string json_air(const AirRun& air) {
    std::size_t i = 0;
    const std::string conditions = json_list(air.truths, [&](const SkyTruth& truth) {
        return fmt::format(R"({{"name":{},"eye_altitude_m":{:g},"sun_zenith_deg":{:g},"horizontal":{}}})", quoted_json(truth.name),
                           truth.condition.altitude.in(m), truth.condition.sun_zenith_deg, json_light(air.illuminances[i++]));
    });
    return fmt::format(R"({{"name":{},"conditions":{},"models":{}}})", quoted_json(air.air.name), conditions,
                       json_list(air.models, json_model));
}

}  // namespace

std::string report_csv(const Comparison& comparison) {
    std::string csv =
        "air,model,condition,eye_altitude_m,sun_zenith_deg,side,directions_asked,directions_answered,relative_rmse_percent,"
        "plain_rmse_percent,truth_noise_percent,bias_percent,spectral_rmse_W_m-2_sr-1_nm-1,luminance_rmse_percent,chromaticity_rmse_uv,"
        "ciede2000,horizontal_illuminance_lx,truth_horizontal_illuminance_lx,precomputation_core_s,memory_bytes,dome_s,direction_s,"
        "refusal\n";
    for (const AirRun& air : comparison.airs)
        for (const ModelRun& model : air.models) add_csv(csv, air, model);
    return csv;
}

std::string report_json(const Comparison& comparison) {
    return fmt::format("{{\"against\":{},\"paths_by_day\":{},\"wavelengths_nm\":{},\"airs\":{}}}\n", quoted_json(truth_text(comparison)),
                       comparison.paths, json_list(comparison.wavelengths, [](Wavelength w) { return fmt::format("{:g}", w.in(nm)); }),
                       json_list(comparison.airs, json_air));
}

std::string truth_text(const Comparison& comparison) {
    switch (comparison.against) {
        case Against::reference:
            return "the Monte Carlo reference";
        case Against::tables:
            return "the tables";
        case Against::measured:
            return "a measured sky";
    }
    return "";
}

std::string percent_text(double fraction) {
    const double percent = 100.0 * fraction;
    if (percent < 10.0) return fmt::format("{:.2f}", percent);
    return percent < 100.0 ? fmt::format("{:.1f}", percent) : fmt::format("{:.0f}", percent);
}

std::string bytes_text(std::size_t bytes) {
    const auto b = static_cast<double>(bytes);
    if (b < 1024.0) return fmt::format("{} B", bytes);
    return b < 1048576.0 ? fmt::format("{:.1f} KiB", b / 1024.0) : fmt::format("{:.1f} MiB", b / 1048576.0);
}

std::string time_text(double seconds) {
    if (seconds < 1e-6) return fmt::format("{:.0f} ns", 1e9 * seconds);
    if (seconds < 1e-3) return fmt::format("{:.3g} µs", 1e6 * seconds);
    return seconds < 1.0 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

Result<Done> write_report(const std::filesystem::path& folder, const Comparison& comparison) {
    const std::pair<const char*, std::string> files[] = {
        {"scores.csv", report_csv(comparison)}, {"scores.json", report_json(comparison)}, {"report.html", report_html(comparison)}};
    for (const auto& [name, text] : files)
        if (const Result<Done> written = write_file(folder / name, text); !written) return written.error();
    return Done{};
}

}  // namespace airlight
