#include "viewer/flight.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace airlight::viewer {

namespace {

// Speed and ground are taken anew after so long; an eye that falls at its height a second is 0.1 % off then.
constexpr double longest_step_s = 1.0 / 500.0;
// Below this height a pilot is as fast as at it: a walk, where the height alone would let no one move.
constexpr double slowest_height_m = 4.0;

struct LocalFrame {
    Vec3 up, east, north;
};
LocalFrame frame_of(double latitude, double longitude) {
    const Vec3 up = direction_of(latitude, longitude), east(-std::sin(longitude), std::cos(longitude), 0.0);
    return {up, east, glm::cross(up, east)};
}

// The eye at a place, looking along `level` as far as the place's horizon allows, with the pitch of before.
Viewpoint moved(const Viewpoint& eye, Vec3 place_m, Vec3 level, double radius_m) {
    Viewpoint there = eye;
    const double r = glm::length(place_m);
    there.altitude_m = r - radius_m;
    there.latitude = std::asin(std::clamp(place_m.z / r, -1.0, 1.0));
    there.longitude = std::atan2(place_m.y, place_m.x);
    const LocalFrame frame = frame_of(there.latitude, there.longitude);
    there.heading = std::atan2(glm::dot(level, frame.east), glm::dot(level, frame.north));
    return there;
}

Viewpoint step(const Viewpoint& eye, const Steering& steering, double per_s, double seconds, const HeightField& ground) {
    const LocalFrame frame = frame_of(eye.latitude, eye.longitude);
    const Vec3 level = std::sin(eye.heading) * frame.east + std::cos(eye.heading) * frame.north;
    const Vec3 right = std::cos(eye.heading) * frame.east - std::sin(eye.heading) * frame.north;
    const Vec3 forward = std::cos(eye.pitch) * level + std::sin(eye.pitch) * frame.up;
    const double way_m = speed_m_s(height_m(eye, ground), per_s) * seconds;
    const Vec3 place = (ground.radius_m + eye.altitude_m) * frame.up +
                       way_m * (steering.forward * forward + steering.right * right + steering.up * frame.up);
    return above_ground(moved(eye, place, level, ground.radius_m), ground);
}

}  // namespace

double height_m(const Viewpoint& eye, const HeightField& ground) { return eye.altitude_m - surface_m(eye, ground); }

double speed_m_s(double height_above_ground_m, double per_s) { return per_s * std::max(height_above_ground_m, slowest_height_m); }

Viewpoint flown(Viewpoint eye, const Steering& steering, double per_s, double seconds, const HeightField& ground) {
    assert(per_s > 0.0 && seconds >= 0.0);
    if (steering.forward == 0.0 && steering.right == 0.0 && steering.up == 0.0) return eye;
    const int steps = static_cast<int>(std::ceil(std::max(1.0, per_s) * seconds / longest_step_s));
    for (int i = 0; i < steps; ++i) eye = step(eye, steering, per_s, seconds / steps, ground);
    return eye;
}

Viewpoint turned(Viewpoint eye, double right, double up) {
    eye.heading = std::remainder(eye.heading + right, 2.0 * pi);
    eye.pitch = std::clamp(eye.pitch + up, -0.5 * pi, 0.5 * pi);
    return eye;
}

Viewpoint above_ground(Viewpoint eye, const HeightField& ground) {
    eye.altitude_m = std::clamp(eye.altitude_m, surface_m(eye, ground) + lowest_eye_m, highest_eye_m);
    return eye;
}

}  // namespace airlight::viewer
