#include "frame_of_scene.h"

namespace airlight::cli {

Result<DrawnFrame> draw_scene(const Scene&, int, int, const TableWishes&) {
    return Error{"airlight render", "this airlight was built without OpenGL.",
                 "Build it with libepoxy-dev and libegl-dev, and -DAIRLIGHT_GPU=ON."};
}

}  // namespace airlight::cli
