#include "viewer.h"

namespace airlight::cli {

Result<Figures> run_viewer(const ViewerWishes&) {
    return Error{"airlight view", "this airlight was built without a window.",
                 "Install libglfw3-dev and libimgui-dev, and build it again with -DAIRLIGHT_GPU=ON."};
}

}  // namespace airlight::cli
