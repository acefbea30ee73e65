// What a session looks like: its ground, its air and the passes that draw them, made anew where the session asks for others.
// What fails leaves all as it was.
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "../scene_air.h"
#include "image/png.h"
#include "render/bloom_pass.h"
#include "render/compare_pass.h"
#include "render/exposure_pass.h"
#include "render/frame.h"
#include "render/tone_pass.h"
#include "viewer/session.h"
#include "viewer/slices.h"

namespace airlight::cli {

// Which air a scene has.
struct AirName {
    std::string atmosphere, weather;  // as in a scene

    friend bool operator==(const AirName&, const AirName&) = default;
};
AirName air_name(const Scene& scene);

// What a session asks of its air: which one, and whether with the tables of the CPU.
struct AirWish {
    AirName name;
    bool tables = false;

    friend bool operator==(const AirWish&, const AirWish&) = default;
};

// The air's tables on their way: baked, or loaded, on other threads.
class AirJob {
public:
    // `coarse_first`: where tables are not kept already, small ones come before, which take less than a second.
    AirJob(const Scene& scene, const TableWishes& wishes, bool coarse_first);
    ~AirJob();  // asks it to stop, and waits
    AirJob(const AirJob&) = delete;
    AirJob& operator=(const AirJob&) = delete;

    const AirName& name() const { return name_; }
    bool ready() const { return ready(std::chrono::seconds(0)); }
    // Waits for so long, if it must.
    bool ready(std::chrono::milliseconds patience) const;
    static constexpr std::chrono::milliseconds forever = std::chrono::hours(24 * 365);
    Result<std::optional<SceneAir>> take() { return air_.get(); }
    // The small ones, once, if they are there.
    std::optional<SceneAir> take_coarse();
    // "second order, 40 %"
    std::string how_far() const;

private:
    AirName name_;
    std::stop_source stop_;
    mutable std::mutex mutex_;
    std::string how_far_;
    std::optional<SceneAir> coarse_;
    std::future<Result<std::optional<SceneAir>>> air_;
};

class Stage {
public:
    // Waits so long for the air's tables: what takes longer comes later, and until then hillaire2020, which needs none, draws the air, or
    // the method by coarse tables.
    // `context` outlives it.
    static Result<Stage> create(const gpu::Context& context, const Scene& scene, int width, int height, const TableWishes& wishes,
                                std::chrono::milliseconds patience);

    const HeightField& ground() const { return ground_; }

    // How a picture that takes long is drawn: in slices, one each time that the view is as it was, or all of it at once.
    enum class Pace { slices, whole };
    // Draws the session as it is `seconds` after the last time. In slices the exact air begins anew in each view, and air in real time is
    // shown where it is not there yet. Fails if the GPU was reset, or the other method of a comparison cannot be made.
    Result<Done> draw(const viewer::Session& session, double seconds, Pace pace);

    // The passes anew, from shaders as they are now; the ground of a scene, if it is another, else its tiles stay; and its objects.
    Result<Done> remake(const Scene& scene);
    // The air anew, from its files as they are now.
    void forget_air();
    // For pictures of another size; the ground's tiles and the air stay.
    Result<Done> resize(int width, int height);

    // As a display of 8 bits shows it, its lowest row first; and its light, in cd m-2 of sRGB's primaries, the highest row first.
    const gpu::Framebuffer& shown() const { return passes_.target; }
    PngLevels levels() const;
    Image light() const;
    // In cd m-2, at a place of the picture: x to the right and y up, from -1 to 1.
    double luminance_at(double x, double y) const;

