// What stands above the air, where the geometry buffer has no surface: the sun's disk, the moon, the stars, as radiance above the air in
// red, green and blue. Air bends the rays to them: near the horizon they stand higher than they are, and the sun is flattened.
// docs/theory.md, section 7. Uses celestial, camera and gpu; knows no light that the air sends.
//
// Leaves out: the planets, the Milky Way, the face of the moon and what the Earth's shadow does to it; twinkling; airglow before the ground,
// and that airglow between the eye and the air, seen from space, is not dimmed by it.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "atmosphere/atmosphere.h"
#include "camera/camera.h"
#include "celestial/refraction.h"
#include "celestial/stars.h"
#include "gpu/buffer.h"
#include "gpu/framebuffer.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "gpu/vertex_array.h"
#include "render/heavens.h"

namespace airlight::render {

// How air bends the rays to an eye at a distance from the planet's centre; without air, they are straight.
BendingTable bending_to(const Atmosphere* air, double radius_m);

class BackgroundPass {
public:
    // For pictures of this size, under these stars. They never set, where the planet's axes are the Earth's.
    static Result<BackgroundPass> create(int width, int height, std::span<const Star> stars);

    // The next pictures have these stars.
    void take(std::span<const Star> stars);

    bool has_stars() const { return star_count_ > 0; }

    // Draws into radiance(). A CameraBlock of the same camera is bound. `air`: of the planet; at night it glows.
    void draw(const Camera& camera, const Heavens& heavens, const BendingTable& bending, const Atmosphere* air = nullptr);

    // cd m-2 of the primaries of sRGB, of each pixel.
    const gpu::Texture& radiance() const { return radiance_; }

private:
    BackgroundPass(gpu::Program disks, gpu::Program points, gpu::Program night, gpu::Texture radiance, gpu::Framebuffer target);

    gpu::Program disks_, points_, night_;
    gpu::Texture radiance_;
    gpu::Framebuffer target_;
    gpu::Buffer stars_{sizeof(std::array<float, 4>)};
    int star_count_ = 0;
    gpu::Buffer block_;
    gpu::VertexArray nothing_;
};

}  // namespace airlight::render
