// From a scene to its picture. With OpenGL in frame_of_scene.cpp; frame_without_opengl.cpp says that there is none.
#pragma once

#include <memory>
#include <optional>
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

// One picture of a scene.
struct Picture {
    CameraScene camera;
    std::optional<Utc> time = {};  // of sun, moon and stars; none: they stand as the scene's own camera sees them
};

// A scene made ready once, for any number of its pictures: its ground, its air and an OpenGL context.
class SceneFrames {
public:
    // For these pictures, of which there is at least one, all of this size. The sun is as far in all of them as in the first. The tables
    // are baked, or loaded, unless the scene has no air. Fails, before that, if a camera would be in the ground; the error says which,
    // counted from 0, if there are several.
    static Result<SceneFrames> create(const Scene& scene, std::span<const Picture> pictures, int width, int height,
                                      const TableWishes& tables);
    SceneFrames(SceneFrames&&) noexcept;
    SceneFrames& operator=(SceneFrames&&) noexcept;
    ~SceneFrames();

    // The picture of this number, or one of the samples of its pixels (camera.h, sampled()). Fails if the GPU was reset.
    Result<DrawnFrame> draw(std::size_t picture, int sample = 0, int samples = 1);

private:
    struct Parts;
    explicit SceneFrames(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

}  // namespace airlight::cli
