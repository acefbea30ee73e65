#include "frame_of_scene.h"

#include <fmt/format.h>

#include "render/frame.h"
#include "spectrum/colour.h"
#include "spectrum/solar.h"

namespace airlight::cli {

namespace {

// What the sun shines with above the air, in lux of the primaries of sRGB.
render::Lights lights_of(const Scene& scene) {
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    const Rgb sun = converter.into_gamut(converter.to_rgb(to_xyz(solar_irradiance(scene.sun.distance_au))));
    return {.towards_sun = towards_sun(scene), .sun = {sun.r, sun.g, sun.b}, .sky = Vec3(0.0)};
}

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

Result<DrawnFrame> draw_scene(const Scene& scene, int width, int height) {
    const Result<HeightField> ground = ground_of(scene);
    if (!ground) return ground.error();
    const Result<GroundColour> colour = colour_of(scene);
    if (!colour) return colour.error();
    const Result<Camera> camera = camera_of(scene, *ground, width, height);
    if (!camera) return camera.error();
    const Result<gpu::Context> context = gpu::Context::create();
    if (!context) return context.error();
    Result<render::Frame> frame = render::Frame::create(*context, *ground, *colour, *camera);
    if (!frame) return frame.error();
    Result<Image> image = frame->draw(*camera, lights_of(scene));
    if (!image) return image.error();
    return drawn_with_figures(std::move(*image), *context, *frame);
}

}  // namespace airlight::cli
