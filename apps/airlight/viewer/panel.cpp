#include "panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <sstream>

#include "atmosphere/presets.h"
#include "viewer/flight.h"

namespace airlight::cli {

namespace {

using viewer::Session;

constexpr float panel_width = 360.0f, graph_width = panel_width - 24.0f;
constexpr std::size_t kept_frames = 120;
const ImVec4 wrong{1.0f, 0.55f, 0.45f, 1.0f}, faint{0.65f, 0.65f, 0.65f, 1.0f};

constexpr std::array<std::array<const char*, 2>, 13> help_lines = {{{"W A S D", "fly along the view, and to its sides"},
                                                                    {"E Q", "rise, sink"},
                                                                    {"Shift", "four times as fast"},
                                                                    {"drag", "look around"},
                                                                    {"wheel", "fly faster or slower; the height does so, too"},
                                                                    {"click", "probe the light there: its spectrum, the sky's radiance"},
                                                                    {"K", "a key of the camera's path, here"},
                                                                    {"Ctrl-Z Ctrl-Y", "take a key back, put it back"},
                                                                    {"P", "fly the path"},
                                                                    {"F2 F3", "save the picture as PNG, its light as EXR"},
                                                                    {"Tab", "hide the panel"},
                                                                    {"F1", "this help"},
                                                                    {"Ctrl-Q", "leave"}}};

void text(const std::string& words) { ImGui::TextUnformatted(words.c_str()); }
void text(const ImVec4& colour, const std::string& words) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushTextWrapPos();
    text(words);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

// A slider over a double, which ImGui knows by its address.
bool slide(const char* label, double& value, double low, double high, const char* format, ImGuiSliderFlags flags = 0) {
    return ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &low, &high, format, flags);
}

bool slide_angle(const char* label, double& radians, double low_deg, double high_deg) {
    double degrees = radians / deg;
    if (!slide(label, degrees, low_deg, high_deg, "%.1f deg")) return false;
    radians = degrees * deg;
    return true;
}

std::string length_text(double metres) {
    if (std::abs(metres) < 1e3) return fmt::format("{:.1f} m", metres);
    return std::abs(metres) < 1e5 ? fmt::format("{:.2f} km", 1e-3 * metres) : fmt::format("{:.0f} km", 1e-3 * metres);
}

void draw_facts(const PanelFacts& facts, const Session& session, const HeightField& ground) {
    const Viewpoint& eye = session.eye;
    const double height = viewer::height_m(eye, ground);
    text(fmt::format("{:.4f} {}, {:.4f} {}", std::abs(eye.latitude / deg), eye.latitude < 0.0 ? "S" : "N",
                     std::abs(std::remainder(eye.longitude, 2.0 * pi) / deg), std::remainder(eye.longitude, 2.0 * pi) < 0.0 ? "W" : "E"));
    text(fmt::format("{} above the ground, {} above 0 m", length_text(height), length_text(eye.altitude_m)));
    text(fmt::format("flies {}/s", length_text(viewer::speed_m_s(height, session.flown_per_s))));
    for (const std::string& failure : facts.failures) text(wrong, failure);
    if (facts.at_work) text(faint, *facts.at_work);
    if (!facts.done.empty()) text(faint, facts.done);
}

void draw_places(Session& session, const HeightField& ground) {
    if (ImGui::BeginCombo("go to", "...")) {
        for (const viewer::Preset& preset : viewer::presets())
            if (ImGui::Selectable(std::string(preset.name).c_str())) viewer::go_to(session, preset, ground);
        ImGui::EndCombo();
    }
    Viewpoint eye = session.eye;
    bool moved = slide_angle("latitude", eye.latitude, -90.0, 90.0);
    eye.longitude = std::remainder(eye.longitude, 2.0 * pi);
    moved |= slide_angle("longitude", eye.longitude, -180.0, 180.0);
    double height = viewer::height_m(eye, ground);
    if (slide("height, m", height, viewer::lowest_eye_m, 1e8, "%.1f", ImGuiSliderFlags_Logarithmic))
        eye.altitude_m = surface_m(eye, ground) + height, moved = true;
    if (moved) session.eye = viewer::above_ground(eye, ground);
    slide_angle("field of view", session.field_of_view, 5.0, 120.0);
}

void draw_sun(Session& session) {
    viewer::SunAngles sun = viewer::sun_angles(session);
    sun.azimuth = sun.azimuth < 0.0 ? sun.azimuth + 2.0 * pi : sun.azimuth;
    bool placed = slide_angle("sun zenith", sun.zenith, 0.0, 180.0);
    placed |= slide_angle("sun azimuth", sun.azimuth, 0.0, 360.0);
    if (placed) viewer::place_sun(session, sun);
    text(faint, session.time ? "by time" : "by its angles; or by time:");
    const Utc time = session.time.value_or(Utc{.year = 2024, .month = 6, .day = 21, .hour = 12});
    std::array<int, 3> date = {time.year, time.month, time.day};
    double hour = time.hour + time.minute / 60.0 + time.second / 3600.0;
    bool timed = ImGui::InputInt3("date", date.data());
    timed |= slide("hour, UTC", hour, 0.0, 23.999, "%.2f");
    if (!timed) return;
    const double minutes = hour * 60.0;
    const Result<Utc> wished = utc_of({.year = date[0],
                                       .month = date[1],
                                       .day = date[2],
                                       .hour = static_cast<int>(hour),
                                       .minute = static_cast<int>(minutes) % 60,
                                       .second = 60.0 * (minutes - std::floor(minutes))});
    if (wished) viewer::set_time(session, *wished);  // else a day that is not, while it is typed
}

// One of a list of words, as the function that reads them names it.
template <class Name>
void choose(const char* label, std::string_view words, std::optional<Name> (*named)(std::string_view), Name& chosen) {
    std::istringstream list{std::string(words)};
    std::vector<std::string> names;
    std::string own;
    for (std::string word; list >> word; names.push_back(word))
        if (named(word) == chosen) own = word;
    if (!ImGui::BeginCombo(label, own.c_str())) return;
    for (const std::string& name : names)
        if (ImGui::Selectable(name.c_str(), name == own)) chosen = *named(name);
    ImGui::EndCombo();
}

void draw_methods(Session& session) {
    using Shown = viewer::Comparison::Shown;
    viewer::Comparison& comparison = session.comparison;
    choose("method", air_method_names, air_method_named, session.air.method);
    choose("shafts", shafts_names, shafts_named, session.air.shafts);
    int shown = static_cast<int>(comparison.shown);
    if (ImGui::Combo("compare", &shown, "no\0side by side\0difference\0")) comparison.shown = static_cast<Shown>(shown);
    if (comparison.shown == Shown::one) return;
    choose("with", air_method_names, air_method_named, comparison.with);
    if (comparison.shown == Shown::side_by_side) {
        slide("edge", comparison.edge, 0.0, 1.0, "%.2f");
        return text(faint, "left of it the method, right of it the other");
    }
    double percent = 100.0 * comparison.span;
    if (slide("full colour", percent, 0.1, 100.0, "%.1f %%", ImGuiSliderFlags_Logarithmic)) comparison.span = 0.01 * percent;
    text(faint, "red where the second is brighter, blue where it is darker");
}

// While no one types, it shows what there is.
void type(TypedLine& line, const char* label, const char* hint, std::string& value) {
    if (!line.active) line.text[value.copy(line.text.data(), line.text.size() - 1)] = '\0';
    ImGui::InputTextWithHint(label, hint, line.text.data(), line.text.size());
    if (ImGui::IsItemDeactivatedAfterEdit()) value = line.text.data();
    line.active = ImGui::IsItemActive();
}

void draw_air(PanelState& state, Session& session) {
    if (ImGui::BeginCombo("air", session.atmosphere.c_str())) {
        if (ImGui::Selectable("none", session.atmosphere == "none")) session.atmosphere = "none";
        for (const std::string_view name : preset_names())
            if (ImGui::Selectable(std::string(name).c_str(), session.atmosphere == name)) session.atmosphere = name;
        ImGui::EndCombo();
    }
    std::string air = session.atmosphere;
    type(state.air, "or its file", "air.toml", air);
    if (!air.empty()) session.atmosphere = air;
    type(state.weather, "weather", "a METAR report, or its file", session.weather);
    draw_methods(session);
}

void draw_look(viewer::Look& look, double ev100) {
    if (ImGui::BeginCombo("tone", std::string(name_of(look.tone)).c_str())) {
        for (const ToneCurve curve : {ToneCurve::linear, ToneCurve::exponential, ToneCurve::reinhard, ToneCurve::filmic})
            if (ImGui::Selectable(std::string(name_of(curve)).c_str(), look.tone == curve)) look.tone = curve;
        ImGui::EndCombo();
    }
    if (ImGui::Checkbox("metered", &look.metered) && !look.metered) look.ev100 = ev100 + look.stops;
    ImGui::SameLine();
    text(faint, fmt::format("now EV {:.1f} at ISO 100", ev100));
    if (!look.metered) slide("EV", look.ev100, -8.0, 20.0, "%.1f");
    slide("brighter, stops", look.stops, -4.0, 4.0, "%.1f");
    slide("bloom", look.bloom, 0.0, 0.2, "%.3f");
}

void draw_path(PanelState& state, const PanelFacts& facts, Input& input) {
    text(fmt::format("{} keys, {:.1f} s", facts.path_keys, facts.path_s));
    if (facts.played_s) text(faint, fmt::format("at {:.1f} s", *facts.played_s));
    slide("to the next, s", state.seconds_to_key, 0.5, 60.0, "%.1f", ImGuiSliderFlags_Logarithmic);
    if (facts.path_keys == 0) ImGui::Checkbox("keys have the sun's time", &state.keys_have_time);
    input.add_key |= ImGui::Button("add key");
    ImGui::SameLine();
    input.undo |= ImGui::Button("undo");
    ImGui::SameLine();
    input.redo |= ImGui::Button("redo");
    ImGui::SameLine();
    input.play |= ImGui::Button(facts.played_s ? "stop" : "play");
    text(faint, facts.path_file);
}

// A place of a graph's lower edge, as a share of its width, and what stands below it.
struct Tick {
    float at;
    std::string label;
};

// Values from 0 to the highest, at even steps.
void draw_graph(const std::vector<float>& values, const std::vector<Tick>& ticks) {
    const float height = 80.0f, label_height = ImGui::GetTextLineHeight();
    const ImVec2 from = ImGui::GetCursorScreenPos(), to{from.x + graph_width, from.y + height};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg));
    for (const Tick& tick : ticks) {
        const float x = from.x + tick.at * graph_width, wide = ImGui::CalcTextSize(tick.label.c_str()).x;
        draw.AddLine({x, from.y}, {x, to.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.4f));
        draw.AddText({std::clamp(x - 0.5f * wide, from.x, to.x - wide), to.y}, ImGui::GetColorU32(faint), tick.label.c_str());
    }
    const float highest = std::max(*std::max_element(values.begin(), values.end()), FLT_MIN);
    std::vector<ImVec2> line;
    for (std::size_t i = 0; i < values.size(); ++i)
        line.emplace_back(from.x + graph_width * static_cast<float>(i) / static_cast<float>(values.size() - 1),
                          to.y - (height - 2.0f) * values[i] / highest);
    draw.AddPolyline(line.data(), static_cast<int>(line.size()), ImGui::GetColorU32(ImGuiCol_PlotLines), 0, 1.5f);
    ImGui::Dummy({graph_width, height + label_height});
}

