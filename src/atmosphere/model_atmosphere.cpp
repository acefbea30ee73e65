#include "atmosphere/model_atmosphere.h"

#include <fmt/format.h>

#include <array>
#include <sstream>

namespace airlight {

namespace {

struct Row {
    double altitude_km, pressure_hpa, temperature_k, air_per_cm3, ozone_per_cm3, water_vapour_per_cm3, nitrogen_dioxide_per_cm3;
};
constexpr std::size_t level_count = 50;
constexpr std::size_t model_count = 6;

using Levels = std::array<AirLevel, level_count>;

std::array<Levels, model_count> read_models() {
    static constexpr std::array<std::array<Row, level_count>, model_count> rows = {{
#include "afgl_atmospheres.inc"
    }};
    std::array<Levels, model_count> models;
    for (std::size_t i = 0; i < model_count; ++i)
        for (std::size_t k = 0; k < level_count; ++k) {
            const Row& r = rows[i][k];
            models[i][k] = {r.altitude_km * km,
                            r.pressure_hpa,
                            r.temperature_k,
                            r.air_per_cm3 * per_cm3,
                            r.ozone_per_cm3 * per_cm3,
                            r.water_vapour_per_cm3 * per_cm3,
                            r.nitrogen_dioxide_per_cm3 * per_cm3};
        }
    return models;
}

const std::array<Levels, model_count>& models() {
    static const std::array<Levels, model_count> all = read_models();
    return all;
}

}  // namespace

Result<std::span<const AirLevel>> model_atmosphere(std::string_view name) {
    std::istringstream words{std::string(model_atmosphere_names)};
    std::size_t index = 0;
    for (std::string word; words >> word; ++index)
        if (word == name) return std::span<const AirLevel>(models()[index]);
    const std::string near = nearest_word(name, model_atmosphere_names);
    return Error{"", fmt::format("\"{}\" is no model atmosphere", name),
                 near.empty() ? fmt::format("There are: {}.", model_atmosphere_names) : fmt::format("Did you mean \"{}\"?", near)};
}

NumberDensity density_of(const AirLevel& level, Gas gas) {
    switch (gas) {
        case Gas::air:
            return level.air;
        case Gas::ozone:
            return level.ozone;
        case Gas::water_vapour:
            return level.water_vapour;
        case Gas::nitrogen_dioxide:
            break;
    }
    return level.nitrogen_dioxide;
}

GasProfile gas_profile(std::span<const AirLevel> levels, Gas gas) {
    NumberDensity greatest = 0.0 * per_m3;
    for (const AirLevel& level : levels) greatest = max(greatest, density_of(level, gas));
    std::vector<Curve<Length, Number>::Sample> samples;
    for (const AirLevel& level : levels) samples.push_back({level.altitude, density_of(level, gas) / greatest});
    return {TabulatedProfile{*Curve<Length, Number>::of(std::move(samples))}, greatest};
}

double effective_temperature_k(std::span<const AirLevel> levels, Gas gas) {
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
        const double depth = (levels[k + 1].altitude - levels[k].altitude).in(km);
        const double low = density_of(levels[k], gas).value * depth;
        const double high = density_of(levels[k + 1], gas).value * depth;
        sum += low * levels[k].temperature_k + high * levels[k + 1].temperature_k;
        weights += low + high;
    }
    return sum / weights;
}

}  // namespace airlight
