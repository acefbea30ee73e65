// The whole domain of the shared text, as rows of arguments: planets from 100 km to 70 000 km in radius, air up to
// 100 000 km, every direction, with grazing rays and points at the top and on the ground.
#pragma once

#include <random>
#include <span>
#include <vector>

#include "tools/point_law.h"

namespace airlight::test {

// A ray that starts in a shell of air, in metres; each value is a float's.
struct ShellRay {
    double h, mu, bottom, top;
};

// Every start and direction: a grid, and around each horizon directions ever closer to it on both sides.
std::vector<ShellRay> all_rays();
std::vector<ShellRay> rays_to_the_top();     // those that do not meet the ground
std::vector<ShellRay> rays_to_the_ground();  // those that do

// How far along a ray: fractions of its whole length in the air, and near its perigee. In metres, a float's value.
std::vector<double> distances_along(const ShellRay& ray);

// Cosines of angles: -1, 1, 0 and both neighbourhoods of each.
std::vector<double> cosines();

// `value` rounded to float.
double to_float(double value);

// One row for each element of `from`: rows(rays, [](const ShellRay& r) { return Row{r.h, r.mu}; }).
template <class T, class F>
std::vector<Row> rows(const std::vector<T>& from, F row) {
    std::vector<Row> all;
    for (const T& t : from) all.push_back(row(t));
    return all;
}

// Every combination of one value from each list.
std::vector<Row> combinations(const std::vector<std::vector<double>>& lists);

}  // namespace airlight::test
