#include "models/preetham1999_rgb.h"

#include <cassert>

#include "physics/models/f64.h"

namespace airlight {

namespace {

batch::PerezCoefficients in_batch(const f64::PerezCoefficients& k) { return {k.a.value, k.b.value, k.c.value, k.d.value, k.e.value}; }

batch::Preetham1999 in_batch(const f64::Preetham1999& sky) {
    return {in_batch(sky.luminance), in_batch(sky.x), in_batch(sky.y), {sky.scale.luminance.value, sky.scale.x.value, sky.scale.y.value}};
}

}  // namespace

Preetham1999Rgb::Preetham1999Rgb(double turbidity, double sun_zenith)
    : sun_(sun_zenith), sky_(in_batch(f64::preetham1999(turbidity, sun_zenith))) {
    assert(turbidity >= 1.7 && turbidity <= 10.0 && sun_zenith >= 0.0 && sun_zenith <= 0.5 * airlight::pi);
}

void Preetham1999Rgb::radiances(std::span<const Direction> directions, std::span<float> rgb) const {
    assert(rgb.size() == 3 * directions.size());
    using batch::Number;
    DirectionBatch d;
    alignas(32) float red[DirectionBatch::size], green[DirectionBatch::size], blue[DirectionBatch::size];
    for_each_batch(directions, [&](std::size_t first, std::span<const Direction> asked) {
        d.fill(asked, sun_);
        const batch::Preetham1999 sky = sky_;  // a copy that no write to the arrays can change
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const batch::LinearSrgb seen =
                batch::linear_srgb(batch::preetham1999_towards(sky, Number::of(d.mu[i]), Number::of(d.nu[i]), Number::of(d.gamma[i])));
            red[i] = seen.r.value;
            green[i] = seen.g.value;
            blue[i] = seen.b.value;
        }
        float* out = &rgb[3 * first];
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const float up = below_horizon(asked[i]) ? 0.0f : 1.0f;
            out[3 * i] = up * red[i];
            out[3 * i + 1] = up * green[i];
            out[3 * i + 2] = up * blue[i];
        }
    });
}

}  // namespace airlight
