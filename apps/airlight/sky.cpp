// `airlight sky`: a picture of the sky over a place at a time under a weather report, and its illuminances.

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "command.h"
#include "core/files.h"
#include "image/exposure.h"
#include "image/exr.h"
#include "image/png.h"
#include "image/tone.h"
#include "interrupt.h"
#include "sky/sky_image.h"
#include "sky_inputs.h"
#include "spectrum/colour_temperature.h"
#include "sun/position.h"
#include "units/text.h"

namespace airlight::cli {

namespace {

struct SkyOptions {
    SkyInputs inputs;
    std::string time;
    double latitude_deg = 0.0;
    double longitude_deg = 0.0;
    double sun_deg = 45.0;
    double sun_azimuth_deg = 180.0;
    double altitude_m = 0.0;
    std::string projection = "fisheye";
    int size = 1024;
    double heading_deg = 180.0;
    double pitch_deg = 10.0;
    double field_deg = 60.0;
    std::string space = "srgb";
    std::string white = "D65";
    std::string exposure = "auto";
    std::string tone = "filmic";
    int bits = 8;
    bool no_disk = false;
    std::vector<std::string> outputs;
};

template <class T>
Result<T> named(std::string_view option, const std::string& name, std::optional<T> found, std::string_view names) {
    if (found) return *found;
    return Error{std::string(option), fmt::format("\"{}\" is none of: {}", name, names), ""};
}

Result<Projection> projection_of(const SkyOptions& given) {
    const int size = given.size;
    if (given.projection == "fisheye") return Projection(Fisheye{size, size});
    if (given.projection == "sphere") return Projection(FullSphere{size, size / 2});
    if (given.projection == "perspective")
        return Projection(Perspective{size, size * 2 / 3, given.heading_deg * deg, given.pitch_deg * deg, 0.0, given.field_deg * deg});
    if (given.projection == "cube") return Projection(CubeMap{size});
    return Error{"--projection", fmt::format("\"{}\" is none of: fisheye sphere perspective cube", given.projection), ""};
}

// Where the sun stands: given, or over a place at a time.
Result<SkyScene> scene_of(const SkyOptions& given) {
    SkyScene scene{.altitude = given.altitude_m * m,
                   .sun_zenith = given.sun_deg * deg,
                   .sun_azimuth = given.sun_azimuth_deg * deg,
                   .sunlight = 1.0,
                   .sun_disk = !given.no_disk};
    if (!given.time.empty()) {
        const Result<Place> place = place_of({given.latitude_deg * deg, given.longitude_deg * deg, 0.0 * m});
        if (!place) return place.error();
        const Result<Utc> time = parse_utc(given.time);
        if (!time) return at("--time", time.error());
        const SunPosition sun = sun_position(*place, *time);
        scene.sun_zenith = sun.direction.zenith;
        scene.sun_azimuth = sun.direction.azimuth;
        scene.sunlight = 1.0 / (sun.distance_au * sun.distance_au);
    }
    if (const Result<Done> ok = check_view(scene.altitude, 0.0, scene.sun_zenith, scene.sun_azimuth); !ok) return ok.error();
    return scene;
}

// Everything about the picture that can be wrong, found out before anything long begins.
struct Wishes {
    SkyScene scene;
    Projection projection;
    RgbSpace space;
    WhitePoint white;
    ToneCurve tone;
    std::optional<double> exposure;  // none: metered
};

Result<Wishes> wishes_of(const SkyOptions& given) {
    const Result<SkyScene> scene = scene_of(given);
    if (!scene) return scene.error();
    const Result<Projection> projection = projection_of(given);
    if (!projection) return projection.error();
    if (const Result<Done> ok = check(*projection); !ok) return ok.error();
    const Result<RgbSpace> space = named("--space", given.space, rgb_space_named(given.space), rgb_space_names);
    if (!space) return space.error();
    const Result<WhitePoint> white = named("--white", given.white, white_point_named(given.white), white_point_names);
    if (!white) return white.error();
    const Result<ToneCurve> tone = named("--tone", given.tone, tone_curve_named(given.tone), tone_curve_names);
    if (!tone) return tone.error();
    if (given.bits != 8 && given.bits != 16) return Error{"--bits", fmt::format("{} is out of range: it must be 8 or 16", given.bits), ""};
    Wishes wishes{*scene, *projection, *space, *white, *tone, std::nullopt};
    if (given.exposure != "auto") {
        const Result<double> ev = parse_number(given.exposure);
        if (!ev)
            return Error{"--exposure", fmt::format("\"{}\" is neither auto nor an exposure value at ISO 100", given.exposure),
                         "Write auto, or a number such as 14."};
        wishes.exposure = exposure_of_ev100(*ev);
    }
    for (const std::string& path : given.outputs) {
        const std::string extension = std::filesystem::path(path).extension().string();
        if (extension != ".exr" && extension != ".png")
            return Error{path, "is neither a .exr nor a .png file", "End the name in .exr (light) or .png (a picture for the screen)."};
        if (extension == ".png" && *space != RgbSpace::srgb)
            return Error{path, "is a PNG file, which holds sRGB only", "Write --space srgb, or a .exr file."};
        if (const Result<Done> possible = can_write(path); !possible) return possible.error();
    }
    return wishes;
}

Result<double> metered(const Image& image, const Wishes& wishes, const RgbConverter& converter) {
    std::vector<float> luminance, weight;
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const std::span<const float> rgb = image.pixel(column, row);
            luminance.push_back(static_cast<float>(std::max(0.0, converter.luminance({rgb[0], rgb[1], rgb[2]}))));
            weight.push_back(static_cast<float>(pixel_solid_angle(wishes.projection, column, row)));
        }
    // A sky looks like one when its middle is well above the grey of a sunlit street.
    return metered_exposure(luminance, weight, {.grey = 0.4});
}

Result<Done> write(const std::string& path, const Image& image, const SkyOptions& given, const Wishes& wishes, double exposure,
                   const std::vector<std::string>& decisions) {
    if (std::filesystem::path(path).extension() == ".exr") {
        ImageMeaning meaning = ImageMeaning::rgb(wishes.space);
        meaning.notes = {{"airlight:atmosphere", given.inputs.air.atmosphere},
                         {"airlight:model", given.inputs.model},
                         {"airlight:sun_zenith_deg", fmt::format("{:.4f}", wishes.scene.sun_zenith / deg)}};
        for (std::size_t i = 0; i < decisions.size(); ++i)
            meaning.notes.push_back({fmt::format("airlight:weather{}", i + 1), decisions[i]});
        return write_exr(path, image, meaning, ExrPixels::float16);
    }
    return write_png(path, developed(image, exposure, wishes.tone), given.bits == 8 ? PngBits::eight : PngBits::sixteen);
}

void print_row(std::string_view quantity, const std::string& value, std::string_view unit) {
    fmt::print("{},{},{}\n", quantity, value, unit);
}

Result<Done> print_table(const AskedSky& asked, const Wishes& wishes, const ColourWeights& weights,
                         const std::vector<std::string>& decisions) {
    const Result<IrradianceEstimate> light = asked.sky->irradiance(wishes.scene.altitude, wishes.scene.sun_zenith);
    if (!light) return light.error();
    const Result<RadianceEstimate> zenith = asked.sky->radiance({wishes.scene.altitude, 0.0, wishes.scene.sun_zenith, 0.0});
    if (!zenith) return zenith.error();
    const Result<std::vector<double>> seen = asked.sky->sunlight_transmittance(wishes.scene.altitude, wishes.scene.sun_zenith);
    if (!seen) return seen.error();
    std::vector<double> normal(seen->size());
    for (std::size_t i = 0; i < normal.size(); ++i)
        normal[i] = (*seen)[i] * asked.atmosphere.sun.irradiance.at(asked.wavelengths[static_cast<int>(i)]).value;
    const double sunlight = wishes.scene.sunlight;
    const auto colour = [&](const std::vector<double>& spectrum) { return sunlight * weights.to_xyz(std::span<const double>(spectrum)); };
    const Xyz direct = colour(light->direct_W_m2_nm);
    const Xyz diffuse = colour(light->diffuse_W_m2_nm);
    for (const std::string& line : decisions) fmt::print("# {}\n", line);
    fmt::print("quantity,value,unit\n");
    print_row("sun zenith angle", fmt::format("{:.4f}", wishes.scene.sun_zenith / deg), "deg");
    print_row("sun azimuth", fmt::format("{:.4f}", wishes.scene.sun_azimuth / deg), "deg");
    print_row("direct normal illuminance", fmt::format("{:.6g}", colour(normal).y), "lx");
    print_row("direct horizontal illuminance", fmt::format("{:.6g}", direct.y), "lx");
    print_row("diffuse horizontal illuminance", fmt::format("{:.6g}", diffuse.y), "lx");
    print_row("global horizontal illuminance", fmt::format("{:.6g}", direct.y + diffuse.y), "lx");
    print_row("zenith luminance", fmt::format("{:.6g}", colour(zenith->radiance_W_m2_sr_nm).y), "cd m-2");
    if (const auto temperature = correlated_colour_temperature(direct + diffuse))
        print_row("correlated colour temperature of daylight", fmt::format("{:.0f}", temperature->kelvin), "K");
    return Done{};
}

Result<Done> run(const SkyOptions& given) {
    const Interrupt interrupt;
    const Result<Wishes> wishes = wishes_of(given);
    if (!wishes) return wishes.error();
    ProgressLine line(given.inputs.quiet);
    const Progress progress = line.progress(interrupt.token());
    const Result<AskedSky> asked = asked_sky(given.inputs, progress);
    if (!asked) return asked.error();
    const ColourWeights weights(asked->wavelengths, asked->atmosphere.sun.irradiance);
    const RgbConverter converter(wishes->space, wishes->white);
    if (!given.outputs.empty()) {
        const Result<Image> image =
            sky_image(*asked->sky, asked->atmosphere.sun, wishes->scene, wishes->projection, weights, converter, progress);
        if (!image) return image.error();
        double exposure = 1.0;
        if (wishes->exposure) {
            exposure = *wishes->exposure;
        } else {
            const Result<double> found = metered(*image, *wishes, converter);
            // A black sky (deep night) has nothing to meter: any exposure shows it black.
            if (found) exposure = *found;
        }
        for (const std::string& path : given.outputs)
            if (const Result<Done> written = write(path, *image, given, *wishes, exposure, asked->decisions); !written)
                return written.error();
    }
    if (const Result<Done> printed = print_table(*asked, *wishes, weights, asked->decisions); !printed) return printed.error();
    for (const std::string& path : given.outputs) print_row("file", path, "");
    return Done{};
}

}  // namespace

