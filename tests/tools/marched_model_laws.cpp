#include <algorithm>
#include <cmath>

#include "physics/models/f32.h"
#include "physics/models/f64.h"
#include "tools/domain.h"
#include "tools/model_laws.h"

// Models that march through exponential air. A march sums tens of exponentials of depths: a bound is what was found, doubled, and a
// comment names the step that loses most. Software's exp differs from the C library's by tens of ulps where its argument is large.

namespace airlight::test {

namespace {

// The Earth's air at one wavelength, and a ray x[0] m up with the cosines x[1] (view), x[2] (sun) and x[3] (between them).
#define AIR \
    exponential_air(6360000.0 * m, 60000.0 * m, 8000.0 * m, 1200.0 * m, ScatteringSpectrum(1.2e-5 / m), ScatteringSpectrum(2.5e-5 / m))
#define RAY air_ray(x[0] * m, x[1], x[2], x[3], distance_in_air(AIR, x[0] * m, x[1]))
#define LAYERS klassen1987_layers(2400.0 * m, 18400.0 * m, 0.86, 0.5, 0.37)
#define FIT oneil2005(scale_function(-0.007, 0.459, 3.83, -6.8, 5.25), scale_function(-0.003, 0.3, 6.1, -12.0, 9.0))
// Expands the words above before they are spelled as GLSL.
#define MARCHED_LAW(label, arguments, expression, rows, roundings, ulps) MODEL_LAW(label, arguments, expression, rows, roundings, ulps)
#define MARCHED_TABLE_LAW(label, tables, arguments, expression, rows, roundings, ulps) \
    TABLE_LAW(label, tables, arguments, expression, rows, roundings, ulps)

// Rays well off the ground's edge and off the terminator, where an answer of yes or no hangs on the last digit.
std::vector<Row> air_rays(double highest_m = 59e3) {
    std::vector<Row> all;
    for (const double h : {0.0, 300.0, 1500.0, 8000.0, 25e3, 59e3})
        for (const double mu : {1.0, 0.7, 0.3, 0.05, -0.2, -0.6, -1.0})
            for (const double mu_s : {1.0, 0.6, 0.1})
                for (const double cos_phi : {1.0, 0.2, -1.0}) {
                    if (h > highest_m || (h == 0.0 && mu < 0.0)) continue;
                    const double nu = mu * mu_s + std::sqrt((1.0 - mu * mu) * (1.0 - mu_s * mu_s)) * cos_phi;
                    all.push_back({to_float(h), to_float(mu), to_float(mu_s), to_float(nu)});
                }
    return all;
}

// A smooth table: optical depths fall along x and rise along y.
LawTable falling_table(int width, int height, int depth = 0) {
    LawTable table{width, height, depth, {}};
    for (int k = 0; k < std::max(1, depth) * height; ++k)
        for (int i = 0; i < width; ++i)
            for (int w = 0; w < 4; ++w)
                table.texels.push_back(
                    static_cast<float>(0.3 * (1.0 + w) * std::exp(-3.0 * i / width) * (1.0 + 2.0 * (k % height) / height)));
    return table;
}

}  // namespace

std::vector<PointLaw> marched_model_laws() {
    const std::vector<LawTable> spheres = {falling_table(16, 31), falling_table(16, 16)}, rays = {falling_table(32, 64)},
                                voxels = {falling_table(6, 5, 8)};
    const std::vector<std::vector<double>> heights = {{0.0, 1.0, 300.0, 1500.0, 8000.0, 25e3, 59e3}};
    return {
        // The sums along the view, each term an exponential of a sum towards the sun.
        MARCHED_LAW("kaneda1991: light of the air", 4, kaneda1991_light(AIR, RAY, 12, 8).air[0], air_rays(), 14, 12),
        MARCHED_LAW("kaneda1991: light of the aerosol", 4, kaneda1991_light(AIR, RAY, 12, 8).aerosol[0], air_rays(), 50, 40),
        MARCHED_LAW("kaneda1991: depth", 4, kaneda1991_light(AIR, RAY, 12, 8).depth[0], air_rays(), 20, 10),
        MARCHED_LAW("nishita1993: sphere", 1, nishita1993_sphere(60000.0 * m, 8000.0 * m, int(x[0]), 64),
                    combinations({{0, 1, 2, 5, 10, 20, 30, 40, 50, 60, 62, 63}}), 24, 24),
        MARCHED_LAW("nishita1993: cylinder", 2, nishita1993_cylinder_place(AIR, x[0] * m, x[1]),
                    combinations({heights[0], {1.0, 0.9, 0.5, 0.2, 0.15}}), 8, 2),
        // The place 1 - e^-(h / H) of a point near the ground, in a table that is 16 spheres wide.
        MARCHED_TABLE_LAW("nishita1993: light of the air", spheres, 4, nishita1993_light(AIR, t2[0], t2[1], 16, 31, RAY).air[0], air_rays(),
                          40, 16),
        MARCHED_TABLE_LAW("nishita1993: depth", spheres, 4, nishita1993_light(AIR, t2[0], t2[1], 16, 31, RAY).depth[0], air_rays(), 18, 12),
        // The root of 1 - mu_s^2 under the level direction's cosine.
        MARCHED_LAW("nishita1996: level direction", 3, nishita1996_cosine(2, x[0], x[1], x[2]),
                    combinations({{0.1, 0.5, 0.9}, {0.1, 0.6, 0.95}, {0.2, 0.5}}), 7, 2),
        MARCHED_TABLE_LAW("nishita1996: light", voxels, 4,
                          nishita1996_light(AIR, ScatteringSpectrum(1.2e-5 / m), ScatteringSpectrum(2.0e-5 / m), t3[0], 6, 5,
                                            nishita1996_even_phases(), RAY, 6)[0],
                          air_rays(), 40, 14),
        MARCHED_LAW("sea: mirrored", 1, sea_reflectance(x[0]), combinations({{0.0, 1e-3, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0, 0.7, 0.3, 0.2}}),
                    8, 2),
        MARCHED_LAW("sea: from the water", 3,
                    sea_water_radiance(ScatteringSpectrum(0.01 / m), ScatteringSpectrum(0.003 / m), x[0], x[1], x[2])[0],
                    combinations({{0.1, 0.5, 1.0}, {0.1, 0.5, 1.0}, {0.0, 0.05, 0.1}}), 2, 4),
        // The column to a sample near the eye: a difference of two look-ups.
        MARCHED_TABLE_LAW("oneil2004: light of the air", rays, 4, oneil2004_light(AIR, t2[0], 32, 64, RAY, 5).air[0], air_rays(), 40, 10),
        MARCHED_LAW("oneil2005: column", 2,
                    oneil2005_column(scale_function(0.0, 0.459, 3.83, -6.8, 5.25), 8000.0 * m, 6360000.0 * m, x[0] * m, x[1]),
                    combinations({heights[0], {1.0, 0.5, 0.1, 0.01, 0.0}}), 13, 12),
        MARCHED_LAW("oneil2005: light of the air", 4, oneil2005_light(AIR, FIT, RAY, 4).air[0], air_rays(), 26, 12),
        MARCHED_LAW("fog: exponential", 2, exponential_fog(x[0] / m, x[1] * m), combinations({{1e-6, 1e-4, 1e-2}, {0.0, 1.0, 100.0, 1e4}}),
                    3, 4),
        MARCHED_LAW("fog: linear", 3, linear_fog(x[0] * m, x[1] * m, x[2] * m),
                    combinations({{0.0, 10.0, 100.0}, {200.0, 1e4}, {0.0, 1.0, 50.0, 150.0, 1000.0, 2e4}}), 2, 1),
        // The difference from one of the exponential at a depth of 0.01.
        MARCHED_LAW("hoffman2002: mean transmittance", 1, mean_transmittance(Spectrum(x[0]))[0],
                    combinations({{0.0, 1e-6, 1e-4, 5e-3, 0.00999, 0.0101, 0.02, 0.1, 0.5, 1.0, 3.0, 10.0, 50.0}}), 20, 200),
        MARCHED_LAW("klassen1987: light of the air", 4, klassen1987_light(AIR, LAYERS, RAY, 8).air[0], air_rays(18e3), 14, 8),
        MARCHED_LAW("klassen1987: depth", 4, klassen1987_light(AIR, LAYERS, RAY, 8).depth[0], air_rays(18e3), 12, 6),
        MARCHED_TABLE_LAW("dobashi2002: light of the air", rays, 4, dobashi2002_light(AIR, t2[0], 32, 64, RAY, 6, 3).air[0], air_rays(), 18,
                          16),
        // The fifth root.
        MARCHED_LAW("nielsen2003: column of the sky", 2, nielsen2003_sky_column(8000.0 * m, x[0] * m, x[1]),
                    combinations({heights[0], {1.0, 0.9, 0.5, 0.1, 0.01, 1e-3}}), 6, 130),
        MARCHED_LAW("nielsen2003: by altitude", 3, nielsen2003_by_altitude(AIR, x[0] * m, x[1] * m, x[2] * m).air,
                    combinations({heights[0], heights[0], {1e3, 1e5}}), 2, 12),
        MARCHED_LAW("nielsen2003: by ends", 3, nielsen2003_by_ends(AIR, x[0] * m, x[1] * m, x[2] * m).aerosol,
                    combinations({heights[0], heights[0], {1e3, 1e5}}), 24, 40),
        MARCHED_LAW("nielsen2003: asymmetry", 2, nielsen2003_asymmetry(nielsen2003_corners(0.25, 0.25, 0.64, 0.2), x[0], x[1]),
                    combinations({{0.0, 0.3, 0.7, 1.0}, {0.0, 0.2, 0.8, 1.0}}), 2, 2),
    };
}

}  // namespace airlight::test
