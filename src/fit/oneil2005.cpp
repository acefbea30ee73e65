#include "fit/oneil2005.h"

#include "models/scale_function_fit.h"
#include "models/two_constituents.h"

namespace airlight {

ONeilFit fit_oneil2005(const Atmosphere& atmosphere) {
    const Wavelength any = 550.0 * nm;  // lengths do not depend on it
    const f64::ExponentialAir air = two_constituents(atmosphere, {&any, 1}).air;
    ONeilFit fit{{air.bottom.value, {}, {}}, {}};
    const auto add = [&](ONeilScale& scale, f64::Length height, const char* condition) {
        const ScaleFunctionFit found = fit_scale_function(air.bottom.value * m, air.top.value * m, height.value * m);
        scale = {height.value, found.coefficients};
        fit.residuals.push_back({condition, found.mean_residual});
    };
    add(fit.data.air, air.air_scale_height, "optical length, air");
    add(fit.data.aerosol, air.aerosol_scale_height, "optical length, aerosol");
    return fit;
}

}  // namespace airlight
