#include "image/adaptation.h"

#include <cassert>
#include <cmath>

namespace airlight {

double covered_share(double seconds, double time_constant_s) {
    assert(seconds >= 0.0 && time_constant_s > 0.0);
    return -std::expm1(-seconds / time_constant_s);
}

double adapted_exposure(double exposure, double metered, double seconds, const Adaptation& adaptation) {
    assert(exposure > 0.0 && metered > 0.0);
    const double constant_s = metered < exposure ? adaptation.to_brighter_s : adaptation.to_darker_s;
    return exposure * std::pow(metered / exposure, covered_share(seconds, constant_s));
}

}  // namespace airlight
