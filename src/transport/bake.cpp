#include "transport/bake.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "core/quadrature.h"
#include "transport/harmonics.h"
#include "transport/pack_arithmetic.h"
#include "transport/ray_light.h"
#include "transport/view_rule.h"

namespace airlight {

namespace {

using f32::IrradianceSpectrum;
using f32::RadianceSpectrum;

// Degree of the harmonics in which light is scattered; with it the radiance of Earth's sky in haze changes by less than 0.1 %
// when the degree is doubled. (Rayleigh's phase function ends at degree 2; Henyey and Greenstein's with g = 0.8 falls to 0.8^20 = 0.01.)
constexpr HarmonicLayout layout{20};
constexpr int nodes_per_piece = 12;

// Directions of quadrature: sky and ground apart, both crowding towards the horizon between them.
constexpr ViewAngles view_angles{.sky = 20, .ground = 12, .layer = 8};
constexpr int azimuths = 22;  // midpoints over half a turn: exact for products of two harmonics of degree 20

// Phase functions are clipped at this angle from the sun; what stands above the clip is integrated over a disk of its own.
constexpr double peak_radius = 25.0 * deg;
constexpr int peak_rings = 12;
constexpr int peak_spokes = 12;

// The directions within the peak's disk around the sun at one of its zenith angles.
struct PeakRule {
    struct Direction {
        double mu;
        double nu;
        float weight;                 // solid angle, both halves of the disk
        std::vector<float> harmonic;  // [layout.count()]
    };
    std::vector<Direction> directions;
};

PeakRule peak_rule(double mu_s) {
    PeakRule rule;
    const GaussRule rings = gauss_rule(peak_rings, 0.0, 1.0);
    const double sin_s = std::sqrt(std::max(0.0, 1.0 - mu_s * mu_s));
    for (std::size_t i = 0; i < rings.nodes.size(); ++i) {
        const double s = rings.nodes[i];
        const double gamma = peak_radius * s * s;
        for (int j = 0; j < peak_spokes; ++j) {
            const double psi = pi * (j + 0.5) / peak_spokes;
            const double mu = std::clamp(mu_s * std::cos(gamma) + sin_s * std::sin(gamma) * std::cos(psi), -1.0, 1.0);
            const double sines = std::sqrt(std::max(0.0, 1.0 - mu * mu)) * sin_s;
            const double cos_phi = sines > 1e-9 ? std::clamp((std::cos(gamma) - mu * mu_s) / sines, -1.0, 1.0) : 1.0;
            const double weight = rings.weights[i] * 2.0 * s * peak_radius * std::sin(gamma) * 2.0 * pi / peak_spokes;
            PeakRule::Direction direction{mu, std::cos(gamma), static_cast<float>(weight), legendre_values(layout, mu)};
            const double phi = std::acos(cos_phi);
            for (int k = 0; k <= layout.degree; ++k)
                for (int l = k; l <= layout.degree; ++l)
                    direction.harmonic[static_cast<std::size_t>(layout.index(l, k))] *= static_cast<float>(std::cos(k * phi));
            rule.directions.push_back(std::move(direction));
        }
    }
    return rule;
}

using Coefficients = std::vector<RadianceSpectrum>;  // [layout.count()]

class Baker {
public:
    Baker(const AirOptics& optics, const BakeSettings& settings)
        : optics_(optics),
          air_(pack_air(optics, settings.sizes)),
          sizes_(settings.sizes),
          transmittance_(transmittance_table(air_, sizes_.transmittance_mu)) {
        for (const AirOptics::Part& part : optics.parts) moments_.push_back(part.phase.legendre_moments(layout.degree + 1));
        for (int i = 0; i < sizes_.altitude; ++i) {
            const double h = altitude(i);
            views_.push_back(view_rule(layout, view_angles, view_edges(air_.shell, air_.densities, h)));
            scattering_factors_.push_back(factors_at(air_.source_axis.inner_altitude_m(i)));
            rays_.emplace_back();
            for (const ViewRule::Angle& angle : views_.back().angles)
                rays_.back().emplace_back(air_, h, angle.mu, nodes_per_piece, source_size());
        }
        for (int j = 0; j < azimuths; ++j)
            for (int k = 0; k <= layout.degree; ++k)
                azimuth_weights_[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] =
                    static_cast<float>(2.0 * pi / azimuths * std::cos(k * pi * (j + 0.5) / azimuths));
        for (int j = 0; j < sizes_.azimuth; ++j) {
            const double phi = std::acos(f64::azimuth_cosine_of_coordinate(static_cast<double>(j) / (sizes_.azimuth - 1)).value);
            texel_cosines_.emplace_back();
            for (int k = 0; k <= layout.degree; ++k)
                texel_cosines_.back()[static_cast<std::size_t>(k)] = static_cast<float>(std::cos(k * phi));
        }
        for (int i = 0; i < sizes_.sun; ++i) peaks_.push_back(peak_rule(sun(i)));
        for (int i = 0; i < sizes_.view; ++i)
            texel_legendre_.push_back(legendre_values(layout, f64::view_of_coordinate(static_cast<double>(i) / (sizes_.view - 1)).value));
    }

