#include "frame_of_scene.h"

namespace airlight::cli {

struct SceneFrames::Parts {};

SceneFrames::SceneFrames(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SceneFrames::SceneFrames(SceneFrames&&) noexcept = default;
SceneFrames& SceneFrames::operator=(SceneFrames&&) noexcept = default;
SceneFrames::~SceneFrames() = default;

Result<SceneFrames> SceneFrames::create(const Scene&, std::span<const Picture>, int, int, const TableWishes&) {
    return Error{"airlight render", "this airlight was built without OpenGL.",
                 "Build it with libepoxy-dev and libegl-dev, and -DAIRLIGHT_GPU=ON."};
}

Result<DrawnFrame> SceneFrames::draw(std::size_t, int, int) {
    return Error{"airlight render", "this airlight was built without OpenGL.", ""};
}

}  // namespace airlight::cli
