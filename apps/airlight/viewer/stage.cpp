#include "stage.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "spectrum/colour.h"

namespace airlight::cli {

namespace {

// Of `airlight render` as well: what the mean of a picture becomes.
constexpr double grey = 0.25;

// An exposure that leaves light as it is, in the form of ExposurePass.
constexpr std::array<float, 2> ones = {1.0f, 1.0f};

std::optional<Atmosphere> atmosphere_of(const std::optional<SceneAir>& air) { return air ? std::optional(air->atmosphere) : std::nullopt; }

bool compares(const viewer::Session& session) { return session.comparison.shown != viewer::Comparison::Shown::one; }

AirWish wish_of(const viewer::Session& session) {
    return {air_name(viewer::scene_of(session)),
            needs_tables(session.air.method) || (compares(session) && needs_tables(session.comparison.with))};
}

// Of tables that are made within a second, on two cores; nowhere finer than what is wished. They are not kept.
TableWishes coarse_wishes(TableWishes wishes) {
    TableSizes& sizes = wishes.bake.sizes;
    const auto at_most = [](int& size, int most) { size = std::min(size, most); };
    at_most(sizes.transmittance_mu, 128), at_most(sizes.transmittance_altitude, 64);
    at_most(sizes.sun, 16), at_most(sizes.azimuth, 4), at_most(sizes.view, 8), at_most(sizes.altitude, 12);
    at_most(wishes.bake.orders, 3);
    wishes.cache.enabled = false;
    return wishes;
}

// The scene with a method that this air can be drawn by: hillaire2020 stands for those whose tables are not there.
Scene drawable(Scene scene, const std::optional<SceneAir>& air) {
    if (air && !air->tables && needs_tables(scene.air.method)) scene.air.method = AirMethodName::hillaire2020;
    return scene;
}

// Whether a method would have its first picture wait while it fills tables of its own.
bool fills_tables(AirMethodName method) { return method == AirMethodName::bruneton2008; }

// The colours of the air's light are those of the sun's distance when it was made. So far may they be apart, in parts of the distance:
// 0.2 % of the light, some days of a year.
constexpr double as_far = 1e-3;

bool sun_is_as_far(const Scene& a, const Scene& b) { return std::abs(a.sun.distance_au / b.sun.distance_au - 1.0) < as_far; }

bool takes_long(AirMethodName method) { return method == AirMethodName::exact; }

double milliseconds_of_air(std::span<const gpu::PassTime> times) {
    double sum = 0.0;
    for (const gpu::PassTime& time : times)
        if (time.pass.ends_with("air")) sum += time.milliseconds;
    return sum;
}

}  // namespace

AirName air_name(const Scene& scene) { return {scene.atmosphere, scene.weather}; }

AirJob::AirJob(const Scene& scene, const TableWishes& wishes, bool coarse_first) : name_(air_name(scene)), how_far_("begins") {
    TableWishes told = wishes;
    told.progress = {.report =
                         [this, tell = wishes.progress](std::string_view step, double fraction) {
                             tell.report(step, fraction);
                             const std::lock_guard lock(mutex_);
                             how_far_ = fmt::format("{}, {:.0f} %", step, 100.0 * fraction);
                         },
                     .stop = stop_.get_token()};
    air_ = std::async(std::launch::async, [this, scene, told, coarse_first]() -> Result<std::optional<SceneAir>> {
        const Result<std::optional<Atmosphere>> air = air_of(scene);
        if (!air) return air.error();
        const TableWishes coarse = coarse_wishes(told);
        if (coarse_first && *air && !(coarse.bake == told.bake) && !tables_are_kept(**air, told))
            if (Result<std::optional<SceneAir>> made = scene_air_of(*air, true, coarse)) {
                const std::lock_guard lock(mutex_);
                coarse_ = *std::move(made);
            }
        return scene_air_of(*air, true, told);
    });
}

AirJob::~AirJob() {
    stop_.request_stop();
    if (air_.valid()) air_.wait();
}

bool AirJob::ready(std::chrono::milliseconds patience) const { return air_.wait_for(patience) == std::future_status::ready; }

std::optional<SceneAir> AirJob::take_coarse() {
    const std::lock_guard lock(mutex_);
    return std::exchange(coarse_, std::nullopt);
}

std::string AirJob::how_far() const {
    const std::lock_guard lock(mutex_);
    return how_far_;
}

Result<Stage::Passes> Stage::make_passes(const gpu::Context& context, const Made& made, int width, int height) {
    Camera like{};
    like.width = width, like.height = height;
    like.vertical_field_of_view = made.scene.camera.vertical_field_of_view;
    Result<render::ShaftsPass> shafts = shafts_pass_of(atmosphere_of(made.air), made.scene, width, height);
    if (!shafts) return shafts.error();
    Result<render::Frame> frame = render::Frame::create(context, made.ground, made.colour, like, {}, *std::move(shafts),
                                                        stars_of(made.scene), made.tiles, made.objects);
    if (!frame) return frame.error();
    Result<render::ExposurePass> exposure = render::ExposurePass::create();
    if (!exposure) return exposure.error();
    Result<render::BloomPass> bloom = render::BloomPass::create(width, height);
    if (!bloom) return bloom.error();
    Result<render::TonePass> tone = render::TonePass::create();
    if (!tone) return tone.error();
    Result<render::ComparePass> compare = render::ComparePass::create();
    if (!compare) return compare.error();
    gpu::Texture second({width, height}), compared({width, height});
    Result<gpu::Framebuffer> compared_target = gpu::Framebuffer::create({&compared});
    if (!compared_target) return compared_target.error();
    gpu::Texture levels({width, height}, {}, gpu::TextureFormat::rgba8);
    Result<gpu::Framebuffer> target = gpu::Framebuffer::create({&levels});
    if (!target) return target.error();
    return Passes{std::move(*frame), std::move(*exposure), std::move(*bloom),           std::move(*tone),  std::move(*compare),
                  std::move(second), std::move(compared),  std::move(*compared_target), std::move(levels), std::move(*target)};
}

Result<Stage> Stage::create(const gpu::Context& context, const Scene& scene, int width, int height, const TableWishes& wishes,
                            std::chrono::milliseconds patience) {
    const Result<HeightField> ground = ground_of(scene);
    if (!ground) return ground.error();
    const Result<GroundColour> colour = colour_of(scene);
    if (!colour) return colour.error();
    const Result<std::vector<Object>> objects = objects_of(scene, *ground);
    if (!objects) return objects.error();
    const Result<std::optional<Atmosphere>> named = air_of(scene);
    if (!named) return named.error();
    Result<std::optional<SceneAir>> made = scene_air_of(*named, false, wishes);
    if (!made) return made.error();
    std::unique_ptr<AirJob> job;
    if (*named && needs_tables(scene.air.method)) {
        job = std::make_unique<AirJob>(scene, wishes, patience < AirJob::forever);
        if (job->ready(patience)) made = std::exchange(job, nullptr)->take();
        if (!made) return made.error();
    }
    Scene first = scene;  // then follow_air() takes what the session asks for
    if (fills_tables(scene.air.method)) first.air.method = AirMethodName::hillaire2020;
    Result<std::optional<render::AirPass>> air = air_pass_of(*made, drawable(first, *made));
    if (!air) return air.error();
    Result<Passes> passes = make_passes(context, {first, *ground, *colour, *objects, *made}, width, height);
    if (!passes) return passes.error();
    passes->frame.exchange_air(*std::move(air));
    return Stage(context, first, wishes, *ground, *colour, *objects, *std::move(made), std::move(job), std::move(*passes));
}

Stage::Stage(const gpu::Context& context, const Scene& scene, TableWishes wishes, HeightField ground, GroundColour colour,
             std::vector<Object> objects, std::optional<SceneAir> air, std::unique_ptr<AirJob> job, Passes passes)
    : context_(&context),
      scene_(scene),
      wishes_(std::move(wishes)),
      ground_(std::move(ground)),
      colour_(std::move(colour)),
      objects_(std::move(objects)),
      air_(std::move(air)),
      wished_air_{air_name(scene), needs_tables(scene.air.method)},
      job_(std::move(job)),
      passes_(std::move(passes)),
      exposure_of_one_(std::as_bytes(std::span(ones))) {}

void Stage::forget_air() {
    wished_air_ = {};
    scene_.atmosphere.clear();
}

Result<Done> Stage::remake(const Scene& scene) {
    HeightField ground = ground_;
    GroundColour colour = colour_;
    std::shared_ptr<TileStore> tiles = passes_.frame.tiles();
    Scene next = scene;
    // What follows the session sees to the rest.
    next.atmosphere = scene_.atmosphere, next.weather = scene_.weather, next.air = scene_.air, next.sun = scene_.sun;
    next.stars = scene_.stars;
    if (!(scene.ground == scene_.ground)) {
        Result<HeightField> other = ground_of(scene);
        if (!other) return other.error();
        Result<GroundColour> other_colour = colour_of(scene);
        if (!other_colour) return other_colour.error();
        ground = *std::move(other), colour = *std::move(other_colour);
        tiles.reset();
        // The air lies on another sphere: that of before is drawn until follow_air() has it.
        if (air_ && scene.ground.radius_m != scene_.ground.radius_m) next.atmosphere.clear();
    }
    Result<std::vector<Object>> objects = objects_of(scene, ground);
    if (!objects) return objects.error();
    Result<Airs> airs = airs_of(air_, next);
    if (!airs) return airs.error();
    Result<Passes> passes = make_passes(*context_, {next, ground, colour, *objects, air_, tiles}, width(), height());
    if (!passes) return passes.error();
    passes->frame.exchange_air(std::move(airs->now));
    passes_ = std::move(*passes);
    begun_air_ = std::move(airs->begun);
    other_.reset(), quick_air_.reset(), view_.reset();
    if (next.atmosphere != scene_.atmosphere) wished_air_ = {};
    ground_ = std::move(ground), colour_ = std::move(colour), objects_ = *std::move(objects), scene_ = std::move(next);
    return Done{};
}

Result<Done> Stage::resize(int width, int height) {
    Result<Passes> passes = make_passes(*context_, {scene_, ground_, colour_, objects_, air_, passes_.frame.tiles()}, width, height);
    if (!passes) return passes.error();
    passes->frame.exchange_air(passes_.frame.exchange_air({}));
    passes_ = std::move(*passes);
    view_.reset();
    return Done{};
}

// Draws the air that the session asks for: at once by what is there, and by its own method when that has its tables.
void Stage::follow_air(const viewer::Session& session) {
    const Scene scene = viewer::scene_of(session);
    if (const AirWish wish = wish_of(session); !(wish == wished_air_)) follow_wish(scene, wish);
    if (const Result<Done> taken = follow_job(scene); !taken) air_failure_ = taken.error().message();
}

void Stage::follow_wish(const Scene& scene, const AirWish& wish) {
    wished_air_ = wish;
    air_failure_.clear();
    job_.reset();
    const bool known = wish.name == air_name(scene_);
    if (known && (!wish.tables || !air_ || (air_->tables && air_->tables->settings() == wishes_.bake))) return;
    Result<Done> taken = Done{};
    if (!known) {
        const Result<std::optional<Atmosphere>> air = air_of(scene);
        if (air) taken = take_air(scene, *scene_air_of(*air, false, wishes_), wish.name);
        else taken = air.error();
    }
    if (!taken) air_failure_ = taken.error().message();
    else if (wish.tables && air_) job_ = std::make_unique<AirJob>(scene, wishes_, true);
}

Result<Done> Stage::follow_job(const Scene& scene) {
    if (job_ && job_->ready()) {
        Result<std::optional<SceneAir>> air = std::exchange(job_, nullptr)->take();
        if (!air) return air.error();
        return take_air(scene, *std::move(air), wished_air_.name);
    }
    if (std::optional<SceneAir> coarse = job_ ? job_->take_coarse() : std::nullopt)
        return take_air(scene, std::move(coarse), wished_air_.name);
    if (!(scene.air == scene_.air) || !sun_is_as_far(scene, scene_)) return take_air(scene, air_, air_name(scene_));
    return Done{};
}

// This air, by the methods and under the sun of the scene.
Result<Done> Stage::take_air(const Scene& scene, std::optional<SceneAir> air, const AirName& name) {
    scene_.air = scene.air, scene_.sun = scene.sun;  // what fails is told once
    Result<Airs> airs = airs_of(air, scene);
    if (!airs) return airs.error();
    Result<render::ShaftsPass> shafts = shafts_pass_of(atmosphere_of(air), scene, width(), height());
    if (!shafts) return shafts.error();
    passes_.frame.exchange_air(std::move(airs->now));
    passes_.frame.exchange_shafts(*std::move(shafts));
    begun_air_ = std::move(airs->begun);
    other_.reset(), quick_air_.reset(), view_.reset();
    air_ = std::move(air);
    scene_.atmosphere = name.atmosphere, scene_.weather = name.weather;
    return Done{};
}

Result<Stage::Airs> Stage::airs_of(const std::optional<SceneAir>& air, const Scene& scene) {
    Result<std::optional<render::AirPass>> own = air_pass_of(air, drawable(scene, air));
    if (!own) return own.error();
    if (!*own || (*own)->begin(timers_)) return Airs{*std::move(own), {}};
    Scene meanwhile = scene;
    meanwhile.air.method = AirMethodName::hillaire2020;
    Result<std::optional<render::AirPass>> now = air_pass_of(air, meanwhile);
    if (!now) return now.error();
    return Airs{*std::move(now), *std::move(own)};
}

// The other method of a comparison.
Result<Done> Stage::follow_other(const viewer::Session& session) {
    if (!compares(session) || (other_ && other_method_ == session.comparison.with)) return Done{};
    Scene scene = viewer::scene_of(session);
    scene.air.method = other_method_ = session.comparison.with;
    Result<Airs> airs = airs_of(air_, scene);
    if (!airs) return airs.error();
    other_ = *std::move(airs);
    return Done{};
}

// Fills methods' own tables on, and draws by them when they are there.
void Stage::follow_begun(Pace pace) {
    const auto filled = [&](std::optional<render::AirPass>& begun) {
        if (!begun) return false;
        bool whole = begun->begin(timers_);
        while (!whole && pace == Pace::whole) whole = begun->begin(timers_);
        return whole;
    };
    if (filled(begun_air_)) passes_.frame.exchange_air(std::exchange(begun_air_, std::nullopt)), view_.reset();
    if (other_ && filled(other_->begun)) other_->now = std::exchange(other_->begun, std::nullopt), view_.reset();
}

void Stage::follow_stars(const viewer::Session& session) {
    if (session.stars == scene_.stars) return;
    scene_.stars = session.stars;
    passes_.frame.take(stars_of(scene_));
    view_.reset();
}

Stage::View Stage::view_of(const viewer::Session& session) {
    return {session.eye,    session.field_of_view,    session.towards_sun,    session.sun_distance_au,
            session.moon_m, session.comparison.shown, session.comparison.with};
}

// By the session's own air, or by another one, which the frame has for so long.
Result<Done> Stage::render(const viewer::Session& session, const std::optional<render::Part>& part, std::optional<render::AirPass>* other) {
    const Camera camera = viewer::camera_of(session, width(), height());
    const render::Lights lights = lights_of(viewer::scene_of(session));
    if (!other) return passes_.frame.render(camera, lights, part);
    std::optional<render::AirPass> own = passes_.frame.exchange_air(std::move(*other));
    const Result<Done> drawn = passes_.frame.render(camera, lights, part);
    *other = passes_.frame.exchange_air(std::move(own));
    return drawn;
}

// The picture of the other method of a comparison, copied before the session's own is drawn.
Result<Done> Stage::draw_second(const viewer::Session& session, const std::optional<render::Part>& part, bool quick) {
    const bool replaced = quick && takes_long(session.comparison.with);
    if (const Result<Done> drawn = render(session, part, replaced ? &quick_air_ : &other_->now); !drawn) return drawn.error();
    for (const gpu::PassTime& time : passes_.frame.times()) times_.push_back({"second " + time.pass, time.milliseconds});
    const render::Part copied = part.value_or(render::Part{0, 0, width(), height()});
    glCopyImageSubData(passes_.frame.radiance().name(), GL_TEXTURE_2D, 0, copied.left, copied.bottom, 0, passes_.second.name(),
                       GL_TEXTURE_2D, 0, copied.left, copied.bottom, 0, copied.width, copied.height, 1);
    return Done{};
}

// A part of what the session shows, or all; `quick`: with air in real time in place of one that takes long.
Result<Done> Stage::draw_pictures(const viewer::Session& session, const std::optional<render::Part>& part, bool quick) {
    if (quick && !quick_air_) {
        Scene scene = viewer::scene_of(session);
        scene.air.method = AirMethodName::airlight;
        Result<std::optional<render::AirPass>> made = air_pass_of(air_, drawable(scene, air_));
        if (!made) return made.error();
        quick_air_ = *std::move(made);
    }
    if (compares(session))
        if (const Result<Done> drawn = draw_second(session, part, quick); !drawn) return drawn.error();
    const bool replaced = quick && takes_long(session.air.method);
    if (const Result<Done> drawn = render(session, part, replaced ? &quick_air_ : nullptr); !drawn) return drawn.error();
    times_.insert(times_.end(), passes_.frame.times().begin(), passes_.frame.times().end());
    return Done{};
}

Result<Done> Stage::draw_slice(const viewer::Session& session) {
    const std::optional<viewer::Slices::Slice> slice = slices_->next();
    if (!slice) return Done{};
    if (const Result<Done> drawn = draw_pictures(session, render::Part{slice->left, slice->bottom, slice->width, slice->height}, false);
        !drawn)
        return drawn.error();
    slices_->drawn(milliseconds_of_air(times_));
    return Done{};
}

Result<Done> Stage::draw_light(const viewer::Session& session) {
    if (!takes_long(session.air.method) && !(compares(session) && takes_long(session.comparison.with))) {
        view_.reset(), slices_.reset();
        return draw_pictures(session, {}, false);
    }
    if (view_ == view_of(session)) return draw_slice(session);
    view_ = view_of(session), slices_.emplace(width(), height());
    return draw_pictures(session, {}, true);
}

void Stage::expose(const viewer::Session& session, double seconds) {
    const auto pass = timers_.time("exposure");
    const double factor = std::exp2(session.look.stops);
    if (session.look.metered) passes_.exposure.meter(passes_.frame.radiance(), {.grey = grey * factor}, {}, seconds);
    else passes_.exposure.set(exposure_of_ev100(session.look.ev100) * factor);
}

// The light of the frame, or of a comparison, as levels.
void Stage::develop(const viewer::Session& session) {
    using Shown = viewer::Comparison::Shown;
    const viewer::Comparison& comparison = session.comparison;
    const gpu::Texture& own = passes_.frame.radiance();
    const gpu::Texture& light = comparison.shown == Shown::one ? own : passes_.compared;
    if (comparison.shown != Shown::one) {
        const auto pass = timers_.time("compare");
        passes_.compared_target.bind();
        if (comparison.shown == Shown::side_by_side) passes_.compare.side_by_side(own, passes_.second, comparison.edge);
        else passes_.compare.difference(own, passes_.second, comparison.span);
    }
    const bool blooms = session.look.bloom > 0.0 && comparison.shown != Shown::difference;
    if (blooms) {
        const auto pass = timers_.time("bloom");
        passes_.bloom.draw(light);
    }
    const auto pass = timers_.time("tone");
    passes_.target.bind();
    const gpu::Buffer& exposure = passes_.exposure.exposure();
    if (comparison.shown == Shown::difference) passes_.tone.draw(light, exposure_of_one_, ToneCurve::linear);
    else if (blooms) passes_.tone.draw(light, exposure, session.look.tone, passes_.bloom, session.look.bloom);
    else passes_.tone.draw(light, exposure, session.look.tone);
}

Result<Done> Stage::draw(const viewer::Session& session, double seconds, Pace pace) {
    follow_air(session);
    if (const Result<Done> made = follow_other(session); !made) return made.error();
    follow_begun(pace);
    follow_stars(session);
    do {
        times_.clear();
        if (const Result<Done> drawn = draw_light(session); !drawn) return drawn.error();
    } while (pace == Pace::whole && slices_ && slices_->next());
    expose(session, seconds);
    develop(session);
    for (gpu::PassTime& time : timers_.read()) times_.push_back(std::move(time));
    return Done{};
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
    if (!job_ && slices_ && slices_->next()) return fmt::format("the exact air: {:.0f} %", 100.0 * slices_->share());
    if (begun_air_ || (other_ && other_->begun)) return "the tables of the air; until then hillaire2020 draws it";
    if (!job_) return std::nullopt;
    const AirName& name = job_->name();
    return fmt::format("the air {}{}, until then coarsely: {}", name.atmosphere, name.weather.empty() ? "" : " in its weather",
                       job_->how_far());
}

}  // namespace airlight::cli
