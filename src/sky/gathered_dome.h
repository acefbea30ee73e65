// The sky around one eye as a grid of directions. Each holds the light of its ray without phase functions, which is smooth; between
// them it is cubic, and phase functions are put on at the end. Uses sky/dome_rows.h; knows nothing of how light is gathered.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "sky/dome_rows.h"
#include "sky/pack_phases.h"
#include "sky/sky.h"

namespace airlight {

// Where a dome stands.
struct DomeEye {
    Shell shell;
    std::span<const double> jumps_m;  // altitudes where the density of the air jumps
    Length altitude;
    double sun_zenith;

    // Whether the edge of the planet's shadow, in the air or on the ground, may be seen: it is sharp by azimuth.
    bool sees_shadow() const { return sun_zenith > 86.0 * deg || altitude.value > shell.top_m; }
};

class GatheredDome : public SkyDome {
public:
    using Cell = f32::RadianceSpectrum;

    // Gathers the light of the views of a row, whose zenith angles are one: [azimuth][1 + scattering parts], the multiple light first,
    // set to zero before. Called from several threads.
    using Gather = std::function<void(std::size_t pack, std::span<const View> row, std::span<Cell> cells)>;

    // Rows as DomeRows takes them; azimuths over half a turn, at least 4.
    struct Grid {
        int sky_rows, ground_rows, azimuths;
    };
    GatheredDome(const DomeEye& eye, Grid grid, PhasesOfPacks phases, const Gather& gather);

    void radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const override;
    // Fastest where directions of one zenith angle follow each other, as in a row of a picture.
    void radiances(std::span<const Direction> directions, std::span<float> radiance) const override;

    // Puts the light of a ray into the cells of its row.
    template <class Light>
    static void put(const Light& light, const PackPhases& phases, std::size_t azimuth, std::span<Cell> row) {
        Cell* cells = &row[azimuth * (1 + phases.parts().size())];
        cells[0] = light.multiple;
        for (std::size_t i = 0; i < phases.parts().size(); ++i) {
            const auto& single = light.single[phases.parts()[i]];
            std::copy(single.v, single.v + pack_size, cells[1 + i].v);
        }
    }

private:
    Stencil azimuths_at(double relative_azimuth) const;
    std::size_t spectra(std::size_t pack) const { return 1 + phases_[pack]->parts().size(); }
    // Mixes the cells of rows at one azimuth: [spectra].
    void mix_rows(std::size_t pack, const Stencil& rows, std::size_t azimuth, Cell* to) const;
    // In directions of one zenith angle, at least one, within the air's edge.
    void row_radiances(std::span<const Direction> directions, std::span<float> radiance) const;

    DomeRows rows_;
    int azimuths_;
    double sun_zenith_;
    PhasesOfPacks phases_;
    std::vector<std::vector<Cell>> cells_;  // [pack][(row * azimuths + azimuth) * spectra + spectrum]
};

}  // namespace airlight
