#include "render/frame.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace airlight::render {

namespace {

// Rows of the GPU go upward, those of an image downward.
Image image_of(const gpu::Texture& radiance) {
    const int width = radiance.size().width, height = radiance.size().height;
    std::vector<float> texels(static_cast<std::size_t>(4 * width * height));
    radiance.read(texels);
    Image image(width, height, 3);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            std::copy_n(&texels[static_cast<std::size_t>(4 * ((height - 1 - row) * width + column))], 3, image.pixel(column, row).begin());
    return image;
}

// Where the sun stands so low under the eye that the full moon's light, a 400 000th of its, begins to tell.
bool is_night(const Camera& camera, Vec3 towards_sun) { return glm::dot(glm::normalize(camera.eye), towards_sun) < std::sin(-6.0 * deg); }

// Nothing is drawn outside of a part while it is there.
class Scissor {
public:
    explicit Scissor(const Part& part) {
        glScissor(part.left, part.bottom, part.width, part.height);
        glEnable(GL_SCISSOR_TEST);
    }
    ~Scissor() { glDisable(GL_SCISSOR_TEST); }
    Scissor(const Scissor&) = delete;
    Scissor& operator=(const Scissor&) = delete;
};

}  // namespace

Result<Frame> Frame::create(const gpu::Context& context, const HeightField& ground, const GroundColour& colour, const Camera& like,
                            std::optional<AirPass> air, std::optional<ShaftsPass> shafts, std::span<const Star> stars,
                            std::shared_ptr<TileStore> tiles, std::span<const Object> objects) {
    const DetailSettings detail{.pixels_per_radian = pixels_per_radian(like), .pixels_of_error = 2.0, .pixels_of_square = 8.0};
    Result<TerrainPass> terrain = TerrainPass::create(ground, detail, {}, std::move(tiles));
    if (!terrain) return terrain.error();
    Result<GroundPass> looks = GroundPass::create(ground, colour);
    if (!looks) return looks.error();
    Result<ObjectPass> bodies = ObjectPass::create(objects);
    if (!bodies) return bodies.error();
    Result<LightPass> light = LightPass::create();
    if (!light) return light.error();
    Result<ShadowPass> shadows = ShadowPass::create();
    if (!shadows) return shadows.error();
    Result<BackgroundPass> background = BackgroundPass::create(like.width, like.height, stars);
    if (!background) return background.error();
    Result<GeometryBuffer> surfaces = GeometryBuffer::create(like.width, like.height);
    if (!surfaces) return surfaces.error();
    gpu::Texture radiance({like.width, like.height});
    Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&radiance}, &surfaces->depth());
    if (!target) return target.error();
    return Frame(context, std::move(*terrain), std::move(*looks), std::move(*bodies), std::move(*light), std::move(air),
                 std::move(*shadows), std::move(shafts), std::move(*background), std::move(*surfaces), std::move(radiance),
                 std::move(*target));
}

Frame::Frame(const gpu::Context& context, TerrainPass terrain, GroundPass ground, ObjectPass objects, LightPass light,
             std::optional<AirPass> air, ShadowPass shadows, std::optional<ShaftsPass> shafts, BackgroundPass background,
             GeometryBuffer surfaces, gpu::Texture radiance, gpu::Framebuffer target)
    : context_(&context),
      terrain_(std::move(terrain)),
      ground_(std::move(ground)),
      objects_(std::move(objects)),
      light_(std::move(light)),
      air_(std::move(air)),
      shadows_(std::move(shadows)),
      shafts_(std::move(shafts)),
      background_(std::move(background)),
      surfaces_(std::move(surfaces)),
      radiance_(std::move(radiance)),
      target_(std::move(target)) {}

Result<Image> Frame::draw(const Camera& camera, const Lights& lights) {
    if (const Result<Done> drawn = render(camera, lights); !drawn) return drawn.error();
    return image();
}

Image Frame::image() const { return image_of(radiance_); }

Result<Done> Frame::render(const Camera& camera, const Lights& lights, const std::optional<Part>& part) {
    assert(camera.width == radiance_.size().width && camera.height == radiance_.size().height);
    camera_.bind(camera);
    {
        const auto pass = timers_.time("terrain");
        surfaces_.begin();
        terrain_.draw(camera);
    }
    {
        const auto pass = timers_.time("objects");
        objects_.draw();
    }
    {
        const auto pass = timers_.time("ground");
        ground_.draw(surfaces_, camera);
        GeometryBuffer::end();
    }
    const Heavens heavens{lights.towards_sun, lights.sun_distance_au, lights.moon_m,
                          background_.has_stars() && is_night(camera, lights.towards_sun)};
    {
        const auto pass = timers_.time("background");
        background_.draw(camera, heavens, bending(camera), air_ ? &air_->atmosphere() : nullptr);
    }
    if (air_) {
        if (const Result<Done> drawn = draw_air(camera, heavens, part.value_or(Part{0, 0, camera.width, camera.height})); !drawn)
            return drawn.error();
    } else {
        if (shafts_) draw_shade(camera, lights.towards_sun);
        const auto pass = timers_.time("light");
        target_.bind();
        light_.draw(surfaces_, lights, shafts_ ? &shafts_->shade() : nullptr, &background_.radiance());
    }
    times_ = timers_.read();
    return context_->check();
}

const BendingTable& Frame::bending(const Camera& camera) {
    const Atmosphere* air = air_ ? &air_->atmosphere() : nullptr;
    const double bottom_m = air ? air->bottom_radius.in(m) : 0.0;
    const double radius_m = bottom_m + settled({glm::length(camera.eye) - bottom_m, 0.0}).altitude_m;
    if (!bending_ || bending_->radius_m != radius_m) bending_ = Bending{radius_m, bending_to(air, radius_m)};
    return bending_->table;
}

void Frame::draw_shade(const Camera& camera, Vec3 towards_sun) {
    {
        const auto pass = timers_.time("shadows");
        shadows_.draw(terrain_, objects_, camera, towards_sun);
    }
    const auto pass = timers_.time("shafts");
    shafts_->draw(surfaces_, shadows_, camera);
}

Result<Done> Frame::draw_air(const Camera& camera, const Heavens& heavens, const Part& part) {
    const Length reach = air_->atmosphere().bottom_radius + air_->atmosphere().top_altitude;
    const bool night = is_night(camera, heavens.towards_sun), shaded = shafts_ && !night;
    air_->prepare(camera, heavens.towards_sun, timers_, eclipse_of(heavens, camera.eye, reach.in(m)), heavens.night_sky);
    if (shaded) draw_shade(camera, heavens.towards_sun);
    {
        const auto pass = timers_.time("air");
        target_.bind();
        const Scissor scissor(part);
        const Result<Done> drawn =
            air_->draw(surfaces_, shaded ? &shafts_->shade() : nullptr, &background_.radiance(), terrain_.count().sea);
        if (!drawn) return drawn.error();
    }
    const std::optional<MoonSeen> moon = moon_seen(heavens, camera.eye);
    if (!moon || !night) return Done{};
    air_->prepare(camera, moon->towards, timers_);
    const auto pass = timers_.time("moonlit air");
    target_.bind();
    const Scissor scissor(part);
    return air_->add(surfaces_, moon->illuminance / sunlight(heavens, SpectrumOf<Number>::constant(1.0)), terrain_.count().sea);
}

}  // namespace airlight::render