double highest(const std::vector<float>& values) { return static_cast<double>(*std::max_element(values.begin(), values.end())); }

void draw_probe_graphs(const viewer::Probe& probe) {
    text(fmt::format("its spectrum, up to {:.3g} W m-2 sr-1 nm-1", highest(probe.spectrum)));
    std::vector<Tick> wavelengths;
    for (const double nm_there : {400.0, 500.0, 600.0, 700.0, 800.0})
        wavelengths.push_back(
            {static_cast<float>((nm_there - probe.first_nm) / (viewer::spectrum_step_nm * static_cast<double>(probe.spectrum.size() - 1))),
             fmt::format("{:.0f} nm", nm_there)});
    draw_graph(probe.spectrum, wavelengths);
    text(fmt::format("the sky in the sun's plane, up to {:.3g} cd m-2", highest(probe.sun_plane)));
    draw_graph(probe.sun_plane, {{0.0f, "sunward"}, {0.25f, "45 deg"}, {0.5f, "zenith"}, {0.75f, "45 deg"}, {1.0f, "away"}});
}

// A window of its own beside the picture's lower right corner, once something was probed.
void draw_probe(bool& open, const PanelFacts& facts) {
    if (!open || !facts.probed_picture) return;
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({all.x - 10.0f, all.y - 10.0f}, ImGuiCond_Always, {1.0f, 1.0f});
    if (ImGui::Begin("Probe", &open, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse)) {
        text(fmt::format("{:>10.4g} cd m-2 in the picture", *facts.probed_picture));
        if (!facts.probe) text(faint, "the sky there is being computed");
        else if (!*facts.probe) text(wrong, facts.probe->error().message());
        else {
            text(fmt::format("{:>10.4g} cd m-2 of sky there, on the CPU", (*facts.probe)->luminance));
            draw_probe_graphs(**facts.probe);
        }
    }
    ImGui::End();
}

