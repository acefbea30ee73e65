#include "render/shadow_cascades.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "terrain/tile.h"

namespace airlight::render {

namespace {

constexpr double first_m = 64.0, ratio = 4.0;
// Of a filter's reach: on each side of the square.
constexpr int margin_texels = 4;

// A ninth of the sun's disk, as an angle.
constexpr double penumbra_share = 1e-3;

// The smallest ball about a point of the view's axis that holds what lies between two distances from the eye and within `angle` of it.
struct PartOfView {
    double along_m, radius_m;
};
PartOfView part_of_view(double from_m, double to_m, double angle) {
    const double along = std::min(0.5 * (from_m + to_m) / std::cos(angle), to_m * std::cos(angle));
    return {along, std::sqrt(std::max(0.0, along * along + to_m * to_m - 2.0 * along * to_m * std::cos(angle)))};
}

// From a sphere of one radius to the horizon of one within it.
double tangent_m(double r, double within) { return std::sqrt(std::max(0.0, (r - within) * (r + within))); }

Interval ground_radii(const HeightField& field) {
    const double least = field.sea ? std::max(0.0, field.whole.low) : field.whole.low;
    return {field.radius_m + least, field.radius_m + std::max(least, field.whole.high)};
}

double nearest_multiple(double x, double step) { return std::round(x / step) * step; }
Vec3 nearest_multiple(Vec3 x, double step) {
    return {nearest_multiple(x.x, step), nearest_multiple(x.y, step), nearest_multiple(x.z, step)};
}

Cascade cascade_of(int level, double to_m, const Camera& camera, const LightAxes& axes, double caster_m, int texels) {
    const double from_m = level == 0 ? 0.0 : to_m / ratio;
    const HalfSize half = half_size(camera);
    const PartOfView ball = part_of_view(from_m, to_m, std::atan(std::hypot(half.width, half.height)));
    const int texels_of_step = texels / 9;
    const double texel = 2.0 * ball.radius_m / (texels - 2 * margin_texels - texels_of_step), step = texels_of_step * texel;
    const Vec3 middle = camera.eye + ball.along_m * camera.forward;
    const Vec3 centre =
        nearest_multiple(Vec3(glm::dot(middle, axes.right), glm::dot(middle, axes.up), glm::dot(middle, axes.towards_sun)), step);
    return {level,
            from_m,
            to_m,
            nearest_multiple(camera.eye, to_m / 32.0),
            centre,
            0.5 * texels * texel,
            texel,
            centre.z - 0.5 * texels * texel,
            centre.z + 0.5 * texels * texel + caster_m};
}

}  // namespace

LightAxes light_axes(Vec3 towards_sun) {
    const Vec3 beside = std::abs(towards_sun.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0);
    const Vec3 right = glm::normalize(glm::cross(beside, towards_sun));
    return {right, glm::cross(towards_sun, right), towards_sun};
}

Vec3 settled_sun(Vec3 towards_sun) { return glm::normalize(nearest_multiple(towards_sun, 1e-4)); }

std::vector<Cascade> cascades(const Camera& camera, const LightAxes& axes, const HeightField& field, int texels,
                              std::span<const Ball> objects) {
    const double r = glm::length(camera.eye);
    const Interval ground = ground_radii(field);
    double nearest = r - ground.high;
    double farthest = tangent_m(std::max(r, ground.low), ground.low) + tangent_m(ground.high, ground.low);
    for (const Ball& object : objects) {
        const double distance = glm::length(object.centre - camera.eye);
        nearest = std::min(nearest, distance - object.radius_m);
        farthest = std::max(farthest, distance + object.radius_m);
    }
    // The longest way of light over the ground, from peak to peak.
    const double caster = 2.0 * tangent_m(ground.high, ground.low);
    std::vector<Cascade> all;
    double to = first_m;
    for (int level = 0; (level == 0 || to / ratio < farthest) && static_cast<int>(all.size()) < most_cascades; ++level, to *= ratio)
        if (to > nearest) all.push_back(cascade_of(level, to, camera, axes, caster, texels));
    return all;
}

PatchChoice casters_of(const Cascade& c, const LightAxes& axes, const HeightField& field) {
    const auto from = [](Vec3 axis, double least) { return HalfSpace{axis, axis * least}; };
    const std::array<HalfSpace, 5> column = {from(axes.right, c.centre.x - c.half_width_m), from(-axes.right, -c.centre.x - c.half_width_m),
                                             from(axes.up, c.centre.y - c.half_width_m), from(-axes.up, -c.centre.y - c.half_width_m),
                                             from(axes.towards_sun, c.lowest_m)};
    const double texel_m = c.texel_m, top_m = c.centre.z + c.half_width_m;
    return {.culled = [column](const NodeBounds& b) { return outside(b, column); },
            .fine_enough =
                [&field, texel_m, top_m, towards_sun = axes.towards_sun](const Node& node, const NodeBounds& b) {
                    const double spacing = spacing_m(node.level, field.radius_m), above = -farthest_along(b, -towards_sun) - top_m;
                    return spacing <= texel_m ||
                           error_m(field, spacing, b.radii_m.high - b.radii_m.low) <= std::max(0.5 * texel_m, penumbra_share * above);
                }};
}

}  // namespace airlight::render
