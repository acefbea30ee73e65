// The Monte Carlo path: light followed backwards from the eye, sixteen wavelengths at a time.
// Theory: docs/theory.md, section 4. Uses columns and samplers; knows nothing of threads, seeds and statistics.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "transport/columns.h"
#include "transport/reference_sampling.h"

namespace airlight {

// An atmosphere at one pack of wavelengths, ready to be traced.
class PathTracer {
public:
    PathTracer(AirOptics optics, std::shared_ptr<const Columns> columns);

    // A point in or below the top of the air, a direction, and where the sun is.
    struct Start {
        double altitude;  // m, 0 <= altitude <= top
        Vec3 up;          // unit vectors
        Vec3 direction;
        Vec3 sun;  // towards the centre of its disk
        // If said, only light that is turned towards the start by the air within this distance counts, and none from the ground there.
        std::optional<double> reach = {};  // m, > 0
    };
    struct Orders {
        int first;  // only light scattered (or reflected by the ground) at least so often is counted, >= 1,
        int last;   // and at most so often
    };

    // One estimate of the radiance that comes from `direction`, without direct sunlight.
    //   hero       wavelength, 0 to heroes() - 1, that draws the path; unbiased if each is as likely
    //   first_u    uniform in [0, 1): where the first collision lies; callers may stratify it
    f64::RadianceSpectrum radiance(const Start& start, Orders orders, int hero, double first_u, Random& random) const;

    int heroes() const { return optics_.wavelength_count; }

    // Transmittance from a point to the top along a direction; zero where the ground is in the way.
    f64::Spectrum transmittance_to_top(double altitude, double mu) const;
    // Transmittance of the leg of length t along a ray; the leg must stay above the ground and below the top.
    f64::Spectrum transmittance(double altitude, double mu, double t) const;

    // The sun's light on a level plane, at an altitude in the air.
    f64::IrradianceSpectrum direct_irradiance(double altitude, double sun_zenith) const;

    const AirOptics& optics() const { return optics_; }
    const Columns& columns() const { return *columns_; }

private:
    struct Path;
    struct Collision;

    double drawn_density(const Path& path) const;
    f64::Spectrum depth(const ColumnSet& columns, const std::vector<int>& parts) const;
    f64::Spectrum ground_share(const f64::Spectrum& air_share) const;
    f64::IrradianceSpectrum sunlight(double altitude, const Vec3& up, const Vec3& direction, double u) const;
    struct Leg;
    bool advance(Path& path, std::optional<double> reach, double u, Random& random, Collision& collision) const;
    bool collide(Path& path, const Leg& leg, double u, Random& random, Collision& collision) const;
    f64::RadianceSpectrum sunlit(const Path& path, const Collision& collision, Random& random) const;
    void turn(Path& path, const Collision& collision, Random& random) const;
    bool goes_on(Path& path, Random& random) const;

    AirOptics optics_;
    std::shared_ptr<const Columns> columns_;
    SunSampler sun_;
    std::vector<DirectionSampler> samplers_;  // [part]; of parts that do not scatter, never used
    std::vector<int> all_parts_;              // indices of parts,
    std::vector<int> scatterers_;             // and of those that scatter
    ColumnSet hero_[pack_size];               // extinction of scatterers, per wavelength: what distances are drawn by
    f64::Spectrum hero_share_;                // 1 / heroes() for heroes, else 0
    ColumnSet aid_;                           // the same for the aid density alone
    int aid_index_;
};

// The densities of a description's constituents, then the aid density: a broad one by which some distances are drawn when
// the sun is low, so that the lit air high above a dark ground is found.
std::vector<DensityProfile> path_densities(const Atmosphere& atmosphere);

}  // namespace airlight
