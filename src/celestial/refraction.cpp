#include "celestial/refraction.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <variant>

#include "core/quadrature.h"
#include "optics/rayleigh.h"

namespace airlight {

namespace {

constexpr Wavelength green = 550.0 * nm;

constexpr int nodes = 32;  // on each side of a ray's lowest place

// n - 1 and its slope, over the distance r from the planet's centre.
class Refractivity {
public:
    explicit Refractivity(const Atmosphere& air) : air_(air) {
        const double of_standard_air = (rayleigh_cross_section_of_air(green) * standard_number_density).value;
        for (const Constituent& part : air.constituents)
            if (std::holds_alternative<RayleighPhase>(part.phase))
                parts_.push_back(
                    {&part.profile, (refractive_index_of_air(green) - 1.0) * part.scattering.at(green).value / of_standard_air});
    }

    double bottom() const { return air_.bottom_radius.value; }
    double top() const { return bottom() + air_.top_altitude.value; }
    double at(double r) const {
        double sum = 0.0;
        if (r > top()) return sum;
        for (const auto& [profile, refractivity] : parts_)
            sum += refractivity * relative_density(*profile, std::max(r - bottom(), 0.0) * m);
        return sum;
    }
    // Of its logarithm over a kilometre: profiles of real air are tables with kinks, at which the bending would tremble by 14".
    double slope(double r) const {
        constexpr double half_step = 500.0;
        const double low = std::max(r - half_step, bottom()), high = std::min(r + half_step, top());
        const double below = at(low), above = at(high);
        return above > 0.0 ? at(r) * std::log(above / below) / (high - low) : 0.0;
    }

private:
    struct Part {
        const DensityProfile* profile;
        double refractivity;
    };
    const Atmosphere& air_;
    std::vector<Part> parts_;
};

// Where n r is `product`, of a ray that is in the air.
double radius_of(const Refractivity& n, double product) {
    double r = product;
    for (int i = 0; i < 3; ++i) r -= ((1.0 + n.at(r)) * r - product) / (1.0 + n.at(r) + r * n.slope(r));
    return std::max(r, n.bottom());
}

double horizon_of(const Refractivity& n, Length eye) {
    const double r = n.bottom() + eye.value;
    const double cosine = (1.0 + n.at(n.bottom())) * n.bottom() / ((1.0 + n.at(r)) * r);
    return -std::acos(std::min(cosine, 1.0));
}

// By Gauss's `rule` on [0, 1].
double bending_of(const Refractivity& n, const GaussRule& rule, Length eye, double elevation) {
    double r = n.bottom() + eye.value, from = elevation;
    if (r > n.top()) {
        const double cosine = r * std::cos(elevation) / n.top();
        if (elevation >= 0.0 || cosine >= 1.0) return 0.0;
        r = n.top(), from = -std::acos(cosine);
    }
    const double kept = (1.0 + n.at(r)) * r * std::cos(from);
    const double to = std::acos(std::min(kept / n.top(), 1.0));
    // Where the ray rises steeply, little air is left on many degrees of its way: nodes crowd towards its lowest place.
    double sum = 0.0;
    const auto add = [&](double low, double high) {
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double u = rule.nodes[i], e = low + (high - low) * u * u;
            const double at = radius_of(n, kept / std::cos(e)), curve = at * n.slope(at);
            sum -= rule.weights[i] * std::abs(high - low) * 2.0 * u * curve / (1.0 + n.at(at) + curve);
        }
    };
    if (from < 0.0) add(0.0, from);
    add(std::max(from, 0.0), to);
    return sum;
}

}  // namespace

double apparent_horizon(const Atmosphere& air, Length eye) { return horizon_of(Refractivity(air), eye); }

double bending(const Atmosphere& air, Length eye, double apparent_elevation) {
    assert(eye.value >= 0.0);
    return bending_of(Refractivity(air), gauss_rule(nodes, 0.0, 1.0), eye, apparent_elevation);
}

BendingTable bending_table(const Atmosphere& air, Length eye, int count) {
    assert(eye.value >= 0.0 && count >= 2);
    const Refractivity n(air);
    const GaussRule rule = gauss_rule(nodes, 0.0, 1.0);
    BendingTable table{horizon_of(n, eye), {}};
    for (int i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / (count - 1);
        table.bending.push_back(bending_of(n, rule, eye, table.horizon + (0.5 * pi - table.horizon) * u * u * u * u));
    }
    return table;
}

}  // namespace airlight
