#include "tools/point_laws.h"

#include "tools/domain.h"

// The bound on float, `roundings`, is the number of operations of the formula that round (+ - * / sqrt), a root halving
// those under it, when every step is stable: sums of terms of one sign, or differences of arguments. A cancelling
// difference of rounded terms would exceed it by orders of magnitude. Products with a power of two, and differences of
// floats within a factor of two of each other, are exact. `exp` counts as two roundings.
//
// The bound on the GPU, `ulps`, is 0 where the text has only + - * / sqrt and comparisons, in which IEEE 754 leaves no
// choice; division and root on a GPU may round differently by 2.5 and 3 ulps (Vulkan's and OpenCL's bounds), llvmpipe
// rounds them exactly.

namespace airlight::test {

namespace {

std::vector<Row> start(const std::vector<ShellRay>& rays) {
    return rows(rays, [](const ShellRay& r) { return Row{r.h, r.mu, r.bottom}; });
}

std::vector<Row> start_and_top(const std::vector<ShellRay>& rays) {
    return rows(rays, [](const ShellRay& r) { return Row{r.h, r.mu, r.bottom, r.top}; });
}

// Points along every ray: h, mu, t, bottom.
std::vector<Row> points_along() {
    std::vector<Row> all;
    for (const ShellRay& r : all_rays())
        for (const double t : distances_along(r)) all.push_back({r.h, r.mu, t, r.bottom});
    return all;
}

// Points along every ray with their altitudes: h, mu, t, h_t, bottom.
std::vector<Row> points_and_altitudes() {
    std::vector<Row> all;
    for (const Row& p : points_along()) {
        using L = f64::Length;
        const double h_t = f64::altitude_at(L::of(p[0]), f64::Number::of(p[1]), L::of(p[2]), L::of(p[3])).value;
        all.push_back({p[0], p[1], p[2], to_float(std::max(h_t, 0.0)), p[3]});
    }
    return all;
}

// The same with a sun: h, mu_s, nu, t, h_t, bottom.
std::vector<Row> points_and_suns() {
    std::vector<Row> all;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> turn(-1.0, 1.0);
    for (const Row& p : points_and_altitudes()) {
        const double mu_s = turn(random);
        const double nu = p[1] * mu_s + std::sqrt((1.0 - p[1] * p[1]) * (1.0 - mu_s * mu_s)) * turn(random);
        all.push_back({p[0], to_float(mu_s), to_float(nu), p[2], p[3], p[4]});
    }
    return all;
}

// Suns around the horizon and elsewhere, of several sizes: h, mu_s, bottom, sun_radius.
std::vector<Row> suns_and_horizons() {
    std::vector<Row> all;
    for (const ShellRay& r : all_rays()) {
        if (r.mu != 1.0) continue;
        const double horizon = f64::horizon_cosine(f64::Length::of(r.h), f64::Length::of(r.bottom)).value;
        for (const double radius : {0.0, 1e-3, 4.65e-3, 0.1}) {
            for (const double off : {-1.2, -0.99, -0.7, -0.1, 0.01, 0.4, 0.9, 0.999, 1.1})
                all.push_back({r.h, to_float(std::clamp(horizon + off * std::max(radius, 1e-3), -1.0, 1.0)), r.bottom, to_float(radius)});
            for (const double mu_s : {-1.0, -0.3, 0.2, 1.0}) all.push_back({r.h, to_float(mu_s), r.bottom, to_float(radius)});
        }
    }
    return all;
}

// Coordinates of texels: both ends, their neighbours, and between.
std::vector<double> coordinates() {
    std::vector<double> all = {0.0, 1e-6, 1e-3, 1.0 - 1e-3, 1.0};
    for (double x = 0.01; x < 1.0; x += 0.0173) all.push_back(x);
    return all;
}

// Starts in a shell with a coordinate for the direction: h, x, bottom, top.
std::vector<Row> starts_and_coordinates() {
    std::vector<Row> all;
    for (const ShellRay& r : all_rays())
        if (r.mu == 0.0)
            for (const double x : coordinates()) all.push_back({r.h, to_float(x), r.bottom, r.top});
    return all;
}

std::vector<double> peaks() { return {-0.999, -0.9, -0.3, -1e-3, 0.0, 1e-3, 0.3, 0.65, 0.76, 0.9, 0.99, 0.999}; }
std::vector<double> altitudes() { return {0.0, 1.0, 300.0, 1200.0, 8000.0, 25e3, 60e3, 100e3, 400e3, 10000e3, 100000e3}; }

}  // namespace

std::vector<PointLaw> shell_laws() {
    return {
        // k 4, p 2, p p 5, sum 6, root 4, divisor 5, quotient 10
        POINT_LAW(distance_to_top, start_and_top(rays_to_the_top()), 10, 0),
        // p 2, p p 5, k 3: 8 between the two sides
        POINT_LAW(meets_ground, start(all_rays()), 8, 0),
        // k 3, root 3, sum 1, quotient 5
        POINT_LAW(horizon_cosine,
                  rows(all_rays(),
                       [](const ShellRay& r) {
                           return Row{r.h, r.bottom};
                       }),
                  5, 0),
        // p 2, p p 5, difference 6 (it cancels as mu nears the horizon's: counted against mu), root 4, sum 5, k 3, quotient 9
        POINT_LAW(distance_to_ground, start(rays_to_the_ground()), 9, 0),
        // r 1, along 3, squares 7 and 6, sum 8, root 5, divisor 6, dividend 5 (it cancels: counted against t), quotient 12, sum 13
        POINT_LAW(altitude_at, points_along(), 13, 0),
        // r 1, product 2, sum 3, r_t 1, quotient 5
        POINT_LAW(cosine_at, points_and_altitudes(), 5, 0),
        // r 1, products 2 and 1, sum 3, r_t 1, quotient 5
        POINT_LAW(sun_cosine_at, points_and_suns(), 5, 0),
        // The part of a disk near none of it is a half less a half: its roundings are counted against one. square 1, difference 2, root 2,
        // product 3, asin 1, sum 4, quotient 5, sums 7; a GPU's asin may be off by 4096 ulps (SPIR-V's bound)
        MODEL_LAW("1 + disk_above", 1, 1.0 + disk_above(x[0]),
                  combinations({{-3.0, -1.0, -0.999, -0.99, -0.9, -0.5, -1e-3, 0.0, 1e-6, 0.1, 0.5, 0.7, 0.99, 0.999, 1.0, 1.5}}), 7, 4096),
        // horizon 5 (counted against mu_s), sine 4, quotients 6 and 7, and the disk's 7
        MODEL_LAW("1 + sun_above_horizon", 4, 1.0 + sun_above_horizon(x[0] * m, x[1], x[2] * m, x[3]), suns_and_horizons(), 14, 4096),
    };
}

std::vector<PointLaw> density_laws() {
    const std::vector<double> scale_heights = {100.0, 1200.0, 8000.0, 11e3, 1000e3};
    return {
        // quotient 1 (counted against h), exp 2; GLSL's exp(x) is exp2 of a rounded product: a rounding for each unit of x, up to 87
        POINT_LAW(exponential_density, combinations({altitudes(), scale_heights}), 3, 90),
        POINT_LAW(layer_density, combinations({altitudes(), {0.0, 1e3, 10e3}, {20e3, 25e3, 100e3}}), 1, 0),
        // differences 1 and 1, quotient 3
        POINT_LAW(triangle_density, combinations({altitudes(), {0.0, 10e3, 10.1e3}, {24e3, 25e3}, {40e3, 41.7e3}}), 3, 0),
    };
}

std::vector<PointLaw> phase_laws() {
    return {
        // constant 3, nu nu and sum 2, product 6, product 7
        POINT_LAW(rayleigh_phase, combinations({cosines()}), 7, 0),
        // divisor 5, quotient 6, sum of terms 4, products 12
        POINT_LAW(depolarised_rayleigh_phase, combinations({{0.0, 0.01, 0.0148, 0.2, 1.0}, cosines()}), 12, 0),
        // squares 3, product 3, sum 4
        POINT_LAW(peak_distance_squared, combinations({peaks(), cosines()}), 4, 0),
        // k 4, k sqrt(k) 8, divisor 11, dividend 3, quotient 15
        POINT_LAW(henyey_greenstein_phase, combinations({peaks(), cosines()}), 15, 0),
        // dividend 8, divisor 15, quotient 24
        POINT_LAW(cornette_shanks_phase, combinations({peaks(), cosines()}), 24, 0),
        // q 2 and squared 5, divisor 8, dividend 4, quotient 13
        POINT_LAW(schlick_phase, combinations({peaks(), cosines()}), 13, 0),
        // terms 1 and 3, difference 4; Mesa regroups the product of three equal factors
        POINT_LAW(schlick_parameter, combinations({peaks()}), 4, 1),
        // constant 2, nu nu and sum 2, products 6
        POINT_LAW(softened_rayleigh_phase, combinations({cosines()}), 6, 0),
    };
}

std::vector<PointLaw> map_laws() {
    return {
        // constant 1, texel 2, product 3, sum 4
        POINT_LAW(texture_coordinate, combinations({coordinates(), {2, 16, 32, 64, 256}}), 4, 0),
        // quotient 1, root 1
        POINT_LAW(altitude_coordinate,
                  rows(all_rays(),
                       [](const ShellRay& r) {
                           return Row{r.h, r.top};
                       }),
                  2, 0),
        POINT_LAW(altitude_of_coordinate, combinations({coordinates(), altitudes()}), 2, 0),
        // roots 3, quotient 6, sum 7
        POINT_LAW(transmittance_span,
                  rows(all_rays(),
                       [](const ShellRay& r) {
                           return Row{r.h, r.bottom, r.top};
                       }),
                  7, 0),
        // d 10, detour 3 + 10 + 4, their product 28, d + knee 11, quotient 40, the rest 9 + 7
        POINT_LAW(transmittance_cosine_coordinate, start_and_top(rays_to_the_top()), 58, 0),
        // q 18, longer 18 + 19 + 4, d 42, quotients 41 + 42 + 43
        POINT_LAW(transmittance_cosine_of_coordinate, starts_and_coordinates(), 130, 0),
        // argument 2, asinh 2, difference 5, divisor 5, quotient 11; Mesa's sinh and asinh are made of exp and log, and cancel
        POINT_LAW(sun_coordinate, combinations({cosines()}), 11, 16),
        POINT_LAW(sun_of_coordinate, combinations({coordinates()}), 11, 64),
        // acos 2, quotient 3; a GPU's acos may be off by 4096 ulps (SPIR-V's bound), Mesa's polynomial is by 3638
        POINT_LAW(view_coordinate, combinations({cosines()}), 3, 4096),
        // product 1 (counted against x), cos 2; a GPU's cos is off by 2^-11 of its range at most, Mesa's by an ulp
        POINT_LAW(view_of_coordinate, combinations({coordinates()}), 3, 2),
        POINT_LAW(azimuth_coordinate, combinations({cosines()}), 2, 0),
        POINT_LAW(azimuth_cosine_of_coordinate, combinations({coordinates()}), 2, 0),
        // products 1, factors 2 and 2, product 5, root 3, dividend 2, quotient 6
        POINT_LAW(relative_azimuth_cosine, combinations({cosines(), cosines(), cosines()}), 6, 0),
    };
}

}  // namespace airlight::test
