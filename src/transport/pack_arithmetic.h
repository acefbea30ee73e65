// Spectra of a pack in single precision: zero, narrowing, sums. Internal to the inner loops of tables, whose flags it is compiled with.
// Uses physics (f32).
#pragma once

#include "transport/air_optics.h"

namespace airlight {

template <class Spectrum>
AIRLIGHT_INLINE Spectrum zero() {
    return Spectrum(Spectrum::Scalar::of(0.0f));
}

// The same values in single precision, as a spectrum of type To.
template <class To, class From>
AIRLIGHT_INLINE To narrowed(const From& from) {
    To to;
    for (int i = 0; i < pack_size; ++i) to.v[i] = static_cast<float>(from.v[i]);
    return to;
}

template <class Spectrum>
AIRLIGHT_INLINE void add_scaled(Spectrum& sum, const Spectrum& x, float factor) {
    for (int w = 0; w < Spectrum::size; ++w) sum.v[w] += factor * x.v[w];
}

}  // namespace airlight
