// Rays in shells of air, in double: what must hold whatever the formula.

#include <doctest/doctest.h>

#include <random>

#include "physics/f64.h"
#include "units/units.h"

using namespace airlight;
using f64::altitude_at;
using f64::cosine_at;
using f64::distance_to_ground;
using f64::distance_to_top;
using f64::horizon_cosine;
using f64::meets_ground;
using f64::sun_cosine_at;

namespace {

constexpr std::uint64_t seed = 20260101;
// What double rounds once; a law that chains a few formulas may lose a few dozen.
constexpr double rounding = 0x1p-53;
constexpr double chain = 40.0 * rounding;
__extension__ using Exact = __float128;

struct Ray {
    Length h, bottom, top;
    Number mu;
};

// Shells and starts over the whole domain, radii log-uniform from 100 km to 70 000 km, tops from 1 km to 100 000 km;
// every second direction lies near the horizon, on either side.
std::vector<Ray> random_rays(int count) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        Ray r;
        r.bottom = std::pow(10.0, 5.0 + unit(random) * 2.845) * m;
        r.top = std::pow(10.0, 3.0 + unit(random) * 5.0) * m;
        r.h = r.top * Number(std::pow(unit(random), 3.0));
        r.mu = 2.0 * unit(random) - 1.0;
        if (i % 2 == 0) {
            const double off = std::pow(10.0, -1.0 - 6.0 * unit(random)) * (unit(random) < 0.5 ? -1.0 : 1.0);
            r.mu = max(horizon_cosine(r.h, r.bottom) * (1.0 + off), Number(-1.0));
        }
        rays.push_back(r);
    }
    return rays;
}

// A point in the plane of the ray, from the planet's centre: the other way to the same distances.
struct Point {
    double x, y;
    double radius() const { return std::hypot(x, y); }
};
Point along(const Ray& r, Length t) {
    return {t.value * std::sqrt((1.0 - r.mu.value) * (1.0 + r.mu.value)), (r.bottom + r.h).value + t.value * r.mu.value};
}

}  // namespace

TEST_CASE("a ray that does not meet the ground is at the top of the air after its distance to the top") {
    for (const Ray& r : random_rays(20000)) {
        if (meets_ground(r.h, r.mu, r.bottom)) continue;
        const Length t = distance_to_top(r.h, r.mu, r.bottom, r.top);
        CAPTURE(r.h.value);
        CAPTURE(r.mu.value);
        CAPTURE(r.bottom.value);
        CAPTURE(r.top.value);
        REQUIRE(t >= 0.0 * m);
        // t is off by chain * t, and the altitude changes by at most as much.
        CHECK(abs(altitude_at(r.h, r.mu, t, r.bottom) - r.top) <= chain * (t + r.top));
    }
}

TEST_CASE("a ray that meets the ground is on it after its distance to the ground") {
    for (const Ray& r : random_rays(20000)) {
        if (!meets_ground(r.h, r.mu, r.bottom)) continue;
        const Length t = distance_to_ground(r.h, r.mu, r.bottom);
        CAPTURE(r.h.value);
        CAPTURE(r.mu.value);
        CAPTURE(r.bottom.value);
        REQUIRE(t >= 0.0 * m);
        // p = r mu; p^2 is rounded before it is compared with the horizon's, which moves the end of the ray by p^2 / bottom.
        const Length p = (r.bottom + r.h) * r.mu;
        CHECK(abs(altitude_at(r.h, r.mu, t, r.bottom)) <= chain * (t + r.h + p * (p / r.bottom)));
    }
}

TEST_CASE("to the top and back along the same ray leads to where it began") {
    for (const Ray& r : random_rays(20000)) {
        if (meets_ground(r.h, r.mu, r.bottom)) continue;
        const Length t = distance_to_top(r.h, r.mu, r.bottom, r.top);
        const Number mu_top = cosine_at(r.h, r.mu, t, r.top, r.bottom);
        CAPTURE(r.h.value);
        CAPTURE(r.mu.value);
        CAPTURE(r.bottom.value);
        CAPTURE(r.top.value);
        // From r^2 = r_top^2 + t^2 - 2 r_top t mu_top: an error of mu_top moves r by r_top t / r as much.
        const Length bound = chain * (t * ((r.bottom + r.top) / (r.bottom + r.h)) + t + r.top);
        CHECK(abs(altitude_at(r.top, -mu_top, t, r.bottom) - r.h) <= bound);
    }
}

