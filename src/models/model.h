// A published model of the sky: what it is, what it can answer, and how it is made for an atmosphere.
// Each model is one file of this folder, whose head is its manual page. docs/decisions/0005-models.md.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/bruneton2008.h"
#include "sky/sky.h"
#include "transport/table_cache.h"

namespace airlight {

// From the ground to space.
inline constexpr Length anywhere = 1e15 * m;

// A row of the survey's table [Lopes2015, table 1], and the range that the model answers for.
struct ModelCard {
    std::string_view key;
    std::string_view paper;       // its key in docs/references.bib; empty for our own
    std::string_view scattering;  // which orders
    std::string_view approach;
    std::string_view precomputation;  // what is computed before the first answer
    std::string_view memory;          // of that
    Length highest_eye = 0.0 * m;     // 0: on the ground alone
    double highest_sun_zenith_deg = 180.0;
    double highest_view_zenith_deg = 180.0;
    bool aerial_perspective = false;
    Length lowest_eye = 0.0 * m;    // of a sky from a file that was fitted for one altitude
    std::string_view refused = {};  // which views within these ranges it does not answer either; empty: none
};

// What a user may say beside the atmosphere. A model takes what concerns it.
struct ModelOptions {
    std::optional<double> turbidity = {};  // instead of the atmosphere's own
    std::filesystem::path data = {};       // a published data set, or a fit
    int cie_type = 12;                     // cie2003: 1 to 15
    std::optional<double> clearness = {};  // perez1993: instead of the atmosphere's own
    std::optional<double> brightness = {};
    std::string variant = {};  // of a model that its paper has in several forms; empty is its first
    BakeSettings bake = {};
    CacheSettings cache = {};
    ReferenceSettings reference = {};
    Bruneton2008Settings bruneton2008 = {};
    Progress progress = {};
};

struct Model {
    ModelCard card;
    Result<std::unique_ptr<Sky>> (*make)(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options);
};

// All models, in the order of their years; the reference and the tables first.
std::span<const Model> models();

// None if no model has the key.
const Model* find_model(std::string_view key);

// The sky of a model. Fails if no model has the key, the wavelengths are outside of the atmosphere's data, or the model
// cannot do this atmosphere.
Result<std::unique_ptr<Sky>> make_sky(std::string_view key, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths,
                                      const ModelOptions& options = {});

// What published models have in common: an atmosphere they are for, and ranges beyond which they do not answer.
class PublishedSky : public Sky {
public:
    PublishedSky(const ModelCard& card, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths);

    std::string name() const override { return std::string(card_.key); }
    std::span<const Wavelength> wavelengths() const override { return wavelengths_; }

    // Checks the ranges and answerable(), then asks sky_radiance(), which answers [N].
    Result<RadianceEstimate> radiance(const View& view) const final;

    // The diffuse part is radiance() summed over the hemisphere, the direct part that of transmittance(); a model without
    // transmittance has no direct part, and says so by the error of transmittance().
    Result<IrradianceEstimate> irradiance(Length altitude, double sun_zenith) const override;

    // By default an error: the model has none.
    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override;

protected:
    // Of a view within the ranges.
    virtual std::vector<double> sky_radiance(const View& view) const = 0;

    // Of a view within the ranges: the error if the model cannot answer it all the same. By default it can.
    virtual Result<Done> answerable(const View& view) const;

    // The error for a view outside of the ranges; it names the range.
    Result<Done> within_range(const View& view) const;

    Length bottom_radius() const override { return atmosphere_.bottom_radius; }
    const Atmosphere& atmosphere() const { return atmosphere_; }
    std::span<const double> solar_irradiance_W_m2_nm() const { return solar_irradiance_; }

private:
    ModelCard card_;
    Atmosphere atmosphere_;
    std::vector<Wavelength> wavelengths_;
    std::vector<double> solar_irradiance_;  // above the air, [N]
};

}  // namespace airlight