void draw_times(PanelState& state, const PanelFacts& facts) {
    double all = 0.0;
    for (const gpu::PassTime& time : facts.times) {
        text(fmt::format("{:>9.2f} ms  {}", time.milliseconds, time.pass));
        all += time.milliseconds;
    }
    text(fmt::format("{:>9.2f} ms  in all, {} patches", all, facts.patches));
    state.frames_ms.push_back(static_cast<float>(all));
    if (state.frames_ms.size() > kept_frames) state.frames_ms.pop_front();
    const std::vector<float> kept(state.frames_ms.begin(), state.frames_ms.end());
    if (kept.size() > 1) draw_graph(kept, {{0.0f, fmt::format("the last {} frames, up to {:.1f} ms", kept.size(), highest(kept))}});
    text(faint, facts.device);
}

void draw_help(bool& open) {
    ImGui::SetNextWindowPos(ImVec2(0.5f * ImGui::GetIO().DisplaySize.x, 0.5f * ImGui::GetIO().DisplaySize.y), ImGuiCond_Appearing,
                            ImVec2(0.5f, 0.5f));
    if (ImGui::Begin("Help", &open, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse))
        if (ImGui::BeginTable("keys", 2)) {
            for (const auto& [key, what] : help_lines) {
                ImGui::TableNextColumn();
                text(key);
                ImGui::TableNextColumn();
                text(what);
            }
            ImGui::EndTable();
        }
    ImGui::End();
}

