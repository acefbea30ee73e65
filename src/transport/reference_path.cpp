#include "transport/reference_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace airlight {

namespace {

using f64::Spectrum;

constexpr double low_sun = 0.2;         // cosine of the sun's zenith angle below which the aid density draws
constexpr double aid_share = 0.5;       // that share of the distances
constexpr double roulette_weight = 0.1; // paths that carry less are played for

// 1 - exp(-x) for x >= 0, without losing small x.
Spectrum share_absorbed(const Spectrum& x) {
    Spectrum share;
    for (int i = 0; i < pack_size; ++i) {
        const double t = x.v[i];
        const double series = t * (1.0 - t * (1.0 / 2.0) * (1.0 - t * (1.0 / 3.0) * (1.0 - t * (1.0 / 4.0) * (1.0 - t * (1.0 / 5.0)))));
        share.v[i] = t < 0.01 ? series : 1.0 - fast_exp(-t);
    }
    return share;
}

double product_sum(const Spectrum& a, const Spectrum& b) {
    double sum[4] = {0.0, 0.0, 0.0, 0.0};
    for (int i = 0; i < pack_size; i += 4)
        for (int k = 0; k < 4; ++k) sum[k] += a.v[i + k] * b.v[i + k];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

double largest(const Spectrum& x) {
    double m = x.v[0];
    for (int i = 1; i < pack_size; ++i) m = x.v[i] > m ? x.v[i] : m;
    return m;
}

// A mean altitude: where half a constituent's particles lie above, roughly.
double mean_altitude(const DensityProfile& profile, double top) {
    double mass = 0.0, moment = 0.0;
    for (int i = 0; i < 4000; ++i) {
        // Samples crowd towards the ground.
        const double x = (i + 0.5) / 4000.0;
        const double h = top * x * x * x;
        const double density = relative_density(profile, Length::of(h)) * x * x;
        mass += density;
        moment += density * h;
    }
    return mass > 0.0 ? moment / mass : 0.0;
}

bool scatters(const Constituent& constituent) {
    const auto& samples = constituent.scattering.samples();
    return std::any_of(samples.begin(), samples.end(), [](const auto& s) { return s.y.value > 0.0; });
}

}  // namespace

std::vector<DensityProfile> path_densities(const Atmosphere& atmosphere) {
    std::vector<DensityProfile> densities;
    double altitude = 1e-3 * atmosphere.top_altitude.value;
    for (const Constituent& c : atmosphere.constituents) {
        densities.push_back(c.profile);
        if (scatters(c)) altitude = std::max(altitude, mean_altitude(c.profile, atmosphere.top_altitude.value));
    }
    densities.push_back(ExponentialProfile{Length::of(2.5 * altitude)});
    return densities;
}

// Where a path is, and what it carries: the light it would bring (weight) and the density with which each wavelength as
// hero would have drawn it, both up to one common factor. Their quotient, with the mean density of all heroes, is the
// estimate: the balance heuristic [Wilkie2014].
struct PathTracer::Path {
    double h;
    Vec3 up;
    Vec3 direction;
    Vec3 sun;
    int hero;
    Spectrum weight;
    Spectrum density;

