// What the sun sees of a planet: cascades of shadow maps from some metres before the eye to the horizon, which say of any point in view
// whether sunlight reaches it. docs/decisions/0013-shadows.md. Uses the passes of terrain and of objects.
//
// Leaves out: the sun's size, except that edges are soft by a texel or two; refraction.
#pragma once

#include <array>
#include <optional>

#include "gpu/framebuffer.h"
#include "render/camera_block.h"
#include "render/object_pass.h"
#include "render/shadow_cascades.h"
#include "render/terrain_pass.h"

namespace airlight::render {

struct ShadowSettings {
    int texels = 1024;  // along a map's side, a multiple of 4; a map takes 4 bytes a texel
};

class ShadowPass {
public:
    static Result<ShadowPass> create(ShadowSettings settings = {});

    // Draws the maps for what the camera sees, but those that are there from before: a map stays while its cascade and the light do, and
    // is what it would be if it were drawn anew. The ground and the objects are always the same. A CameraBlock of the same camera is
    // bound; `towards_sun` is of length one.
    void draw(TerrainPass& terrain, const ObjectPass& objects, const Camera& camera, Vec3 towards_sun);

    // For a program that includes shadow.glsl.
    void bind() const;

    // Of the last draw: where the maps lie, along which axes, and how many patches were drawn into those that were not there.
    const std::vector<Cascade>& cascades() const { return cascades_; }
    const LightAxes& axes() const { return axes_; }
    std::size_t patches() const { return patches_; }

private:
    struct Drawn {
        Cascade cascade;
        Vec3 towards_sun;

        friend bool operator==(const Drawn&, const Drawn&) = default;
    };
    ShadowPass(ShadowSettings settings, gpu::Texture maps, gpu::Framebuffer target);
    void draw_map(TerrainPass& terrain, const ObjectPass& objects, const Camera& camera, const Cascade& cascade);

    ShadowSettings settings_;
    gpu::Texture maps_;  // one above the other
    gpu::Framebuffer target_;
    CameraBlock camera_;
    gpu::Buffer block_;
    LightAxes axes_{};
    std::vector<Cascade> cascades_;
    std::array<std::optional<Drawn>, most_cascades> maps_of_;  // what each of the maps shows
    std::size_t patches_ = 0;
};

}  // namespace airlight::render
