// From a scene to its picture. With OpenGL in frame_of_scene.cpp; frame_without_opengl.cpp says that there is none.
#pragma once

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

// The tables are baked, or loaded, unless the scene has no air.
Result<DrawnFrame> draw_scene(const Scene& scene, int width, int height, const TableWishes& tables);

}  // namespace airlight::cli
