// What a viewer shows and what its user may do to it, without a window: the eye, the sun, the air, the picture's look.
// Uses scene, image and flight.h; knows neither window nor GPU.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "image/tone.h"
#include "scene/scene.h"
#include "sun/time.h"

namespace airlight::viewer {

// How light becomes a picture.
struct Look {
    ToneCurve tone = ToneCurve::filmic;
    bool metered = true;  // by the picture's own light; else:
    double ev100 = 14.0;  // at ISO 100
    double stops = 0.0;   // brighter than that
    double bloom = 0.0;   // the share of light that is spread, 0 to 1

    friend bool operator==(const Look&, const Look&) = default;
};

// Two methods of the air, for the same view.
struct Comparison {
    enum class Shown { one, side_by_side, difference };
    Shown shown = Shown::one;
    AirMethodName with = AirMethodName::hillaire2020;  // in real time, as the default is
    double edge = 0.5;  // side by side: the share of the picture's width that is the session's own method
    double span = 0.1;  // difference: the share of luminance whose colour is full
};

struct Session {
    Scene file;              // what the file says; what follows goes on from there
    std::string atmosphere;  // a preset or a file, as in a scene; "none" is no air
    std::string weather;     // a METAR report, or a file with one, as in a scene; empty: none
    AirScene air;            // its methods
    Comparison comparison;
    Viewpoint eye;  // its altitude is above 0 m
    double field_of_view = 60.0 * deg;
    // What stands above stands in the world, along its axes, wherever the eye flies.
    Vec3 towards_sun{};  // of length one
    double sun_distance_au = 1.0;
    std::optional<Vec3> moon_m;  // its centre, from the planet's
    std::optional<StarScene> stars;
    std::optional<Utc> time;   // none: the sun was placed by its angles
    double flown_per_s = 0.5;  // the share of the height above the ground
    Look look;
};

// A scene as its file says it. Fails if the camera would be in the ground.
Result<Session> session_of(const Scene& scene, const HeightField& ground);

// The session after its scene's file was written anew: what the file now says otherwise holds, all else stays as the user left it. Under
// another ground the eye is lifted out of it. Fails if the file puts the camera into the ground.
Result<Session> reloaded(const Session& session, const Scene& scene, const HeightField& ground);

// The camera of the session's eye, for pictures of this size.
Camera camera_of(const Session& session, int width, int height);

// The scene that the session has become: the file's ground under its eye, its air, and what stands above, seen from there.
Scene scene_of(const Session& session);

// Where the sun stands at the eye's place: radians, zenith from straight up, azimuth from north, clockwise.
struct SunAngles {
    double zenith, azimuth;
};
SunAngles sun_angles(const Session& session);

// The sun at angles over the eye's place; moon and stars stay where they are.
void place_sun(Session& session, SunAngles angles);
// Sun, moon and stars of a moment.
void set_time(Session& session, const Utc& time);

// The factor that the scroll wheel's `notches` put on the speed; within bounds that a pilot can still use.
void change_speed(Session& session, double notches);

// A place in the air above where the eye is, and a sun over it. Its name is what a menu shows.
struct Preset {
    std::string_view name;
    double height_m;       // above the ground
    double pitch;          // radians
    double sun_zenith;     // radians
    double sun_from_view;  // radians, the sun's azimuth right of where the eye looks
};
std::span<const Preset> presets();
void go_to(Session& session, const Preset& preset, const HeightField& ground);

}  // namespace airlight::viewer
