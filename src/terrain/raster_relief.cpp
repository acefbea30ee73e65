#include "terrain/raster_relief.h"

#include <algorithm>
#include <cmath>

namespace airlight {

namespace {

double smooth_step(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double latitude_of(Vec3 d) { return std::atan2(d.z, std::hypot(d.x, d.y)); }
double longitude_of(Vec3 d) { return std::atan2(d.y, d.x); }

class Ground {
public:
    Ground(std::shared_ptr<const Raster> raster, const RasterRelief& relief, HeightField outside)
        : raster_(std::move(raster)), relief_(relief), outside_(std::move(outside)) {
        const double pixel_m = raster_->pixel() * relief_.radius_m;
        detail_ = {2.0 * pixel_m, 2.0 * pixel_m * relief_.detail_share, relief_.detail_smoothness, relief_.detail_narrowest_m,
                   relief_.seed};
    }

    // height = base + share * noise; its slope is the base's and the share's, by differences, and the noise's own.
    HeightSample sample(Vec3 d, double width_m) const {
        const Base at = base_at(d);
        const NoiseRelief noise =
            at.share > 0.0 ? noise_relief(detail_, relief_.radius_m, d, width_m) : NoiseRelief{0.0, Vec3(0.0), Vec3(0.0), Vec3(0.0)};
        const auto slope = [&](double width, Vec3 of_noise) {
            const BaseSlope base = slope_of_base(d, width);
            return base.of_base + noise.height_m * base.of_share + at.share * of_noise;
        };
        return {at.height_m + at.share * noise.height_m, slope(width_m, noise.slope), slope(2.0 * width_m, noise.coarse_slope),
                slope(broad_width_m, noise.broad_slope)};
    }

    Interval range(const Cap& cap) const {
        const GeographicRange at = geographic_range(cap);
        const Interval base = base_range(cap, at), noise = noise_relief_range(detail_, relief_.radius_m, cap);
        const double low = share_at(base.low), high = share_at(base.high);
        const double least = base.low < 0.0 && base.high > 0.0 ? share_at(0.0) : std::min(low, high);
        const Interval shares = {least, std::max(low, high)};
        const Interval inside = {base.low + std::min(shares.low * noise.low, shares.high * noise.low),
                                 base.high + std::max(shares.low * noise.high, shares.high * noise.high)};
        if (all_within(at)) return inside;
        const Interval other = outside_.range(cap);
        return {std::min(inside.low, other.low), std::max(inside.high, other.high)};
    }

    double detail(double spacing_m) const {
        const double fine = noise_relief_detail(detail_, spacing_m);
        if (spacing_m <= 2.0 * detail_.wavelength_m) return fine;
        return std::min(2000.0, detail_.amplitude_m * std::pow(spacing_m / detail_.wavelength_m, detail_.smoothness));
    }

private:
    // Of the detail at a height; nowhere less than at 0 m, and growing from there.
    double share_at(double height_m) const {
        const double high = smooth_step(height_m / relief_.detail_full_at_m);
        return (relief_.detail_least + (1.0 - relief_.detail_least) * high) *
               (relief_.sea ? smooth_step(std::abs(height_m) / relief_.detail_shore_m) : 1.0);
    }

    // Whether all of a place lies within the raster, beside its edges, which are eight pixels wide: a narrower place between them does if its
    // corners do.
    bool all_within(const GeographicRange& at) const {
        const bool everywhere =
            raster_->presence(0.0, pi) == 1.0 && raster_->presence(pi / 2, 0.0) == 1.0 && raster_->presence(-pi / 2, 0.0) == 1.0;
        const bool narrow = at.longitudes.high - at.longitudes.low < 8.0 * raster_->narrowest_pixel(0.0);
        const auto present = [&](double latitude, double longitude) { return raster_->presence(latitude, longitude) == 1.0; };
        return everywhere || (narrow && present(at.latitudes.low, at.longitudes.low) && present(at.latitudes.low, at.longitudes.high) &&
                              present(at.latitudes.high, at.longitudes.low) && present(at.latitudes.high, at.longitudes.high));
    }

    // Of the raster's heights, which within a cap narrower than a pixel change by less than from one pixel to the next: a cubic through pixels
    // of some range has at most 1.5 times it as its slope, by 1.25 for the weights across, along each of two axes.
    Interval base_range(const Cap& cap, const GeographicRange& at) const {
        constexpr double steepest = 1.5 * 1.25 * 1.4143;
        const Interval around = raster_->range(at.latitudes, at.longitudes);
        const double pixel = raster_->narrowest_pixel(std::max(std::abs(at.latitudes.low), std::abs(at.latitudes.high)));
        if (2.0 * steepest * cap.angle >= pixel) return around;
        const double change = steepest * (around.high - around.low) * cap.angle / pixel;
        const double middle = raster_->height_m(latitude_of(cap.centre), longitude_of(cap.centre));
        return {std::max(around.low, middle - change), std::min(around.high, middle + change)};
    }

    // What changes slowly: the raster's height, or what is outside of it, and the share of detail.
    struct Base {
        double height_m, share;
    };
    struct BaseSlope {
        Vec3 of_base, of_share;
    };

    Base base_at(Vec3 d) const {
        const double latitude = latitude_of(d), longitude = longitude_of(d), presence = raster_->presence(latitude, longitude);
        if (presence == 0.0) return {outside_.sample(d, 1.0).height_m, 0.0};
        const double height = raster_->height_m(latitude, longitude);
        const double share = share_at(height);
        if (presence == 1.0) return {height, share};
        return {glm::mix(outside_.sample(d, 1.0).height_m, height, presence), presence * share};
    }

    // The difference quotient over a width: what is narrower has no part in it.
    BaseSlope slope_of_base(Vec3 d, double width_m) const {
        const Vec3 east = glm::normalize(glm::cross(std::abs(d.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0), d)), north = glm::cross(d, east);
        const double step = 0.5 * width_m, turn = step / relief_.radius_m;
        BaseSlope slope{Vec3(0.0), Vec3(0.0)};
        for (const Vec3& e : {east, north}) {
            const Base there = base_at(glm::normalize(d + e * turn)), back = base_at(glm::normalize(d - e * turn));
            slope.of_base += e * ((there.height_m - back.height_m) / (2.0 * step));
            slope.of_share += e * ((there.share - back.share) / (2.0 * step));
        }
        return slope;
    }

    std::shared_ptr<const Raster> raster_;
    RasterRelief relief_;
    HeightField outside_;
    Octaves detail_{};
};

}  // namespace

GeographicRange geographic_range(const Cap& cap) {
    const double latitude = latitude_of(cap.centre), longitude = longitude_of(cap.centre);
    const Interval latitudes{std::max(-pi / 2, latitude - cap.angle), std::min(pi / 2, latitude + cap.angle)};
    if (latitude + cap.angle >= pi / 2 || latitude - cap.angle <= -pi / 2) return {latitudes, {-pi, pi}};
    const double half = std::asin(std::min(1.0, std::sin(cap.angle) / std::cos(latitude)));
    return {latitudes, {longitude - half, longitude + half}};
}

HeightField level_height(double radius_m) {
    return {.radius_m = radius_m,
            .sample =
                [](Vec3, double) {
                    return HeightSample{0.0, Vec3(0.0), Vec3(0.0), Vec3(0.0)};
                },
            .range = [](const Cap&) { return Interval{}; },
            .detail = [](double) { return 0.0; },
            .whole = {},
            .sea = false};
}

HeightField raster_height(std::shared_ptr<const Raster> raster, const RasterRelief& relief, HeightField outside) {
    const auto ground = std::make_shared<const Ground>(std::move(raster), relief, std::move(outside));
    return {.radius_m = relief.radius_m,
            .sample = [ground](Vec3 d, double width_m) { return ground->sample(d, width_m); },
            .range = [ground](const Cap& cap) { return ground->range(cap); },
            .detail = [ground](double spacing_m) { return ground->detail(spacing_m); },
            .whole = ground->range({Vec3(0, 0, 1), pi}),
            .sea = relief.sea};
}

}  // namespace airlight
