#include "stage.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "spectrum/colour.h"

namespace airlight::cli {

namespace {

// Of `airlight render` as well: what the mean of a picture becomes.
constexpr double grey = 0.25;

Result<std::optional<Tables>> tables_of_scene(const Scene& scene, const TableWishes& wishes) {
    const Result<std::optional<Atmosphere>> air = air_of(scene);
    if (!air) return air.error();
    return tables_of(*air, wishes);
}

}  // namespace

AirJob::AirJob(const Scene& scene, const TableWishes& wishes) : atmosphere_(scene.atmosphere), how_far_("begins") {
    TableWishes told = wishes;
    told.progress = {.report =
                         [this](std::string_view step, double fraction) {
                             const std::lock_guard lock(mutex_);
                             how_far_ = fmt::format("{}, {:.0f} %", step, 100.0 * fraction);
                         },
                     .stop = stop_.get_token()};
    tables_ = std::async(std::launch::async, [scene, told] { return tables_of_scene(scene, told); });
}

AirJob::~AirJob() {
    stop_.request_stop();
    if (tables_.valid()) tables_.wait();
}

bool AirJob::ready() const { return tables_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

std::string AirJob::how_far() const {
    const std::lock_guard lock(mutex_);
    return how_far_;
}

Result<Stage::Passes> Stage::make_passes(const gpu::Context& context, const HeightField& ground, const GroundColour& colour,
                                         const std::optional<Tables>& tables, const Scene& scene, int width, int height) {
    Camera like{};
    like.width = width, like.height = height;
    like.vertical_field_of_view = scene.camera.vertical_field_of_view;
    Result<std::optional<render::AirPass>> air = air_pass_of(tables, scene);
    if (!air) return air.error();
    Result<render::Frame> frame = render::Frame::create(context, ground, colour, like, *std::move(air));
    if (!frame) return frame.error();
    Result<render::ExposurePass> exposure = render::ExposurePass::create();
    if (!exposure) return exposure.error();
    Result<render::BloomPass> bloom = render::BloomPass::create(width, height);
    if (!bloom) return bloom.error();
    Result<render::TonePass> tone = render::TonePass::create();
    if (!tone) return tone.error();
    gpu::Texture levels({width, height}, {}, gpu::TextureFormat::rgba8);
    Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&levels});
    if (!target) return target.error();
    return Passes{std::move(*frame), std::move(*exposure), std::move(*bloom), std::move(*tone), std::move(levels), std::move(*target)};
}

Result<Stage> Stage::create(const gpu::Context& context, const Scene& scene, int width, int height, const TableWishes& wishes) {
    const Result<HeightField> ground = ground_of(scene);
    if (!ground) return ground.error();
    const Result<GroundColour> colour = colour_of(scene);
    if (!colour) return colour.error();
    Result<std::optional<Tables>> tables = tables_of_scene(scene, wishes);
    if (!tables) return tables.error();
    Result<Passes> passes = make_passes(context, *ground, *colour, *tables, scene, width, height);
    if (!passes) return passes.error();
    return Stage(context, scene, wishes, *ground, *colour, *std::move(tables), std::move(*passes));
}

Stage::Stage(const gpu::Context& context, const Scene& scene, TableWishes wishes, HeightField ground, GroundColour colour,
             std::optional<Tables> tables, Passes passes)
    : context_(&context),
      scene_(scene),
      wishes_(std::move(wishes)),
      ground_(std::move(ground)),
      colour_(std::move(colour)),
      tables_(std::move(tables)),
      wished_air_(scene.atmosphere),
      passes_(std::move(passes)) {}

