// The tables of bruneton2008 as the GPU fills them: against what the CPU gathers from the finer bake of transport, and the laws that they
// must follow.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "atmosphere/presets.h"
#include "models/two_look_ups.h"
#include "physics/models/f64.h"
#include "render/bruneton2008_tables.h"
#include "tools/gpu_case.h"
#include "tools/small_tables.h"

using namespace airlight;
using namespace airlight::test;

namespace {

// Two groups of four.
const std::vector<Wavelength> five = {450.0 * nm, 500.0 * nm, 550.0 * nm, 600.0 * nm, 650.0 * nm};
constexpr TableSizes around = {.transmittance_mu = 256, .transmittance_altitude = 64, .sun = 32, .azimuth = 8, .view = 16, .altitude = 16};
constexpr Bruneton2008Settings small = {.altitude = 6, .view = 16, .sun = 12, .nu = 4, .twilight = true};

using Programs = std::shared_ptr<const render::Bruneton2008Programs>;

Programs programs() {
    Result<Programs> made = render::bruneton2008_programs();
    if (!made) FAIL(made.error().message());
    return *std::move(made);
}

render::Bruneton2008Textures filled(const Programs& programs, const Atmosphere& atmosphere, std::span<const Wavelength> wavelengths,
                                    const Bruneton2008Settings& texels, int orders) {
    render::Bruneton2008Bake bake(programs, atmosphere, wavelengths, texels, {.sizes = around, .orders = orders, .extrapolate = false});
    gpu::PassTimers timers;
    while (bake.done() < bake.slices()) bake.advance(timers);
    return std::move(bake).take();
}

double fraction(int i, int size) { return static_cast<double>(i) / (size - 1); }

// The view of a texel: at the ground, ways to the ground begin 1 m up; its nu is the texel's even where view and sun cannot make it.
AirView view_of_texel(const render::Bruneton2008Textures& tables, const Shell& shell, int altitude, int view, int nu, int sun) {
    const Bruneton2008Settings& texels = tables.texels;
    const f64::Length bottom = f64::Length::of(shell.bottom_m), top = f64::Length::of(shell.top_m);
    const f64::Length h = f64::Length::of(tables.altitudes.altitude_m(altitude));
    const int half = texels.view / 2;
    const bool ground = view < half;
    const f64::Length above = ground ? std::max(h, f64::Length::of(1.0)) : h;
    const double mu = ground ? f64::bruneton2008_ground_cosine(above, fraction(view, half), bottom).value
                             : f64::bruneton2008_sky_cosine(h, fraction(view - half, half), bottom, top).value;
    return {above.value, mu, f64::bruneton2008_chosen_sun_of_coordinate(fraction(sun, texels.sun), texels.twilight).value,
            2.0 * fraction(nu, texels.nu) - 1.0, ground};
}

// What the CPU gathers for a view, by the source of a bake.
RayLight light_of(const Tables::Pack& pack, const AirView& view) {
    constexpr int nodes = 12;
    // On its own side of the horizon.
    const double horizon = f64::horizon_cosine(f64::Length::of(view.altitude_m), f64::Length::of(pack.air.shell.bottom_m)).value;
    const double mu = view.ground ? std::min(view.mu, horizon - 1e-12) : std::max(view.mu, horizon + 1e-12);
    const PreparedRay ray(pack.air, view.altitude_m, mu, nodes, pack.tables.source.size());
    const Gathered higher{.single = false, .source = &pack.tables.source, .diffuse_on_ground = nullptr, .direct_on_ground = false};
    const double sines = std::sqrt(std::max(0.0, (1.0 - mu * mu) * (1.0 - view.mu_s * view.mu_s)));
    const double nu = std::clamp(view.nu, mu * view.mu_s - sines, mu * view.mu_s + sines);
    RayLight light;
    light.multiple = ray.multiple(pack.air, pack.tables.transmittance, higher, static_cast<float>(view.mu_s), static_cast<float>(nu));
    light.single = single_light(pack.air, pack.tables.transmittance, ray, {view.altitude_m, mu, view.mu_s, nu}, nodes);
    return light;
}

// The scattering tables of a group.
struct ScatteringTables {
    Bruneton2008Settings texels;
    int tables;
    std::vector<float> values;
    std::vector<double> gains;  // of ways to the ground: [altitude][view]