    int width() const { return passes_.levels.size().width; }
    int height() const { return passes_.levels.size().height; }
    // Of the last picture.
    const std::vector<gpu::PassTime>& times() const { return times_; }
    double exposure() const { return passes_.exposure.read(); }
    const render::TerrainCount& terrain() const { return passes_.frame.terrain(); }
    // What is being made, and how far it is; none if nothing is.
    std::optional<std::string> at_work() const;
    // Why the session's air is not what is drawn; empty if it is, or is being made.
    const std::string& air_failure() const { return air_failure_; }

private:
    struct Passes {
        render::Frame frame;
        render::ExposurePass exposure;
        render::BloomPass bloom;
        render::TonePass tone;
        render::ComparePass compare;
        gpu::Texture second, compared;  // of a comparison: the other method's light, and what is shown of both
        gpu::Framebuffer compared_target;
        gpu::Texture levels;
        gpu::Framebuffer target;
    };
    // What passes are made for; `tiles` of this ground, if they are there.
    struct Made {
        const Scene& scene;
        const HeightField& ground;
        const GroundColour& colour;
        const std::vector<Object>& objects;
        const std::optional<SceneAir>& air;
        std::shared_ptr<TileStore> tiles = {};
    };
    // Without air, which the frame takes in exchange for none.
    static Result<Passes> make_passes(const gpu::Context& context, const Made& made, int width, int height);
    Stage(const gpu::Context& context, const Scene& scene, TableWishes wishes, HeightField ground, GroundColour colour,
          std::vector<Object> objects, std::optional<SceneAir> air, std::unique_ptr<AirJob> job, Passes passes);
    // What draws an air now, and what will when its own tables are filled.
    struct Airs {
        std::optional<render::AirPass> now, begun;
    };
    void follow_air(const viewer::Session& session);
    void follow_wish(const Scene& scene, const AirWish& wish);
    Result<Done> follow_job(const Scene& scene);
    Result<Done> take_air(const Scene& scene, std::optional<SceneAir> air, const AirName& name);
    Result<Airs> airs_of(const std::optional<SceneAir>& air, const Scene& scene);
    Result<Done> follow_other(const viewer::Session& session);
    void follow_begun(Pace pace);
    void follow_stars(const viewer::Session& session);
    // What slices belong to, beside the passes.
    struct View {
        Viewpoint eye;
        double field_of_view;
        Vec3 towards_sun;
        double sun_distance_au;
        std::optional<Vec3> moon_m;
        viewer::Comparison::Shown shown;
        AirMethodName with;

        friend bool operator==(const View&, const View&) = default;
    };
    static View view_of(const viewer::Session& session);
    Result<Done> draw_light(const viewer::Session& session);
    Result<Done> draw_slice(const viewer::Session& session);
    Result<Done> draw_pictures(const viewer::Session& session, const std::optional<render::Part>& part, bool quick);
    Result<Done> draw_second(const viewer::Session& session, const std::optional<render::Part>& part, bool quick);
    Result<Done> render(const viewer::Session& session, const std::optional<render::Part>& part,
                        std::optional<render::AirPass>* other = nullptr);
    void expose(const viewer::Session& session, double seconds);
    void develop(const viewer::Session& session);

    const gpu::Context* context_;
    Scene scene_;  // that the passes were made for
    TableWishes wishes_;
    HeightField ground_;
    GroundColour colour_;
    std::vector<Object> objects_;
    std::optional<SceneAir> air_;
    AirWish wished_air_;
    std::string air_failure_;
    std::unique_ptr<AirJob> job_;
    Passes passes_;
    std::optional<render::AirPass> begun_air_;  // whose own tables are filled between pictures; the frame has what draws now
    std::optional<Airs> other_;                 // of a comparison
    std::optional<render::AirPass> quick_air_;  // in real time, in place of one that takes long
    std::optional<View> view_;                  // that the slices belong to; none: the next picture begins anew
    std::optional<viewer::Slices> slices_;      // none: the picture is drawn at once
    AirMethodName other_method_ = {};
    gpu::Buffer exposure_of_one_;
    gpu::PassTimers timers_;
    std::vector<gpu::PassTime> times_;
};

}  // namespace airlight::cli
