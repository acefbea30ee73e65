// From a scene to its picture. With OpenGL in frame_of_scene.cpp; frame_without_opengl.cpp says that there is none.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "image/image.h"
#include "scene/scene.h"

namespace airlight::cli {

struct DrawnFrame {
    Image image;                                                             // red, green and blue of sRGB, in cd m-2
    std::vector<std::tuple<std::string, std::string, std::string>> figures;  // quantity, value, unit
};

Result<DrawnFrame> draw_scene(const Scene& scene, int width, int height);

}  // namespace airlight::cli
