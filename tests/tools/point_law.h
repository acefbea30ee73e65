// A function of the shared text, called by name in any of its readings on rows of plain numbers.
// The tests of precision (double against float) and of parity (float against the GPU) take it from here.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "physics/f32.h"
#include "physics/f64.h"

namespace airlight::test {

// The arguments of one call, in the order of the text, in base units. Each is a float's value, so that
// every reading gets the same input.
using Row = std::vector<double>;

// A table that a law looks up: four floats a texel, as a texture has; depth 0 is two-dimensional.
struct LawTable {
    int width, height, depth;
    std::vector<float> texels;
};

struct PointLaw {
    std::string name;
    std::string call;  // the call as GLSL spells it, of a float x[]: "distance_to_top(x[0], x[1], x[2], x[3])"
    std::function<double(std::span<const double>)> f64;
    std::function<double(std::span<const double>)> f32;
    std::vector<Row> rows;
    double roundings;                   // the bound on float's error, in roundings of the arguments and the result
    int ulps;                           // the bound on the GPU's distance from float, in units in the last place
    std::vector<LawTable> tables = {};  // first those of two dimensions, t2[...] in the call, then those of three, t3[...]
};

// The largest errors of float found over the rows of a law.
struct Loss {
    double relative = 0.0;   // |f32 - f64| / |f64|
    double absolute = 0.0;   // |f32 - f64|, base units
    double roundings = 0.0;  // |f32 - f64|, in what rounding the result and the arguments once would do
    Row worst;               // where `roundings` is largest
};

// Measures one law over its rows. An error is counted in roundings: the change of the exact result when it, and each
// argument in turn, moves by one rounding (2^-24). Where an answer hangs on the last digit of its arguments, as the
// distance to the ground of a grazing ray does, no formula can do better than a few.
Loss measure(const PointLaw& law);

// How far apart two floats are, counted in floats between them; 0 for +0 and -0, and for two NaN.
long ulps_between(float a, float b);

namespace detail {

template <class A>
A argument(double x) {
    if constexpr (std::is_same_v<A, int>) return static_cast<int>(std::lround(x));
    else if constexpr (requires { A::size; }) return A(A::Scalar::of(static_cast<typename A::Rep>(x)));
    else return A::of(static_cast<typename A::Rep>(x));
}

template <class A>
std::string glsl_argument(std::size_t i) {
    const std::string x = "x[" + std::to_string(i) + "]";
    if constexpr (std::is_same_v<A, int>) return "int(" + x + ")";
    else if constexpr (requires { A::size; }) return "Spectrum(" + x + ")";
    else return x;
}

template <class R>
double result(const R& r) {
    if constexpr (std::is_same_v<R, bool> || std::is_same_v<R, int>) return r;
    else if constexpr (requires { R::size; }) return static_cast<double>(r.v[0]);
    else return static_cast<double>(r.value);
}

template <class R, class... A>
std::function<double(std::span<const double>)> caller(R (*f)(A...)) {
    return [f](std::span<const double> x) {
        return [&]<std::size_t... I>(std::index_sequence<I...>) { return result(f(argument<std::decay_t<A>>(x[I])...)); }
        (std::index_sequence_for<A...>());
    };
}

template <class R, class... A>
std::string glsl_call(const std::string& name, R (*)(A...)) {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
        std::string arguments;
        ((arguments += (I == 0 ? "" : ", ") + glsl_argument<std::decay_t<A>>(I)), ...);
        const std::string call = name + "(" + arguments + ")";
        if constexpr (requires { R::size; }) return call + "[0]";
        return "float(" + call + ")";
    }
    (std::index_sequence_for<A...>());
}

template <class F64, class F32>
PointLaw point_law(const std::string& name, F64 f64, F32 f32, std::vector<Row> rows, double roundings, int ulps) {
    return {name, glsl_call(name, f32), caller(f64), caller(f32), std::move(rows), roundings, ulps};
}

}  // namespace detail

