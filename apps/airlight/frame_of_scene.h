// From a scene to its picture. With OpenGL in frame_of_scene.cpp; frame_without_opengl.cpp says that there is none.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "image/image.h"
#include "scene/scene.h"
#include "transport/table_cache.h"

namespace airlight::cli {

using Figures = std::vector<std::tuple<std::string, std::string, std::string>>;  // quantity, value, unit

struct DrawnFrame {
    Image image;  // red, green and blue of sRGB, in cd m-2
    Figures figures;
};

// How the tables of a scene's air are made and kept.
struct TableWishes {
    BakeSettings bake;
    CacheSettings cache;
    Progress progress;
};

// A scene made ready once, for any number of its pictures: its ground, its air and an OpenGL context.
class SceneFrames {
public:
    // For pictures of this size, one for each of the cameras, of which there is at least one; the sun stands as the scene's own camera
    // sees it. The tables are baked, or loaded, unless the scene has no air. Fails, before that, if a camera would be in the ground; the
    // error says which, counted from 0, if there are several.
    static Result<SceneFrames> create(const Scene& scene, std::span<const CameraScene> cameras, int width, int height,
                                      const TableWishes& tables);
    SceneFrames(SceneFrames&&) noexcept;
    SceneFrames& operator=(SceneFrames&&) noexcept;
    ~SceneFrames();

    // As the camera of this number sees it. Fails if the GPU was reset.
    Result<DrawnFrame> draw(std::size_t camera);

private:
    struct Parts;
    explicit SceneFrames(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

}  // namespace airlight::cli
