// N wavelengths of one quantity, worked on together: what the inner loops of radiative transfer carry.
// A plain aligned array with loops of constant length, which compilers turn into vector instructions
// (compiler vector types were three times slower, docs/decisions/0002-one-text.md).
#pragma once

#include "units/quantity.h"

#define AIRLIGHT_INLINE __attribute__((always_inline)) inline

namespace airlight {

template <class R, int N, int L, int W, int S, int P>
struct Spectral {
    using Scalar = Quantity<R, L, W, S, P>;
    using Rep = R;
    static constexpr int size = N;

    alignas(32) R v[N];  // in the base units: m, nm, sr, W

    Spectral() = default;
    AIRLIGHT_INLINE explicit Spectral(Scalar all) {
        for (int i = 0; i < N; ++i) v[i] = all.value;
    }

    // Reading one wavelength; writing goes through set(), which GLSL's text cannot name.
    AIRLIGHT_INLINE Scalar operator[](int i) const { return Scalar::of(v[i]); }
    AIRLIGHT_INLINE void set(int i, Scalar x) { v[i] = x.value; }

    friend AIRLIGHT_INLINE Spectral operator+(const Spectral& a, const Spectral& b) {
        Spectral r;
        for (int i = 0; i < N; ++i) r.v[i] = a.v[i] + b.v[i];
        return r;
    }
    friend AIRLIGHT_INLINE Spectral operator-(const Spectral& a, const Spectral& b) {
        Spectral r;
        for (int i = 0; i < N; ++i) r.v[i] = a.v[i] - b.v[i];
        return r;
    }
    friend AIRLIGHT_INLINE Spectral operator-(const Spectral& a) {
        Spectral r;
        for (int i = 0; i < N; ++i) r.v[i] = -a.v[i];
        return r;
    }
    friend AIRLIGHT_INLINE Spectral operator*(double a, const Spectral& b) {
        Spectral r;
        for (int i = 0; i < N; ++i) r.v[i] = static_cast<R>(a) * b.v[i];
        return r;
    }
    friend AIRLIGHT_INLINE Spectral operator*(const Spectral& a, double b) { return b * a; }
    AIRLIGHT_INLINE Spectral& operator+=(const Spectral& b) {
        for (int i = 0; i < N; ++i) v[i] += b.v[i];
        return *this;
    }
};

template <class R, int N, int L, int W, int S, int P, int L2, int W2, int S2, int P2>
AIRLIGHT_INLINE Spectral<R, N, L + L2, W + W2, S + S2, P + P2> operator*(const Spectral<R, N, L, W, S, P>& a,
                                                                         const Spectral<R, N, L2, W2, S2, P2>& b) {
    Spectral<R, N, L + L2, W + W2, S + S2, P + P2> r;
    for (int i = 0; i < N; ++i) r.v[i] = a.v[i] * b.v[i];
    return r;
}
template <class R, int N, int L, int W, int S, int P, int L2, int W2, int S2, int P2>
AIRLIGHT_INLINE Spectral<R, N, L + L2, W + W2, S + S2, P + P2> operator*(const Spectral<R, N, L, W, S, P>& a,
                                                                         Quantity<R, L2, W2, S2, P2> b) {
    Spectral<R, N, L + L2, W + W2, S + S2, P + P2> r;
    for (int i = 0; i < N; ++i) r.v[i] = a.v[i] * b.value;
    return r;
}
template <class R, int N, int L, int W, int S, int P, int L2, int W2, int S2, int P2>
AIRLIGHT_INLINE Spectral<R, N, L + L2, W + W2, S + S2, P + P2> operator*(Quantity<R, L2, W2, S2, P2> b,
                                                                         const Spectral<R, N, L, W, S, P>& a) {
    return a * b;
}
template <class R, int N, int L, int W, int S, int P, int L2, int W2, int S2, int P2>
AIRLIGHT_INLINE Spectral<R, N, L - L2, W - W2, S - S2, P - P2> operator/(const Spectral<R, N, L, W, S, P>& a,
                                                                         const Spectral<R, N, L2, W2, S2, P2>& b) {
    Spectral<R, N, L - L2, W - W2, S - S2, P - P2> r;
    for (int i = 0; i < N; ++i) r.v[i] = a.v[i] / b.v[i];
    return r;
}
template <class R, int N, int L, int W, int S, int P, int L2, int W2, int S2, int P2>
AIRLIGHT_INLINE Spectral<R, N, L - L2, W - W2, S - S2, P - P2> operator/(const Spectral<R, N, L, W, S, P>& a,
                                                                         Quantity<R, L2, W2, S2, P2> b) {
    Spectral<R, N, L - L2, W - W2, S - S2, P - P2> r;
    for (int i = 0; i < N; ++i) r.v[i] = a.v[i] / b.value;
    return r;
}

template <class Scalar, int N>
struct SpectralOfQuantity;
template <class R, int L, int W, int S, int P, int N>
struct SpectralOfQuantity<Quantity<R, L, W, S, P>, N> {
    using Type = Spectral<R, N, L, W, S, P>;
};
// N wavelengths of the quantity `Scalar`.
template <class Scalar, int N>
using SpectralOf = typename SpectralOfQuantity<Scalar, N>::Type;

// e^x without a branch or a library call, so that the loop over wavelengths stays in vector registers.
// x is split into k ln 2 + f, |f| <= ln 2 / 2; e^f by its Taylor polynomial; 2^k by the exponent's bits.
// float: |relative error| < 1.2e-7; double: < 3e-16. Below the range of normal numbers the result is 0.
AIRLIGHT_INLINE float fast_exp(float x) {
    const float clamped = x < -87.0f ? -87.0f : (x > 88.0f ? 88.0f : x);
    const float t = clamped * 1.44269504f;
    const int k = static_cast<int>(t + 127.5f) - 127;  // rounds by cutting: t + 127.5 is above zero, and there is no branch
    const float kf = static_cast<float>(k);
    const float f = (clamped - kf * 0.693359375f) + kf * 2.12194440e-4f;
    float p = 1.0f / 5040.0f;
    p = p * f + 1.0f / 720.0f;
    p = p * f + 1.0f / 120.0f;
    p = p * f + 1.0f / 24.0f;
    p = p * f + 1.0f / 6.0f;
    p = p * f + 0.5f;
    p = p * f + 1.0f;
    p = p * f + 1.0f;
    const float r = p * __builtin_bit_cast(float, (k + 127) << 23);
    return x < -87.0f ? 0.0f : r;
}
AIRLIGHT_INLINE double fast_exp(double x) {
    const double clamped = x < -708.0 ? -708.0 : (x > 709.0 ? 709.0 : x);
    const double t = clamped * 1.4426950408889634;
    // Through int, not long: AVX2 converts doubles only to 32-bit integers.
    const int k = static_cast<int>(t + 1023.5) - 1023;
    const double kf = static_cast<double>(k);
    const double f = (clamped - kf * 6.93147180369123816490e-01) - kf * 1.90821492927058770002e-10;
    double p = 1.0 / 6227020800.0;
    p = p * f + 1.0 / 479001600.0;
    p = p * f + 1.0 / 39916800.0;
    p = p * f + 1.0 / 3628800.0;
    p = p * f + 1.0 / 362880.0;
    p = p * f + 1.0 / 40320.0;
    p = p * f + 1.0 / 5040.0;
    p = p * f + 1.0 / 720.0;
    p = p * f + 1.0 / 120.0;
    p = p * f + 1.0 / 24.0;
    p = p * f + 1.0 / 6.0;
    p = p * f + 0.5;
    p = p * f + 1.0;
    p = p * f + 1.0;
    const double r = p * __builtin_bit_cast(double, static_cast<long long>(k + 1023) << 52);
    return x < -708.0 ? 0.0 : r;
}

// The natural logarithm of a normal number above 0, without a branch or a library call.
// x is split into 2^k and a part from sqrt(1/2) to sqrt(2), whose logarithm is by the series of the inverse hyperbolic tangent. |error| < 2e-7 (1 + |ln x|).
AIRLIGHT_INLINE float fast_log(float x) {
    const int bits = __builtin_bit_cast(int, x);
    const int k = (bits - 0x3f3504f3) >> 23;  // 0x3f3504f3: sqrt(1/2)
    const float part = __builtin_bit_cast(float, bits - (k << 23));
    const float z = (part - 1.0f) / (part + 1.0f), zz = z * z;
    float p = 2.0f / 9.0f;
    p = p * zz + 2.0f / 7.0f;
    p = p * zz + 2.0f / 5.0f;
    p = p * zz + 2.0f / 3.0f;
    p = p * zz + 2.0f;
    return p * z + static_cast<float>(k) * 0.69314718f;
}

template <class R, int N>
AIRLIGHT_INLINE Spectral<R, N, 0, 0, 0, 0> exp(const Spectral<R, N, 0, 0, 0, 0>& x) {
    Spectral<R, N, 0, 0, 0, 0> r;
    for (int i = 0; i < N; ++i) r.v[i] = fast_exp(x.v[i]);
    return r;
}
template <class R, int N, int L, int W, int S, int P>
AIRLIGHT_INLINE Spectral<R, N, L, W, S, P> max(const Spectral<R, N, L, W, S, P>& a, const Spectral<R, N, L, W, S, P>& b) {
    Spectral<R, N, L, W, S, P> r;
    for (int i = 0; i < N; ++i) r.v[i] = a.v[i] > b.v[i] ? a.v[i] : b.v[i];
    return r;
}

}  // namespace airlight
