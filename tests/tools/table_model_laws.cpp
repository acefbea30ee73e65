#include <cmath>
#include <random>

#include "physics/models/f32.h"
#include "physics/models/f64.h"
#include "tools/domain.h"
#include "tools/model_laws.h"

// Look-ups in tables. A texture's coordinate is worth its size in texels, so a rounding of it is counted as one of the argument;
// the blend of texels adds three roundings a dimension. Software fuses x * (b - a) + a, and so differs by roundings of the texels.

namespace airlight::test {

namespace {

// A table of values between 1 and 2 without any order.
LawTable rough_table(int width, int height, int depth) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(1.0f, 2.0f);
    LawTable table{width, height, depth, {}};
    for (int i = 0; i < 4 * width * height * std::max(1, depth); ++i) table.texels.push_back(value(random));
    return table;
}

// Inside, on centres and edges of texels, and beyond the table.
std::vector<double> places() {
    std::vector<double> all = {-1.0, -0.1, 0.0, 0.5, 1.0, 1.1, 3.0};
    for (int i = 0; i < 40; ++i) all.push_back((i + 0.37) / 41.0);
    for (const int n : {3, 5, 7, 16})
        for (int i = 0; i < 2 * n; ++i) all.push_back(0.5 * i / n);
    return all;
}

std::vector<double> coordinates() {
    std::vector<double> all = {0.0, 1e-6, 1e-3, 1.0 - 1e-3, 1.0};
    for (int i = 1; i < 32; ++i) all.push_back(i / 32.0);
    return all;
}

// h, mu, bottom, top; and, for rays to the ground, without the top.
std::vector<Row> rays_up() {
    return rows(rays_to_the_top(), [](const ShellRay& r) { return Row{r.h, r.mu, r.bottom, r.top}; });
}
std::vector<Row> rays_down() {
    return rows(rays_to_the_ground(), [](const ShellRay& r) { return Row{r.h, r.mu, r.bottom}; });
}

// h, x, bottom, top of points in shells; and h, x, bottom.
std::vector<Row> points_and_coordinates(bool top) {
    std::vector<Row> all;
    for (const ShellRay& r : all_rays())
        if (r.mu == 1.0)
            for (const double x : coordinates())
                all.push_back(top ? Row{r.h, to_float(x), r.bottom, r.top} : Row{r.h, to_float(x), r.bottom});
    return all;
}

// Values that fall smoothly, as light does from texel to texel.
LawTable smooth_table(int width, int height, int depth) {
    LawTable table{width, height, depth, {}};
    for (int k = 0; k < std::max(1, depth); ++k)
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i)
                for (int w = 0; w < 4; ++w)
                    table.texels.push_back(static_cast<float>(0.1 * (1.0 + w) / (1.0 + 0.3 * i + 0.2 * j + 0.1 * k)));
    return table;
}

// Earth's air at 32 altitudes, and optical depths of about its size.
LawTable medium_table() {
    LawTable table{32, 3, 0, {}};
    for (int row = 0; row < 3; ++row)
        for (int i = 0; i < 32; ++i) {
            const double h = 60000.0 * (i / 31.0) * (i / 31.0), air = 1.2e-5 * std::exp(-h / 8000.0), haze = 2e-5 * std::exp(-h / 1200.0);
            for (int w = 0; w < 4; ++w) table.texels.push_back(static_cast<float>(row == 0 ? air : row == 1 ? haze : air + 1.1 * haze));
        }
    return table;
}
LawTable depth_table() {
    LawTable table{16, 8, 0, {}};
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 16; ++i)
            for (int w = 0; w < 4; ++w) table.texels.push_back(static_cast<float>(0.2 * (1.0 + i) * std::exp(-0.8 * j)));
    return table;
}

// h, mu, mu_s, nu, and whether the ray meets the ground.
std::vector<Row> bruneton2008_views() {
    std::vector<Row> all = combinations({{0.0, 10.0, 2000.0, 30000.0}, {0.05, 0.2, 0.7, 1.0}, {-0.1, 0.1, 0.9}, {-0.9, 0.1, 0.95}, {0.0}});
    const std::vector<Row> down = combinations({{10.0, 2000.0, 30000.0}, {-1.0, -0.7, -0.2}, {-0.1, 0.1, 0.9}, {-0.9, 0.1, 0.95}, {1.0}});
    all.insert(all.end(), down.begin(), down.end());
    return all;
}

