#include "sun/events.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace airlight {

namespace {

constexpr double step_s = 600.0;
constexpr double resolution_s = 0.01;
constexpr double last_instant_s = 1e-3;  // the day's end belongs to the next one

// An angle as a function of the second of the day, known at nodes: every step, and where it turns.
struct DayCurve {
    Utc midnight;
    std::function<double(double)> at;
    struct Node {
        double second;
        double value;
    };
    std::vector<Node> nodes;
};

// The lowest point between two nodes of a curve with one turn, by golden section.
DayCurve::Node lowest(const std::function<double(double)>& at, double a, double b) {
    constexpr double ratio = 0.6180339887498949;
    double left = b - ratio * (b - a);
    double right = a + ratio * (b - a);
    double at_left = at(left);
    double at_right = at(right);
    while (b - a > 0.5) {  // near a turn half a second changes nothing
        if (at_left < at_right) {
            b = right;
            right = left;
            at_right = at_left;
            left = b - ratio * (b - a);
            at_left = at(left);
        } else {
            a = left;
            left = right;
            at_left = at_right;
            right = a + ratio * (b - a);
            at_right = at(right);
        }
    }
    const double middle = 0.5 * (a + b);
    return {middle, at(middle)};
}

// Nodes at turns keep a sun that shows for a minute only, at the edge of the polar night, from being missed.
void add_turns(DayCurve& curve) {
    const std::vector<DayCurve::Node> nodes = curve.nodes;
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
        const double before = nodes[i].value - nodes[i - 1].value;
        const double behind = nodes[i + 1].value - nodes[i].value;
        if (before * behind > 0.0) continue;
        const double sign = before < 0.0 ? 1.0 : -1.0;
        DayCurve::Node turn = lowest([&](double s) { return sign * curve.at(s); }, nodes[i - 1].second, nodes[i + 1].second);
        turn.value *= sign;
        curve.nodes.push_back(turn);
    }
    std::sort(curve.nodes.begin(), curve.nodes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
}

DayCurve day_curve(const Utc& date, const std::function<double(const Utc&)>& angle) {
    const Utc midnight{date.year, date.month, date.day, 0, 0, 0.0};
    DayCurve curve{midnight, [midnight, angle](double second) { return angle(*after(midnight, second)); }, {}};
    const double end = day_length_s(midnight) - last_instant_s;
    for (double second = 0.0; second < end + step_s; second += step_s) {
        const double inside = std::min(second, end);
        curve.nodes.push_back({inside, curve.at(inside)});
    }
    add_turns(curve);
    return curve;
}

// Where the curve crosses `level` between two nodes on either side of it.
double crossing(const DayCurve& curve, DayCurve::Node a, DayCurve::Node b, double level) {
    while (b.second - a.second > resolution_s) {
        const double middle = 0.5 * (a.second + b.second);
        const double value = curve.at(middle);
        ((value < level) == (a.value < level) ? a : b) = {middle, value};
    }
    return 0.5 * (a.second + b.second);
}

// A zenith angle that falls through the level is a rise.
Crossings crossings(const DayCurve& curve, double level) {
    Crossings found{{}, {}, curve.nodes.front().value < level};
    for (std::size_t i = 1; i < curve.nodes.size(); ++i) {
        const auto& a = curve.nodes[i - 1];
        const auto& b = curve.nodes[i];
        if ((a.value < level) == (b.value < level)) continue;
        (b.value < level ? found.rises : found.sets).push_back(*after(curve.midnight, crossing(curve, a, b, level)));
    }
    return found;
}

}  // namespace

SunDay sun_day(const Place& place, const Utc& date, double ut1_minus_utc_s) {
    const SkyOptions options{{}, ut1_minus_utc_s};
    const DayCurve curve = day_curve(date, [&](const Utc& t) { return sun_position(place, t, options).direction.zenith; });
    const auto top =
        *std::min_element(curve.nodes.begin(), curve.nodes.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
    return {crossings(curve, sunrise_zenith),           crossings(curve, civil_twilight_zenith),
            crossings(curve, nautical_twilight_zenith), crossings(curve, astronomical_twilight_zenith),
            *after(curve.midnight, top.second),         top.value};
}

Crossings moon_rises_and_sets(const Place& place, const Utc& date, double ut1_minus_utc_s) {
    constexpr double horizon = 90.0 * deg + 34.0 / 60.0 * deg;
    const SkyOptions options{{}, ut1_minus_utc_s};
    const auto upper_limb = [&](const Utc& t) {
        const MoonPosition moon = moon_position(place, t, options);
        return moon.direction.zenith - moon.angular_radius;
    };
    return crossings(day_curve(date, upper_limb), horizon);
}

}  // namespace airlight
