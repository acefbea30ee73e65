// The zenith angles of a dome's rows, placed where the sky around one eye changes: in segments between the edge of the air, the
// tangents of layers below the eye, and the horizon, crowded towards these; and on the ground by distance and angle.
// Knows nothing of light.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "transport/ray_nodes.h"
#include "units/units.h"

namespace airlight {

// Four neighbours and their weights, of a cubic by Catmull and Rom.
struct Stencil {
    std::array<int, 4> at;
    std::array<float, 4> weight;
};
// Of s between 0 and 1 among `count` places from `first`, at least 4; beyond the ends go on parabolas, or mirror images.
Stencil stencil_of(double s, int first, int count, bool mirrored);

class DomeRows {
public:
    // Below it the ground is so near that its distance says nothing; an eye there counts as one at this altitude.
    static constexpr double lowest_eye_m = 0.01;

    // `jumps_m`: altitudes where the air's density jumps, increasing. Rows: of the uppermost segment of the sky (each other one has
    // a third of them), and of the ground; at least 4.
    DomeRows(const Shell& shell, Length altitude, std::span<const double> jumps_m, int sky_rows, int ground_rows);

    // Zenith angles between which nothing is interpolated, and their rows; the last is the ground.
    struct Segment {
        double from, to;
        int first, count;
    };
    std::span<const Segment> segments() const { return segments_; }

    int size() const { return segments_.back().first + segments_.back().count; }
    double zenith(int row) const;
    // Zenith angle where the air begins: 0 within it.
    double edge() const { return segments_.front().from; }
    // Of a zenith angle from edge() to pi.
    Stencil at(double view_zenith) const;

private:
    double place(const Segment& segment, double view_zenith) const;  // 0 to 1
    double ground_place(double view_zenith) const;
    double ground_distance(double view_zenith) const;

    double h_, bottom_;  // of the eye and of the ground, m
    double farthest_;    // distance to the horizon
    std::vector<Segment> segments_;
};

}  // namespace airlight