    void move(double t, double to, double bottom) {
        up = glm::normalize((bottom + h) * up + t * direction);
        h = to;
    }
};

// How light arriving at the end of a leg is turned towards its start.
struct PathTracer::Collision {
    bool ground;
    ColumnSet density;  // where there is air
};

PathTracer::PathTracer(AirOptics optics, std::shared_ptr<const Columns> columns)
    : optics_(std::move(optics)), columns_(std::move(columns)), sun_(optics_.sun, optics_.wavelengths), hero_share_(f64::Number(0.0)), aid_index_(static_cast<int>(optics_.parts.size())) {
    for (int l = 0; l < heroes(); ++l) hero_share_.v[l] = 1.0 / heroes();
    assert(aid_index_ < max_columns);
    for (std::size_t c = 0; c < optics_.parts.size(); ++c) {
        const AirOptics::Part& part = optics_.parts[c];
        samplers_.emplace_back(part.phase);
        if (!part.scatters) continue;
        scatterers_.push_back(static_cast<int>(c));
        for (int l = 0; l < pack_size; ++l) hero_[l].v[c] = part.extinction.v[l];
    }
    aid_.v[aid_index_] = 1.0;
}

double PathTracer::drawn_density(const Path& path) const { return product_sum(path.density, hero_share_); }

Spectrum PathTracer::depth(const ColumnSet& columns) const {
    Spectrum depth(f64::Number(0.0));
    for (std::size_t c = 0; c < optics_.parts.size(); ++c) depth += optics_.parts[c].extinction * f64::Length::of(columns.v[c]);
    return depth;
}

Spectrum PathTracer::transmittance_to_top(double altitude, double mu) const {
    if (f64::meets_ground(f64::Length::of(altitude), mu, optics_.bottom_radius)) return Spectrum(f64::Number(0.0));
    return exp(-depth(columns_->to_top(altitude, mu)));
}

Spectrum PathTracer::transmittance(double altitude, double mu, double t) const {
    const Columns::Ray ray = columns_->ray(altitude, mu);
    return exp(-depth(columns_->at_distance(ray, std::min(t, ray.length)).column));
}

// The sun's light, on a plane facing it, that reaches a point from one direction of its disk.
f64::IrradianceSpectrum PathTracer::sunlight(double altitude, const Vec3& up, const Vec3& direction, double u) const {
    const f64::IrradianceSpectrum light = optics_.solar_irradiance * transmittance_to_top(altitude, glm::dot(up, direction));
    return sun_.is_point() ? light : light * sun_.weight(u);
}

f64::IrradianceSpectrum PathTracer::direct_irradiance(double altitude, double sun_zenith) const {
    const Vec3 up(0.0, 0.0, 1.0);
    const Vec3 centre(std::sin(sun_zenith), 0.0, std::cos(sun_zenith));
    const int rings = sun_.is_point() ? 1 : 32, spokes = sun_.is_point() ? 1 : 32;
    f64::IrradianceSpectrum sum(f64::IrradianceSpectrum::Scalar::of(0.0));
    for (int i = 0; i < rings; ++i)
        for (int k = 0; k < spokes; ++k) {
            const double u = (i + 0.5) / rings;
            const Vec3 direction = sun_.is_point() ? centre : sun_.draw(centre, u, (k + 0.5) / spokes);
            sum += sunlight(altitude, up, direction, u) * f64::Number(std::max(0.0, direction.z) / (rings * spokes));
        }
    return sum;
}

// Moves the path to its next collision, in the air or with the ground; false if there is none.
bool PathTracer::advance(Path& path, int order, double first_u, Random& random, Collision& collision) const {
    const double mu = std::clamp(glm::dot(path.up, path.direction), -1.0, 1.0);
    const Columns::Ray ray = columns_->ray(path.h, mu);
    Spectrum scatterers_depth(f64::Number(0.0));
    for (const int c : scatterers_) scatterers_depth += optics_.parts[static_cast<std::size_t>(c)].extinction * f64::Length::of(ray.total.v[c]);
    const Spectrum share = share_absorbed(scatterers_depth);
    collision.ground = false;
    if (ray.ground) {
        Spectrum ground;
        for (int i = 0; i < pack_size; ++i) {
            const double reflected = optics_.ground_albedo.v[i] * (1.0 - share.v[i]);
            ground.v[i] = reflected / std::max(reflected + share.v[i], 1e-300);
        }
        collision.ground = random() < ground.v[path.hero];
        path.density = path.density * (collision.ground ? ground : Spectrum(f64::Number(1.0)) - ground);
    }
    if (collision.ground) {
        path.weight = path.weight * optics_.ground_albedo * exp(-depth(ray.total));
        path.move(ray.length, 0.0, columns_->bottom());
        return true;
    }
    const double low_mu_s = (glm::dot(path.up, path.sun) * (columns_->bottom() + path.h) + ray.low_t * glm::dot(path.direction, path.sun)) / (columns_->bottom() + ray.low_h);
    const double beta = low_mu_s < low_sun ? aid_share : 0.0;
    const double u = order == 1 ? first_u : random();
    Columns::Stop stop;
    if (beta > 0.0 && random() < beta) {
        stop = columns_->at_depth(ray, aid_, u * ray.total.v[aid_index_]);
    } else {
        if (!(share.v[path.hero] > 0.0)) return false;
        stop = columns_->at_depth(ray, hero_[path.hero], -std::log1p(-u * share.v[path.hero]));
    }
    // The density of this stop for each hero: of collisions with what scatters, given that there is one; and the aid's.
    Spectrum coefficient(f64::Number(0.0)), optical_depth(f64::Number(0.0));
    for (const int c : scatterers_) {
        const auto& extinction = optics_.parts[static_cast<std::size_t>(c)].extinction;
        for (int i = 0; i < pack_size; ++i) {
            coefficient.v[i] += extinction.v[i] * stop.density.v[c];
            optical_depth.v[i] += extinction.v[i] * stop.column.v[c];
        }
    }
    const Spectrum reached = exp(-optical_depth);
    const double aid_density = ray.total.v[aid_index_] > 0.0 ? beta * stop.density.v[aid_index_] / ray.total.v[aid_index_] : 0.0;
    for (int i = 0; i < pack_size; ++i)
        path.density.v[i] *= (1.0 - beta) * coefficient.v[i] * reached.v[i] / std::max(share.v[i], 1e-300) + aid_density;
    path.weight = path.weight * exp(-depth(stop.column));
    path.move(stop.t, stop.h, columns_->bottom());
    collision.density = stop.density;
    return drawn_density(path) > 0.0;
}

f64::RadianceSpectrum PathTracer::radiance(const Start& start, Orders orders, int hero, double first_u, Random& random) const {
    f64::RadianceSpectrum sum(f64::RadianceSpectrum::Scalar::of(0.0));
    Path path{start.altitude, start.up, start.direction, start.sun, hero, Spectrum(f64::Number(1.0)), Spectrum(f64::Number(1.0))};
    Collision collision;
    for (int order = 1; order <= orders.last; ++order) {
        if (!advance(path, order, first_u, random, collision)) break;
        // The sun, as seen from here.
        if (order >= orders.first) {
            const double u = sun_.is_point() ? 0.0 : random();
            const Vec3 sun = sun_.is_point() ? path.sun : sun_.draw(path.sun, u, random());
            const f64::IrradianceSpectrum light = sunlight(path.h, path.up, sun, u);
            f64::PhaseSpectrum turned_light(0.0 * f64::per_sr);
            if (collision.ground) turned_light = f64::PhaseSpectrum(std::max(0.0, glm::dot(path.up, sun)) / pi * f64::per_sr);
            else
                for (const int c : scatterers_) {
                    const AirOptics::Part& part = optics_.parts[static_cast<std::size_t>(c)];
                    const f64::PhaseSpectrum phase = part.phase.at(glm::dot(path.direction, sun));
                    for (int i = 0; i < pack_size; ++i) turned_light.v[i] += part.scattering.v[i] * collision.density.v[c] * phase.v[i];
                }
            sum += path.weight * f64::Number(1.0 / drawn_density(path)) * (turned_light * light);
        }
        if (order == orders.last) break;
        // A new direction.
        if (collision.ground) {
            path.direction = turned(path.up, std::sqrt(random()), 2.0 * pi * random());
        } else {
            double shares[max_columns];
            double total = 0.0;
            for (const int c : scatterers_) shares[c] = total += optics_.parts[static_cast<std::size_t>(c)].scattering.v[hero] * collision.density.v[c];
            const double pick = random() * total;
            const int chosen = *std::find_if(scatterers_.begin(), scatterers_.end() - 1, [&](int c) { return pick < shares[c]; });
            const DirectionSampler::Draw draw = samplers_[static_cast<std::size_t>(chosen)].draw(hero, random(), random());
            Spectrum turned_light(f64::Number(0.0)), drawn(f64::Number(0.0)), scattering(f64::Number(0.0));
            for (const int c : scatterers_) {
                const AirOptics::Part& part = optics_.parts[static_cast<std::size_t>(c)];
                const f64::PhaseSpectrum phase = part.phase.at(draw.nu);
                const f64::PhaseSpectrum& density = samplers_[static_cast<std::size_t>(c)].density(draw.bin);
                for (int i = 0; i < pack_size; ++i) {
                    const double coefficient = part.scattering.v[i] * collision.density.v[c];
                    scattering.v[i] += coefficient;
                    turned_light.v[i] += coefficient * phase.v[i];
                    drawn.v[i] += coefficient * density.v[i];
                }
            }
            for (int i = 0; i < pack_size; ++i) path.density.v[i] *= drawn.v[i] / std::max(scattering.v[i], 1e-300);
            path.weight = path.weight * turned_light;
            path.direction = turned(path.direction, draw.nu, 2.0 * pi * random());
        }
        // Both up to one factor: keep them near one. Then play for paths that carry little.
        const double scale = drawn_density(path);
        if (!(scale > 0.0)) break;
        path.density = path.density / f64::Number(scale);
        path.weight = path.weight / f64::Number(scale);
        const double carried = largest(path.weight);
        if (carried < roulette_weight) {
            if (random() * roulette_weight >= carried) break;
            path.weight = path.weight * f64::Number(roulette_weight / carried);
        }
    }
    return sum;
}

}  // namespace airlight
