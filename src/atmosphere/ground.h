// Albedos of common grounds, for those who have no measured spectrum.
// Table: [Dickinson1986, tables 2 and 3]. Uses units; knows nothing of files.
#pragma once

#include <string_view>

#include "core/result.h"
#include "units/curve.h"

namespace airlight {

inline constexpr std::string_view ground_material_names = "grass forest soil sand sea snow old_snow";

// Albedo of a material from 300 to 1000 nm: one value for light that plants use, one for the near infrared, and a straight
// step from 690 to 710 nm. Fails if there is no such material, naming those that there are.
Result<SpectrumOf<Number>> ground_material(std::string_view name);

}  // namespace airlight
