#include "viewer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "image/exr.h"
#include "panel.h"
#include "prober.h"
#include "render/shaders.h"
#include "stage.h"
#include "viewer/file_watch.h"
#include "viewer/files.h"
#include "viewer/path_edit.h"
#include "window.h"

namespace airlight::cli {

namespace {

constexpr double watch_every_s = 0.5;
constexpr double longest_frame_s = 0.25;  // flown after a stall
constexpr double fast = 4.0;
constexpr double rest_s = 0.3;     // of a window whose size was changed
constexpr int smallest_side = 64;  // of a picture
constexpr double scripted_frame_s = 1.0 / 30.0;
constexpr std::chrono::milliseconds patience{500};  // for tables of air that are there already

// Where the picture stands in the window: as large as it can be, in the middle.
struct Fit {
    int left, bottom, width, height;
};
Fit fit(const Window& window, const Stage& stage) {
    const double scale =
        std::min(static_cast<double>(window.width()) / stage.width(), static_cast<double>(window.height()) / stage.height());
    const int width = static_cast<int>(std::lround(scale * stage.width())), height = static_cast<int>(std::lround(scale * stage.height()));
    return {(window.width() - width) / 2, (window.height() - height) / 2, width, height};
}

void show_picture(const Window& window, const Stage& stage) {
    const Fit at = fit(window, stage);
    const GLfloat black[] = {0.0f, 0.0f, 0.0f, 1.0f};
    glDisable(GL_FRAMEBUFFER_SRGB);
    glClearNamedFramebufferfv(0, GL_COLOR, 0, black);
    glBlitNamedFramebuffer(stage.shown().name(), 0, 0, 0, stage.width(), stage.height(), at.left, at.bottom, at.left + at.width,
                           at.bottom + at.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

// A place of the window as one of the picture.
PicturePlace in_picture(PicturePlace place, const Window& window, const Stage& stage) {
    const Fit at = fit(window, stage);
    return {place.x * window.width() / at.width, place.y * window.height() / at.height};
}

// What goes wrong while the viewer runs; each stays until it is mended.
struct Failures {
    std::string scene, shaders, size, air, file, path;
    std::vector<std::string> all() const {
        std::vector<std::string> told;
        for (const std::string* failure : {&scene, &shaders, &size, &air, &file, &path})
            if (!failure->empty()) told.push_back(*failure);
        return told;
    }
};

// On standard error, once each, for who has hidden the panel or reads a log.
void tell_new(const std::vector<std::string>& failures, const std::vector<std::string>& before) {
    for (const std::string& failure : failures)
        if (std::find(before.begin(), before.end(), failure) == before.end()) fmt::print(stderr, "{}\n", failure);
}

std::string message_of(const Result<Done>& result) { return result ? std::string() : result.error().message(); }

// The file of a scene's air; none if it is a preset, or none.
std::vector<std::filesystem::path> air_files(const viewer::Session& session) {
    std::vector<std::filesystem::path> files;
    for (const std::string& name : {session.atmosphere, session.weather})
        if (!name.empty()) files.emplace_back(beside(session.file, name));
    return files;
}

class Viewer {
public:
    Viewer(const ViewerWishes& wishes, Window& window, Stage stage, viewer::Session session, viewer::PathEdit path)
        : wishes_(wishes),
          window_(window),
          stage_(std::move(stage)),
          session_(std::move(session)),
          path_(std::move(path)),
          prober_(wishes.tables),
          air_files_(air_files(session_)),
          scene_watch_({wishes.scene.file}),
          shader_watch_(render::shader_folders()),
          path_watch_({path_.file()}),
          air_watch_(air_files_) {}

    // A frame; false: the user leaves.
    Result<bool> frame() {
        Input input = window_.begin_frame();
        if (wishes_.frames > 0) input.seconds = scripted_frame_s;
        watched_s_ += input.seconds;
        if (watched_s_ >= watch_every_s) look_for_changes();
        if (wishes_.frames == 0) follow_size(input.seconds);
        fly(input);
        tell_new(failures_.all(), facts_.failures);
        facts_.failures = failures_.all();
        draw_panel(panel_, facts_, session_, stage_.ground(), input);
        const Stage::Pace pace = wishes_.frames > 0 ? Stage::Pace::whole : Stage::Pace::slices;
        const Result<Done> drawn = stage_.draw(session_, std::exchange(drawn_once_, true) ? input.seconds : 0.0, pace);
        failures_.air = drawn ? stage_.air_failure() : drawn.error().message();
        if (const Result<Done> there = window_.context().check(); !there) return there.error();
        tell();
        save(input);
        edit_path(input);
        probe(input);
        show_picture(window_, stage_);
        window_.draw_panels();
        return !leaves(input);
    }

    // Where keys of the path are that its file lacks; empty if it has them all.
    const std::filesystem::path& path_kept_in() const { return path_.kept_in(); }

    Figures figures() const {
        Figures all = {{"device", fmt::format("\"{}\"", facts_.device), ""}};
        for (const gpu::PassTime& time : facts_.times) all.push_back({"pass " + time.pass, fmt::format("{:.3f}", time.milliseconds), "ms"});
        return all;
    }

private:
    // The user leaves; but is asked, if keys of the path are on no disk.
    bool leaves(const Input& input) {
        if (!input.quit && !window_.closed()) return panel_.leaves;
        if (!path_.unsaved() || !path_.kept_in().empty()) return true;
        window_.stay();
        panel_.asks_to_leave = true;
        return false;
    }

    void fly(const Input& input) {
        if (played_s_) return play(input);
        viewer::change_speed(session_, input.notches);
        const HalfSize half = half_size(viewer::camera_of(session_, stage_.width(), stage_.height()));
        // What is dragged follows the mouse.
        session_.eye = viewer::turned(session_.eye, -std::atan(half.width) * input.dragged.x, -std::atan(half.height) * input.dragged.y);
        session_.eye = viewer::flown(session_.eye, input.steering, session_.flown_per_s * (input.fast ? fast : 1.0),
                                     std::min(input.seconds, longest_frame_s), stage_.ground());
    }

    // The path has the camera until its end, or until the user stops it.
    void play(const Input& input) {
        *played_s_ += std::min(input.seconds, longest_frame_s);
        const CameraPath path = over(stage_.ground(), {path_.keys()});
        const CameraKey now = camera_at(path, *played_s_);
        session_.eye = viewer::above_ground(now.eye, stage_.ground());
        session_.field_of_view = now.vertical_field_of_view;
        if (now.sky_time) viewer::set_time(session_, *now.sky_time);
        if (*played_s_ >= path.end_s()) played_s_.reset();
    }

    void edit_path(const Input& input) {
        if (input.play) played_s_ = played_s_ || path_.keys().empty() ? std::nullopt : std::optional(path_.keys().front().time_s);
        if (input.add_key) tell_of_path(path_.add(key_here(), panel_.seconds_to_key));
        if (input.undo) tell_of_path(path_.undo());
        if (input.redo) tell_of_path(path_.redo());
        facts_.path_file = path_.file().string();
        facts_.path_keys = path_.keys().size();
        facts_.path_s = path_.keys().empty() ? 0.0 : path_.keys().back().time_s;
        facts_.played_s = played_s_;
    }

    // With the sky's time if the keys before have one, or if the user wishes it for the first.
    CameraKey key_here() const {
        const bool timed = path_.keys().empty() ? panel_.keys_have_time : path_.keys().front().sky_time.has_value();
        return {.eye = session_.eye,
                .vertical_field_of_view = session_.field_of_view,
                .sky_time = timed ? session_.time : std::optional<Utc>()};
    }

    void tell_of_path(const Result<Done>& edited) {
        failures_.path = message_of(edited);
        if (!path_.kept_in().empty()) failures_.path += "\n  Its keys are kept in " + path_.kept_in().string() + '.';
    }

    void look_for_changes() {
        watched_s_ = 0.0;
        if (path_.unsaved()) tell_of_path(path_.save());
        else if (path_watch_.changed()) tell_of_path(path_.follow());
        look_for_air();
        if (shader_watch_.changed()) failures_.shaders = message_of(stage_.remake(session_.file));
        if (wishes_.built_in || !scene_watch_.changed()) return;
        failures_.scene = message_of(take_scene());
    }

    // The file of the air was written anew, or the air is another.
    void look_for_air() {
        const std::vector<std::filesystem::path> files = air_files(session_);
        if (files != air_files_) air_watch_ = viewer::FileWatch(air_files_ = files);
        if (!air_watch_.changed()) return;
        stage_.forget_air();
        prober_.forget_air();
    }

    // Pictures of the window's size, once it rests.
    void follow_size(double seconds) {
        const std::array<int, 2> size = {window_.width(), window_.height()};
        rested_s_ = size == window_size_ ? rested_s_ + seconds : 0.0;
        window_size_ = size;
        if (rested_s_ < rest_s || size == std::array{stage_.width(), stage_.height()} || std::min(size[0], size[1]) < smallest_side) return;
        failures_.size = message_of(stage_.resize(size[0], size[1]));
        rested_s_ = 0.0;
    }

    // The scene's file was written anew.
    Result<Done> take_scene() {
        const Result<Scene> scene = read_scene(session_.file.file);
        if (!scene) return scene.error();
        const bool same_ground = scene->ground == session_.file.ground;
        const Result<HeightField> ground = same_ground ? Result(stage_.ground()) : ground_of(*scene);
        if (!ground) return ground.error();
        Result<viewer::Session> next = viewer::reloaded(session_, *scene, *ground);
        if (!next) return next.error();
        if (!same_ground || scene->objects != session_.file.objects)
            if (const Result<Done> made = stage_.remake(*scene); !made) return made.error();
        session_ = *std::move(next);
        return Done{};
    }

    void tell() {
        facts_.device = window_.context().renderer();
        facts_.times = stage_.times();
        facts_.patches = stage_.terrain().patches;
        facts_.ev100 = ev100_of_exposure(std::max(stage_.exposure(), 1e-12));
        facts_.at_work = stage_.at_work();
        facts_.probe = prober_.answer();
    }

    void save(const Input& input) {
        if (input.png) saved(".png", [&](const std::filesystem::path& path) { return write_png(path, stage_.levels()); });
        if (input.exr)
            saved(".exr", [&](const std::filesystem::path& path) {
                ImageMeaning meaning = ImageMeaning::rgb(RgbSpace::srgb);
                meaning.notes = {{"airlight:scene", session_.file.file}};
                return write_exr(path, stage_.light(), meaning, ExrPixels::float16);
            });
    }

    template <class Write>
    void saved(const char* extension, Write write) {
        const std::filesystem::path path = viewer::free_name(wishes_.folder, "airlight", extension);
        failures_.file = message_of(write(path));
        if (failures_.file.empty()) facts_.done = "saved " + path.string();
    }

    void probe(const Input& input) {
        if (!input.clicked) return;
        const PicturePlace at = in_picture(*input.clicked, window_, stage_);
        if (std::abs(at.x) >= 1.0 || std::abs(at.y) >= 1.0) return;
        const Camera camera = viewer::camera_of(session_, stage_.width(), stage_.height());
        facts_.probed_picture = stage_.luminance_at(at.x, at.y);
        prober_.ask(viewer::scene_of(session_),
                    {camera.eye, direction_at(camera, at.x, at.y), session_.towards_sun, stage_.ground().radius_m});
    }

    const ViewerWishes& wishes_;
    Window& window_;
    Stage stage_;
    viewer::Session session_;
    viewer::PathEdit path_;
    std::optional<double> played_s_;
    Prober prober_;
    std::vector<std::filesystem::path> air_files_;
    viewer::FileWatch scene_watch_, shader_watch_, path_watch_, air_watch_;
    double watched_s_ = 0.0, rested_s_ = 0.0;
    std::array<int, 2> window_size_ = {0, 0};
    bool drawn_once_ = false;
    PanelState panel_;
    PanelFacts facts_;
    Failures failures_;
};

}  // namespace

Result<Figures> run_viewer(const ViewerWishes& wishes) {
    Result<viewer::PathEdit> path = viewer::PathEdit::open(wishes.path, viewer::state_folder());
    if (!path) return path.error();
    Result<Window> window = Window::open(wishes.width, wishes.height, "Airlight");
    if (!window) return window.error();
    Result<Stage> stage = Stage::create(window->context(), wishes.scene, wishes.width, wishes.height, wishes.tables,
                                        wishes.frames > 0 ? AirJob::forever : patience);
    if (!stage) return stage.error();
    Result<viewer::Session> session = viewer::session_of(wishes.scene, stage->ground());
    if (!session) return session.error();
    Viewer viewer(wishes, *window, *std::move(stage), *std::move(session), *std::move(path));
    for (int frame = 1;; ++frame) {
        const Result<bool> goes_on = viewer.frame();
        if (!goes_on) return goes_on.error();
        const bool last = !*goes_on || frame == wishes.frames;
        if (last && wishes.screenshot)
            if (const Result<Done> written = write_png(*wishes.screenshot, window->levels()); !written) return written.error();
        window->show();
        if (!last) continue;
        if (!viewer.path_kept_in().empty())
            fmt::print(stderr, "{} could not be written: its keys are in {}.\n", wishes.path.string(), viewer.path_kept_in().string());
        return viewer.figures();
    }
}

}  // namespace airlight::cli
