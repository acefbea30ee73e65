#include "sky/gathered_dome.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "transport/pack_arithmetic.h"

namespace airlight {

namespace {

using Cell = GatheredDome::Cell;

// The sum of four cells, each `spectra` long, of which one spectrum is taken.
AIRLIGHT_INLINE Cell mixed(const std::array<const Cell*, 4>& from, const std::array<float, 4>& weight, std::size_t spectrum) {
    Cell sum;
    for (int w = 0; w < pack_size; ++w)
        sum.v[w] = weight[0] * from[0][spectrum].v[w] + weight[1] * from[1][spectrum].v[w] + weight[2] * from[2][spectrum].v[w] +
                   weight[3] * from[3][spectrum].v[w];
    return sum;
}

// Radiance of the cells' mixture, never below zero.
AIRLIGHT_INLINE void write_radiance(const PackPhases& phases, const std::array<const Cell*, 4>& from, const std::array<float, 4>& weight,
                                    PackPhases::Place angle, float* radiance) {
    f32::RadianceSpectrum sum = mixed(from, weight, 0);
    for (std::size_t i = 0; i < phases.parts().size(); ++i) {
        const Cell cell = mixed(from, weight, 1 + i);
        f32::IrradianceSpectrum single;
        for (int w = 0; w < pack_size; ++w) single.v[w] = cell.v[w];
        phases.add(angle, i, single, sum);
    }
    for (int w = 0; w < phases.wavelength_count(); ++w) radiance[w] = std::max(sum.v[w], 0.0f);
}

}  // namespace

GatheredDome::GatheredDome(const DomeEye& eye, Grid grid, PhasesOfPacks phases, const Gather& gather)
    : rows_(eye.shell, eye.altitude, eye.jumps_m, grid.sky_rows, grid.ground_rows),
      azimuths_(grid.azimuths),
      sun_zenith_(eye.sun_zenith),
      phases_(std::move(phases)) {
    const auto height = static_cast<std::size_t>(rows_.size()), width = static_cast<std::size_t>(azimuths_);
    for (std::size_t p = 0; p < phases_.size(); ++p) cells_.emplace_back(height * width * spectra(p), zero<Cell>());
    parallel_for(height, [&](std::size_t i) {
        std::vector<View> views;
        const double zenith = rows_.zenith(static_cast<int>(i));
        for (std::size_t j = 0; j < width; ++j)
            views.push_back({eye.altitude, zenith, eye.sun_zenith, pi * static_cast<double>(j) / (azimuths_ - 1)});
        for (std::size_t p = 0; p < phases_.size(); ++p)
            gather(p, views, std::span(cells_[p]).subspan(i * width * spectra(p), width * spectra(p)));
    });
}

AIRLIGHT_INLINE void GatheredDome::mix_rows(std::size_t pack, const Stencil& rows, std::size_t azimuth, Cell* to) const {
    const std::size_t count = spectra(pack);
    std::array<const Cell*, 4> from;
    for (std::size_t k = 0; k < 4; ++k) from[k] = &cells_[pack][(static_cast<std::size_t>(rows.at[k] * azimuths_) + azimuth) * count];
    for (std::size_t k = 0; k < count; ++k) to[k] = mixed(from, rows.weight, k);
}

Stencil GatheredDome::azimuths_at(double relative_azimuth) const {
    return stencil_of(std::abs(std::remainder(relative_azimuth, 2.0 * pi)) / pi, 0, azimuths_, true);
}

void GatheredDome::radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const {
    std::fill(radiance.begin(), radiance.end(), 0.0f);
    if (view_zenith < rows_.edge()) return;
    const Stencil rows = rows_.at(view_zenith), azimuths = azimuths_at(relative_azimuth);
    const PackPhases::Place angle = PackPhases::place(view_sun_cosine({0.0 * m, view_zenith, sun_zenith_, relative_azimuth}));
    float* seen = radiance.data();
    for (std::size_t p = 0; p < phases_.size(); ++p) {
        std::array<std::array<Cell, 1 + max_parts>, 4> around;
        std::array<const Cell*, 4> from;
        for (std::size_t k = 0; k < 4; ++k) {
            mix_rows(p, rows, static_cast<std::size_t>(azimuths.at[k]), around[k].data());
            from[k] = around[k].data();
        }
        write_radiance(*phases_[p], from, azimuths.weight, angle, seen);
        seen += phases_[p]->wavelength_count();
    }
}

void GatheredDome::row_radiances(std::span<const Direction> directions, std::span<float> radiance) const {
    const double zenith = directions[0].view_zenith, mu = std::cos(zenith), mu_s = std::cos(sun_zenith_),
                 sines = std::sin(zenith) * std::sin(sun_zenith_);
    const Stencil rows = rows_.at(zenith);
    std::size_t first = 0;  // wavelength of the pack
    const std::size_t count = radiance.size() / directions.size();
    std::vector<Cell> strip;
    for (std::size_t p = 0; p < phases_.size(); ++p) {
        strip.resize(static_cast<std::size_t>(azimuths_) * spectra(p));
        for (std::size_t j = 0; j < static_cast<std::size_t>(azimuths_); ++j) mix_rows(p, rows, j, &strip[j * spectra(p)]);
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const Stencil azimuths = azimuths_at(directions[i].relative_azimuth);
            std::array<const Cell*, 4> from;
            for (std::size_t k = 0; k < 4; ++k) from[k] = &strip[static_cast<std::size_t>(azimuths.at[k]) * spectra(p)];
            const PackPhases::Place angle = PackPhases::place(mu * mu_s + sines * std::cos(directions[i].relative_azimuth));
            write_radiance(*phases_[p], from, azimuths.weight, angle, &radiance[i * count + first]);
        }
        first += static_cast<std::size_t>(phases_[p]->wavelength_count());
    }
}

void GatheredDome::radiances(std::span<const Direction> directions, std::span<float> radiance_of) const {
    constexpr std::size_t worth_a_row = 8;
    const std::size_t count = directions.empty() ? 0 : radiance_of.size() / directions.size();
    for (std::size_t first = 0, last = 0; first < directions.size(); first = last) {
        const double zenith = directions[first].view_zenith;
        while (last < directions.size() && directions[last].view_zenith == zenith) ++last;
        const std::span<float> seen = radiance_of.subspan(first * count, (last - first) * count);
        if (last - first >= worth_a_row && zenith >= rows_.edge()) row_radiances(directions.subspan(first, last - first), seen);
        else
            for (std::size_t i = first; i < last; ++i)
                radiance(zenith, directions[i].relative_azimuth, seen.subspan((i - first) * count, count));
    }
}

}  // namespace airlight
