// A window with OpenGL 4.5 and Dear ImGui in it, and what its user does with mouse and keys.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "core/result.h"
#include "gpu/context.h"
#include "gpu/handle.h"
#include "image/png.h"
#include "viewer/flight.h"

struct GLFWwindow;

namespace airlight::cli {

// A place in the window's picture: x to the right and y up, from -1 to 1.
struct PicturePlace {
    double x, y;
};

// Since the last frame.
struct Input {
    double seconds = 0.0;
    viewer::Steering steering;
    bool fast = false;
    PicturePlace dragged{0.0, 0.0};  // with a button held, outside of panels; 2 is the whole window
    double notches = 0.0;            // of the wheel, away from the user
    std::optional<PicturePlace> clicked;
    bool help = false, hide_panel = false, png = false, exr = false;
    bool add_key = false, undo = false, redo = false, play = false, quit = false;
};

class Window {
public:
    // Fails, with one reason, if there is no display, or it does not offer OpenGL 4.5.
    static Result<Window> open(int width, int height, const std::string& title);

    const gpu::Context& context() const { return *context_; }
    // Whether the user has closed it; stay() opens it again.
    bool closed() const;
    void stay();
    int width() const;
    int height() const;

    // Asks for what happened, and begins a frame of ImGui.
    Input begin_frame();
    // Draws the panels of ImGui over what is there.
    void draw_panels();
    // What is to be shown, its highest row first.
    PngLevels levels() const;
    void show();

private:
    struct CloseLibrary {
        void operator()(unsigned) const;
    };
    struct CloseWindow {
        void operator()(GLFWwindow* window) const;
    };
    struct CloseImgui {
        void operator()(unsigned) const;
    };
    Window() = default;

    // In the order in which they are opened; they close the other way. 1 where a library is open.
    gpu::Handle<CloseLibrary> library_;
    std::unique_ptr<GLFWwindow, CloseWindow> window_;
    std::optional<gpu::Context> context_;
    gpu::Handle<CloseImgui> imgui_;
    std::set<int> down_;  // keys that were at the last frame
};

}  // namespace airlight::cli
