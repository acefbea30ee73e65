#include "render/shadow_cascades.h"

#include <algorithm>
#include <cmath>

#include "terrain/tile.h"

namespace airlight::render {

namespace {

constexpr double first_m = 64.0, ratio = 4.0;
// Of a filter's reach, and of the step to a whole texel: on each side of the square.
constexpr int margin_texels = 4;

// The smallest ball about a point of the view's axis that holds what lies between two distances from the eye and within `angle` of it.
struct Ball {
    double along_m, radius_m;
};
Ball ball_of(double from_m, double to_m, double angle) {
    const double along = std::min(0.5 * (from_m + to_m) / std::cos(angle), to_m * std::cos(angle));
    return {along, std::sqrt(std::max(0.0, along * along + to_m * to_m - 2.0 * along * to_m * std::cos(angle)))};
}

// From a sphere of one radius to the horizon of one within it.
double tangent_m(double r, double within) { return std::sqrt(std::max(0.0, (r - within) * (r + within))); }

Interval ground_radii(const HeightField& field) {
    const double least = field.sea ? std::max(0.0, field.whole.low) : field.whole.low;
    return {field.radius_m + least, field.radius_m + std::max(least, field.whole.high)};
}

Cascade cascade_of(double from_m, double to_m, const Camera& camera, const LightAxes& axes, double caster_m, int texels) {
    const HalfSize half = half_size(camera);
    const Ball ball = ball_of(from_m, to_m, std::atan(std::hypot(half.width, half.height)));
    const double texel = 2.0 * ball.radius_m / (texels - 2 * margin_texels);
    const Vec3 middle = ball.along_m * camera.forward;
    // The square's corner is a whole number of texels from the planet's centre.
    const auto whole = [&](Vec3 axis) {
        const double eye = glm::dot(camera.eye, axis);
        return std::floor((eye + glm::dot(middle, axis)) / texel) * texel - eye;
    };
    const double along = glm::dot(middle, axes.towards_sun);
    return {from_m,
            to_m,
            {whole(axes.right), whole(axes.up), along},
            0.5 * texels * texel,
            texel,
            along - ball.radius_m - texel,
            along + ball.radius_m + caster_m};
}

}  // namespace

LightAxes light_axes(Vec3 towards_sun) {
    const Vec3 beside = std::abs(towards_sun.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0);
    const Vec3 right = glm::normalize(glm::cross(beside, towards_sun));
    return {right, glm::cross(towards_sun, right), towards_sun};
}

std::vector<Cascade> cascades(const Camera& camera, const LightAxes& axes, const HeightField& field, int texels) {
    const double r = glm::length(camera.eye);
    const Interval ground = ground_radii(field);
    const double nearest = r - ground.high;
    const double farthest = tangent_m(std::max(r, ground.low), ground.low) + tangent_m(ground.high, ground.low);
    // The longest way of light over the ground, from peak to peak.
    const double caster = 2.0 * tangent_m(ground.high, ground.low);
    std::vector<Cascade> all;
    double from = 0.0;
    for (double to = first_m; from < farthest && static_cast<int>(all.size()) < most_cascades; from = to, to *= ratio)
        if (to > nearest) all.push_back(cascade_of(from, to, camera, axes, caster, texels));
    return all;
}

std::vector<HalfSpace> casters_within(const Cascade& c, const Camera& camera, const LightAxes& axes) {
    std::vector<HalfSpace> within;
    for (const auto& [axis, middle] : {std::pair{axes.right, c.centre.x}, {axes.up, c.centre.y}})
        for (const double side : {1.0, -1.0}) within.push_back({side * axis, camera.eye + (middle - side * c.half_width_m) * axis});
    within.push_back({axes.towards_sun, camera.eye + c.lowest_m * axes.towards_sun});
    for (const Vec3& inward : frustum(camera))
        if (glm::dot(inward, axes.towards_sun) >= 0.0) within.push_back({inward, camera.eye});
    return within;
}

int finest_level(const Cascade& c, double radius_m) {
    int level = 0;
    while (level < deepest_level && spacing_m(level, radius_m) > c.texel_m) ++level;
    return level;
}

}  // namespace airlight::render
