// Columns of air along rays: what every optical depth is made of.
// The extinction of a constituent is a spectrum times a density profile, so the optical depth of any leg is the sum over
// constituents of extinction(wavelength) times column(leg): the integral of the relative density along it.
// Theory: docs/theory.md, section 4. Uses atmosphere (profiles) and the f64 reading of the shell; knows no wavelength.
#pragma once

#include <span>
#include <vector>

#include "atmosphere/density_profile.h"
#include "physics/f64.h"

namespace airlight {

inline constexpr int max_columns = 12;

// One number for each density: columns in metres, or relative densities.
struct ColumnSet {
    alignas(32) double v[max_columns] = {};
};

// The densities on shells thin enough that each is a polynomial of degree four, and their columns from the shells'
// edges to the top, tabulated by the ray's zenith cosine. Inside a shell Gauss's rule integrates the polynomials, so
// kinks of profiles cost no precision, and along a ray the column is smooth and its slope is the density.
class Columns {
public:
    // At most max_columns densities (asserted); 0 < top. Takes about 0.1 s.
    Columns(std::span<const DensityProfile> profiles, f64::Length bottom, f64::Length top);

    // One leg: from a point to the top of the air or to the ground, as the ray's zenith cosine says.
    struct Ray {
        double h;       // altitude of the start, m
        double q;       // distance from the point nearest the planet's centre, along the ray; negative where the ray goes down
        bool ground;    // the end is on the ground, not at the top
        double length;  // from start to end, m
        double low_h;   // altitude and distance of the lowest point: the start, the perigee or the ground
        double low_t;
        ColumnSet start;  // from the start, the lowest point: outwards to the top
        ColumnSet low;
        ColumnSet total;  // from start to end
    };
    // A stop on a ray.
    struct Stop {
        double t;  // distance from the start, m
        double h;
        ColumnSet column;  // from the start to here
        ColumnSet density;
    };

    // 0 <= h <= top; -1 <= mu <= 1.
    Ray ray(double h, double mu) const;
    // Columns from start to end only; for rays that do not meet the ground.
    ColumnSet to_top(double h, double mu) const;
    // The stop at a distance 0 <= t <= ray.length.
    Stop at_distance(const Ray& ray, double t) const;
    // The stop up to which sum over c of a[c] column[c] is `depth`, 0 <= depth <= the same sum of ray.total; a[c] >= 0.
    Stop at_depth(const Ray& ray, const ColumnSet& a, double depth) const;

    ColumnSet density(double h) const;
    double sum(const ColumnSet& a, const ColumnSet& columns) const;
    double bottom() const { return bottom_; }
    double top() const { return top_; }

private:
    static constexpr int degree = 4;
    struct Shell {
        double low, high;
        double centre, per_half;  // z = (h - centre) * per_half lies in [-1, 1]
    };
    struct Leg;

    void divide(std::span<const DensityProfile> profiles);
    void tabulate();
    const Shell& shell_at(double h) const;
    void add_within(std::size_t shell, double h, double q, double t, ColumnSet& columns) const;
    ColumnSet outwards(double h, double q) const;
    double solve(const Leg& leg, const ColumnSet& a, double level, ColumnSet& columns, ColumnSet& density) const;
    double altitude(double h, double q, double t) const;

    double bottom_;
    double top_;
    int count_;   // densities
    int stride_;  // the same, rounded up to whole vectors of four
    std::vector<Shell> shells_;
    std::vector<double> polynomials_;  // [shell][degree + 1][stride]
    std::vector<int> hints_;           // [bucket of altitude]: the lowest shell that may hold it
    double cosine_scale_;              // the table's coordinate is asinh(mu / cosine_scale) * nodes_per_unit
    double nodes_per_unit_;
    int nodes_;
    std::vector<double> table_;  // [shell][node][stride]: columns from the shell's upper edge to the top
};

}  // namespace airlight
