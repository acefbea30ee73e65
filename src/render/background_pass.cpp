#include "render/background_pass.h"

#include <epoxy/gl.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "celestial/night_sky.h"
#include "render/shaders.h"
#include "spectrum/colour.h"
#include "terrain/cube_sphere.h"

namespace airlight::render {

namespace {

using Four = std::array<float, 4>;

constexpr int bending_places = 96;
constexpr unsigned block_binding = 1;

Four four(Vec3 v, double w = 0.0) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

// `uniform Background` of src/render/shaders/background.glsl.
struct Block {
    Four eye_up, towards_sun;
    std::array<Four, 3> sun_radiance;
    Four towards_moon, moon_to_sun, moon_lit, moon_dark, pixel;
    Four beyond, airglow, glowing_shell;
};

void set_night_sky(Block& block, const Camera& camera, const Atmosphere* air) {
    const NightLight light = night_light();
    block.beyond = four(light.beyond);
    if (!air) return;
    const double bottom_m = air->bottom_radius.in(m);
    block.airglow = four(light.airglow);
    block.glowing_shell = four({bottom_m, airglow_bottom.in(m), airglow_top.in(m)}, glm::length(camera.eye) - bottom_m);
}

std::vector<Four> light_of(std::span<const Star> stars) {
    const RgbConverter converter(RgbSpace::srgb, WhitePoint::d65);
    std::vector<Four> light;
    for (const Star& star : stars) {
        const Rgb rgb = converter.to_rgb(star.illuminance);
        light.push_back(four(star.direction));
        light.push_back(four({rgb.r, rgb.g, rgb.b}));
    }
    return light;
}

// Whether something of an angular radius may be in the picture, however air bends the rays to it: by 0.02 at most.
bool may_see(const Camera& camera, Vec3 towards, double radius) {
    const HalfSize half = half_size(camera);
    return angle_between(camera.forward, towards) < std::atan(std::hypot(half.width, half.height)) + radius + 0.03;
}

}  // namespace

// Without air the lowest ray is that of the caller's planet: what it hides is hidden by its surface.
BendingTable bending_to(const Atmosphere* air, double radius_m) {
    if (!air) return {-0.5 * pi, std::vector<double>(2, 0.0)};
    return bending_table(*air, std::max(radius_m - air->bottom_radius.in(m), 0.0) * m, bending_places);
}

Result<BackgroundPass> BackgroundPass::create(int width, int height, std::span<const Star> stars) {
    Result<gpu::Program> disks = program("fullscreen.vert", "background.frag");
    if (!disks) return disks.error();
    Result<gpu::Program> points = program("stars.vert", "stars.frag");
    if (!points) return points.error();
    Result<gpu::Program> night = program("fullscreen.vert", "night_sky.frag");
    if (!night) return night.error();
    gpu::Texture radiance({width, height});
    Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&radiance});
    if (!target) return target.error();
    BackgroundPass pass(std::move(*disks), std::move(*points), std::move(*night), std::move(radiance), std::move(*target));
    pass.take(stars);
    return pass;
}

BackgroundPass::BackgroundPass(gpu::Program disks, gpu::Program points, gpu::Program night, gpu::Texture radiance, gpu::Framebuffer target)
    : disks_(std::move(disks)),
      points_(std::move(points)),
      night_(std::move(night)),
      radiance_(std::move(radiance)),
      target_(std::move(target)),
      block_(sizeof(Block)) {}

void BackgroundPass::take(std::span<const Star> stars) {
    const std::vector<Four> light = light_of(stars);
    if (!light.empty()) stars_ = gpu::Buffer(std::as_bytes(std::span(light)));
    star_count_ = static_cast<int>(stars.size());
}

void BackgroundPass::draw(const Camera& camera, const Heavens& heavens, const BendingTable& bending, const Atmosphere* air) {
    const std::array<RgbLight, 3> sun = sun_radiance(heavens);
    const std::optional<MoonSeen> moon = moon_seen(heavens, camera.eye);
    Block block{.eye_up = four(glm::normalize(camera.eye), bending.horizon),
                .towards_sun = four(heavens.towards_sun, sun_radius(heavens)),
                .sun_radiance = {four(sun[0]), four(sun[1]), four(sun[2])},
                .towards_moon = {},
                .moon_to_sun = {},
                .moon_lit = {},
                .moon_dark = {},
                .pixel = {static_cast<float>(1.0 / pixels_per_radian(camera)), static_cast<float>(camera.width),
                          static_cast<float>(camera.height), 0.0f},
                .beyond = {},
                .airglow = {},
                .glowing_shell = {}};
    if (heavens.night_sky) set_night_sky(block, camera, air);
    if (moon) {
        block.towards_moon = four(moon->towards, moon->angular_radius);
        block.moon_to_sun = four(moon->to_sun);
        block.moon_lit = four(moon->lit);
        block.moon_dark = four(moon->dark);
    }
    block_.write(std::as_bytes(std::span(&block, 1)));
    block_.bind_uniform(block_binding);
    const std::vector<float> texels(bending.bending.begin(), bending.bending.end());
    const gpu::Texture bends({static_cast<int>(texels.size()), 1}, texels, gpu::TextureFormat::r32f);
    bends.bind_sampler(0);
    target_.bind();
    glDisable(GL_DEPTH_TEST);
    if (may_see(camera, heavens.towards_sun, 20.0 * sun_radius(heavens)) ||
        (moon && may_see(camera, moon->towards, moon->angular_radius))) {
        disks_.use();
        nothing_.draw_triangles(3);
    } else if (heavens.night_sky) {
        night_.use();
        nothing_.draw_triangles(3);
    } else {
        target_.clear_colour(0, 0.0f, 0.0f, 0.0f, 1.0f);
    }
    if (star_count_ == 0) return;
    stars_.bind_storage(0);
    points_.use();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glEnable(GL_PROGRAM_POINT_SIZE);
    nothing_.draw_points(star_count_);
    glDisable(GL_PROGRAM_POINT_SIZE);
    glDisable(GL_BLEND);
}

}  // namespace airlight::render
