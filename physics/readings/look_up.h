// Tables as the shared text reads them: linear between the centres of texels, the edge's texel beyond them, exactly as OpenGL
// defines GL_LINEAR with GL_CLAMP_TO_EDGE. physics/readings/glsl.glsl is the other spelling: a sampler2D or a sampler3D.
// Views only: the texels belong to somebody else, the first dimension running fastest, as in a texture.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "units/quantity.h"
#include "units/spectral.h"

namespace airlight {

// Texture coordinates: texel i of n lies at (i + 1/2) / n.
template <class R>
struct TexCoord2Of {
    AIRLIGHT_INLINE TexCoord2Of(NumberOf<R> u, NumberOf<R> v) : x(u), y(v) {}
    NumberOf<R> x, y;
};
template <class R>
struct TexCoord3Of {
    AIRLIGHT_INLINE TexCoord3Of(NumberOf<R> u, NumberOf<R> v, NumberOf<R> w) : x(u), y(v), z(w) {}
    NumberOf<R> x, y, z;
};

// The two texels around a coordinate, and the weight of the second.
template <class R>
struct Filtered {
    std::size_t low, high;
    R weight;
};
template <class R>
AIRLIGHT_INLINE Filtered<R> filtered(NumberOf<R> coordinate, int size) {
    const R last = static_cast<R>(size - 1);
    const R x = coordinate.value * static_cast<R>(size) - R(0.5);
    const R inside = x > R(0) ? (x < last ? x : last) : R(0);
    const int low = static_cast<int>(inside);
    return {static_cast<std::size_t>(low), static_cast<std::size_t>(low + 1 < size ? low + 1 : low), inside - static_cast<R>(low)};
}

// What a stored number stands for: itself, or with 16 bits a 65535th of itself.
template <class R, class Stored>
inline constexpr R stored_unit = std::is_same_v<Stored, std::uint16_t> ? R(1) / R(65535) : R(1);

// A table of spectra T.
template <class T, class Stored = typename T::Rep>
class Table2D {
public:
    using Rep = typename T::Rep;
    Table2D(const Stored* values, int width, int height) : values_(values), width_(width), height_(height) {}
    Table2D(std::span<const T> texels, int width, int height) requires std::is_same_v<Stored, Rep>
        : Table2D(texels.data()->v, width, height) {
        assert(texels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    }

    AIRLIGHT_INLINE T at(TexCoord2Of<Rep> place) const {
        const Filtered<Rep> x = filtered(place.x, width_), y = filtered(place.y, height_);
        T r;
        const Stored *a = row(y.low, x.low), *b = row(y.low, x.high), *c = row(y.high, x.low), *d = row(y.high, x.high);
        for (int i = 0; i < T::size; ++i) {
            const Rep low = Rep(a[i]) + x.weight * (Rep(b[i]) - Rep(a[i])), high = Rep(c[i]) + x.weight * (Rep(d[i]) - Rep(c[i]));
            r.v[i] = (low + y.weight * (high - low)) * stored_unit<Rep, Stored>;
        }
        return r;
    }

private:
    AIRLIGHT_INLINE const Stored* row(std::size_t j, std::size_t i) const {
        return values_ + (j * static_cast<std::size_t>(width_) + i) * static_cast<std::size_t>(T::size);
    }
    const Stored* values_;  // [height][width][T::size]
    int width_, height_;
};

template <class T, class Stored = typename T::Rep>
class Table3D {
public:
    using Rep = typename T::Rep;
    Table3D(const Stored* values, int width, int height, int depth) : values_(values), width_(width), height_(height), depth_(depth) {}
    Table3D(std::span<const T> texels, int width, int height, int depth) requires std::is_same_v<Stored, Rep>
        : Table3D(texels.data()->v, width, height, depth) {
        assert(texels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(depth));
    }

    AIRLIGHT_INLINE T at(TexCoord3Of<Rep> place) const {
        const Filtered<Rep> z = filtered(place.z, depth_);
        const T low = slice(z.low).at({place.x, place.y}), high = slice(z.high).at({place.x, place.y});
        T r;
        for (int i = 0; i < T::size; ++i) r.v[i] = low.v[i] + z.weight * (high.v[i] - low.v[i]);
        return r;
    }

private:
    AIRLIGHT_INLINE Table2D<T, Stored> slice(std::size_t k) const {
        return {values_ + k * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * static_cast<std::size_t>(T::size),
                width_, height_};
    }
    const Stored* values_;  // [depth][height][width][T::size]
    int width_, height_, depth_;
};

template <class T>
using PackedTable2D = Table2D<T, std::uint16_t>;
template <class T>
using PackedTable3D = Table3D<T, std::uint16_t>;

template <class T, class Stored>
AIRLIGHT_INLINE T look_up(const Table2D<T, Stored>& table, TexCoord2Of<typename T::Rep> place) {
    return table.at(place);
}
template <class T, class Stored>
AIRLIGHT_INLINE T look_up(const Table3D<T, Stored>& table, TexCoord3Of<typename T::Rep> place) {
    return table.at(place);
}

}  // namespace airlight
