// `airlight render`: a picture of a planet from anywhere, without a window.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <system_error>
#include <vector>

#include "command.h"
#include "core/files.h"
#include "frame_of_scene.h"
#include "image/adaptation.h"
#include "image/exposure.h"
#include "image/exr.h"
#include "image/png.h"
#include "image/tone.h"
#include "interrupt.h"
#include "scene/camera_path.h"
#include "scene/path_frames.h"
#include "spectrum/colour.h"
#include "table_wishes.h"
#include "units/text.h"
#include "video.h"

namespace airlight::cli {

namespace {

// Of a path: their names have five digits.
constexpr int most_pictures = 100'000;

constexpr int most_samples = 64;

struct RenderOptions {
    std::string scene;
    std::vector<std::string> outputs;
    std::string path;
    double rate = 25.0;
    int width = 1280;
    int height = 720;
    int samples = 1;
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
    std::optional<CameraPath> path;
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

Result<Done> check_video(const RenderOptions& given) {
    if (const Result<Done> possible = can_make_videos(); !possible) return possible.error();
    if (given.width % 2 != 0 || given.height % 2 != 0)
        return Error{"--width, --height", fmt::format("a video of {} x {} pixels cannot be: both must be even", given.width, given.height),
                     ""};
    return can_write(given.outputs[0]);
}

Result<Done> check_outputs(const RenderOptions& given) {
    if (given.path.empty()) {
        for (const std::string& path : given.outputs)
            if (const Result<Done> possible = check_output(path); !possible) return possible.error();
        return Done{};
    }
    const std::filesystem::path output = given.outputs[0];
    if (given.outputs.size() != 1 || (output.has_extension() && !is_video(output)))
        return Error{"--output", fmt::format("the pictures of a path go into one folder, or into one video ({})", video_extensions),
                     "Write -o frames/, or -o flight.mp4."};
    if (is_video(output))
        if (const Result<Done> possible = check_video(given); !possible) return possible.error();
    if (!(given.rate > 0.0 && given.rate <= 1000.0))
        return Error{"--rate", fmt::format("{} is out of range: it must be above 0 and at most 1000 pictures a second", given.rate), ""};
    return Done{};
}

Result<std::optional<CameraPath>> path_of(const RenderOptions& given) {
    if (given.path.empty()) return std::optional<CameraPath>();
    Result<CameraPath> path = read_camera_path(given.path);
    if (!path) return path.error();
    if ((path->end_s() - path->begin_s()) * given.rate >= most_pictures)
        return Error{"--rate", fmt::format("{} pictures a second make more than {} of this path", given.rate, most_pictures), ""};
    return std::optional(*std::move(path));
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
    if (given.samples < 1 || given.samples > most_samples || !std::has_single_bit(static_cast<unsigned>(given.samples)))
        return Error{"--samples", fmt::format("{} is none of 1, 2, 4, 8, 16, 32 and 64", given.samples),
                     "4 smooth edges, 16 make thin lines even."};
    const std::optional<ToneCurve> tone = tone_curve_named(given.tone);
    if (!tone) return Error{"--tone", fmt::format("\"{}\" is none of: {}", given.tone, tone_curve_names), ""};
    if (const Result<Done> possible = check_outputs(given); !possible) return possible.error();
    const Result<std::optional<CameraPath>> path = path_of(given);
    if (!path) return path.error();
    const Result<TableWishes> tables = table_wishes_of(given.tables);
    if (!tables) return tables.error();
    Wishes wishes{*scene, *path, *tone, std::nullopt, *tables};
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

// The means of a picture's samples. A screen's light is averaged, too, after the tone curve, or the edge of the sun would be white wherever a
// sample of a pixel met it. The first sample's exposure holds for all.
struct Seen {
    Image light;    // cd m-2
    Image display;  // [0, 1], linear
    double exposure;
    Figures figures;  // of the last sample
};

Result<Seen> seen(SceneFrames& frames, std::size_t number, const RenderOptions& given, const Wishes& wishes,
                  const std::function<double(const Image&)>& expose) {
    Seen mean{Image(given.width, given.height, 3), Image(given.width, given.height, 3), 0.0, {}};
    const float share = 1.0f / static_cast<float>(given.samples);
    for (int sample = 0; sample < given.samples; ++sample) {
        const Result<DrawnFrame> drawn = frames.draw(number, sample, given.samples);
        if (!drawn) return drawn.error();
        if (sample == 0) mean.exposure = expose(drawn->image);
        add_share(mean.light, drawn->image, share);
        add_share(mean.display, developed(drawn->image, mean.exposure, wishes.tone), share);
        mean.figures = drawn->figures;
    }
    return mean;
}

Result<Done> write(const std::string& path, const Seen& picture, const RenderOptions& given) {
    if (std::filesystem::path(path).extension() == ".png") return write_png(path, picture.display);
    ImageMeaning meaning = ImageMeaning::rgb(RgbSpace::srgb);
    meaning.notes = {{"airlight:scene", given.scene}};
    return write_exr(path, picture.light, meaning, ExrPixels::float16);
}

void print(const Figures& figures) {
    for (const auto& [quantity, value, unit] : figures) fmt::print("{},{},{}\n", quantity, value, unit);
}

// What a file is, for telling another of the same name from it; "" for a name that is no file, such as that of a preset.
std::string file_stamp(const std::filesystem::path& path) {
    std::error_code absent;
    const auto bytes = std::filesystem::file_size(path, absent);
    if (absent) return "";
    return fmt::format("{} {}", bytes, std::filesystem::last_write_time(path, absent).time_since_epoch().count());
}

// All that the pictures of a path are a function of.
Result<std::string> ingredients_of(const RenderOptions& given, const Scene& scene) {
    std::string made_of =
        fmt::format("{} {}x{} {} {} {} {} {} {} {} {}\n", AIRLIGHT_VERSION, given.width, given.height, given.samples, given.rate,
                    given.exposure, given.tone, given.air, given.shafts, given.tables.orders, given.tables.sizes);
    for (const std::string& file : {given.scene, given.path}) {
        const Result<std::string> text = read_file(file);
        if (!text) return text.error();
        made_of += *text + '\0';
    }
    const std::filesystem::path beside = std::filesystem::path(scene.file).parent_path();
    std::vector<std::filesystem::path> files = {scene.ground.elevation.value_or(""),
                                                scene.ground.surface.value_or(""),
                                                beside / scene.atmosphere,
                                                std::filesystem::path(scene.atmosphere),
                                                beside / scene.weather,
                                                std::filesystem::path(scene.weather)};
    for (const ObjectScene& object : scene.objects) files.push_back(object.mesh);
    for (const std::filesystem::path& file : files) made_of += file.string() + ' ' + file_stamp(file) + '\n';
    return made_of;
}

Result<std::vector<Picture>> pictures_of(const Scene& scene, const CameraPath& path, const std::vector<double>& times) {
    CameraPath way = path;
    if (std::ranges::any_of(path.keys, &CameraKey::above_ground)) {
        const Result<HeightField> ground = ground_of(scene);
        if (!ground) return ground.error();
        way = over(*ground, path);
    }
    std::vector<Picture> pictures;
    for (const double time : times) {
        const CameraKey key = camera_at(way, time);
        pictures.push_back({{.viewpoint = key.eye, .vertical_field_of_view = key.vertical_field_of_view}, key.sky_time});
    }
    return pictures;
}

Error interrupted() { return {"", "the path was interrupted", "What was finished is kept: the same command goes on from there."}; }

// The exposure of the next picture: fixed, or metered and followed as an eye does.
double followed_exposure(const Image& image, const Wishes& wishes, const std::vector<double>& before, double rate) {
    const double now = exposure_of(image, wishes);
    if (wishes.exposure || before.empty()) return now;
    return adapted_exposure(before.back(), now, 1.0 / rate, {});
}

// The pictures of a folder as a video.
Result<Done> write_video(const RenderOptions& given, const FrameFolder& folder, const Progress& progress) {
    Result<Video> video = Video::open(given.outputs[0], given.width, given.height, given.rate);
    if (!video) return video.error();
    const std::size_t pictures = folder.exposures().size();
    for (std::size_t number = 0; number < pictures; ++number) {
        progress.report("video", static_cast<double>(number) / static_cast<double>(pictures));
        if (progress.stop.stop_requested()) return interrupted();
        const Result<PngLevels> picture = read_png(folder.picture(number));
        if (!picture) return picture.error();
        if (const Result<Done> added = video->add(*picture); !added) return added.error();
    }
    return video->close();
}

Result<Done> run_path(const RenderOptions& given, const Wishes& wishes) {
    const std::vector<double> times = picture_times(*wishes.path, given.rate);
    const Result<std::string> made_of = ingredients_of(given, wishes.scene);
    if (!made_of) return made_of.error();
    const bool video = is_video(given.outputs[0]);
    Result<FrameFolder> folder = FrameFolder::open(given.outputs[0] + (video ? ".frames" : ""), *made_of);
    if (!folder) return folder.error();
    const std::size_t kept = folder->exposures().size();
    Figures figures;
    if (kept < times.size()) {
        const Result<std::vector<Picture>> pictures = pictures_of(wishes.scene, *wishes.path, times);
        if (!pictures) return pictures.error();
        Result<SceneFrames> frames = SceneFrames::create(wishes.scene, *pictures, given.width, given.height, wishes.tables);
        if (!frames) return frames.error();
        for (std::size_t number = kept; number < times.size(); ++number) {
            wishes.tables.progress.report("pictures", static_cast<double>(number) / static_cast<double>(times.size()));
            if (wishes.tables.progress.stop.stop_requested()) return interrupted();
            const Result<Seen> picture = seen(*frames, number, given, wishes, [&](const Image& image) {
                return followed_exposure(image, wishes, folder->exposures(), given.rate);
            });
            if (!picture) return picture.error();
            if (const Result<Done> written = write_png(folder->picture(number), picture->display); !written) return written.error();
            if (const Result<Done> noted = folder->add(picture->exposure); !noted) return noted.error();
            figures = picture->figures;
        }
    }
    if (video) {
        if (const Result<Done> written = write_video(given, *folder, wishes.tables.progress); !written) return written.error();
        if (const Result<Done> gone = folder->discard(); !gone) return gone.error();
    }
    fmt::print("quantity,value,unit\n");
    print(figures);
    fmt::print("pictures kept,{},\npictures drawn,{},\n{},{},\n", kept, times.size() - kept, video ? "file" : "folder", given.outputs[0]);
    return Done{};
}

Result<Done> run_picture(const RenderOptions& given, const Wishes& wishes) {
    Result<SceneFrames> frames =
        SceneFrames::create(wishes.scene, std::array{Picture{wishes.scene.camera}}, given.width, given.height, wishes.tables);
    if (!frames) return frames.error();
    const Result<Seen> picture = seen(*frames, 0, given, wishes, [&](const Image& image) { return exposure_of(image, wishes); });
    if (!picture) return picture.error();
    for (const std::string& path : given.outputs)
        if (const Result<Done> written = write(path, *picture, given); !written) return written.error();
    fmt::print("quantity,value,unit\n");
    print(picture->figures);
    for (const std::string& path : given.outputs) fmt::print("file,{},\n", path);
    return Done{};
}

Result<Done> run(const RenderOptions& given) {
    const Interrupt interrupt;
    Result<Wishes> wishes = wishes_of(given);
    if (!wishes) return wishes.error();
    ProgressLine line(given.quiet);
    wishes->tables.progress = line.progress(interrupt.token());
    return wishes->path ? run_path(given, *wishes) : run_picture(given, *wishes);
}

}  // namespace

Command render_command(CLI::App& airlight) {
    const auto given = std::make_shared<RenderOptions>();
    CLI::App* render = airlight.add_subcommand("render", "Draw a planet from anywhere, its ground and its air, without a window.");
    render->add_option("scene", given->scene, "a scene file: docs/scene-file.md")->required()->option_text("<scene.toml>");
    render
        ->add_option("-o,--output", given->outputs,
                     "a .exr (light in cd m-2) or .png file; may be given several times; with --path a folder, or a video where "
                     "ffmpeg is installed")
        ->option_text("<file>")
        ->required();
    render->add_option("--path", given->path, "a camera path: docs/camera-path.md; the same command goes on with one that was stopped")
        ->option_text("<path.toml>");
    render->add_option("--rate", given->rate, "of a path, in pictures a second")->option_text("<n>")->capture_default_str();
    render->add_option("--width", given->width, "of the picture, in pixels")->option_text("<n>")->capture_default_str();
    render->add_option("--height", given->height, "of the picture, in pixels")->option_text("<n>")->capture_default_str();
    render->add_option("--samples", given->samples, "of each pixel, for smooth edges: 1, 2, 4, ... 64, each of which takes as long as one")
        ->option_text("<n>")
        ->capture_default_str();
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
