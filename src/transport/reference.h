// The truth: radiance by Monte Carlo in double precision, on spherical shells, all orders of scattering.
// Theory: docs/theory.md, section 4. Uses paths; knows nothing of tables and images.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "atmosphere/atmosphere.h"
#include "core/progress.h"
#include "core/result.h"
#include "units/vector.h"

namespace airlight {

class PathTracer;
class Columns;

// An eye and its direction, without the digits that positions on large planets lose. Angles in radians.
struct View {
    Length altitude = 0.0 * m;      // of the eye above the ground, >= 0; may lie outside the air
    double view_zenith = 0.0;       // 0 looks straight up, pi straight down
    double sun_zenith = 0.0;        // 0 to pi, at the eye
    double relative_azimuth = 0.0;  // 0 looks towards the sun's vertical plane
};

struct ReferenceSettings {
    std::int64_t paths = 16384;  // rounded up to a multiple of 64, at least 128; the cost is linear in it
    std::uint64_t seed = 1;
    int first_order = 1;         // only light scattered, or reflected by the ground, at least this often counts,
    int last_order = 1'000'000;  // and at most this often
};

// Means over the paths and the standard errors of these means, one for each wavelength.
struct RadianceEstimate {
    std::vector<double> radiance_W_m2_sr_nm;
    std::vector<double> standard_error;
};
struct IrradianceEstimate {
    std::vector<double> direct_W_m2_nm;   // from the sun's disk
    std::vector<double> diffuse_W_m2_nm;  // from the rest of the sky
    std::vector<double> standard_error;   // of the diffuse part
};

class Reference {
public:
    // Fails if there is no wavelength, the description has no data at one, or the air has more than eleven constituents.
    static Result<Reference> of(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths);

    // Radiance that reaches the eye from its direction, all orders of scattering; the sun's disk itself is not in it.
    // The same seed gives the same bits on any number of threads. A direction that misses the air gives zeros.
    // Fails if the eye is below the ground, an angle is not finite, or it is told to stop.
    Result<RadianceEstimate> radiance(const View& view, const ReferenceSettings& settings, const Progress& progress = {}) const;
    // The same by vectors; `eye` is in metres from the planet's centre, `view` and `sun` are unit vectors.
    Result<RadianceEstimate> radiance(const Vec3& eye, const Vec3& view, const Vec3& sun, const ReferenceSettings& settings,
                                      const Progress& progress = {}) const;

    // The part of that radiance that the air within a distance of the eye turns towards it: what aerial perspective adds to the light
    // of a point there. The ground's own light is not in it. Fails if the eye lies outside the air.
    Result<RadianceEstimate> inscattered(const View& view, Length distance, const ReferenceSettings& settings,
                                         const Progress& progress = {}) const;

    // What falls on a level plane at an altitude from above: 0 <= altitude <= top.
    Result<IrradianceEstimate> irradiance(Length altitude, double sun_zenith, const ReferenceSettings& settings,
                                          const Progress& progress = {}) const;

    // Transmittance over a distance along a ray from an altitude in the air; the leg ends at the ground or the top if these come first.
    std::vector<double> transmittance(Length altitude, double view_zenith, Length distance) const;

    const std::vector<Wavelength>& wavelengths() const { return wavelengths_; }

private:
    Reference() = default;

    std::vector<Wavelength> wavelengths_;
    std::vector<std::shared_ptr<const PathTracer>> packs_;
    std::shared_ptr<const Columns> columns_;
};

}  // namespace airlight
