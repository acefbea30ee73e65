#include "sky/reference_sky.h"

namespace airlight {

ReferenceSky::ReferenceSky(Reference reference, Length bottom_radius, ReferenceSettings settings, Progress progress)
    : reference_(std::move(reference)), bottom_radius_(bottom_radius), settings_(settings), progress_(std::move(progress)) {}

Result<RadianceEstimate> ReferenceSky::radiance(const View& view) const {
    if (const Result<Done> ok = check_view(view.altitude, view.view_zenith, view.sun_zenith, view.relative_azimuth); !ok) return ok.error();
    return reference_.radiance(view, settings_, progress_);
}

Result<IrradianceEstimate> ReferenceSky::irradiance(Length altitude, double sun_zenith) const {
    if (const Result<Done> ok = check_view(altitude, 0.0, sun_zenith, 0.0); !ok) return ok.error();
    return reference_.irradiance(altitude, sun_zenith, settings_, progress_);
}

Result<std::vector<double>> ReferenceSky::transmittance(Length altitude, double view_zenith, Length distance) const {
    if (const Result<Done> ok = check_view(altitude, view_zenith, 0.0, 0.0); !ok) return ok.error();
    return reference_.transmittance(altitude, view_zenith, distance);
}

Result<AerialPerspective> ReferenceSky::aerial_perspective(const View& view, Length distance) const {
    if (const Result<Done> ok = check_view(view.altitude, view.view_zenith, view.sun_zenith, view.relative_azimuth); !ok) return ok.error();
    Result<RadianceEstimate> light = reference_.inscattered(view, distance, settings_, progress_);
    if (!light) return light.error();
    return AerialPerspective{reference_.transmittance(view.altitude, view.view_zenith, distance), std::move(light->radiance_W_m2_sr_nm)};
}

}  // namespace airlight
