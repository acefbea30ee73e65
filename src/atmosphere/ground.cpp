#include "atmosphere/ground.h"

#include <fmt/format.h>

namespace airlight {

namespace {

struct Material {
    std::string_view name;
    double visible, near_infrared;
};

// Cover types "short grass", "deciduous broadleaf tree", "desert" and "ocean"; dry soil of colour 4; snow new (0.95, 0.65) and
// at the end of its ageing (0.8 and 0.5 times that). The sea's near infrared is that of a flat surface, 0.06 like its visible [Briegleb1986].
constexpr Material materials[] = {
    {"grass", 0.10, 0.30}, {"forest", 0.08, 0.28}, {"soil", 0.18, 0.36},      {"sand", 0.20, 0.40},
    {"sea", 0.06, 0.06},   {"snow", 0.95, 0.65},   {"old_snow", 0.76, 0.325},
};

}  // namespace

Result<SpectrumOf<Number>> ground_material(std::string_view name) {
    for (const Material& material : materials)
        if (material.name == name)
            return *SpectrumOf<Number>::of({{300.0 * nm, material.visible},
                                            {690.0 * nm, material.visible},
                                            {710.0 * nm, material.near_infrared},
                                            {1000.0 * nm, material.near_infrared}});
    const std::string near = nearest_word(name, ground_material_names);
    return Error{"", fmt::format("\"{}\" is no ground", name),
                 near.empty() ? fmt::format("There are: {}.", ground_material_names) : fmt::format("Did you mean \"{}\"?", near)};
}

}  // namespace airlight
