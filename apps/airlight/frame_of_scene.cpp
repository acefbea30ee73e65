#include "frame_of_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "render/frame.h"
#include "scene_air.h"

namespace airlight::cli {

namespace {

DrawnFrame drawn_with_figures(Image image, const gpu::Context& context, const render::Frame& frame) {
    DrawnFrame drawn{std::move(image), {}};
    drawn.figures.push_back({"device", fmt::format("\"{}\"", context.renderer()), ""});
    for (const gpu::PassTime& time : frame.times())
        drawn.figures.push_back({"pass " + time.pass, fmt::format("{:.3f}", time.milliseconds), "ms"});
    drawn.figures.push_back({"patches", fmt::format("{}", frame.terrain().patches), ""});
    drawn.figures.push_back({"triangles", fmt::format("{}", frame.terrain().triangles), ""});
    return drawn;
}

// Where each of the cameras is, over the ground.
Result<std::vector<Camera>> cameras_of(const Scene& scene, std::span<const Picture> pictures, const HeightField& ground, int width,
                                       int height) {
    std::vector<Camera> cameras;
    for (const Picture& picture : pictures) {
        Scene from = scene;
        from.camera = picture.camera;
        const Result<Camera> camera = camera_of(from, ground, width, height);
        if (!camera) return pictures.size() == 1 ? camera.error() : at(fmt::format("picture {}", cameras.size()), camera.error());
        cameras.push_back(*camera);
    }
    return cameras;
}

// The ground is as fine as the camera that sees it nearest needs it.
const Camera& narrowest(std::span<const Camera> cameras) { return *std::ranges::min_element(cameras, {}, &Camera::vertical_field_of_view); }

}  // namespace

struct SceneFrames::Parts {
    std::unique_ptr<gpu::Context> context;
    Scene scene;  // at the time of the first picture
    std::vector<Camera> cameras;
    std::vector<std::optional<Utc>> times;
    render::Frame frame;
};

SceneFrames::SceneFrames(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SceneFrames::SceneFrames(SceneFrames&&) noexcept = default;
SceneFrames& SceneFrames::operator=(SceneFrames&&) noexcept = default;
SceneFrames::~SceneFrames() = default;

Result<SceneFrames> SceneFrames::create(const Scene& said, std::span<const Picture> pictures, int width, int height,
                                        const TableWishes& wishes) {
    Scene scene = said;
    if (pictures.front().time) set_time(scene, *pictures.front().time);
    const Result<HeightField> ground = ground_of(scene);
    if (!ground) return ground.error();
    const Result<GroundColour> colour = colour_of(scene);
    if (!colour) return colour.error();
    const Result<std::vector<Object>> objects = objects_of(scene, *ground);
    if (!objects) return objects.error();
    Result<std::vector<Camera>> placed = cameras_of(scene, pictures, *ground, width, height);
    if (!placed) return placed.error();
    const Result<std::optional<Atmosphere>> air = air_of(scene);
    if (!air) return air.error();
    Result<gpu::Context> made = gpu::Context::create();
    if (!made) return made.error();
    auto context = std::make_unique<gpu::Context>(*std::move(made));
    const Result<std::optional<SceneAir>> seen_through = scene_air_of(*air, needs_tables(scene.air.method), wishes);
    if (!seen_through) return seen_through.error();
    Result<std::optional<render::AirPass>> pass = air_pass_of(*seen_through, scene);
    if (!pass) return pass.error();
    Result<render::ShaftsPass> shafts = shafts_pass_of(*air, scene, width, height);
    if (!shafts) return shafts.error();
    Result<render::Frame> frame = render::Frame::create(*context, *ground, *colour, narrowest(*placed), *std::move(pass),
                                                        *std::move(shafts), stars_of(scene), {}, *objects);
    if (!frame) return frame.error();
    std::vector<std::optional<Utc>> times;
    for (const Picture& picture : pictures) times.push_back(picture.time);
    return SceneFrames(
        std::make_unique<Parts>(Parts{std::move(context), std::move(scene), *std::move(placed), std::move(times), *std::move(frame)}));
}

Result<DrawnFrame> SceneFrames::draw(std::size_t picture, int sample, int samples) {
    Scene scene = parts_->scene;
    if (const std::optional<Utc>& time = parts_->times[picture]) {
        set_time(scene, *time);
        scene.sun.distance_au = parts_->scene.sun.distance_au;  // the air's light was made for it
        parts_->frame.take(stars_of(scene));
    }
    Result<Image> image = parts_->frame.draw(sampled(parts_->cameras[picture], sample, samples), lights_of(scene));
    if (!image) return image.error();
    bring_into_gamut(*image);
    return drawn_with_figures(std::move(*image), *parts_->context, parts_->frame);
}

}  // namespace airlight::cli