    Result<PackTables> bake(const BakeSettings& settings, const Progress& progress, BakeSteps steps) {
        BakeState state = steps.from.orders_done > 0 ? std::move(steps.from) : empty_state();
        Source next = empty_source();
        Irradiance next_irradiance = empty_irradiance();
        for (int order = state.orders_done + 1; order <= settings.orders; ++order) {
            std::atomic<int> done = 0;
            const int tasks = sizes_.altitude * sizes_.sun;
            parallel_for(static_cast<std::size_t>(tasks), [&](std::size_t task) {
                if (progress.stop.stop_requested()) return;
                const int i_s = static_cast<int>(task) % sizes_.sun;
                const bool night = i_s == 0;  // the sun is 30 degrees below: that texel stays dark
                if (!night) scatter(order, static_cast<int>(task) / sizes_.sun, i_s, state.source, state.irradiance, next, next_irradiance);
                const int count = ++done;
                if (count % 64 == 0) progress.report("scattering", (order - 1 + static_cast<double>(count) / tasks) / settings.orders);
            });
            if (progress.stop.stop_requested()) return Error{"", "the bake was interrupted", ""};
            const bool last = order == settings.orders;
            const bool closes = last && settings.extrapolate && order >= 3;
            if (closes) {
                add_series(state.source_sum, state.source, next);
                add_series(state.irradiance_sum, state.irradiance, next_irradiance);
            } else {
                if (!last) add(state.source_sum, next);  // the source of a scattering beyond the last is not wanted
                add(state.irradiance_sum, next_irradiance);
            }
            std::swap(state.source, next);
            std::swap(state.irradiance, next_irradiance);
            state.orders_done = order;
            if (!last) steps.order_done(state);
        }
        return PackTables{std::move(transmittance_), std::move(state.source_sum), std::move(state.irradiance_sum)};
    }

private:
    using Source = Table<RadianceSpectrum, 4>;
    using Irradiance = Table<IrradianceSpectrum, 2>;

    std::array<int, 4> source_size() const { return {sizes_.sun, sizes_.azimuth, sizes_.view, sizes_.altitude}; }
    Source empty_source() const { return filled<Source>(source_size()); }
    Irradiance empty_irradiance() const { return filled<Irradiance>({sizes_.sun, sizes_.altitude}); }
    BakeState empty_state() const { return {0, empty_source(), empty_irradiance(), empty_source(), empty_irradiance()}; }
    template <class T>
    static T filled(const decltype(T().size())& size) {
        T table(size);
        for (auto& cell : table.cells()) cell = zero<std::decay_t<decltype(cell)>>();
        return table;
    }

    double altitude(int i) const { return air_.source_axis.altitude_m(i); }
    double sun(int i) const { return f64::sun_of_coordinate(static_cast<double>(i) / (sizes_.sun - 1)).value; }

    // By which the coefficients of degree l are multiplied when light scatters at an altitude: [degree + 1].
    std::vector<f32::Spectrum> factors_at(double h) const {
        float density[max_parts];
        air_.densities.at(static_cast<float>(h), density);
        std::vector<f32::Spectrum> factors(layout.degree + 1, zero<f32::Spectrum>());
        f32::ScatteringSpectrum total = zero<f32::ScatteringSpectrum>();
        for (std::size_t p = 0; p < optics_.parts.size(); ++p) total += air_.scattering[p] * f32::Number(density[p]);
        for (std::size_t p = 0; p < optics_.parts.size(); ++p) {
            for (std::size_t l = 0; l < factors.size(); ++l)
                for (int w = 0; w < pack_size; ++w)
                    if (total.v[w] > 0.0f)
                        factors[l].v[w] += air_.scattering[p].v[w] * density[p] / total.v[w] * static_cast<float>(moments_[p][l].v[w]);
        }
        for (int w = 0; w < pack_size; ++w)
            if (!(total.v[w] > 0.0f)) factors[0].v[w] = 1.0f;  // no air here: any phase function will do
        return factors;
    }

