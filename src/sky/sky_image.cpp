#include "sky/sky_image.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/parallel.h"

namespace airlight {

namespace {

constexpr int samples_across = 6;  // of a pixel that the sun's disk may touch

class Painter {
public:
    Painter(const Sky& sky, const SkyDome& dome, const Sun& sun, const SkyScene& scene, const Projection& projection,
            const ColourWeights& weights)
        : sky_(sky), dome_(dome), sun_(sun), scene_(scene), projection_(projection), weights_(weights) {
        to_sun_ = sky_direction({scene.sun_azimuth, scene.sun_zenith});
    }

    // The colour of a pixel; black where it sees nothing.
    Xyz pixel(int column, int row, std::vector<float>& radiance) const {
        const std::optional<Vec3> view = direction(projection_, {column + 0.5, row + 0.5});
        if (!view) return {0.0, 0.0, 0.0};
        const SkyAngles angles = sky_angles(*view);
        dome_.radiance(angles.zenith, angles.azimuth - scene_.sun_azimuth, radiance);
        Xyz colour = weights_.to_xyz(std::span<const float>(radiance));
        if (scene_.sun_disk && touches_sun(*view, column, row)) colour = colour + disk_in_pixel(column, row);
        return scene_.sunlight * colour;
    }

private:
    bool touches_sun(const Vec3& view, int column, int row) const {
        const double pixel_radius = std::sqrt(pixel_solid_angle(projection_, column, row));  // generous: 1.8 times that of the circle
        return std::acos(std::clamp(glm::dot(view, to_sun_), -1.0, 1.0)) < sun_.angular_radius + pixel_radius;
    }

    Xyz disk_in_pixel(int column, int row) const {
        Xyz sum{0.0, 0.0, 0.0};
        for (int j = 0; j < samples_across; ++j)
            for (int i = 0; i < samples_across; ++i) {
                const std::optional<Vec3> view =
                    direction(projection_, {column + (i + 0.5) / samples_across, row + (j + 0.5) / samples_across});
                if (view) sum = sum + disk(*view);
            }
        return 1.0 / (samples_across * samples_across) * sum;
    }

    // The disk's colour in a direction, through the air.
    Xyz disk(const Vec3& view) const {
        const double angle = std::acos(std::clamp(glm::dot(view, to_sun_), -1.0, 1.0));
        if (!(angle < sun_.angular_radius)) return {0.0, 0.0, 0.0};
        const double zenith = sky_angles(view).zenith;
        const Result<std::vector<double>> seen = sky_.sunlight_transmittance(scene_.altitude, zenith);
        std::vector<double> radiance = sun_disk_radiance(sun_, sky_.wavelengths(), angle);
        for (std::size_t w = 0; w < radiance.size(); ++w) radiance[w] *= seen ? (*seen)[w] : 0.0;
        return weights_.to_xyz(std::span<const double>(radiance));
    }

    const Sky& sky_;
    const SkyDome& dome_;
    const Sun& sun_;
    const SkyScene& scene_;
    const Projection& projection_;
    const ColourWeights& weights_;
    Vec3 to_sun_;
};

}  // namespace

Result<Image> sky_image(const Sky& sky, const Sun& sun, const SkyScene& scene, const Projection& projection, const ColourWeights& weights,
                        const RgbConverter& converter, const Progress& progress) {
    if (const Result<Done> ok = check(projection); !ok) return ok.error();
    const Result<std::unique_ptr<SkyDome>> dome = sky.dome(scene.altitude, scene.sun_zenith);
    if (!dome) return dome.error();
    const ImageSize size = image_size(projection);
    Image image(size.width, size.height, 3);
    const Painter painter(sky, **dome, sun, scene, projection, weights);
    std::atomic<int> rows_done = 0;
    parallel_for(static_cast<std::size_t>(size.height), [&](std::size_t row) {
        if (progress.stop.stop_requested()) return;
        std::vector<float> radiance(sky.wavelengths().size());
        for (int column = 0; column < size.width; ++column) {
            const Rgb rgb = converter.into_gamut(converter.to_rgb(painter.pixel(column, static_cast<int>(row), radiance)));
            const std::span<float> out = image.pixel(column, static_cast<int>(row));
            out[0] = static_cast<float>(std::max(rgb.r, 0.0));  // rounding may leave -0
            out[1] = static_cast<float>(std::max(rgb.g, 0.0));
            out[2] = static_cast<float>(std::max(rgb.b, 0.0));
        }
        progress.report("painting", static_cast<double>(++rows_done) / size.height);
    });
    if (progress.stop.stop_requested()) return Error{"", "the picture was interrupted", ""};
    return image;
}

}  // namespace airlight
