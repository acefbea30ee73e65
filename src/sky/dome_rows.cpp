#include "sky/dome_rows.h"

#include <algorithm>
#include <cmath>

namespace airlight {

namespace {

// A layer that begins so little above the eye has its edge in the eye's horizontal.
constexpr double beside_the_eye_m = 500.0;

// Where a ray from r touches the sphere of a radius, or pi / 2 from within it.
double tangent(double radius, double r) { return pi - std::asin(std::min(1.0, radius / r)); }

}  // namespace

Stencil stencil_of(double s, int first, int count, bool mirrored) {
    const double x = std::clamp(s, 0.0, 1.0) * (count - 1);
    const int low = std::min(static_cast<int>(x), count - 2);
    const float t = static_cast<float>(x - low);
    Stencil stencil{{first + low - 1, first + low, first + low + 1, first + low + 2},
                    {0.5f * t * ((2.0f - t) * t - 1.0f), 0.5f * (t * t * (3.0f * t - 5.0f) + 2.0f),
                     0.5f * t * ((4.0f - 3.0f * t) * t + 1.0f), 0.5f * t * t * (t - 1.0f)}};
    auto& weight = stencil.weight;
    if (low == 0 && mirrored) stencil.at[0] = first + 1;
    else if (low == 0) {
        // The parabola through the first three places stands for the one before them.
        const float outside = weight[0];
        stencil.at[0] = first;
        weight = {3.0f * outside, weight[1], weight[2] - 3.0f * outside, weight[3] + outside};
    }
    if (low == count - 2 && mirrored) stencil.at[3] = first + count - 2;
    else if (low == count - 2) {
        const float outside = weight[3];
        stencil.at[3] = first + count - 1;
        weight = {weight[0] + outside, weight[1] - 3.0f * outside, weight[2], 3.0f * outside};
    }
    return stencil;
}

DomeRows::DomeRows(const Shell& shell, Length altitude, std::span<const double> jumps_m, int sky_rows, int ground_rows)
    : h_(std::max(altitude.value, lowest_eye_m)), bottom_(shell.bottom_m), farthest_(std::sqrt(h_ * (2.0 * bottom_ + h_))) {
    const double r = bottom_ + altitude.value, top = bottom_ + shell.top_m;
    std::vector<double> ends{r <= top ? 0.0 : tangent(top, r)};
    for (std::size_t i = jumps_m.size(); i-- > 0;)
        if (jumps_m[i] <= altitude.value + beside_the_eye_m && tangent(bottom_ + jumps_m[i], r) > ends.back() + 0.01 * deg)
            ends.push_back(tangent(bottom_ + jumps_m[i], r));
    const double horizon = tangent(bottom_, r);
    if (ends.size() > 1 && ends.back() > horizon - 0.01 * deg) ends.pop_back();
    ends.push_back(horizon);
    int first = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        segments_.push_back({ends[i], ends[i + 1], first, i == 0 ? sky_rows : std::max(4, sky_rows / 3)});
        first += segments_.back().count;
    }
    segments_.push_back({horizon, pi, first, ground_rows});
}

// Of the ground in a direction below the horizon.
double DomeRows::ground_distance(double view_zenith) const {
    const double fall = -(bottom_ + h_) * std::cos(view_zenith);
    return farthest_ * farthest_ / (fall + std::sqrt(std::max(fall * fall - farthest_ * farthest_, 0.0)));
}

// On the ground, half by the logarithm of the distance, which near the horizon runs away, and half by the angle, which it does not
// tell near the nadir.
double DomeRows::ground_place(double view_zenith) const {
    const Segment& ground = segments_.back();
    return 0.5 * std::log(farthest_ / ground_distance(view_zenith)) / std::log(farthest_ / h_) +
           0.5 * (view_zenith - ground.from) / (ground.to - ground.from);
}

double DomeRows::place(const Segment& segment, double view_zenith) const {
    if (&segment == &segments_.back()) return ground_place(view_zenith);
    const double t = std::clamp((view_zenith - segment.from) / (segment.to - segment.from), 0.0, 1.0);
    // Crowded towards the lower end, and towards the upper one unless it is the zenith.
    return segment.from == 0.0 ? 1.0 - std::sqrt(1.0 - t) : 2.0 / pi * std::asin(std::sqrt(t));
}

double DomeRows::zenith(int row) const {
    const auto segment = std::find_if(segments_.begin(), segments_.end(), [&](const Segment& s) { return row < s.first + s.count; });
    const double s = static_cast<double>(row - segment->first) / (segment->count - 1);
    // The inverse of place(), by halving: what lies on which side of the horizon and of a tangent is certain.
    double low = segment->from, high = segment->to;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (place(*segment, middle) < s ? low : high) = middle;
    }
    // A hair off a segment's ends, on its own side.
    const double hair = 1e-9 * (segment->to - segment->from);
    return std::clamp(0.5 * (low + high), segment->from > 0.0 ? segment->from + hair : 0.0, segment->to < pi ? segment->to - hair : pi);
}

Stencil DomeRows::at(double view_zenith) const {
    const auto segment = std::find_if(segments_.begin(), segments_.end() - 1, [&](const Segment& s) { return view_zenith <= s.to; });
    return stencil_of(place(*segment, view_zenith), segment->first, segment->count, false);
}

}  // namespace airlight