    // The light of one order around a point, scattered once more.
    void scatter(int order, int i_h, int i_s, const Source& source, const Irradiance& irradiance, Source& next,
                 Irradiance& next_irradiance) const {
        Coefficients light(static_cast<std::size_t>(layout.count()), zero<RadianceSpectrum>());
        IrradianceSpectrum on_level = zero<IrradianceSpectrum>();
        const Gathered what{.single = order == 1,
                            .source = order == 1 ? nullptr : &source,
                            .diffuse_on_ground = order == 1 ? nullptr : &irradiance,
                            .direct_on_ground = order == 1};
        add_all_directions(what, i_h, i_s, light, on_level);
        if (order == 1) add_peak(i_h, i_s, light, on_level);
        next_irradiance[{i_s, i_h}] = on_level;

        const std::vector<f32::Spectrum>& factors = scattering_factors_[static_cast<std::size_t>(i_h)];
        for (int k = 0; k <= layout.degree; ++k)
            for (int l = k; l <= layout.degree; ++l) {
                RadianceSpectrum& coefficient = light[static_cast<std::size_t>(layout.index(l, k))];
                coefficient = coefficient * factors[static_cast<std::size_t>(l)];
            }
        write_texels(light, i_h, i_s, next);
    }

    void add_all_directions(const Gathered& what, int i_h, int i_s, Coefficients& light, IrradianceSpectrum& on_level) const {
        const double mu_s = sun(i_s);
        std::array<RadianceSpectrum, layout.degree + 1> by_order;
        for (std::size_t i = 0; i < views_[static_cast<std::size_t>(i_h)].angles.size(); ++i) {
            const ViewRule::Angle& angle = views_[static_cast<std::size_t>(i_h)].angles[i];
            const PreparedRay& ray = rays_[static_cast<std::size_t>(i_h)][i];
            by_order.fill(zero<RadianceSpectrum>());
            for (int j = 0; j < azimuths; ++j) {
                const double phi = pi * (j + 0.5) / azimuths;
                const double nu =
                    std::clamp(angle.mu * mu_s + std::sqrt((1.0 - angle.mu * angle.mu) * (1.0 - mu_s * mu_s)) * std::cos(phi), -1.0, 1.0);
                RadianceSpectrum radiance = ray.multiple(air_, transmittance_, what, static_cast<float>(mu_s), static_cast<float>(nu));
                if (what.single)
                    radiance += single_light(ray, {altitude(i_h), angle.mu, mu_s, nu},
                                             [nu](const SpectralPhase& phase) { return phase.at(std::min(nu, std::cos(peak_radius))); });
                for (int k = 0; k <= layout.degree; ++k)
                    add_scaled(by_order[static_cast<std::size_t>(k)], radiance,
                               azimuth_weights_[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)]);
            }
            if (angle.mu > 0.0)
                for (int w = 0; w < pack_size; ++w) on_level.v[w] += by_order[0].v[w] * angle.weight * static_cast<float>(angle.mu);
            for (int k = 0; k <= layout.degree; ++k)
                for (int l = k; l <= layout.degree; ++l) {
                    const auto c = static_cast<std::size_t>(layout.index(l, k));
                    add_scaled(light[c], by_order[static_cast<std::size_t>(k)], angle.weight * angle.legendre[c]);
                }
        }
    }

    // Light scattered once along a ray, each constituent's by `phase_of` its phase function. A ray that the shadow's edge
    // crosses is cut there, at its price.
    template <class PhaseOf>
    RadianceSpectrum single_light(const PreparedRay& prepared, const Ray& ray, PhaseOf phase_of) const {
        const auto mu_s = static_cast<float>(ray.mu_s);
        const auto nu = static_cast<float>(ray.nu);
        RadianceSpectrum radiance = zero<RadianceSpectrum>();
        const PreparedRay::Lit lit = prepared.lit(air_, mu_s, nu);
        if (lit == PreparedRay::Lit::nothing) return radiance;
        std::array<IrradianceSpectrum, max_parts> single;
        if (lit == PreparedRay::Lit::all) {
            prepared.single(air_, transmittance_, mu_s, nu, single);
        } else {
            RayNodes nodes;
            sample_ray(air_.shell, ray, air_.densities, air_.opacity, nodes_per_piece, nodes);
            single = gather(air_, transmittance_,
                            {.single = true, .source = nullptr, .diffuse_on_ground = nullptr, .direct_on_ground = false}, nodes, nu)
                         .single;
        }
        for (std::size_t p = 0; p < optics_.parts.size(); ++p)
            if (optics_.parts[p].scatters) radiance += single[p] * narrowed<f32::PhaseSpectrum>(phase_of(optics_.parts[p].phase));
        return radiance;
    }

