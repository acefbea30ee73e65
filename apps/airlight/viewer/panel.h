// The viewer's panel: all of a session that can be changed without flying, what was probed, and how long the passes take.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "gpu/pass_timers.h"
#include "viewer/probe.h"
#include "viewer/session.h"
#include "window.h"

namespace airlight::cli {

// What the panel tells.
struct PanelFacts {
    std::string device;
    std::string scene_file;  // empty: the built-in one
    std::vector<gpu::PassTime> times;
    std::size_t patches = 0;
    double ev100 = 0.0;
    std::optional<std::string> at_work;
    std::vector<std::string> failures;  // each stays until it is mended
    std::string done;                   // what was done last: a file that was written
    std::string path_file;
    std::size_t path_keys = 0;
    double path_s = 0.0;                         // how long it takes
    std::optional<double> played_s;              // since its beginning; none: it is not played
    std::optional<double> probed_picture;        // luminance where the user clicked, cd m-2; none: nowhere
    std::optional<Result<viewer::Probe>> probe;  // the sky there; none: not yet
};

// A line of text, which counts once it is left: by Enter, Tab or a click elsewhere.
struct TypedLine {
    std::array<char, 1024> text{};  // ends with a 0
    bool active = false;
};

// What it keeps from frame to frame.
struct PanelState {
    bool help = false, hidden = false, probe = false;
    bool asks_to_leave = false;   // whether keys may be lost
    bool leaves = false;          // they may
    double seconds_to_key = 4.0;  // from the path's last key to the next one
    bool keys_have_time = false;  // those of a path that has none yet: that of sun, moon and stars
    std::deque<float> frames_ms;
    TypedLine air, weather;
};

// Draws it, and changes the session as its user wishes. Buttons set the same wishes as keys do.
void draw_panel(PanelState& state, const PanelFacts& facts, viewer::Session& session, const HeightField& ground, Input& input);

}  // namespace airlight::cli
