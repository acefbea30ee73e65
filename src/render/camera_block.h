// The camera as shaders read it, and the depth that all passes agree on.
//
// Depth is near / distance along the camera's axis, in float: 1 at near_m, 0 at infinity ("reversed"), so that float's many numbers
// near 0 serve what is far, and a position is rebuilt equally well at any distance (docs/decisions/0008-geometry-buffer.md).
// Uses camera and gpu.
#pragma once

#include "camera/camera.h"
#include "gpu/buffer.h"

namespace airlight::render {

// Nothing nearer is drawn.
inline constexpr double near_m = 0.1;

// `uniform CameraBlock` of src/render/shaders/camera.glsl, at binding 0.
class CameraBlock {
public:
    CameraBlock();
    // What is drawn from now on is seen by this camera.
    void bind(const Camera& camera) const;

private:
    gpu::Buffer buffer_;
};

}  // namespace airlight::render
