#include "transport/altitude_axis.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "physics/f64.h"

namespace airlight {

namespace {

double coordinate_of(double altitude_m, double top_m) {
    return f64::altitude_coordinate(f64::Length::of(altitude_m), f64::Length::of(top_m)).value;
}

}  // namespace

AltitudeAxis::AltitudeAxis(double top_m, std::span<const double> jumps_m, int size) : top_m_(static_cast<float>(top_m)) {
    assert(size >= 2);
    const std::size_t count = std::min(jumps_m.size() + 1, static_cast<std::size_t>(size / 2));
    ends_m_.push_back(0.0);
    for (std::size_t s = 0; s + 1 < count; ++s) ends_m_.push_back(jumps_m[s]);
    ends_m_.push_back(top_m);
    // Beyond its two, half of the texels are shared out by the length of segments and half evenly: a layer is thin for its depth.
    const double spare = size - 2.0 * static_cast<double>(count);
    for (std::size_t s = 0; s < count; ++s) {
        const double from = coordinate_of(ends_m_[s], top_m), to = coordinate_of(ends_m_[s + 1], top_m);
        const int first = s == 0 ? 0 : segments_.back().last + 1;
        const double shared = spare * 0.5 * (to + static_cast<double>(s + 1) / static_cast<double>(count));  // by all up to here
        const int last = s + 1 == count ? size - 1 : static_cast<int>(std::lround(shared)) + 2 * static_cast<int>(s + 1) - 1;
        segments_.push_back({static_cast<float>(from), static_cast<float>(1.0 / (to - from)), first, last, s + 1 < count});
    }
}

const AltitudeAxis::Segment& AltitudeAxis::segment_of(int texel) const {
    assert(texel >= 0 && texel < size());
    return *std::find_if(segments_.begin(), segments_.end(), [&](const Segment& s) { return texel <= s.last; });
}

double AltitudeAxis::altitude_m(int texel) const {
    const Segment& segment = segment_of(texel);
    const auto s = static_cast<std::size_t>(&segment - segments_.data());
    if (texel == segment.first) return ends_m_[s];
    if (texel == segment.last) return ends_m_[s + 1];
    const double top = ends_m_.back();
    const double from = coordinate_of(ends_m_[s], top), to = coordinate_of(ends_m_[s + 1], top);
    const double v = static_cast<double>(texel - segment.first) / (segment.last - segment.first);
    const double u = from + (to - from) * (segment.crowds ? v * (2.0 - v) : v);
    return f64::altitude_of_coordinate(u, f64::Length::of(top)).value;
}

double AltitudeAxis::inner_altitude_m(int texel) const {
    const Segment& segment = segment_of(texel);
    const double hair = texel == segment.first ? 1e-6 : texel == segment.last ? -1e-6 : 0.0;
    return altitude_m(texel) * (1.0 + hair);
}

}  // namespace airlight
