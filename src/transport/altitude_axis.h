// The altitudes of a table's texels, dense towards the ground, with a texel on either side of each jump of density.
// Theory: docs/theory.md, section 5.1. Uses the maps of physics; knows nothing of what is in the table.
#pragma once

#include <span>
#include <vector>

#include "transport/table.h"

namespace airlight {

// Segments between jumps of density. Two texels stand at a jump, one that ends the segment below and one that begins the segment
// above, and nothing is interpolated between them: what is scattered there jumps with the mixture of the air, and texels on both
// sides of a jump would blend haze with the clear air above it. In the highest segment texels are even in the root of the altitude;
// in one that ends at a jump they crowd, besides, as the square towards it: a low sun lights no more than the skin of a layer, whose
// depth along the sun's rays grows as the root of the depth below its edge.
class AltitudeAxis {
public:
    struct Segment {
        float from;  // altitude_coordinate of its first texel
        float inverse_range;
        int first;
        int last;
        bool crowds;  // towards its upper end, a jump
    };

    // `size` texels, 2 or more, from the ground to `top_m`; `jumps_m` are increasing and lie between. Each segment has at least two
    // texels; where there are too few texels for that, the upper jumps are left out.
    AltitudeAxis(double top_m, std::span<const double> jumps_m, int size);

    int size() const { return segments_.back().last + 1; }

    std::span<const Segment> segments() const { return segments_; }

    // The altitude of a texel, in metres.
    double altitude_m(int texel) const;
    // The same a millionth of it into the texel's own segment, where a density that jumps has the segment's value.
    double inner_altitude_m(int texel) const;

    // The texels around an altitude; above the top the last.
    AIRLIGHT_INLINE Texels at(float altitude_m) const {
        const float u = f32::altitude_coordinate(f32::Length::of(altitude_m), f32::Length::of(top_m_)).value;
        std::size_t s = 0;
        while (s + 1 < segments_.size() && u >= segments_[s + 1].from) ++s;
        const Segment& segment = segments_[s];
        const float t = (u - segment.from) * segment.inverse_range;
        const float v = segment.crowds ? 1.0f - __builtin_sqrtf(t < 1.0f ? 1.0f - t : 0.0f) : t;
        const float x = static_cast<float>(segment.first) + v * static_cast<float>(segment.last - segment.first);
        const float clamped = x < static_cast<float>(segment.last) ? x : static_cast<float>(segment.last);
        const int low = clamped < static_cast<float>(segment.last - 1) ? static_cast<int>(clamped) : segment.last - 1;
        return {low, low + 1, clamped - static_cast<float>(low)};
    }

private:
    const Segment& segment_of(int texel) const;

    float top_m_;
    std::vector<double> ends_m_;  // [segments + 1], from the ground to the top
    std::vector<Segment> segments_;
};

}  // namespace airlight
