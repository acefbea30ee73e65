// Any bytes are a camera path or a refusal; a path that was read, written again, reads back the same, and leads somewhere at any time.

#include <cmath>

#include "fuzz.h"
#include "scene/camera_path.h"

using namespace airlight;
using fuzz::demand;

namespace {

HeightField smooth() {
    return {.radius_m = 6.371e6,
            .sample =
                [](Vec3, double) {
                    return HeightSample{1e3, {}, {}, {}};
                },
            .range = {},
            .detail = {},
            .whole = {}};
}

void check_way(const CameraPath& path) {
    for (int i = 0; i <= 16; ++i) {
        const CameraKey there = camera_at(path, path.begin_s() + (path.end_s() - path.begin_s()) * i / 16.0);
        demand(std::abs(there.eye.latitude) <= 0.5 * pi && std::isfinite(there.eye.longitude), "a way has places");
        demand(std::abs(there.eye.altitude_m) <= 1.001e9, "a way goes beyond no key");
        demand(std::isfinite(there.eye.heading) && std::abs(there.eye.pitch) <= 0.5 * pi + 1e-9, "a way has views");
        demand(there.sky_time.has_value() == path.keys[0].sky_time.has_value(), "all of a way has a time, or none");
    }
}

bool same(const CameraPath& a, const CameraPath& b) {
    if (a.keys.size() != b.keys.size()) return false;
    for (std::size_t i = 0; i < a.keys.size(); ++i) {
        CameraKey one = a.keys[i], other = b.keys[i];
        if (one.sky_time && other.sky_time && std::abs(seconds_between(*one.sky_time, *other.sky_time)) > 1e-3 + 1e-6) return false;
        one.sky_time = other.sky_time;  // written to a millisecond
        if (!(one == other)) return false;
    }
    return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<CameraPath> path = parse_camera_path(fuzz::text_of(data, size), "fuzz.toml");
    if (!path) {
        fuzz::demand_message(path.error());
        return 0;
    }
    const Result<CameraPath> again = parse_camera_path(camera_path_text(*path), "written.toml");
    demand(again && same(*again, *path), "a written path reads back");
    check_way(over(smooth(), *path));
    return 0;
}
