#include "scene_air.h"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <system_error>

#include "air_inputs.h"
#include "atmosphere/atmosphere_file.h"
#include "atmosphere/presets.h"
#include "render/air_airlight.h"
#include "render/air_exact.h"
#include "render/air_hillaire2020.h"
#include "render/bruneton2008_air.h"
#include "spectrum/colour.h"
#include "spectrum/colour_weights.h"
#include "spectrum/solar.h"

namespace airlight::cli {

namespace {

std::vector<Wavelength> wavelengths() {
    const WavelengthGrid grid = WavelengthGrid::standard();
    return {grid.begin(), grid.end()};
}

// In cd m-2 of the primaries of sRGB, under the sun of the scene.
std::vector<Vec3> colours_of(const Atmosphere& air, const Scene& scene) {
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    const ColourWeights weights(WavelengthGrid::standard(), air.sun.irradiance);
    std::vector<Vec3> colours;
    for (const Xyz& weight : weights.weights()) {
        const Rgb rgb = converter.to_rgb(weight);
        colours.push_back(Vec3(rgb.r, rgb.g, rgb.b) / (scene.sun.distance_au * scene.sun.distance_au));
    }
    return colours;
}

Result<std::unique_ptr<render::AirMethod>> bruneton2008_air(const SceneAir& air, std::span<const Vec3> colours) {
    const Result<std::shared_ptr<const render::Bruneton2008Programs>> programs = render::bruneton2008_programs();
    if (!programs) return programs.error();
    render::Bruneton2008Bake bake(*programs, air.atmosphere, wavelengths(), render::fine_texels,
                                  {.sizes = render::sizes_around_points, .orders = air.orders});
    return std::unique_ptr<render::AirMethod>(std::make_unique<render::Bruneton2008Air>(std::move(bake), colours));
}

Result<std::unique_ptr<render::AirMethod>> method_of(const SceneAir& air, std::span<const Vec3> colours, AirMethodName name) {
    switch (name) {
        case AirMethodName::airlight:
            return render::airlight_air(*air.tables, colours);
        case AirMethodName::hillaire2020:
            return render::hillaire2020_air({air.atmosphere, wavelengths(), colours});
        case AirMethodName::bruneton2008:
            return bruneton2008_air(air, colours);
        case AirMethodName::exact:
            break;
    }
    return render::exact_air(*air.tables, colours);
}

render::Shafts shafts_of(ShaftsName name) {
    switch (name) {
        case ShaftsName::epipolar:
            return render::Shafts::epipolar;
        case ShaftsName::marched:
            return render::Shafts::marched;
        case ShaftsName::planes:
            return render::Shafts::planes;
        case ShaftsName::volumes:
            return render::Shafts::volumes;
        case ShaftsName::brute:
            return render::Shafts::brute;
        case ShaftsName::none:
            break;
    }
    return render::Shafts::none;
}

}  // namespace

std::string beside(const Scene& scene, const std::string& name) {
    std::error_code absent;
    const std::filesystem::path file = std::filesystem::path(scene.file).parent_path() / name;
    return std::filesystem::exists(file, absent) ? file.string() : name;
}

render::Lights lights_of(const Scene& scene) {
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    const Rgb sun = converter.into_gamut(converter.to_rgb(to_xyz(solar_irradiance(scene.sun.distance_au))));
    return {.towards_sun = towards_sun(scene),
            .sun = {sun.r, sun.g, sun.b},
            .sky = Vec3(0.0),
            .sun_distance_au = scene.sun.distance_au,
            .moon_m = moon_place(scene)};
}

Result<std::optional<Atmosphere>> air_of(const Scene& scene) {
    if (scene.atmosphere == "none") return std::optional<Atmosphere>();
    const std::vector<std::string_view> presets = preset_names();
    const bool is_preset = std::find(presets.begin(), presets.end(), scene.atmosphere) != presets.end();
    Result<Atmosphere> air = atmosphere_named(is_preset ? scene.atmosphere : beside(scene, scene.atmosphere));
    if (!air) return at(scene.file + ": atmosphere", air.error());
    if (!scene.weather.empty()) {
        Result<AskedAir> under = air_under(*std::move(air), beside(scene, scene.weather), AerosolType::continental_average);
        if (!under) return at(scene.file + ": weather", under.error());
        air = std::move(under->atmosphere);
    }
    air->bottom_radius = scene.ground.radius_m * m;
    return std::optional<Atmosphere>(*std::move(air));
}

bool needs_tables(AirMethodName method) { return method == AirMethodName::airlight || method == AirMethodName::exact; }

Result<std::optional<SceneAir>> scene_air_of(const std::optional<Atmosphere>& air, bool tables, const TableWishes& wishes) {
    if (!air) return std::optional<SceneAir>();
    SceneAir made{*air, wishes.bake.orders, {}};
    if (tables) {
        Result<Tables> baked = cached_tables(*air, wavelengths(), wishes.bake, wishes.cache, wishes.progress);
        if (!baked) return baked.error();
        made.tables = *std::move(baked);
    }
    return std::optional<SceneAir>(std::move(made));
}

bool tables_are_kept(const Atmosphere& air, const TableWishes& wishes) {
    if (!wishes.cache.enabled) return false;
    return std::ranges::all_of(cache_files(air, wavelengths(), wishes.bake, wishes.cache), [](const std::filesystem::path& file) {
        std::error_code absent;
        return std::filesystem::exists(file, absent);
    });
}

Result<std::optional<render::AirPass>> air_pass_of(const std::optional<SceneAir>& air, const Scene& scene) {
    if (!air) return std::optional<render::AirPass>();
    assert(air->tables || !needs_tables(scene.air.method));
    const std::vector<Vec3> colours = colours_of(air->atmosphere, scene);
    Result<std::unique_ptr<render::AirMethod>> method = method_of(*air, colours, scene.air.method);
    if (!method) return method.error();
    Result<render::AirPass> pass = render::AirPass::create({air->atmosphere, wavelengths(), colours}, *std::move(method));
    if (!pass) return pass.error();
    return std::optional<render::AirPass>(*std::move(pass));
}

Result<render::ShaftsPass> shafts_pass_of(const std::optional<Atmosphere>& air, const Scene& scene, int width, int height) {
    return render::ShaftsPass::create(width, height, shafts_of(scene.air.shafts), air ? &*air : nullptr);
}

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

}  // namespace airlight::cli
