#include "render/camera_block.h"

#include <array>

namespace airlight::render {

namespace {

// std140.
struct Block {
    std::array<double, 4> eye_m;
    std::array<float, 4> right, up, forward;  // .w of the first two: how far the picture is shifted, in halves of its size
    std::array<float, 4> lens;                // half width and half height at distance 1; near_m; width of a pixel at distance 1
};
static_assert(sizeof(Block) == 96);

std::array<float, 4> four(Vec3 v, double w) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

}  // namespace

CameraBlock::CameraBlock() : buffer_(sizeof(Block)) {}

void CameraBlock::bind(const Camera& c) const {
    const HalfSize half = half_size(c);
    const Block block{{c.eye.x, c.eye.y, c.eye.z, 0.0},
                      four(c.right, 2.0 * c.shift_x / c.width),
                      four(c.up, 2.0 * c.shift_y / c.height),
                      four(c.forward, 0.0),
                      {static_cast<float>(half.width), static_cast<float>(half.height), static_cast<float>(near_m),
                       static_cast<float>(1.0 / pixels_per_radian(c))}};
    buffer_.write(std::as_bytes(std::span(&block, 1)));
    buffer_.bind_uniform(0);
}

}  // namespace airlight::render