    ScatteringTables(const render::Bruneton2008Textures& all, std::size_t group, const Shell& shell)
        : texels(all.texels), tables(1 + static_cast<int>(all.parts.size())) {
        for (int k = 0; k < texels.altitude; ++k)
            for (int v = 0; v < texels.view; ++v) {
                const AirView view = view_of_texel(all, shell, k, v, 0, 0);
                const auto way = f64::distance_to_ground(f64::Length::of(view.altitude_m), view.mu, f64::Length::of(shell.bottom_m));
                gains.push_back(view.ground ? f64::bruneton2008_gain(way).value : 1.0);
            }
        values.resize(static_cast<std::size_t>(4 * tables * texels.altitude * texels.view * texels.nu * texels.sun));
        all.groups[group].scattering.read(values);
    }
    double at(int table, int altitude, int view, int nu, int sun, int w) const {
        const int row = (table * texels.altitude + altitude) * texels.view + view;
        const double root = values[static_cast<std::size_t>(4 * ((row * texels.nu + nu) * texels.sun + sun) + w)];
        return root * root * gains[static_cast<std::size_t>(altitude * texels.view + view)];
    }
};

struct Difference {
    double sum = 0.0, expected = 0.0, worst = 0.0;
    void add(double value, double truth, double least) {
        sum += std::abs(value - truth);
        expected += truth;
        worst = std::max(worst, std::abs(value - truth) / (truth + least));
    }
    double mean() const { return sum / expected; }
};

}  // namespace

// The CPU's bake has finer directions and harmonics, and another rule along rays; both have the same texels of the source. Of light so
// faint that it is below 1e-3 W m-2 sr-1 nm-1, a hundredth of a day's sky, the absolute difference counts. The largest differences are of
// rays that the edge of the planet's shadow crosses: the CPU cuts them there, the GPU has more nodes.
TEST_CASE("the GPU fills the tables of bruneton2008 with what the CPU gathers, texel by texel") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Atmosphere atmosphere = *preset("earth-clear");
    const render::Bruneton2008Textures gpu = filled(programs(), atmosphere, five, small, 3);
    const Tables baked = *bake_tables(atmosphere, five, {.sizes = around, .orders = 3, .extrapolate = false}, {});
    const Tables::Pack& pack = baked.packs()[0];
    std::vector<Difference> differences(1 + gpu.parts.size());
    for (std::size_t g = 0; g < gpu.groups.size(); ++g) {
        const ScatteringTables tables(gpu, g, pack.air.shell);
        for (int k = 0; k < small.altitude; ++k)
            // At the ground the CPU's ways to it have no length.
            for (int v = k == 0 ? small.view / 2 : 0; v < small.view; ++v)
                for (int n = 0; n < small.nu; ++n)
                    for (int s = 0; s < small.sun; ++s) {
                        const RayLight light = light_of(pack, view_of_texel(gpu, pack.air.shell, k, v, n, s));
                        for (std::size_t w = 4 * g; w < std::min(4 * g + 4, five.size()); ++w) {
                            differences[0].add(tables.at(0, k, v, n, s, static_cast<int>(w % 4)), light.multiple.v[w], 1e-3);
                            for (std::size_t i = 0; i < gpu.parts.size(); ++i)
                                differences[1 + i].add(tables.at(static_cast<int>(1 + i), k, v, n, s, static_cast<int>(w % 4)),
                                                       light.single[gpu.parts[i]].v[w], 1e-3);
                        }
                    }
    }
    for (const Difference& d : differences)
        fmt::print("  mean difference {:.3f} %, the largest {:.2f} %\n", 100.0 * d.mean(), 100.0 * d.worst);
    CHECK(differences[0].mean() <= 0.015);
    CHECK(differences[0].worst <= 0.15);
    for (std::size_t i = 1; i < differences.size(); ++i) {
        CHECK(differences[i].mean() <= 0.003);
        CHECK(differences[i].worst <= 0.15);
    }
}

