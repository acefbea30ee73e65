// `airlight view`: the loop of its window. With a window in viewer.cpp; without_window.cpp says that there is none.
#pragma once

#include <filesystem>
#include <optional>

#include "../frame_of_scene.h"

namespace airlight::cli {

struct ViewerWishes {
    Scene scene;
    bool built_in = false;  // the scene has no file
    int width = 1280, height = 720;
    std::filesystem::path folder = ".";                 // where screenshots go
    std::filesystem::path path = "airlight-path.toml";  // of the camera
    TableWishes tables;
    int frames = 0;                                        // then it ends; 0: when the window is closed
    std::optional<std::filesystem::path> screenshot = {};  // of the window, at its end
};

// Until its user closes the window; the figures are of the last frame. Fails if there is no window, or what it is to show cannot be shown at first; later failures are told
// in its panel.
Result<Figures> run_viewer(const ViewerWishes& wishes);

}  // namespace airlight::cli