// POINT_LAW(name, rows, roundings, ulps): the function `name` of the shared text, in all its readings.
#define POINT_LAW(name, rows, roundings, ulps) \
    airlight::test::detail::point_law(#name, &airlight::f64::name, &airlight::f32::name, rows, roundings, ulps)

// MODEL_LAW(label, 3, expression of x[0], x[1], x[2], rows, roundings, ulps): an expression with functions of the shared text,
// for those that take or return structures.
#define MODEL_LAW(label, arguments, expression, rows, roundings, ulps)                                                                 \
    airlight::test::PointLaw {                                                                                                         \
        label, "float(" #expression ")", MODEL_LAW_READING(f64, arguments, expression), MODEL_LAW_READING(f32, arguments, expression), \
            rows, roundings, ulps                                                                                                      \
    }
#define MODEL_LAW_READING(reading, arguments, expression)                                                             \
    [](std::span<const double> values) {                                                                              \
        using namespace airlight::reading;                                                                            \
        Number x[arguments];                                                                                          \
        for (int i = 0; i < arguments; ++i) x[i] = Number::of(static_cast<Rep>(values[static_cast<std::size_t>(i)])); \
        return static_cast<double>((expression).value);                                                               \
    }

// The tables of a law in one reading: t2[0] and t3[0] become whatever table of spectra a function takes.
template <class R, int N>
class LawTables {
public:
    struct Any {
        const R* values;
        int width, height, depth;
        template <class T>
        operator Table2D<T>() const {
            return {values, width, height};
        }
        template <class T>
        operator Table3D<T>() const {
            return {values, width, height, depth};
        }
        friend Spectral<R, N, 0, 0, 0, 0> look_up(const Any& table, TexCoord2Of<R> place) {
            return Table2D<Spectral<R, N, 0, 0, 0, 0>>(table).at(place);
        }
        friend Spectral<R, N, 0, 0, 0, 0> look_up(const Any& table, TexCoord3Of<R> place) {
            return Table3D<Spectral<R, N, 0, 0, 0, 0>>(table).at(place);
        }
    };
    explicit LawTables(const std::vector<LawTable>& tables) : storage_(tables.size()) {
        for (std::size_t i = 0; i < tables.size(); ++i) {
            const LawTable& t = tables[i];
            for (std::size_t k = 0; k < t.texels.size(); k += 4)
                for (std::size_t w = 0; w < N; ++w) storage_[i].push_back(static_cast<R>(t.texels[k + w % 4]));
            (t.depth ? t3 : t2).push_back({storage_[i].data(), t.width, t.height, t.depth});
        }
    }
    LawTables(const LawTables&) = delete;
    LawTables& operator=(const LawTables&) = delete;

private:
    std::vector<std::vector<R>> storage_;

public:
    std::vector<Any> t2, t3;
};

// TABLE_LAW(label, tables, 3, expression of t2[0], t3[0], x[0], x[1], x[2], rows, roundings, ulps): MODEL_LAW with tables.
#define TABLE_LAW(label, tables, arguments, expression, rows, roundings, ulps)                   \
    airlight::test::PointLaw {                                                                   \
        label, "float(" #expression ")", TABLE_LAW_READING(f64, tables, arguments, expression),  \
            TABLE_LAW_READING(f32, tables, arguments, expression), rows, roundings, ulps, tables \
    }
#define TABLE_LAW_READING(reading, tables, arguments, expression)                                                                      \
    [held = std::make_shared<const LawTables<airlight::reading::Rep, airlight::reading::N>>(tables)](std::span<const double> values) { \
        using namespace airlight::reading;                                                                                             \
        [[maybe_unused]] const auto& t2 = held->t2;                                                                                    \
        [[maybe_unused]] const auto& t3 = held->t3;                                                                                    \
        Number x[arguments];                                                                                                           \
        for (int i = 0; i < arguments; ++i) x[i] = Number::of(static_cast<Rep>(values[static_cast<std::size_t>(i)]));                  \
        return static_cast<double>((expression).value);                                                                                \
    }

}  // namespace airlight::test