// What leaves at the top of the air, what reaches the ground scattered and what reaches it straight. On a planet so large that the air is
// flat but for 3 degrees beside the horizon.
TEST_CASE("air that absorbs nothing, over a black ground, gives back all light, with one order, only what is scattered once") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    Atmosphere atmosphere = one_gas();
    atmosphere.bottom_radius = 60000.0 * km;
    atmosphere.ground_albedo = SpectrumOf<Number>::constant(0.0);
    const std::vector<Wavelength> one = {550.0 * nm};
    const Bruneton2008Settings texels = {.altitude = 2, .view = 96, .sun = 8, .nu = 16, .twilight = true};
    const Programs compiled = programs();
    const render::Bruneton2008Textures all = filled(compiled, atmosphere, one, texels, 7),
                                       single = filled(compiled, atmosphere, one, texels, 1);
    const Shell shell{atmosphere.bottom_radius.in(m), atmosphere.top_altitude.in(m)};
    const ScatteringTables light(all, 0, shell), once(single, 0, shell);
    const double sun = atmosphere.sun.irradiance.at(one[0]).value;
    const double depth = 2e-5 * 8000.0 * -std::expm1(-100.0 / 8.0);
    std::vector<float> irradiance(static_cast<std::size_t>(4 * around.sun * around.altitude));
    all.groups[0].irradiance.read(irradiance);

    for (const int s : {6, 7}) {
        const double mu_s = view_of_texel(all, shell, 0, 0, 0, s).mu_s;
        // Upward at the top: by the trapezium rule between the texels of views to the ground, and over azimuths.
        const auto upward = [&](int view) {
            const AirView at = view_of_texel(all, shell, texels.altitude - 1, view, 0, s);
            double sum = 0.0;
            constexpr int azimuths = 32;
            for (int j = 0; j < azimuths; ++j) {
                const double sines = std::sqrt((1.0 - at.mu * at.mu) * (1.0 - mu_s * mu_s));
                const double nu = std::clamp(at.mu * mu_s + sines * std::cos(pi * (j + 0.5) / azimuths), -1.0, 1.0);
                const double x = (0.5 + 0.5 * nu) * (texels.nu - 1);
                const int low = std::min(static_cast<int>(x), texels.nu - 2);
                const auto between = [&](int table) {
                    return std::lerp(light.at(table, texels.altitude - 1, view, low, s, 0),
                                     light.at(table, texels.altitude - 1, view, low + 1, s, 0), x - low);
                };
                sum += between(0) + between(1) * f64::rayleigh_phase(nu).value;
            }
            return std::pair(at.mu, 2.0 * pi / azimuths * sum * -at.mu);
        };
        double up = 0.0;
        for (int v = 0; v + 1 < texels.view / 2; ++v) {
            const auto [mu, flux] = upward(v);
            const auto [next_mu, next_flux] = upward(v + 1);
            up += 0.5 * (flux + next_flux) * (next_mu - mu);
        }
        const double x = f64::sun_coordinate(mu_s).value * (around.sun - 1);
        const auto low = static_cast<std::size_t>(std::min(x, around.sun - 2.0));
        const double packed = std::lerp(irradiance[4 * low], irradiance[4 * (low + 1)], x - static_cast<double>(low));
        const double down = sun * std::exp(packed * 28.0 - 26.0), straight = sun * mu_s * std::exp(-depth / mu_s);
        fmt::print("  sun at {:.2f}: {:.4f} up, {:.4f} down, {:.4f} straight, of {:.4f}\n", mu_s, up, down, straight, sun * mu_s);
        CHECK((up + down + straight) / (sun * mu_s) == doctest::Approx(1.0).epsilon(0.01));
    }
    for (int v = 0; v < texels.view; ++v)
        for (int s = 0; s < texels.sun; ++s) {
            CHECK(once.at(0, 0, v, 8, s, 0) <= 1e-8);
            CHECK(once.at(1, 0, v, 8, s, 0) == light.at(1, 0, v, 8, s, 0));
        }
}