std::vector<PointLaw> bruneton2008_laws() {
    const std::vector<LawTable> scattering = {smooth_table(18, 8, 4)}, depths = {depth_table()};
    return {
        // products 4 and 4, quotient 9, root 4
        POINT_LAW(bruneton2008_altitude_coordinate,
                  rows(all_rays(),
                       [](const ShellRay& r) {
                           return Row{r.h, r.bottom, r.top};
                       }),
                  6, 0),
        POINT_LAW(bruneton2008_altitude_of_coordinate,
                  rows(points_and_coordinates(true),
                       [](const Row& r) {
                           return Row{r[1], r[2], r[3]};
                       }),
                  12, 1),
        // d 10, the rest 14, the span 7, the quotient
        POINT_LAW(bruneton2008_sky_coordinate, rays_up(), 32, 0),
        // A cosine near zero is one less one: its roundings are counted against one.
        MODEL_LAW("2 + bruneton2008_sky_cosine", 4, 2.0 + bruneton2008_sky_cosine(x[0] * m, x[1], x[2] * m, x[3] * m),
                  points_and_coordinates(true), 8, 0),
        // d - h, near straight down, cancels: what is left is counted against mu
        POINT_LAW(bruneton2008_ground_coordinate, rays_down(), 27, 0),
        POINT_LAW(bruneton2008_ground_cosine, points_and_coordinates(false), 8, 0),
        // exponent 3, its exponential 5, difference 6, quotient 13
        POINT_LAW(bruneton2008_sun_coordinate, combinations({cosines()}), 13, 8),
        POINT_LAW(bruneton2008_sun_of_coordinate, combinations({coordinates()}), 13, 64),
        // sum 1, quotient 2
        POINT_LAW(bruneton2008_gain, combinations({{0.0, 1e-3, 1.0, 30.0, 999.0, 12e3, 29999.0, 30e3, 70e3, 800e3, 3e6, 1e8}}), 2, 0),
        // on either axis as on that axis alone
        MODEL_LAW("bruneton2008_chosen_sun_coordinate", 2, bruneton2008_chosen_sun_coordinate(x[0], x[1] > 0.5),
                  combinations({cosines(), {0.0, 1.0}}), 13, 16),
        MODEL_LAW("bruneton2008_chosen_sun_of_coordinate", 2, bruneton2008_chosen_sun_of_coordinate(x[0], x[1] > 0.5),
                  combinations({coordinates(), {0.0, 1.0}}), 13, 64),
        TABLE_LAW("bruneton2008: higher orders", scattering, 5,
                  bruneton2008_multiple(t3[0], bruneton2008_place(bruneton2008(6360000.0 * m, 60000.0 * m, 4, 8, 6, 3), x[0] * m, x[1],
                                                                  x[2], x[3], x[4] > 0.5))[0],
                  bruneton2008_views(), 5, 5),
        TABLE_LAW("bruneton2008: transmittance", depths, 3,
                  bruneton2008_transmittance(t2[0], bruneton2008(6360000.0 * m, 60000.0 * m, 4, 8, 6, 3), 16, 8, x[0] * m, x[1], x[2] * m,
                                             false)[0],
                  combinations({{0.0, 10.0, 2000.0, 30000.0}, {0.05, 0.2, 0.7, 1.0}, {1.0, 1000.0, 20000.0}}), 16, 8),
    };
}

