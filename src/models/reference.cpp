// reference: the truth, by Monte Carlo on spherical shells (transport/reference.h).
//   parameters   paths in each direction, seed
//   leaves out   polarisation, refraction; aerial perspective for an eye in space
#include "models/list.h"
#include "sky/reference_sky.h"

namespace airlight {

namespace {

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    Result<Reference> reference = Reference::of(atmosphere, std::move(wavelengths));
    if (!reference) return reference.error();
    return std::unique_ptr<Sky>(
        std::make_unique<ReferenceSky>(std::move(*reference), atmosphere.bottom_radius, options.reference, options.progress));
}

}  // namespace

Model reference_model() {
    return {{.key = "reference",
             .paper = "",
             .scattering = "all orders",
             .approach = "Monte Carlo on spherical shells, double precision, with standard errors",
             .precomputation = "none",
             .memory = "below 1 MiB",
             .highest_eye = anywhere,
             .aerial_perspective = true},
            make};
}

}  // namespace airlight
