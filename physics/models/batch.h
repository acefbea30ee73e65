// The run-time parts of the fitted skies in float, for loops over many directions: f32's arithmetic with an exponential without
// a branch or a call (fast_exp, units/spectral.h), and every function a part of the loop's body. So compilers run the loop in the
// vector unit; with the library's exponential it is ten times slower.
#pragma once

#include <cmath>

#include "physics/readings/macros.h"
#include "units/spectral.h"

namespace airlight::batch {

struct Number {
    float value;

    Number() = default;
    AIRLIGHT_INLINE constexpr Number(double x) : value(static_cast<float>(x)) {}
    static AIRLIGHT_INLINE Number of(float x) {
        Number r;
        r.value = x;
        return r;
    }
    friend AIRLIGHT_INLINE Number operator+(Number a, Number b) { return of(a.value + b.value); }
    friend AIRLIGHT_INLINE Number operator-(Number a, Number b) { return of(a.value - b.value); }
    friend AIRLIGHT_INLINE Number operator*(Number a, Number b) { return of(a.value * b.value); }
    friend AIRLIGHT_INLINE Number operator/(Number a, Number b) { return of(a.value / b.value); }
    friend AIRLIGHT_INLINE Number operator-(Number a) { return of(-a.value); }
    friend AIRLIGHT_INLINE Number max(Number a, Number b) { return of(a.value > b.value ? a.value : b.value); }
    friend AIRLIGHT_INLINE Number abs(Number a) { return of(std::abs(a.value)); }
    // 1 at 0, where the text uses it for an angle that is then the same on both sides: copysign is an operation on bits.
    friend AIRLIGHT_INLINE Number sign(Number a) { return of(std::copysign(1.0f, a.value)); }
    friend AIRLIGHT_INLINE Number sqrt(Number a) { return of(std::sqrt(a.value)); }
    friend AIRLIGHT_INLINE Number exp(Number a) { return of(fast_exp(a.value)); }
    // For what does not depend on the direction.
    friend AIRLIGHT_INLINE Number sin(Number a) { return of(std::sin(a.value)); }
    friend AIRLIGHT_INLINE Number cos(Number a) { return of(std::cos(a.value)); }
    friend AIRLIGHT_INLINE Number pow(Number a, double b) { return of(std::pow(a.value, static_cast<float>(b))); }
};

constexpr Number pi = Number(3.14159265358979323846);

#pragma push_macro("FN")
#undef FN
#define FN AIRLIGHT_INLINE
// In the order in which they use each other.
// clang-format off
#include "physics/angle.glsl"
#include "physics/models/perez.glsl"
#include "physics/models/cie2003.glsl"
#include "physics/models/preetham1999.glsl"
#include "physics/models/hosek2012.glsl"
// clang-format on
#pragma pop_macro("FN")

}  // namespace airlight::batch