std::vector<PointLaw> hillaire2020_laws() {
    const std::vector<LawTable> tables = {medium_table(), depth_table(), smooth_table(8, 8, 0)};
    const std::vector<Row> views =
        combinations({{0.0, 10.0, 2000.0, 30000.0}, {-0.9, -0.4, 0.05, 0.3, 0.8}, {0.1, 0.4, 0.9}, {-0.3, 0.2, 0.7}});
    const std::vector<double> altitudes = {0.0, 10.0, 2000.0, 30000.0};
    // A march adds terms of one sign; what it loses is the altitude of each step, counted against its arguments, and exponentials,
    // of which a GPU's are off by their argument's roundings. Sums over the sphere lose, besides, in sqrt(1 - mu^2) cos phi; the row
    // of the table in the difference of two angles near the horizon.
    return {
        TABLE_LAW(
            "hillaire2020: light in the air", tables, 4,
            hillaire2020_march(hillaire2020(6360000.0 * m, 60000.0 * m, Spectrum(Number(0.3)), 32, 16, 8, 8), t2[0], t2[1], t2[2], x[0] * m,
                               x[1], x[2], x[3], 50000.0 * m * (1.0 + x[1]), 8, PhaseSpectrum(0.08 * per_sr), PhaseSpectrum(0.12 * per_sr))
                .inscattered[0],
            views, 4, 20),
        TABLE_LAW("hillaire2020: orders beyond the first", tables, 2,
                  hillaire2020_series(hillaire2020_orders(hillaire2020(6360000.0 * m, 60000.0 * m, Spectrum(Number(0.3)), 32, 16, 8, 8),
                                                          t2[0], t2[1], x[0] * m, x[1]))[0],
                  combinations({altitudes, {0.3, 0.5, 0.9}}), 30, 50),
        MODEL_LAW("hillaire2020: row of the sky-view table", 2, hillaire2020_sky_view_row(x[0] * m, x[1], 6360000.0 * m, 108),
                  combinations({altitudes, {-1.0, -0.9, -0.4, -0.12, 0.01, 0.3, 0.8, 1.0}}), 30, 2),
        MODEL_LAW("hillaire2020: slices", 1, hillaire2020_slices(x[0] * m, 32000.0 * m, 32).coordinate,
                  combinations({{1500.0, 3000.0, 5000.0, 10000.0, 20000.0, 31000.0, 700.0, 800.0, 900.0, 1000.0, 1100.0, 1200.0}}), 6, 0),
    };
}

std::vector<PointLaw> small_table_laws() {
    const std::vector<LawTable> table = {smooth_table(8, 8, 4)};
    return {
        TABLE_LAW("schafhitzel2007: light", table, 5,
                  schafhitzel2007_light(t3[0], schafhitzel2007(6360000.0 * m, 60000.0 * m, 4, 8, 8), x[0] * m, x[1], x[2], x[4] > 0.5)[0],
                  bruneton2008_views(), 5, 5),
        TABLE_LAW("elek2009: light", table, 5, elek2009_single(t3[0], elek2009(60000.0 * m, 4, 8, 8), x[0] * m, x[1], x[2])[0],
                  bruneton2008_views(), 5, 5),
        // Roots 7, three of Newton's steps that each make good what was lost before, but for 4 of their own.
        POINT_LAW(elek2009_cosine_coordinate, combinations({cosines()}), 8, 1),
        POINT_LAW(elek2009_cosine_of_coordinate, combinations({coordinates()}), 6, 0),
    };
}

}  // namespace

std::vector<PointLaw> table_model_laws() {
    const std::vector<LawTable> one = {rough_table(1, 1, 0)}, small = {rough_table(5, 3, 0)}, wide = {rough_table(256, 64, 0)},
                                deep = {rough_table(7, 5, 3)};
    std::vector<PointLaw> laws = {
        TABLE_LAW("look_up in a texel", one, 2, look_up(t2[0], TexCoord2(x[0], x[1]))[0], combinations({places(), places()}), 1, 0),
        TABLE_LAW("look_up in 5 x 3 texels", small, 2, look_up(t2[0], TexCoord2(x[0], x[1]))[0], combinations({places(), places()}), 2, 2),
        TABLE_LAW("look_up in 256 x 64 texels", wide, 2, look_up(t2[0], TexCoord2(x[0], x[1]))[0], combinations({places(), places()}), 2,
                  2),
        TABLE_LAW("look_up in 7 x 5 x 3 texels", deep, 3, look_up(t3[0], TexCoord3(x[0], x[1], x[2]))[0],
                  combinations({places(), {-0.1, 0.0, 0.11, 0.5, 0.77, 1.0}, {0.0, 0.17, 0.3, 0.9, 1.0}}), 3, 2),
    };
    for (const auto& model : {bruneton2008_laws(), hillaire2020_laws(), small_table_laws()})
        laws.insert(laws.end(), model.begin(), model.end());
    return laws;
}

}  // namespace airlight::test
