#include "transport/reference_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace airlight {

namespace {

using f64::Spectrum;

constexpr double low_sun = 0.2;          // cosine of the sun's zenith angle below which the aid density draws
constexpr double aid_share = 0.5;        // that share of the distances
constexpr double roulette_weight = 0.1;  // paths that carry less are played for

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

// The mean altitude of a constituent's particles.
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

// Where in the air a collision may lie: a ray, the columns of the part of it that counts, and the share of each wavelength's light
// that scatterers stop there.
struct PathTracer::Leg {
    Columns::Ray ray;
    ColumnSet total;
    Spectrum share;
};

PathTracer::PathTracer(AirOptics optics, std::shared_ptr<const Columns> columns)
    : optics_(std::move(optics)),
      columns_(std::move(columns)),
      sun_(optics_.sun, optics_.wavelengths),
      hero_share_(f64::Number(0.0)),
      aid_index_(static_cast<int>(optics_.parts.size())) {
    for (int l = 0; l < heroes(); ++l) hero_share_.v[l] = 1.0 / heroes();
    assert(aid_index_ < max_columns);
    for (std::size_t c = 0; c < optics_.parts.size(); ++c) {
        const AirOptics::Part& part = optics_.parts[c];
        samplers_.emplace_back(part.phase);
        all_parts_.push_back(static_cast<int>(c));
        if (!part.scatters) continue;
        scatterers_.push_back(static_cast<int>(c));
        for (int l = 0; l < pack_size; ++l) hero_[l].v[c] = part.extinction.v[l];
    }
    aid_.v[aid_index_] = 1.0;
}

double PathTracer::drawn_density(const Path& path) const { return product_sum(path.density, hero_share_); }

Spectrum PathTracer::depth(const ColumnSet& columns, const std::vector<int>& parts) const {
    Spectrum depth(f64::Number(0.0));
    for (const int c : parts) depth += optics_.parts[static_cast<std::size_t>(c)].extinction * f64::Length::of(columns.v[c]);
    return depth;
}

Spectrum PathTracer::transmittance_to_top(double altitude, double mu) const {
    if (f64::meets_ground(f64::Length::of(altitude), mu, optics_.bottom_radius)) return Spectrum(f64::Number(0.0));
    return exp(-depth(columns_->to_top(altitude, mu), all_parts_));
}

Spectrum PathTracer::transmittance(double altitude, double mu, double t) const {
    const Columns::Ray ray = columns_->ray(altitude, mu);
    return exp(-depth(columns_->at_distance(ray, std::min(t, ray.length)).column, all_parts_));
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

// The share of collisions with the ground that heroes draw, for a ray that would end there: by what each brings back.
Spectrum PathTracer::ground_share(const Spectrum& air_share) const {
    Spectrum ground;
    for (int i = 0; i < pack_size; ++i) {
        const double reflected = optics_.ground_albedo.v[i] * (1.0 - air_share.v[i]);
        ground.v[i] = reflected / std::max(reflected + air_share.v[i], 1e-300);
    }
    return ground;
}

// Moves the path to its next collision, in the air or with the ground; false if there is none. With a reach, in the air within it.
bool PathTracer::advance(Path& path, std::optional<double> reach, double u, Random& random, Collision& collision) const {
    Leg leg{columns_->ray(path.h, std::clamp(glm::dot(path.up, path.direction), -1.0, 1.0)), {}, {}};
    const Columns::Ray& ray = leg.ray;
    leg.total = reach && *reach < ray.length ? columns_->at_distance(ray, *reach).column : ray.total;
    leg.share = share_absorbed(depth(leg.total, scatterers_));
    collision.ground = false;
    if (ray.ground && !reach) {
        const Spectrum ground = ground_share(leg.share);
        collision.ground = random() < ground.v[path.hero];
        path.density = path.density * (collision.ground ? ground : Spectrum(f64::Number(1.0)) - ground);
    }
    if (collision.ground) {
        path.weight = path.weight * optics_.ground_albedo * exp(-depth(ray.total, all_parts_));
        path.move(ray.length, 0.0, columns_->bottom());
        return true;
    }
    return collide(path, leg, u, random, collision);
}

// Moves the path to a collision with a scatterer of the air, given that there is one; false if there is none.
bool PathTracer::collide(Path& path, const Leg& leg, double u, Random& random, Collision& collision) const {
    const Columns::Ray& ray = leg.ray;
    const Spectrum& share = leg.share;
    const double low_mu_s = f64::sun_cosine_at(f64::Length::of(path.h), glm::dot(path.up, path.sun), glm::dot(path.direction, path.sun),
                                               f64::Length::of(ray.low_t), f64::Length::of(ray.low_h), optics_.bottom_radius)
                                .value;
    const double beta = low_mu_s < low_sun ? aid_share : 0.0;
    Columns::Stop stop;
    if (beta > 0.0 && random() < beta) {
        stop = columns_->at_depth(ray, aid_, u * leg.total.v[aid_index_]);
    } else {
        if (!(share.v[path.hero] > 0.0)) return false;
        stop = columns_->at_depth(ray, hero_[path.hero], -std::log1p(-u * share.v[path.hero]));
    }
    // The density of this stop for each hero: of collisions with scatterers, given that there is one; and the aid's.
    Spectrum coefficient(f64::Number(0.0));
    for (const int c : scatterers_)
        for (int i = 0; i < pack_size; ++i)
            coefficient.v[i] += optics_.parts[static_cast<std::size_t>(c)].extinction.v[i] * stop.density.v[c];
    const Spectrum reached = exp(-depth(stop.column, scatterers_));
    const double aid_density =
        beta > 0.0 && leg.total.v[aid_index_] > 0.0 ? beta * stop.density.v[aid_index_] / leg.total.v[aid_index_] : 0.0;
    for (int i = 0; i < pack_size; ++i)
        path.density.v[i] *= (1.0 - beta) * coefficient.v[i] * reached.v[i] / std::max(share.v[i], 1e-300) + aid_density;
    path.weight = path.weight * exp(-depth(stop.column, all_parts_));
    path.move(stop.t, stop.h, columns_->bottom());
    collision.density = stop.density;
    return drawn_density(path) > 0.0;
}

// The sunlight that the collision turns towards the path's start, without what the path itself carries.
f64::RadianceSpectrum PathTracer::sunlit(const Path& path, const Collision& collision, Random& random) const {
    const double u = sun_.is_point() ? 0.0 : random();
    const Vec3 sun = sun_.is_point() ? path.sun : sun_.draw(path.sun, u, random());
    const f64::IrradianceSpectrum light = sunlight(path.h, path.up, sun, u);
    if (collision.ground) return light * f64::PhaseSpectrum(std::max(0.0, glm::dot(path.up, sun)) / pi * f64::per_sr);
    f64::RadianceSpectrum sum(f64::RadianceSpectrum::Scalar::of(0.0));
    for (const int c : scatterers_) {
        const AirOptics::Part& part = optics_.parts[static_cast<std::size_t>(c)];
        sum += part.scattering * part.phase.at(glm::dot(path.direction, sun)) * light * f64::Length::of(collision.density.v[c]);
    }
    return sum;
}

// Draws the direction in which the path goes on: over the ground by the cosine, in the air by one constituent's phase
// function at the hero's wavelength. What the path carries is multiplied by the true sum over constituents.
void PathTracer::turn(Path& path, const Collision& collision, Random& random) const {
    if (collision.ground) {
        path.direction = turned(path.up, std::sqrt(random()), 2.0 * pi * random());
        return;
    }
    double shares[max_columns];
    double total = 0.0;
    for (const int c : scatterers_)
        shares[c] = total += optics_.parts[static_cast<std::size_t>(c)].scattering.v[path.hero] * collision.density.v[c];
    const double pick = random() * total;
    const int chosen = *std::find_if(scatterers_.begin(), scatterers_.end() - 1, [&](int c) { return pick < shares[c]; });
    const DirectionSampler::Draw draw = samplers_[static_cast<std::size_t>(chosen)].draw(path.hero, random(), random());
    Spectrum light(f64::Number(0.0)), drawn(f64::Number(0.0)), scattering(f64::Number(0.0));
    for (const int c : scatterers_) {
        const AirOptics::Part& part = optics_.parts[static_cast<std::size_t>(c)];
        const f64::PhaseSpectrum phase = part.phase.at(draw.nu);
        const f64::PhaseSpectrum& density = samplers_[static_cast<std::size_t>(c)].density(draw.bin);
        for (int i = 0; i < pack_size; ++i) {
            const double coefficient = part.scattering.v[i] * collision.density.v[c];
            scattering.v[i] += coefficient;
            light.v[i] += coefficient * phase.v[i];
            drawn.v[i] += coefficient * density.v[i];
        }
    }
    for (int i = 0; i < pack_size; ++i) path.density.v[i] *= drawn.v[i] / std::max(scattering.v[i], 1e-300);
    path.weight = path.weight * light;
    path.direction = turned(path.direction, draw.nu, 2.0 * pi * random());
}

// Scales what the path carries to a mean density of one, then plays Russian roulette; false if the path ends.
bool PathTracer::goes_on(Path& path, Random& random) const {
    const double scale = drawn_density(path);
    if (!(scale > 0.0)) return false;
    path.density = path.density / f64::Number(scale);
    path.weight = path.weight / f64::Number(scale);
    const double carried = largest(path.weight);
    if (carried >= roulette_weight) return true;
    if (random() * roulette_weight >= carried) return false;
    path.weight = path.weight * f64::Number(roulette_weight / carried);
    return true;
}

f64::RadianceSpectrum PathTracer::radiance(const Start& start, Orders orders, int hero, double first_u, Random& random) const {
    f64::RadianceSpectrum sum(f64::RadianceSpectrum::Scalar::of(0.0));
    Path path{start.altitude, start.up, start.direction, start.sun, hero, Spectrum(f64::Number(1.0)), Spectrum(f64::Number(1.0))};
    Collision collision;
    for (int order = 1; advance(path, order == 1 ? start.reach : std::nullopt, order == 1 ? first_u : random(), random, collision);
         ++order) {
        if (order >= orders.first) sum += path.weight * f64::Number(1.0 / drawn_density(path)) * sunlit(path, collision, random);
        if (order == orders.last) break;
        turn(path, collision, random);
        if (!goes_on(path, random)) break;
    }
    return sum;
}

}  // namespace airlight