void draw_leave(PanelState& state) {
    if (state.asks_to_leave) ImGui::OpenPopup("Leave?");
    state.asks_to_leave = false;
    if (!ImGui::BeginPopupModal("Leave?", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
    text("The last keys of the camera's path are on no disk.");
    if (ImGui::Button("stay")) ImGui::CloseCurrentPopup();
    ImGui::SameLine();
    state.leaves = ImGui::Button("leave, and lose them");
    ImGui::EndPopup();
}

bool section(const char* name, bool open = true) { return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0); }

}  // namespace

void draw_panel(PanelState& state, const PanelFacts& facts, Session& session, const HeightField& ground, Input& input) {
    state.help ^= input.help, state.hidden ^= input.hide_panel;
    if (state.help) draw_help(state.help);
    draw_leave(state);
    if (state.hidden) return;
    state.probe |= input.clicked.has_value();
    draw_probe(state.probe, facts);
    ImGui::SetNextWindowPos(ImVec2(10.0f, 10.0f), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints(ImVec2(panel_width, 0.0f), ImVec2(panel_width, ImGui::GetIO().DisplaySize.y - 20.0f));
    ImGui::Begin("Airlight (F1: help)", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PushItemWidth(0.6f * panel_width);
    draw_facts(facts, session, ground);
    if (section("Place")) draw_places(session, ground);
    if (section("Sun")) draw_sun(session);
    if (section("Air")) draw_air(state, session);
    if (section("Picture")) {
        draw_look(session.look, facts.ev100);
        input.png |= ImGui::Button("save PNG");
        ImGui::SameLine();
        input.exr |= ImGui::Button("save EXR");
    }
    if (section("Path", false)) draw_path(state, facts, input);
    if (section("Frame times", false)) draw_times(state, facts);
    ImGui::PopItemWidth();
    ImGui::End();
}

}  // namespace airlight::cli
