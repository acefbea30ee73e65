#include "sheet.h"

#include <fmt/format.h>

#include "image/exposure.h"
#include "image/png.h"
#include "image/tone.h"
#include "models/model.h"

namespace airlight::figures {

namespace {

ColourWeights weights_of(const ShownSky& sky) { return {WavelengthGrid::standard(), sky.atmosphere.sun.irradiance}; }

Result<Done> write_picture(const Settings& settings, const std::filesystem::path& path, const Shot& shot, const ShownSky& sky) {
    Perspective camera = shot.camera;
    camera.height = settings.picture_width * camera.height / camera.width;
    camera.width = settings.picture_width;
    const Result<Image> image = sky_image(*sky.sky, sky.atmosphere.sun, shot.scene, camera, weights_of(sky),
                                          RgbConverter(RgbSpace::srgb, WhitePoint::d65), settings.progress);
    if (!image) return image.error();
    return write_png(path, developed(*image, exposure_of_ev100(shot.ev100), ToneCurve::exponential));
}

}  // namespace

Result<ShownSky> shown_sky(const Settings& settings, std::string_view model, const Atmosphere& atmosphere, int orders) {
    ModelOptions options;
    options.bake = settings.bake;
    options.bake.orders = orders;
    options.cache.folder = settings.folder / "tables";
    options.progress = settings.progress;
    const WavelengthGrid grid = WavelengthGrid::standard();
    Result<std::unique_ptr<Sky>> sky = make_sky(model, atmosphere, {grid.begin(), grid.end()}, options);
    if (!sky) return sky.error();
    return ShownSky{atmosphere, std::move(*sky)};
}

Result<double> luminance(const ShownSky& sky, const View& view) {
    const Result<RadianceEstimate> seen = sky.sky->radiance(view);
    if (!seen) return seen.error();
    return weights_of(sky).to_xyz(std::span<const double>(seen->radiance_W_m2_sr_nm)).y;
}

Result<Table> sheet(const Settings& settings, std::string_view name, const std::vector<Shot>& shots,
                    const std::vector<Variation>& variations) {
    Table table{{"row", "column", "eye_km", "luminance_cd_m2"}, {}};
    for (std::size_t row = 0; row < shots.size(); ++row)
        for (std::size_t column = 0; column < variations.size(); ++column) {
            const Shot& shot = shots[row];
            const ShownSky& sky = variations[column].sky;
            const std::filesystem::path path = settings.folder / fmt::format("{}-{}-{}.png", name, row, column);
            if (const Result<Done> written = write_picture(settings, path, shot, sky); !written) return written.error();
            const Result<double> noted =
                luminance(sky, {shot.scene.altitude, shot.probe_zenith, shot.scene.sun_zenith, shot.probe_azimuth});
            if (!noted) return noted.error();
            table.rows.push_back({{shot.name, variations[column].name}, {shot.scene.altitude.in(km), *noted}});
        }
    return table;
}

}  // namespace airlight::figures
