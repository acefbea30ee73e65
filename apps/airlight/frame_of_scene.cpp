#include "frame_of_scene.h"

#include <fmt/format.h>

#include <optional>

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

}  // namespace

Result<DrawnFrame> draw_scene(const Scene& scene, int width, int height, const TableWishes& wishes) {
    const Result<HeightField> ground = ground_of(scene);
    if (!ground) return ground.error();
    const Result<GroundColour> colour = colour_of(scene);
    if (!colour) return colour.error();
    const Result<Camera> camera = camera_of(scene, *ground, width, height);
    if (!camera) return camera.error();
    const Result<std::optional<Atmosphere>> air = air_of(scene);
    if (!air) return air.error();
    const Result<gpu::Context> context = gpu::Context::create();
    if (!context) return context.error();
    const Result<std::optional<Tables>> tables = tables_of(*air, wishes);
    if (!tables) return tables.error();
    Result<std::optional<render::AirPass>> pass = air_pass_of(*tables, scene);
    if (!pass) return pass.error();
    Result<render::ShaftsPass> shafts = shafts_pass_of(*air, scene, width, height);
    if (!shafts) return shafts.error();
    Result<render::Frame> frame =
        render::Frame::create(*context, *ground, *colour, *camera, *std::move(pass), *std::move(shafts), stars_of(scene));
    if (!frame) return frame.error();
    Result<Image> image = frame->draw(*camera, lights_of(scene));
    if (!image) return image.error();
    bring_into_gamut(*image);
    return drawn_with_figures(std::move(*image), *context, *frame);
}

}  // namespace airlight::cli
