// Tables as the shared text reads them: what linear filtering with clamped edges must give.

#include <doctest/doctest.h>

#include <vector>

#include "physics/f32.h"
#include "physics/f64.h"

using namespace airlight;
using f64::Spectrum;

namespace {

// value(i, j, k) at each texel.
template <class F>
std::vector<Spectrum> texels(int width, int height, int depth, F value) {
    std::vector<Spectrum> all;
    for (int k = 0; k < depth; ++k)
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) all.emplace_back(f64::Number(value(i, j, k)));
    return all;
}

}  // namespace

TEST_CASE("a table gives its texels at their centres, in one, two and three dimensions") {
    const std::vector<Spectrum> all = texels(5, 3, 4, [](int i, int j, int k) { return i + 10 * j + 100 * k; });
    const Table3D<Spectrum> table(all, 5, 3, 4);
    for (int k = 0; k < 4; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 5; ++i)
                CHECK(look_up(table, f64::TexCoord3((i + 0.5) / 5, (j + 0.5) / 3, (k + 0.5) / 4))[3].value ==
                      doctest::Approx(i + 10 * j + 100 * k).epsilon(1e-14));
}

TEST_CASE("between texels a table is the function that is linear in each coordinate") {
    const auto function = [](double x, double y) { return 1.0 + 2.0 * x + 3.0 * y + 4.0 * x * y; };
    const std::vector<Spectrum> all = texels(8, 4, 1, [&](int i, int j, int) { return function((i + 0.5) / 8, (j + 0.5) / 4); });
    const Table2D<Spectrum> table(all, 8, 4);
    for (const double x : {0.07, 0.2, 0.55, 0.93})
        for (const double y : {0.126, 0.4, 0.87})
            CHECK(look_up(table, f64::TexCoord2(x, y))[0].value == doctest::Approx(function(x, y)).epsilon(1e-14));
}

TEST_CASE("beyond the centres at its edge a table stays as it is there") {
    const std::vector<Spectrum> all = texels(3, 2, 1, [](int i, int j, int) { return i + 10 * j; });
    const Table2D<Spectrum> table(all, 3, 2);
    for (const double x : {-5.0, 0.0, 1.0 / 6.0}) CHECK(look_up(table, f64::TexCoord2(x, 0.0))[0].value == 0.0);
    for (const double x : {5.0 / 6.0, 1.0, 7.0}) CHECK(look_up(table, f64::TexCoord2(x, 1.0))[0].value == 12.0);
}

TEST_CASE("a table of one texel is that texel everywhere") {
    const std::vector<Spectrum> all = texels(1, 1, 1, [](int, int, int) { return 7; });
    for (const double x : {-1.0, 0.3, 2.0}) {
        CHECK(look_up(Table2D<Spectrum>(all, 1, 1), f64::TexCoord2(x, x))[0].value == 7.0);
        CHECK(look_up(Table3D<Spectrum>(all, 1, 1, 1), f64::TexCoord3(x, x, x))[0].value == 7.0);
    }
}