Result<Done> Stage::remake(const Scene& scene) {
    HeightField ground = ground_;
    GroundColour colour = colour_;
    Scene next = scene;
    next.atmosphere = scene_.atmosphere;  // follow_air() sees to the air
    if (!(scene.ground == scene_.ground)) {
        Result<HeightField> other = ground_of(scene);
        if (!other) return other.error();
        Result<GroundColour> other_colour = colour_of(scene);
        if (!other_colour) return other_colour.error();
        ground = *std::move(other), colour = *std::move(other_colour);
        if (tables_ && scene.ground.radius_m != scene_.ground.radius_m) wished_air_.clear();
    }
    Result<Passes> passes = make_passes(*context_, ground, colour, tables_, next, width(), height());
    if (!passes) return passes.error();
    passes_ = std::move(*passes);
    ground_ = std::move(ground), colour_ = std::move(colour), scene_ = std::move(next);
    return Done{};
}

// Begins to make the air that the session asks for, and takes it when it is there.
Result<Done> Stage::follow_air(const viewer::Session& session) {
    if (session.atmosphere != wished_air_) {
        wished_air_ = session.atmosphere;
        job_.reset();
        job_ = std::make_unique<AirJob>(viewer::scene_of(session), wishes_);
    }
    if (!job_ || !job_->ready()) return Done{};
    const std::unique_ptr<AirJob> done = std::move(job_);
    Result<std::optional<Tables>> tables = done->take();
    if (!tables) return tables.error();
    Scene scene = viewer::scene_of(session);
    Result<std::optional<render::AirPass>> air = air_pass_of(*tables, scene);
    if (!air) return air.error();
    passes_.frame.exchange_air(*std::move(air));
    tables_ = *std::move(tables);
    scene_.atmosphere = done->atmosphere();
    return Done{};
}

Result<Done> Stage::draw(const viewer::Session& session, double seconds) {
    const Result<Done> air = follow_air(session);
    const Camera camera = viewer::camera_of(session, width(), height());
    if (const Result<Done> drawn = passes_.frame.render(camera, lights_of(viewer::scene_of(session))); !drawn) return drawn.error();
    const gpu::Texture& light = passes_.frame.radiance();
    {
        const auto pass = timers_.time("exposure");
        const double factor = std::exp2(session.look.stops);
        if (session.look.metered) passes_.exposure.meter(light, {.grey = grey * factor}, {}, seconds);
        else passes_.exposure.set(exposure_of_ev100(session.look.ev100) * factor);
    }
    const bool blooms = session.look.bloom > 0.0;
    if (blooms) {
        const auto pass = timers_.time("bloom");
        passes_.bloom.draw(light);
    }
    {
        const auto pass = timers_.time("tone");
        passes_.target.bind();
        if (blooms) passes_.tone.draw(light, passes_.exposure.exposure(), session.look.tone, passes_.bloom, session.look.bloom);
        else passes_.tone.draw(light, passes_.exposure.exposure(), session.look.tone);
    }
    times_ = passes_.frame.times();
    for (gpu::PassTime& time : timers_.read()) times_.push_back(std::move(time));
    return air;
}

PngLevels Stage::levels() const {
    std::vector<float> texels(static_cast<std::size_t>(4 * width() * height()));
    passes_.levels.read(texels);
    PngLevels read{width(), height(), 3, 8, {}};
    for (int row = height() - 1; row >= 0; --row)
        for (int i = 4 * row * width(); i < 4 * (row + 1) * width(); ++i)
            if (i % 4 < 3) read.levels.push_back(static_cast<std::uint16_t>(std::lround(255.0f * texels[static_cast<std::size_t>(i)])));
    return read;
}

Image Stage::light() const {
    Image image = passes_.frame.image();
    bring_into_gamut(image);
    return image;
}

double Stage::luminance_at(double x, double y) const {
    const auto pixel = [](double along, int pixels) { return std::clamp(static_cast<int>(0.5 * (along + 1.0) * pixels), 0, pixels - 1); };
    const Image image = passes_.frame.image();
    const std::span<const float> rgb = image.pixel(pixel(x, width()), pixel(-y, height()));
    return RgbConverter(RgbSpace::srgb, WhitePoint::d65).luminance({rgb[0], rgb[1], rgb[2]});
}

std::optional<std::string> Stage::at_work() const {
    if (!job_) return std::nullopt;
    return fmt::format("the air {}: {}", job_->atmosphere(), job_->how_far());
}

}  // namespace airlight::cli
