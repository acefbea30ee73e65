// `airlight render`: a picture of a planet from anywhere, without a window.

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "command.h"
#include "core/files.h"
#include "frame_of_scene.h"
#include "image/exposure.h"
#include "image/exr.h"
#include "image/png.h"
#include "image/tone.h"
#include "interrupt.h"
#include "spectrum/colour.h"
#include "table_wishes.h"
#include "units/text.h"

namespace airlight::cli {

namespace {

struct RenderOptions {
    std::string scene;
    std::vector<std::string> outputs;
    int width = 1280;
    int height = 720;
    std::string air;
    std::string shafts;
    std::string exposure = "auto";
    std::string tone = "filmic";
    TableOptions tables;
    bool quiet = false;
};

// Everything that can be wrong, found out before anything long begins.
struct Wishes {
    Scene scene;
    ToneCurve tone;
    std::optional<double> exposure;  // none: metered
    TableWishes tables;
};

Result<Done> check_output(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    if (extension != ".exr" && extension != ".png")
        return Error{path, "is neither a .exr nor a .png file", "End the name in .exr (light) or .png (a picture for the screen)."};
    return can_write(path);
}

Result<Wishes> wishes_of(const RenderOptions& given) {
    Result<Scene> scene = read_scene(given.scene);
    if (!scene) return scene.error();
    if (!given.air.empty()) {
        const std::optional<AirMethodName> method = air_method_named(given.air);
        if (!method) return Error{"--air", fmt::format("\"{}\" is none of: {}", given.air, air_method_names), ""};
        scene->air.method = *method;
    }
    if (!given.shafts.empty()) {
        const std::optional<ShaftsName> shafts = shafts_named(given.shafts);
        if (!shafts) return Error{"--shafts", fmt::format("\"{}\" is none of: {}", given.shafts, shafts_names), ""};
        scene->air.shafts = *shafts;
    }
    if (given.width < 1 || given.height < 1 || given.width > 16384 || given.height > 16384)
        return Error{"--width, --height", fmt::format("{} x {} is out of range: each must be from 1 to 16384", given.width, given.height),
                     ""};
    const std::optional<ToneCurve> tone = tone_curve_named(given.tone);
    if (!tone) return Error{"--tone", fmt::format("\"{}\" is none of: {}", given.tone, tone_curve_names), ""};
    for (const std::string& path : given.outputs)
        if (const Result<Done> possible = check_output(path); !possible) return possible.error();
    const Result<TableWishes> tables = table_wishes_of(given.tables);
    if (!tables) return tables.error();
    Wishes wishes{*scene, *tone, std::nullopt, *tables};
    if (given.exposure == "auto") return wishes;
    const Result<double> ev = parse_number(given.exposure);
    if (!ev)
        return Error{"--exposure", fmt::format("\"{}\" is neither auto nor an exposure value at ISO 100", given.exposure),
                     "Write auto, or a number such as 14."};
    wishes.exposure = exposure_of_ev100(*ev);
    return wishes;
}

double exposure_of(const Image& image, const Wishes& wishes) {
    if (wishes.exposure) return *wishes.exposure;
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    std::vector<float> luminance;
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const std::span<const float> rgb = image.pixel(column, row);
            luminance.push_back(static_cast<float>(std::max(0.0, converter.luminance({rgb[0], rgb[1], rgb[2]}))));
        }
    // A picture of the dark has nothing to meter: any exposure shows it black.
    const Result<double> found = metered_exposure(luminance, {}, {.grey = 0.25});
    return found ? *found : 1.0;
}

Result<Done> write(const std::string& path, const Image& image, const RenderOptions& given, const Wishes& wishes) {
    if (std::filesystem::path(path).extension() == ".png")
        return write_png(path, developed(image, exposure_of(image, wishes), wishes.tone));
    ImageMeaning meaning = ImageMeaning::rgb(RgbSpace::srgb);
    meaning.notes = {{"airlight:scene", given.scene}};
    return write_exr(path, image, meaning, ExrPixels::float16);
}

Result<Done> run(const RenderOptions& given) {
    const Interrupt interrupt;
    Result<Wishes> wishes = wishes_of(given);
    if (!wishes) return wishes.error();
    ProgressLine line(given.quiet);
    wishes->tables.progress = line.progress(interrupt.token());
    const Result<DrawnFrame> drawn = draw_scene(wishes->scene, given.width, given.height, wishes->tables);
    if (!drawn) return drawn.error();
    for (const std::string& path : given.outputs)
        if (const Result<Done> written = write(path, drawn->image, given, *wishes); !written) return written.error();
    fmt::print("quantity,value,unit\n");
    for (const auto& [quantity, value, unit] : drawn->figures) fmt::print("{},{},{}\n", quantity, value, unit);
    for (const std::string& path : given.outputs) fmt::print("file,{},\n", path);
    return Done{};
}

}  // namespace

Command render_command(CLI::App& airlight) {
    const auto given = std::make_shared<RenderOptions>();
    CLI::App* render = airlight.add_subcommand("render", "Draw a planet from anywhere, its ground and its air, without a window.");
    render->add_option("scene", given->scene, "a scene file: docs/scene-file.md")->required()->option_text("<scene.toml>");
    render->add_option("-o,--output", given->outputs, "a .exr (light in cd m-2) or .png file; may be given several times")
        ->option_text("<file>")
        ->required();
    render->add_option("--width", given->width, "of the picture, in pixels")->option_text("<n>")->capture_default_str();
    render->add_option("--height", given->height, "of the picture, in pixels")->option_text("<n>")->capture_default_str();
    render
        ->add_option("--air", given->air,
                     "how the light of the air is computed: airlight, hillaire2020, bruneton2008 or exact (default: what the scene says)")
        ->option_text("<method>");
    render
        ->add_option("--shafts", given->shafts,
                     "how shadows in the air are found: epipolar, marched, planes, volumes, brute or none (default: what the scene says)")
        ->option_text("<method>");
    render->add_option("--exposure", given->exposure, "of PNG files: auto, or an exposure value at ISO 100 (15: a sunny day)")
        ->option_text("<auto|EV>")
        ->capture_default_str();
    render->add_option("--tone", given->tone, "of PNG files: linear, exponential, reinhard or filmic")
        ->option_text("<curve>")
        ->capture_default_str();
    add_table_options(*render, given->tables);
    render->add_flag("--quiet", given->quiet, "no progress on standard error");
    render->footer(help_footer(
        "CSV: quantity, value, unit: who draws, how long each pass takes, how many patches the ground has; last, the files.",
        "airlight render data/demo/mountains.toml --width 160 --height 90 --sizes 16x8x16x8 --orders 3 --cache tables -o mountains.png"));
    return {render, [given] { return run(*given); }};
}

}  // namespace airlight::cli
