#include "models/luminance_sky.h"

#include <algorithm>
#include <cmath>

#include "core/quadrature.h"
#include "models/direction_batch.h"

namespace airlight {

namespace {

// One sun: the formula, and what it is multiplied by at each wavelength.
class LuminanceDome : public SkyDome {
public:
    LuminanceDome(const LuminanceFormula& formula, double sun_zenith, const std::vector<double>& scale)
        : cie_(formula.cie), sun_(sun_zenith), scale_(scale.begin(), scale.end()) {
        k_ = {formula.k.a.value, formula.k.b.value, formula.k.c.value, formula.k.d.value, formula.k.e.value};
    }

    void radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const override {
        const Direction direction{view_zenith, relative_azimuth};
        radiances({&direction, 1}, radiance);
    }

    void radiances(std::span<const Direction> directions, std::span<float> radiance) const override {
        DirectionBatch d;
        float seen[DirectionBatch::size];
        for_each_batch(directions, [&](std::size_t first, std::span<const Direction> asked) {
            d.fill(asked, sun_);
            luminances(d, {seen, asked.size()});
            float* out = &radiance[first * scale_.size()];
            for (std::size_t i = 0; i < asked.size(); ++i) {
                const float luminance = below_horizon(asked[i]) || seen[i] < 0.0f ? 0.0f : seen[i];
                for (std::size_t w = 0; w < scale_.size(); ++w) out[i * scale_.size() + w] = luminance * scale_[w];
            }
        });
    }

private:
    void luminances(const DirectionBatch& d, std::span<float> seen) const {
        using batch::Number;
        const batch::PerezCoefficients k = k_;
        if (cie_)
            for (std::size_t i = 0; i < seen.size(); ++i)
                seen[i] = batch::cie2003(k, Number::of(d.mu[i]), Number::of(d.nu[i]), Number::of(d.gamma[i])).value;
        else
            for (std::size_t i = 0; i < seen.size(); ++i)
                seen[i] = batch::perez(k, Number::of(d.mu[i]), Number::of(d.nu[i]), Number::of(d.gamma[i])).value;
    }

    bool cie_;
    BatchSun sun_;
    batch::PerezCoefficients k_;
    std::vector<float> scale_;
};

}  // namespace

double relative_luminance(const LuminanceFormula& formula, double mu, double nu) {
    const f64::Number gamma = f64::angle_of_cosine(nu);
    const double seen = formula.cie ? f64::cie2003(formula.k, mu, nu, gamma).value : f64::perez(formula.k, mu, nu, gamma).value;
    return std::max(0.0, seen);
}

double relative_illuminance(const LuminanceFormula& formula, double sun_zenith) {
    // As PublishedSky::irradiance() sums: the square of the cosine makes the weight even.
    constexpr int azimuths = 32;
    static const GaussRule rule = gauss_rule(32, 0.0, 1.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (int j = 0; j < azimuths; ++j) {
            const View view{0.0 * m, std::acos(std::sqrt(rule.nodes[i])), sun_zenith, (j + 0.5) * pi / azimuths};
            sum += relative_luminance(formula, std::sqrt(rule.nodes[i]), view_sun_cosine(view)) * rule.weights[i] * pi / azimuths;
        }
    return sum;
}

Result<std::shared_ptr<const TableSky>> LuminanceSky::ground_light(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths,
                                                                   const ModelOptions& options) {
    // Diffuse illuminance within 1.8 % of that of tables with 120 times the texels of source, for suns to 88 degrees above clear air.
    BakeSettings settings;
    settings.sizes = {.transmittance_mu = 64, .transmittance_altitude = 32, .sun = 24, .azimuth = 4, .view = 6, .altitude = 4};
    settings.orders = 3;
    Result<Tables> tables = bake_tables(atmosphere, std::move(wavelengths), settings, options.progress);
    if (!tables) return tables.error();
    return std::shared_ptr<const TableSky>(std::make_shared<TableSky>(std::make_shared<const Tables>(std::move(*tables))));
}

LuminanceSky::LuminanceSky(const ModelCard& card, const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths,
                           std::shared_ptr<const TableSky> ground)
    : PublishedSky(card, atmosphere, std::move(wavelengths)), ground_(std::move(ground)) {}

Result<IrradianceEstimate> LuminanceSky::irradiance(Length altitude, double sun_zenith) const {
    if (const Result<Done> ok = within_range({altitude, 0.0, sun_zenith, 0.0}); !ok) return ok.error();
    return ground_->irradiance(altitude, sun_zenith);
}

Result<std::vector<double>> LuminanceSky::transmittance(Length altitude, double view_zenith, Length distance) const {
    if (const Result<Done> ok = within_range({altitude, view_zenith, 0.0, 0.0}); !ok) return ok.error();
    return ground_->transmittance(altitude, view_zenith, distance);
}

Result<std::unique_ptr<SkyDome>> LuminanceSky::dome(Length altitude, double sun_zenith) const {
    const Result<IrradianceEstimate> light = irradiance(altitude, sun_zenith);
    if (!light) return light.error();
    const LuminanceFormula of_sun = formula(sun_zenith);
    const double sum = relative_illuminance(of_sun, sun_zenith);
    std::vector<double> scale = light->diffuse_W_m2_nm;
    for (double& s : scale) s /= sum;
    return std::unique_ptr<SkyDome>(std::make_unique<LuminanceDome>(of_sun, sun_zenith, scale));
}

std::vector<double> LuminanceSky::sky_radiance(const View& view) const {
    const LuminanceFormula of_sun = formula(view.sun_zenith);
    const double seen = relative_luminance(of_sun, std::max(0.0, std::cos(view.view_zenith)), view_sun_cosine(view)) /
                        relative_illuminance(of_sun, view.sun_zenith);
    std::vector<double> radiance = ground_->irradiance(view.altitude, view.sun_zenith)->diffuse_W_m2_nm;
    for (double& r : radiance) r *= seen;
    return radiance;
}

}  // namespace airlight
