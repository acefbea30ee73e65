#include "transport/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

#include "atmosphere/validate.h"
#include "core/parallel.h"
#include "transport/reference_path.h"

namespace airlight {

namespace {

// Paths come in groups: within one, heroes and first collisions are spread evenly (stratified), so the paths of a group
// depend on each other but groups do not. The standard error is that of independent groups.
constexpr int group_size = 64;

// One path of a group: its estimate at every wavelength.
using TracePath = std::function<f64::Spectrum(int hero, double first_u, Random& random)>;

struct Estimate {
    f64::Spectrum mean;
    f64::Spectrum standard_error;
};

f64::Spectrum group_mean(const TracePath& trace, int heroes, std::uint64_t seed, std::uint64_t group) {
    Random random(seed, group);
    const double shift = random();
    const int first_hero = static_cast<int>(random() * heroes);
    f64::Spectrum sum(f64::Number(0.0));
    for (int i = 0; i < group_size; ++i) {
        // Each first_u alone is uniform; together they fill [0, 1) evenly.
        const double u = (i + random()) / group_size + shift;
        sum += trace((first_hero + i) % heroes, u - std::floor(u), random);
    }
    return sum / f64::Number(group_size);
}

Estimate statistics(const std::vector<f64::Spectrum>& groups) {
    const f64::Number count = static_cast<double>(groups.size());
    Estimate result{f64::Spectrum(f64::Number(0.0)), f64::Spectrum(f64::Number(0.0))};
    for (const f64::Spectrum& g : groups) result.mean += g / count;
    for (const f64::Spectrum& g : groups) {
        const f64::Spectrum d = g - result.mean;
        result.standard_error += d * d;
    }
    for (double& x : result.standard_error.v) x = std::sqrt(x / (count.value * (count.value - 1.0)));
    return result;
}

Result<Estimate> estimate(const TracePath& trace, int heroes, const ReferenceSettings& settings, const Progress& progress, double done,
                          double share) {
    const std::size_t groups = static_cast<std::size_t>(std::max<std::int64_t>(2, (settings.paths + group_size - 1) / group_size));
    constexpr std::size_t batch = 32;  // groups between two looks at the stop request
    std::vector<f64::Spectrum> means(groups);
    std::atomic<std::size_t> finished = 0;
    parallel_for((groups + batch - 1) / batch, [&](std::size_t b) {
        if (progress.stop.stop_requested()) return;
        const std::size_t end = std::min(groups, (b + 1) * batch);
        for (std::size_t g = b * batch; g < end; ++g) means[g] = group_mean(trace, heroes, settings.seed, g);
        const std::size_t before = finished.fetch_add(end - b * batch);
        if (before * 50 / groups != (before + end - b * batch) * 50 / groups)
            progress.report("tracing paths", done + share * static_cast<double>(before) / static_cast<double>(groups));
    });
    if (progress.stop.stop_requested()) return Error{"", "stopped before all paths were traced", ""};
    return statistics(means);
}

Result<Done> check(const ReferenceSettings& settings) {
    if (settings.paths < 1) return Error{"", fmt::format("{} paths: there must be at least 1", settings.paths), ""};
    if (settings.first_order < 1 || settings.last_order < settings.first_order)
        return Error{"",
                     fmt::format("orders {} to {}: the first must be at least 1 and the last not below it", settings.first_order,
                                 settings.last_order),
                     ""};
    return Done{};
}

// Where paths start for an eye that may lie outside the air, unless its ray misses the air.
struct Entry {
    PathTracer::Start start;
    bool misses;
};
Entry entry(double altitude, Vec3 up, const Vec3& direction, const Vec3& sun, const Columns& columns) {
    const double bottom = columns.bottom(), top = columns.top();
    if (altitude > top) {
        const double mu = glm::dot(up, direction);
        const double r = bottom + altitude;
        const double across = r * std::sqrt(std::max(0.0, (1.0 - mu) * (1.0 + mu)));
        if (mu >= 0.0 || across >= bottom + top) return {{}, true};
        // Distance to the sphere of the top, from outside.
        const double k = (altitude - top) * (2.0 * bottom + top + altitude);
        const double t = k / (std::sqrt(r * mu * r * mu - k) - r * mu);
        up = glm::normalize(r * up + t * direction);
        altitude = top;
    }
    return {{altitude, up, direction, sun, {}}, false};
}

bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Vec3 from_angles(double zenith, double azimuth) {
    return {std::sin(zenith) * std::cos(azimuth), std::sin(zenith) * std::sin(azimuth), std::cos(zenith)};
}

using Packs = std::vector<std::shared_ptr<const PathTracer>>;

// Of paths from a start; zeros if they would miss the air.
Result<RadianceEstimate> radiance_from(const Entry& begin, const ReferenceSettings& settings, const Progress& progress,
                                       const Packs& packs) {
    RadianceEstimate result;
    for (std::size_t p = 0; p < packs.size(); ++p) {
        const int count = packs[p]->optics().wavelength_count;
        Estimate found{f64::Spectrum(f64::Number(0.0)), f64::Spectrum(f64::Number(0.0))};
        if (!begin.misses) {
            const TracePath trace = [&](int hero, double u, Random& random) {
                return packs[p]->radiance(begin.start, {settings.first_order, settings.last_order}, hero, u, random) /
                       f64::RadianceSpectrum::Scalar::of(1.0);
            };
            const Result<Estimate> traced =
                estimate(trace, packs[p]->heroes(), settings, progress, static_cast<double>(p) / static_cast<double>(packs.size()),
                         1.0 / static_cast<double>(packs.size()));
            if (!traced) return traced.error();
            found = *traced;
        }
        result.radiance_W_m2_sr_nm.insert(result.radiance_W_m2_sr_nm.end(), found.mean.v, found.mean.v + count);
        result.standard_error.insert(result.standard_error.end(), found.standard_error.v, found.standard_error.v + count);
    }
    return result;
}

Result<RadianceEstimate> radiance_at(double altitude, const Vec3& up, const Vec3& direction, const Vec3& sun,
                                     const ReferenceSettings& settings, const Progress& progress, const Packs& packs) {
    if (Result<Done> checked = check(settings); !checked) return checked.error();
    if (!finite(up) || !finite(direction) || !finite(sun) || !std::isfinite(altitude))
        return Error{"", "an eye, a view or a sun that is not finite", ""};
    if (altitude < 0.0) return Error{"", fmt::format("the eye is {} m below the ground", -altitude), "Give an altitude of 0 m or more."};
    return radiance_from(entry(altitude, up, direction, sun, packs.front()->columns()), settings, progress, packs);
}

}  // namespace

Result<Reference> Reference::of(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths) {
    if (wavelengths.empty()) return Error{"", "no wavelength is given", ""};
    if (atmosphere.constituents.size() >= max_columns)
        return Error{"", fmt::format("{} constituents: at most {} can be traced", atmosphere.constituents.size(), max_columns - 1),
                     "Combine constituents that share a density profile."};
    const auto [first, last] = std::minmax_element(wavelengths.begin(), wavelengths.end());
    if (const Result<Done> covered = covers(atmosphere, *first, *last); !covered) return covered.error();
    Reference reference;
    const auto densities = path_densities(atmosphere);
    reference.columns_ = std::make_shared<const Columns>(densities, f64::Length::of(atmosphere.bottom_radius.value),
                                                         f64::Length::of(atmosphere.top_altitude.value));
    for (const std::vector<Wavelength>& pack : packs(wavelengths))
        reference.packs_.push_back(std::make_shared<const PathTracer>(air_optics(atmosphere, pack), reference.columns_));
    reference.wavelengths_ = std::move(wavelengths);
    return reference;
}

Result<RadianceEstimate> Reference::radiance(const View& view, const ReferenceSettings& settings, const Progress& progress) const {
    return radiance_at(view.altitude.value, {0.0, 0.0, 1.0}, from_angles(view.view_zenith, 0.0),
                       from_angles(view.sun_zenith, view.relative_azimuth), settings, progress, packs_);
}

Result<RadianceEstimate> Reference::radiance(const Vec3& eye, const Vec3& view, const Vec3& sun, const ReferenceSettings& settings,
                                             const Progress& progress) const {
    const double r = glm::length(eye);
    return radiance_at(r - columns_->bottom(), eye / r, glm::normalize(view), glm::normalize(sun), settings, progress, packs_);
}

Result<RadianceEstimate> Reference::inscattered(const View& view, Length distance, const ReferenceSettings& settings,
                                                const Progress& progress) const {
    if (Result<Done> checked = check(settings); !checked) return checked.error();
    const double altitude = view.altitude.value;
    if (!(altitude >= 0.0 && altitude <= columns_->top()))
        return Error{"", fmt::format("an eye at {} m lies outside the air", altitude), ""};
    if (!std::isfinite(view.view_zenith) || !std::isfinite(view.sun_zenith) || !std::isfinite(view.relative_azimuth))
        return Error{"", "a view or a sun that is not finite", ""};
    if (!(distance > 0.0 * m)) return Error{"", fmt::format("a distance of {} m: it must be above 0", distance.value), ""};
    const PathTracer::Start start{
        altitude, {0.0, 0.0, 1.0}, from_angles(view.view_zenith, 0.0), from_angles(view.sun_zenith, view.relative_azimuth), distance.value};
    return radiance_from({start, false}, settings, progress, packs_);
}

Result<IrradianceEstimate> Reference::irradiance(Length altitude, double sun_zenith, const ReferenceSettings& settings,
                                                 const Progress& progress) const {
    if (Result<Done> checked = check(settings); !checked) return checked.error();
    if (!(altitude.value >= 0.0 && altitude.value <= columns_->top()))
        return Error{"", fmt::format("an altitude of {} m lies outside the air", altitude.value), ""};
    if (!std::isfinite(sun_zenith)) return Error{"", "a sun zenith angle that is not finite", ""};
    const Vec3 up(0.0, 0.0, 1.0);
    const Vec3 sun = from_angles(sun_zenith, 0.0);
    IrradianceEstimate result;
    for (const auto& pack : packs_) {
        const int count = pack->optics().wavelength_count;
        const TracePath trace = [&](int hero, double u, Random& random) {
            // Directions in proportion to their cosine: pi times the mean radiance is the irradiance.
            const Vec3 direction = turned(up, std::sqrt(random()), 2.0 * pi * random());
            return pack->radiance({altitude.value, up, direction, sun, {}}, {settings.first_order, settings.last_order}, hero, u, random) *
                   f64::Number(pi) / f64::RadianceSpectrum::Scalar::of(1.0);
        };
        const Result<Estimate> traced = estimate(trace, pack->heroes(), settings, progress, 0.0, 1.0);
        if (!traced) return traced.error();
        const f64::IrradianceSpectrum direct = pack->direct_irradiance(altitude.value, sun_zenith);
        result.direct_W_m2_nm.insert(result.direct_W_m2_nm.end(), direct.v, direct.v + count);
        result.diffuse_W_m2_nm.insert(result.diffuse_W_m2_nm.end(), traced->mean.v, traced->mean.v + count);
        result.standard_error.insert(result.standard_error.end(), traced->standard_error.v, traced->standard_error.v + count);
    }
    return result;
}

std::vector<double> Reference::transmittance(Length altitude, double view_zenith, Length distance) const {
    std::vector<double> result;
    for (const auto& pack : packs_) {
        const f64::Spectrum t = pack->transmittance(altitude.value, std::cos(view_zenith), distance.value);
        result.insert(result.end(), t.v, t.v + pack->optics().wavelength_count);
    }
    return result;
}

}  // namespace airlight
