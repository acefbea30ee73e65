// Numbers with a physical dimension, checked by the compiler, at no cost at run time.
// A bare number becomes a quantity only times a unit (8.0 * km), and leaves only by .in(unit).
// The dimensions are length, wavelength, solid angle and power; wavelength is kept apart from length so that
// "per metre" and "per nanometre of wavelength" cannot be confused.
#pragma once

#include <cmath>
#include <type_traits>

namespace airlight {

template <class R, int L, int W, int S, int P>
struct Quantity;

// A dimensionless quantity in the representation R. It alone converts from a bare number.
template <class R>
using NumberOf = Quantity<R, 0, 0, 0, 0>;

template <class R, int L, int W, int S, int P>
struct Quantity {
    using Rep = R;
    static constexpr bool dimensionless = L == 0 && W == 0 && S == 0 && P == 0;

    R value;  // in the base units: m, nm, sr, W

    constexpr Quantity() = default;
    constexpr Quantity(double number) requires dimensionless : value(static_cast<R>(number)) {}
    static constexpr Quantity of(R base_value) {
        Quantity q;
        q.value = base_value;
        return q;
    }

    // The same quantity in another representation (double to float at a border).
    template <class R2>
    constexpr explicit Quantity(Quantity<R2, L, W, S, P> other) requires(!std::is_same_v<R, R2>) : value(static_cast<R>(other.value)) {}

    constexpr R in(Quantity unit) const { return value / unit.value; }
    constexpr explicit operator int() const requires dimensionless { return static_cast<int>(value); }

    friend constexpr Quantity operator+(Quantity a) { return a; }
    friend constexpr Quantity operator-(Quantity a) { return of(-a.value); }
    friend constexpr Quantity operator+(Quantity a, Quantity b) { return of(a.value + b.value); }
    friend constexpr Quantity operator-(Quantity a, Quantity b) { return of(a.value - b.value); }
    friend constexpr Quantity operator*(double a, Quantity b) { return of(static_cast<R>(a) * b.value); }
    friend constexpr Quantity operator*(Quantity a, double b) { return of(a.value * static_cast<R>(b)); }
    friend constexpr Quantity operator/(Quantity a, double b) { return of(a.value / static_cast<R>(b)); }
    constexpr Quantity& operator+=(Quantity b) { return *this = *this + b; }
    constexpr Quantity& operator-=(Quantity b) { return *this = *this - b; }
    constexpr Quantity& operator*=(NumberOf<R> b) {
        value *= b.value;
        return *this;
    }

    friend constexpr bool operator==(Quantity a, Quantity b) { return a.value == b.value; }
    friend constexpr bool operator!=(Quantity a, Quantity b) { return a.value != b.value; }
    friend constexpr bool operator<(Quantity a, Quantity b) { return a.value < b.value; }
    friend constexpr bool operator<=(Quantity a, Quantity b) { return a.value <= b.value; }
    friend constexpr bool operator>(Quantity a, Quantity b) { return a.value > b.value; }
    friend constexpr bool operator>=(Quantity a, Quantity b) { return a.value >= b.value; }

    friend constexpr Quantity min(Quantity a, Quantity b) { return a.value < b.value ? a : b; }
    friend constexpr Quantity max(Quantity a, Quantity b) { return a.value > b.value ? a : b; }
    friend constexpr Quantity clamp(Quantity x, Quantity low, Quantity high) { return min(max(x, low), high); }
    friend constexpr NumberOf<R> sign(Quantity a) { return NumberOf<R>::of(static_cast<R>((a.value > R(0)) - (a.value < R(0)))); }
    friend Quantity abs(Quantity a) { return of(std::abs(a.value)); }
};

template <class R, int L, int W, int S, int P, int L2, int W2, int S2, int P2>
constexpr Quantity<R, L + L2, W + W2, S + S2, P + P2> operator*(Quantity<R, L, W, S, P> a, Quantity<R, L2, W2, S2, P2> b) {
    return Quantity<R, L + L2, W + W2, S + S2, P + P2>::of(a.value * b.value);
}
template <class R, int L, int W, int S, int P, int L2, int W2, int S2, int P2>
constexpr Quantity<R, L - L2, W - W2, S - S2, P - P2> operator/(Quantity<R, L, W, S, P> a, Quantity<R, L2, W2, S2, P2> b) {
    return Quantity<R, L - L2, W - W2, S - S2, P - P2>::of(a.value / b.value);
}
template <class R, int L, int W, int S, int P>
constexpr Quantity<R, -L, -W, -S, -P> operator/(double a, Quantity<R, L, W, S, P> b) {
    return Quantity<R, -L, -W, -S, -P>::of(static_cast<R>(a) / b.value);
}
template <class R, int L, int W, int S, int P>
Quantity<R, L / 2, W / 2, S / 2, P / 2> sqrt(Quantity<R, L, W, S, P> a) {
    static_assert(L % 2 == 0 && W % 2 == 0 && S % 2 == 0 && P % 2 == 0, "the root of this has no dimension");
    return Quantity<R, L / 2, W / 2, S / 2, P / 2>::of(std::sqrt(a.value));
}

// The functions of plain numbers that GLSL ES 3.00 has too.
#define AIRLIGHT_NUMBER_FUNCTION(name)              \
    template <class R>                              \
    NumberOf<R> name(NumberOf<R> x) {               \
        return NumberOf<R>::of(std::name(x.value)); \
    }
AIRLIGHT_NUMBER_FUNCTION(exp)
AIRLIGHT_NUMBER_FUNCTION(log)
AIRLIGHT_NUMBER_FUNCTION(sin)
AIRLIGHT_NUMBER_FUNCTION(cos)
AIRLIGHT_NUMBER_FUNCTION(acos)
AIRLIGHT_NUMBER_FUNCTION(asin)
AIRLIGHT_NUMBER_FUNCTION(sinh)
AIRLIGHT_NUMBER_FUNCTION(asinh)
AIRLIGHT_NUMBER_FUNCTION(floor)
#undef AIRLIGHT_NUMBER_FUNCTION
template <class R>
NumberOf<R> pow(NumberOf<R> x, NumberOf<R> y) {
    return NumberOf<R>::of(std::pow(x.value, y.value));
}
template <class R>
NumberOf<R> pow(NumberOf<R> x, double y) {
    return NumberOf<R>::of(std::pow(x.value, static_cast<R>(y)));
}

}  // namespace airlight
