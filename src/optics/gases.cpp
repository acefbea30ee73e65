#include "optics/gases.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace airlight {

namespace {

template <std::size_t T>
struct Row {
    double wavelength_nm;
    double cross_section_m2[T];
};

constexpr std::array ozone_temperatures_k{203.0, 223.0, 243.0, 273.0, 293.0};
constexpr Row<5> ozone_rows[] = {
#include "ozone_cross_section.inc"
};

constexpr std::array nitrogen_dioxide_temperatures_k{223.0, 273.0, 293.0};
constexpr Row<3> nitrogen_dioxide_rows[] = {
#include "nitrogen_dioxide_cross_section.inc"
};

// The table at one temperature: linear between two columns, the nearest column beyond them.
template <std::size_t T, std::size_t N>
SpectrumOf<Area> at_temperature(const Row<T> (&rows)[N], const std::array<double, T>& temperatures_k, double temperature_k) {
    const double clamped = std::clamp(temperature_k, temperatures_k.front(), temperatures_k.back());
    const auto above = std::upper_bound(temperatures_k.begin() + 1, temperatures_k.end() - 1, clamped);
    const std::size_t i = static_cast<std::size_t>(above - temperatures_k.begin()) - 1;
    const double t = (clamped - temperatures_k[i]) / (temperatures_k[i + 1] - temperatures_k[i]);
    std::vector<SpectrumOf<Area>::Sample> samples;
    for (const Row<T>& row : rows)
        samples.push_back({row.wavelength_nm * nm, (row.cross_section_m2[i] * (1.0 - t) + row.cross_section_m2[i + 1] * t) * m2});
    return *SpectrumOf<Area>::of(std::move(samples));
}

}  // namespace

SpectrumOf<Area> ozone_cross_section(double temperature_k) { return at_temperature(ozone_rows, ozone_temperatures_k, temperature_k); }

SpectrumOf<Area> nitrogen_dioxide_cross_section(double temperature_k) {
    return at_temperature(nitrogen_dioxide_rows, nitrogen_dioxide_temperatures_k, temperature_k);
}

}  // namespace airlight