TEST_CASE("altitudes and cosines along a ray are those of its points in the plane") {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const Ray& r : random_rays(20000)) {
        if (meets_ground(r.h, r.mu, r.bottom)) continue;
        const Length t = distance_to_top(r.h, r.mu, r.bottom, r.top) * Number(unit(random));
        const Length h_t = altitude_at(r.h, r.mu, t, r.bottom);
        const Point p = along(r, t);
        CHECK(std::abs((r.bottom + h_t).value - p.radius()) <= chain * (r.bottom + r.h + t).value);
        const double sine = std::sqrt((1.0 - r.mu.value) * (1.0 + r.mu.value));
        const double cosine = (p.x * sine + p.y * r.mu.value) / p.radius();
        CHECK(std::abs(cosine_at(r.h, r.mu, t, h_t, r.bottom).value - cosine) <= chain * (r.bottom + r.h + t).value / p.radius());
    }
}

TEST_CASE("the sun's cosine along a ray is the ray's own where the sun stands in the view") {
    for (const Ray& r : random_rays(2000)) {
        if (meets_ground(r.h, r.mu, r.bottom)) continue;
        const Length t = 0.7 * distance_to_top(r.h, r.mu, r.bottom, r.top);
        const Length h_t = altitude_at(r.h, r.mu, t, r.bottom);
        CHECK(sun_cosine_at(r.h, r.mu, 1.0, t, h_t, r.bottom) == cosine_at(r.h, r.mu, t, h_t, r.bottom));
        CHECK(sun_cosine_at(r.h, -r.mu, -1.0, t, h_t, r.bottom) == -cosine_at(r.h, r.mu, t, h_t, r.bottom));
    }
}

TEST_CASE("the horizon divides the rays that meet the ground from those that do not") {
    for (const Ray& r : random_rays(20000)) {
        const Number mu = horizon_cosine(r.h, r.bottom);
        CHECK(mu <= Number(0.0));
        CHECK(!meets_ground(r.h, mu * (1.0 - chain), r.bottom));
        // From a thousandth of a millimetre up, or else both sides of the comparison are zero.
        if (r.h > 1e-6 * m) CHECK(meets_ground(r.h, mu * (1.0 + chain), r.bottom));
    }
    CHECK(meets_ground(0.0 * m, -1e-9, 6371.0 * km));
    CHECK(!meets_ground(0.0 * m, 0.0, 6371.0 * km));
}

TEST_CASE("straight up and straight down, distances are differences of altitude") {
    for (const Ray& r : random_rays(2000)) {
        CHECK(abs(distance_to_top(r.h, 1.0, r.bottom, r.top) - (r.top - r.h)) <= chain * r.top);
        // The rounding of r^2 counts r / bottom times, once against r and once against the ground's radius.
        const Number far = (r.bottom + r.h) / r.bottom;
        CHECK(abs(distance_to_ground(r.h, -1.0, r.bottom) - r.h) <= chain * r.h * (far * far));
        CHECK(distance_to_top(r.top, 1.0, r.bottom, r.top) == 0.0 * m);
        CHECK(distance_to_ground(0.0 * m, -1.0, r.bottom) == 0.0 * m);
    }
}

// On a planet of 10^8 km the ground is flat, and squares of radii have 22 digits, 6 more than a double. The errors are
// those of the equation of the sphere, which quadruple precision (34 digits) evaluates as it stands.
TEST_CASE("on a nearly flat planet no digit is lost") {
    const Exact b = 1e11;
    const Exact top = 1e5;
    for (const double mu : {1.0, 0.7, 0.2, 0.01, 1e-4, 0.0})
        for (const double h : {0.0, 1.0, 2000.0, 99000.0}) {
            CAPTURE(mu);
            CAPTURE(h);
            const Exact r = b + h;
            const Exact t = distance_to_top(h * m, mu, 1e11 * m, 1e5 * m).value;
            const Exact t_off = (t * t + 2 * r * mu * t - (top - h) * (2 * b + top + h)) / (2 * r * mu + 2 * t);
            CHECK(std::abs(static_cast<double>(t_off / t)) <= chain);
            for (const double d : {1.0, 1e3, 1e6, 1e9}) {
                const Exact h_t = altitude_at(h * m, mu, d * m, 1e11 * m).value;
                const Exact r_t = b + h_t;
                const Exact h_off = ((h_t - h) * (r_t + r) - d * (2 * r * mu + d)) / (2 * r_t);
                CHECK(std::abs(static_cast<double>(h_off / h_t)) <= chain);
            }
        }
}