    // Single scattering near the sun, as far as phase functions stand above their value at the disk's edge.
    void add_peak(int i_h, int i_s, Coefficients& light, IrradianceSpectrum& on_level) const {
        for (const PeakRule::Direction& direction : peaks_[static_cast<std::size_t>(i_s)].directions) {
            const PreparedRay ray(air_, altitude(i_h), direction.mu, nodes_per_piece, source_size());
            const RadianceSpectrum radiance =
                single_light(ray, {altitude(i_h), direction.mu, sun(i_s), direction.nu},
                             [&](const SpectralPhase& phase) { return phase.at(direction.nu) - phase.at(std::cos(peak_radius)); });
            if (direction.mu > 0.0)
                for (int w = 0; w < pack_size; ++w) on_level.v[w] += radiance.v[w] * direction.weight * static_cast<float>(direction.mu);
            for (std::size_t c = 0; c < light.size(); ++c) add_scaled(light[c], radiance, direction.weight * direction.harmonic[c]);
        }
    }

    void write_texels(const Coefficients& light, int i_h, int i_s, Source& next) const {
        std::array<RadianceSpectrum, layout.degree + 1> by_order;
        for (int i = 0; i < sizes_.view; ++i) {
            const std::vector<float>& legendre = texel_legendre_[static_cast<std::size_t>(i)];
            for (int k = 0; k <= layout.degree; ++k) {
                by_order[static_cast<std::size_t>(k)] = zero<RadianceSpectrum>();
                for (int l = k; l <= layout.degree; ++l) {
                    const auto c = static_cast<std::size_t>(layout.index(l, k));
                    add_scaled(by_order[static_cast<std::size_t>(k)], light[c], legendre[c]);
                }
            }
            for (int j = 0; j < sizes_.azimuth; ++j) {
                RadianceSpectrum sum = zero<RadianceSpectrum>();
                for (int k = 0; k <= layout.degree; ++k)
                    add_scaled(sum, by_order[static_cast<std::size_t>(k)],
                               texel_cosines_[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)]);
                next[{i_s, j, i, i_h}] = max(sum, zero<RadianceSpectrum>());  // a cut series may ring below zero in the dark
            }
        }
    }

    template <class T>
    static void add(T& sum, const T& x) {
        for (std::size_t i = 0; i < sum.cells().size(); ++i) sum.cells()[i] += x.cells()[i];
    }

    // The factor by which the last order, summed over all texels, is less than the one before: [wavelength], at most 0.95.
    template <class T>
    static std::array<float, pack_size> decline(const T& previous, const T& last) {
        std::array<float, pack_size> ratio;
        for (int w = 0; w < pack_size; ++w) {
            double before = 0.0, after = 0.0;
            for (std::size_t i = 0; i < last.cells().size(); ++i) {
                before += previous.cells()[i].v[w];
                after += last.cells()[i].v[w];
            }
            ratio[static_cast<std::size_t>(w)] = before > 0.0 ? static_cast<float>(std::min(after / before, 0.95)) : 0.0f;
        }
        return ratio;
    }

    // Adds `last` and all that follows it in the geometric series that `previous` and `last` begin. Successive orders approach
    // such a series, for light forgets where it came from. Deep in haze the first orders still grow; a texel's own ratio,
    // there above that of the whole, would then overstate what follows by half.
    template <class T>
    static void add_series(T& sum, const T& previous, const T& last) {
        const std::array<float, pack_size> most = decline(previous, last);
        for (std::size_t i = 0; i < sum.cells().size(); ++i)
            for (int w = 0; w < pack_size; ++w) {
                const float a = previous.cells()[i].v[w];
                const float b = last.cells()[i].v[w];
                const float ratio = a > 0.0f ? std::min(b / a, most[static_cast<std::size_t>(w)]) : 0.0f;
                sum.cells()[i].v[w] += b / (1.0f - ratio);
            }
    }

    const AirOptics& optics_;
    PackAir air_;
    TableSizes sizes_;
    Table<f32::Spectrum, 2> transmittance_;
    std::vector<std::vector<f64::Spectrum>> moments_;                             // [part][degree + 1], of its phase function
    std::vector<ViewRule> views_;                                                 // [altitude]
    std::vector<std::vector<PreparedRay>> rays_;                                  // [altitude][view angle]
    std::array<std::array<float, layout.degree + 1>, azimuths> azimuth_weights_;  // cos(k phi) times the share of a turn
    std::vector<std::vector<f32::Spectrum>> scattering_factors_;                  // [altitude][degree + 1]
    std::vector<PeakRule> peaks_;                                                 // [sun]
    std::vector<std::array<float, layout.degree + 1>> texel_cosines_;             // [azimuth], cos(k phi)
    std::vector<std::vector<float>> texel_legendre_;                              // [view][layout.count()]
};

}  // namespace

Result<PackTables> bake_pack(const AirOptics& optics, const BakeSettings& settings, const Progress& progress, BakeSteps steps) {
    assert(settings.orders >= 1 && steps.from.orders_done < settings.orders);
    return Baker(optics, settings).bake(settings, progress, std::move(steps));
}

}  // namespace airlight
