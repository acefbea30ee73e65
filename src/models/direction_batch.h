// Directions of view in batches: the cosines that fitted skies want of them, in loops for the vector unit.
// Uses physics/models/batch.h; knows no model.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "physics/models/batch.h"
#include "sky/sky.h"

namespace airlight {

// sin x for |x| <= pi / 2, by its Taylor polynomial: off by less than 1.2e-7.
AIRLIGHT_INLINE float short_sine(float x) {
    const float y = x * x;
    float p = 1.0f / 6227020800.0f;
    p = p * y - 1.0f / 39916800.0f;
    p = p * y + 1.0f / 362880.0f;
    p = p * y - 1.0f / 5040.0f;
    p = p * y + 1.0f / 120.0f;
    p = p * y - 1.0f / 6.0f;
    return x + x * y * p;
}

// The sun of a dome.
struct BatchSun {
    explicit BatchSun(double zenith) : mu_s(static_cast<float>(std::cos(zenith))), sin_s(static_cast<float>(std::sin(zenith))) {}
    float mu_s, sin_s;
};

// Directions of the upper hemisphere, as many as stay in the nearest cache with what is computed of them.
struct DirectionBatch {
    static constexpr std::size_t size = 64;
    alignas(32) float mu[size];     // cosine of the zenith angle; 0 below the horizon
    alignas(32) float nu[size];     // cosine of the angle from the sun
    alignas(32) float gamma[size];  // that angle

    // Takes at most size directions.
    void fill(std::span<const Direction> directions, const BatchSun& sun) {
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const double z = directions[i].view_zenith;
            const double turns = directions[i].relative_azimuth * (0.5 / pi);
            const float elevation = static_cast<float>(0.5 * pi - z);  // exact at the horizon, where the cosine is small
            // Half the azimuth, -pi / 2 to pi / 2: cos(azimuth) = 1 - 2 sin^2(azimuth / 2).
            const float s = short_sine(static_cast<float>((turns - std::floor(turns + 0.5)) * pi));
            mu[i] = short_sine(elevation > 0.0f ? elevation : 0.0f);
            const float sin_z = short_sine(static_cast<float>(z < 0.5 * pi ? z : 0.5 * pi));
            const float cosine = mu[i] * sun.mu_s + sin_z * sun.sin_s * (1.0f - 2.0f * s * s);
            nu[i] = cosine > 1.0f ? 1.0f : (cosine < -1.0f ? -1.0f : cosine);
        }
        for (std::size_t i = 0; i < directions.size(); ++i) gamma[i] = batch::angle_of_cosine(batch::Number::of(nu[i])).value;
    }
};

// Calls body(first, directions) for each batch of at most DirectionBatch::size.
template <class Body>
void for_each_batch(std::span<const Direction> directions, Body body) {
    for (std::size_t first = 0; first < directions.size(); first += DirectionBatch::size)
        body(first, directions.subspan(first, std::min(DirectionBatch::size, directions.size() - first)));
}

// A model that answers above the horizon alone is dark below it, a hair apart.
inline bool below_horizon(const Direction& direction) { return direction.view_zenith > 0.5 * pi + 1e-9; }

}  // namespace airlight
