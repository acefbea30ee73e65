// A frame: its passes in their order, from a ground, objects and a camera to an image.
// Uses the passes of this module and image.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "gpu/context.h"
#include "gpu/pass_timers.h"
#include "image/image.h"
#include "render/air_pass.h"
#include "render/background_pass.h"
#include "render/camera_block.h"
#include "render/ground_pass.h"
#include "render/light_pass.h"
#include "render/object_pass.h"
#include "render/shafts_pass.h"
#include "render/terrain_pass.h"

namespace airlight::render {

// A rectangle of a picture in pixels, whose lowest row is 0.
struct Part {
    int left, bottom, width, height;
};

class Frame {
public:
    // For pictures of this size and field of view, with these objects, under these stars; `context` outlives it. Without `shafts` nothing casts a shadow; shafts that have an air
    // need `air`. `tiles`: of the same ground, those of another frame; without them, they are built.
    static Result<Frame> create(const gpu::Context& context, const HeightField& ground, const GroundColour& colour, const Camera& like,
                                std::optional<AirPass> air, std::optional<ShaftsPass> shafts = {}, std::span<const Star> stars = {},
                                std::shared_ptr<TileStore> tiles = {}, std::span<const Object> objects = {});

    // Red, green and blue of each pixel: with air, in cd m-2, and the lights' irradiances do not count; without, in the unit
    // of the lights a steradian, black where there is nothing. The camera has the size that the frame was made for. Fails if the GPU was
    // reset.
    Result<Image> draw(const Camera& camera, const Lights& lights);

    // The same, left on the GPU: radiance() has it, its lowest row first, and image() reads it back. Waits
    // for the GPU. With air it may be done in parts: other pixels than these stay as they are.
    Result<Done> render(const Camera& camera, const Lights& lights, const std::optional<Part>& part = {});
    const gpu::Texture& radiance() const { return radiance_; }
    Image image() const;

    // The next pictures have this air, and these shadows; those of before come back.
    std::optional<AirPass> exchange_air(std::optional<AirPass> air) {
        bending_.reset();
        return std::exchange(air_, std::move(air));
    }
    std::optional<ShaftsPass> exchange_shafts(std::optional<ShaftsPass> shafts) { return std::exchange(shafts_, std::move(shafts)); }

    // The next pictures have these stars.
    void take(std::span<const Star> stars) { background_.take(stars); }

    // Of the last picture.
    const std::vector<gpu::PassTime>& times() const { return times_; }
    const TerrainCount& terrain() const { return terrain_.count(); }
    const std::shared_ptr<TileStore>& tiles() const { return terrain_.tiles(); }

private:
    Frame(const gpu::Context& context, TerrainPass terrain, GroundPass ground, ObjectPass objects, LightPass light,
          std::optional<AirPass> air, ShadowPass shadows, std::optional<ShaftsPass> shafts, BackgroundPass background,
          GeometryBuffer surfaces, gpu::Texture radiance, gpu::Framebuffer target);

    const BendingTable& bending(const Camera& camera);
    void draw_shade(const Camera& camera, Vec3 towards_sun);
    Result<Done> draw_air(const Camera& camera, const Heavens& heavens, const Part& part);

    const gpu::Context* context_;
    CameraBlock camera_;
    TerrainPass terrain_;
    GroundPass ground_;
    ObjectPass objects_;
    LightPass light_;
    std::optional<AirPass> air_;
    ShadowPass shadows_;
    std::optional<ShaftsPass> shafts_;
    BackgroundPass background_;
    struct Bending {
        double radius_m;
        BendingTable table;
    };
    std::optional<Bending> bending_;  // of air_, for the settled eye of the last picture
    GeometryBuffer surfaces_;
    gpu::Texture radiance_;
    gpu::Framebuffer target_;
    gpu::PassTimers timers_;
    std::vector<gpu::PassTime> times_;
};

}  // namespace airlight::render