Command sky_command(CLI::App& airlight) {
    const auto given = std::make_shared<SkyOptions>();
    CLI::App* sky =
        airlight.add_subcommand("sky", "Compute the sky over a place at a time under a weather report: pictures and illuminances.");
    CLI::Option* lat = sky->add_option("--lat", given->latitude_deg, "geodetic latitude, north positive, -90 to 90")->option_text("<deg>");
    CLI::Option* lon = sky->add_option("--lon", given->longitude_deg, "longitude, east positive, -180 to 180")->option_text("<deg>");
    CLI::Option* time =
        sky->add_option("--time", given->time, "ISO 8601, UTC unless it ends in an offset; with --lat and --lon")->option_text("<time>");
    time->needs(lat)->needs(lon);
    sky->add_option("--sun", given->sun_deg, "instead of place and time: zenith angle of the sun, 0 to 180")
        ->option_text("<deg>")
        ->capture_default_str()
        ->excludes(time);
    sky->add_option("--sun-azimuth", given->sun_azimuth_deg, "and its azimuth from north, clockwise")
        ->option_text("<deg>")
        ->capture_default_str()
        ->excludes(time);
    sky->add_option("--altitude-m", given->altitude_m, "height of the eye above the ground, 0 or more; space is fine")
        ->option_text("<m>")
        ->capture_default_str();
    sky->add_option("-o,--output", given->outputs, "a .exr (light in cd m-2) or .png file; may be given several times")
        ->option_text("<file>");
    sky->add_option("--projection", given->projection, "fisheye, sphere, perspective or cube")
        ->option_text("<name>")
        ->capture_default_str();
    sky->add_option("--size", given->size, "width in pixels (of a face, for cube)")->option_text("<n>")->capture_default_str();
    sky->add_option("--heading", given->heading_deg, "perspective: azimuth looked at")->option_text("<deg>")->capture_default_str();
    sky->add_option("--pitch", given->pitch_deg, "perspective: angle above the horizon")->option_text("<deg>")->capture_default_str();
    sky->add_option("--field", given->field_deg, "perspective: vertical field of view")->option_text("<deg>")->capture_default_str();
    sky->add_option("--exposure", given->exposure, "of PNG files: auto, or an exposure value at ISO 100 (15: a sunny day)")
        ->option_text("<auto|EV>")
        ->capture_default_str();
    sky->add_option("--tone", given->tone, "of PNG files: linear, exponential, reinhard or filmic")
        ->option_text("<curve>")
        ->capture_default_str();
    sky->add_option("--bits", given->bits, "of PNG files: 8 or 16")->option_text("<n>")->capture_default_str();
    sky->add_option("--space", given->space, "primaries: srgb, rec2020 or acescg")->option_text("<name>")->capture_default_str();
    sky->add_option("--white", given->white, "the light that looks white: D65, D60, E or sun")
        ->option_text("<name>")
        ->capture_default_str();
    sky->add_flag("--no-disk", given->no_disk, "leave the sun's disk out of the picture");
    add_sky_inputs(*sky, given->inputs);
    sky->footer(help_footer("lines that begin with # (what the weather report led to), then CSV: quantity, value, unit; last, the files.",
                            "airlight sky earth-clear --lat 46.5 --lon 8 --time 2026-06-21T16:00Z --sizes 16x8x16x8 --orders 3 --cache "
                            "tables --size 64 -o sky.png"));
    return {sky, [given] { return run(*given); }};
}

}  // namespace airlight::cli
