// `airlight view`: a planet and its air in a window.

#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "core/files.h"
#include "table_wishes.h"
#include "viewer/viewer.h"

namespace airlight::cli {

namespace {

// Where no scene is named: mountains of noise, in the afternoon.
constexpr std::string_view built_in_scene = R"(
[camera]
latitude = "36.2 deg"
longitude = "31.5 deg"
altitude = "4.5 km"
heading = "55 deg"
pitch = "-7 deg"
[sun]
zenith = "62 deg"
azimuth = "300 deg"
)";

struct ViewOptions {
    std::string scene;
    int width = 1280;
    int height = 720;
    std::string folder = ".";
    std::string path = "airlight-path.toml";
    TableOptions tables;
    int frames = 0;
    std::string screenshot;
    bool quiet = false;
};

Result<ViewerWishes> wishes_of(const ViewOptions& given) {
    const Result<Scene> scene = given.scene.empty() ? parse_scene(built_in_scene, "the built-in scene") : read_scene(given.scene);
    if (!scene) return scene.error();
    if (given.width < 64 || given.height < 64 || given.width > 8192 || given.height > 8192)
        return Error{"--width, --height", fmt::format("{} x {} is out of range: each must be from 64 to 8192", given.width, given.height),
                     ""};
    if (given.frames < 0) return Error{"--frames", fmt::format("{} is out of range: it must be 0 or more", given.frames), ""};
    Result<TableWishes> tables = table_wishes_of(given.tables);
    if (!tables) return tables.error();
    ViewerWishes wishes{.scene = *scene,
                        .built_in = given.scene.empty(),
                        .width = given.width,
                        .height = given.height,
                        .folder = given.folder,
                        .path = given.path,
                        .tables = *std::move(tables),
                        .frames = given.frames};
    if (given.screenshot.empty()) return wishes;
    if (const Result<Done> possible = can_write(given.screenshot); !possible) return possible.error();
    wishes.screenshot = given.screenshot;
    return wishes;
}

Result<Done> run(const ViewOptions& given) {
    Result<ViewerWishes> wishes = wishes_of(given);
    if (!wishes) return wishes.error();
    ProgressLine line(given.quiet);
    wishes->tables.progress = line.progress();
    const Result<Figures> figures = run_viewer(*wishes);
    if (!figures) return figures.error();
    if (given.frames == 0) return Done{};
    fmt::print("quantity,value,unit\n");
    for (const auto& [quantity, value, unit] : *figures) fmt::print("{},{},{}\n", quantity, value, unit);
    if (wishes->screenshot) fmt::print("file,{},\n", given.screenshot);
    return Done{};
}

}  // namespace

Command view_command(CLI::App& airlight) {
    const auto given = std::make_shared<ViewOptions>();
    CLI::App* view = airlight.add_subcommand("view", "Fly over a planet, from its orbits to its grass, in a window.");
    view->add_option("scene", given->scene, "a scene file, read again when it is written: docs/scene-file.md")->option_text("<scene.toml>");
    view->add_option("--width", given->width, "of the picture, in pixels")->option_text("<n>")->capture_default_str();
    view->add_option("--height", given->height, "of the picture, in pixels")->option_text("<n>")->capture_default_str();
    view->add_option("--folder", given->folder, "where F2 and F3 put pictures")->option_text("<folder>")->capture_default_str();
    view->add_option("--path", given->path, "the camera's path, kept here as it is made: docs/camera-path.md")
        ->option_text("<path.toml>")
        ->capture_default_str();
    add_table_options(*view, given->tables);
    view->add_option("--frames", given->frames, "leave after so many frames, a thirtieth of a second each; 0: when the window is closed")
        ->option_text("<n>")
        ->capture_default_str();
    view->add_option("--screenshot", given->screenshot, "a PNG file of the window as it is left")->option_text("<file>");
    view->add_flag("--quiet", given->quiet, "no progress on standard error");
    view->footer(help_footer(
        "a window; F1 in it tells the keys. With --frames, CSV: quantity, value, unit: who draws, and how long each pass takes.\n"
        "        With AIRLIGHT_SHADERS=<source tree>, shaders are read from there, and again when they are written.",
        "airlight view --frames 2 --width 160 --height 90 --sizes 16x4x8x12,32x16 --orders 2 --cache tables"));
    return {view, [given] { return run(*given); }};
}

}  // namespace airlight::cli
