// What the sun sees of a planet: cascades of shadow maps from some metres before the eye to the horizon, which say of any point in view
// whether sunlight reaches it. docs/decisions/0013-shadows.md. Uses the pass of terrain.
//
// Leaves out: the sun's size, except that edges are soft by a texel or two; refraction.
#pragma once

#include "gpu/framebuffer.h"
#include "render/shadow_cascades.h"
#include "render/terrain_pass.h"

namespace airlight::render {

struct ShadowSettings {
    int texels = 1024;  // along a map's side, a multiple of 4; a map takes 4 bytes a texel
};

class ShadowPass {
public:
    static Result<ShadowPass> create(ShadowSettings settings = {});

    // Draws the maps for what the camera sees. A CameraBlock of the same camera is bound; `towards_sun` is of length one.
    void draw(TerrainPass& terrain, const Camera& camera, Vec3 towards_sun);

    // For a program that includes shadow.glsl.
    void bind() const;

    // Of the last draw, and the patches in all of them.
    const std::vector<Cascade>& cascades() const { return cascades_; }
    std::size_t patches() const { return patches_; }

private:
    ShadowPass(ShadowSettings settings, gpu::Texture maps, gpu::Framebuffer target);

    ShadowSettings settings_;
    gpu::Texture maps_;  // one above the other
    gpu::Framebuffer target_;
    gpu::Buffer block_;
    std::vector<Cascade> cascades_;
    std::size_t patches_ = 0;
};

}  // namespace airlight::render
