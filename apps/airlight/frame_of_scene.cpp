#include "frame_of_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "atmosphere/atmosphere_file.h"
#include "atmosphere/presets.h"
#include "render/air_exact.h"
#include "render/frame.h"
#include "spectrum/colour.h"
#include "spectrum/colour_weights.h"
#include "spectrum/solar.h"

namespace airlight::cli {

namespace {

// What the sun shines with above the air, in lux of the primaries of sRGB.
render::Lights lights_of(const Scene& scene) {
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    const Rgb sun = converter.into_gamut(converter.to_rgb(to_xyz(solar_irradiance(scene.sun.distance_au))));
    return {.towards_sun = towards_sun(scene), .sun = {sun.r, sun.g, sun.b}, .sky = Vec3(0.0)};
}

// The air of a scene on the scene's planet; none if it has none.
Result<std::optional<Atmosphere>> air_of(const Scene& scene) {
    if (scene.atmosphere == "none") return std::optional<Atmosphere>();
    const std::vector<std::string_view> presets = preset_names();
    const bool is_preset = std::find(presets.begin(), presets.end(), scene.atmosphere) != presets.end();
    const std::filesystem::path beside = std::filesystem::path(scene.file).parent_path() / scene.atmosphere;
    Result<Atmosphere> air = atmosphere_named(is_preset || !std::filesystem::exists(beside) ? scene.atmosphere : beside.string());
    if (!air) return at(scene.file + ": atmosphere", air.error());
    air->bottom_radius = scene.ground.radius_m * m;
    return std::optional<Atmosphere>(*std::move(air));
}

// In cd m-2 of the primaries of sRGB, under the sun of the scene.
std::vector<Vec3> colours_of(const Atmosphere& air, const WavelengthGrid& grid, const Scene& scene) {
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    const ColourWeights weights(grid, air.sun.irradiance);
    std::vector<Vec3> colours;
    for (const Xyz& weight : weights.weights()) {
        const Rgb rgb = converter.to_rgb(weight);
        colours.push_back(Vec3(rgb.r, rgb.g, rgb.b) / (scene.sun.distance_au * scene.sun.distance_au));
    }
    return colours;
}

Result<std::optional<Tables>> tables_of(const std::optional<Atmosphere>& air, const WavelengthGrid& grid, const TableWishes& wishes) {
    if (!air) return std::optional<Tables>();
    Result<Tables> tables = cached_tables(*air, {grid.begin(), grid.end()}, wishes.bake, wishes.cache, wishes.progress);
    if (!tables) return tables.error();
    return std::optional<Tables>(*std::move(tables));
}

Result<std::optional<render::AirPass>> air_pass_of(const std::optional<Tables>& tables, const WavelengthGrid& grid, const Scene& scene) {
    if (!tables) return std::optional<render::AirPass>();
    const std::vector<Vec3> colours = colours_of(tables->atmosphere(), grid, scene);
    Result<render::AirPass> pass =
        render::AirPass::create({tables->atmosphere(), tables->wavelengths(), colours}, render::exact_air(*tables, colours));
    if (!pass) return pass.error();
    return std::optional<render::AirPass>(*std::move(pass));
}

// Colours beyond the primaries, which a few wavelengths of a deep red sun have, are brought to their edge.
void bring_into_gamut(Image& image) {
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const std::span<float> pixel = image.pixel(column, row);
            const Rgb rgb = converter.into_gamut({pixel[0], pixel[1], pixel[2]});
            pixel[0] = static_cast<float>(std::max(rgb.r, 0.0));
            pixel[1] = static_cast<float>(std::max(rgb.g, 0.0));
            pixel[2] = static_cast<float>(std::max(rgb.b, 0.0));
        }
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
    const WavelengthGrid grid = WavelengthGrid::standard();
    const Result<std::optional<Tables>> tables = tables_of(*air, grid, wishes);
    if (!tables) return tables.error();
    Result<std::optional<render::AirPass>> pass = air_pass_of(*tables, grid, scene);
    if (!pass) return pass.error();
    Result<render::Frame> frame = render::Frame::create(*context, *ground, *colour, *camera, *std::move(pass));
    if (!frame) return frame.error();
    Result<Image> image = frame->draw(*camera, lights_of(scene));
    if (!image) return image.error();
    bring_into_gamut(*image);
    return drawn_with_figures(std::move(*image), *context, *frame);
}

}  // namespace airlight::cli
