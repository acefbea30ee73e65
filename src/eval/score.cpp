#include "eval/score.h"

#include <algorithm>
#include <cmath>

#include "eval/ciede2000.h"
#include "spectrum/colour.h"

namespace airlight {

namespace {

constexpr double dark = 1e-8;  // of the solar irradiance, per steradian

// Sums over directions on one side of the horizon.
class Scorer {
public:
    Scorer(const Sky& model, const Sun& sun, const ColourWeights& weights, const SkyTruth& truth) : weights_(weights) {
        for (const Wavelength w : model.wavelengths()) solar_.push_back(sun.irradiance.at(w).in(W_per_m2_nm));
        darkest_ = dark * weights.to_xyz(std::span<const double>(solar_)).y;
        double brightest = 0.0;
        for (const RadianceEstimate& seen : truth.radiance) brightest = std::max(brightest, colour(seen).y);
        white_ = with_luminance(white_chromaticity(WhitePoint::d65), std::max(brightest, darkest_));
    }

    // The relative excess of luminance; none where the truth is dark.
    std::optional<double> add(const RadianceEstimate& found, const RadianceEstimate& truth) {
        ++score_.answered;
        for (std::size_t w = 0; w < solar_.size(); ++w)
            add_band(found.radiance_W_m2_sr_nm[w], truth.radiance_W_m2_sr_nm[w], truth.standard_error[w], dark * solar_[w]);
        return add_colour(colour(found), colour(truth));
    }
    void ask() { ++score_.asked; }

    // None if nothing was answered, or all of it is dark.
    std::optional<Score> score() const {
        if (values_ == 0) return {};
        Score s = score_;
        const double n = values_, c = std::max(1, colours_);
        s.plain_rmse = std::sqrt(square_ / n);
        s.noise = std::sqrt(variance_ / n);
        s.relative_rmse = std::sqrt(std::max(0.0, square_ - variance_) / n);
        s.bias = excess_ / n;
        s.spectral_rmse = std::sqrt(spectral_ / n);
        s.luminance_rmse = std::sqrt(luminance_ / c);
        s.chromaticity_rmse = std::sqrt(chromaticity_ / c);
        s.colour_difference = difference_ / c;
        return s;
    }

private:
    Xyz colour(const RadianceEstimate& seen) const { return weights_.to_xyz(std::span<const double>(seen.radiance_W_m2_sr_nm)); }

    void add_band(double found, double truth, double error, double darkest) {
        if (truth < darkest) return;
        const double excess = found / truth - 1.0;
        ++values_;
        excess_ += excess;
        square_ += excess * excess;
        variance_ += (error / truth) * (error / truth);
        spectral_ += (found - truth) * (found - truth);
    }

    std::optional<double> add_colour(Xyz found, Xyz truth) {
        if (truth.y < darkest_) return {};
        const double excess = found.y / truth.y - 1.0;
        ++colours_;
        luminance_ += excess * excess;
        difference_ += ciede2000(lab(found, white_), lab(truth, white_));
        // Black has no chromaticity: it is taken for as far as the diagram's middle is from its edge.
        const double off = found.y > 0.0 ? distance(uniform_chromaticity(found), uniform_chromaticity(truth)) : 0.25;
        chromaticity_ += off * off;
        return excess;
    }

    const ColourWeights& weights_;
    std::vector<double> solar_;
    double darkest_ = 0.0;
    Xyz white_{};
    Score score_;
    int values_ = 0, colours_ = 0;
    double excess_ = 0.0, square_ = 0.0, variance_ = 0.0, spectral_ = 0.0, luminance_ = 0.0, chromaticity_ = 0.0, difference_ = 0.0;
};

}  // namespace

Illuminance illuminance(const IrradianceEstimate& light, const ColourWeights& weights) {
    return {weights.to_xyz(std::span<const double>(light.direct_W_m2_nm)).y,
            weights.to_xyz(std::span<const double>(light.diffuse_W_m2_nm)).y};
}

Verdict judged(const Sky& model, const SkyTruth& truth, const Sun& sun, const ColourWeights& weights) {
    Verdict verdict;
    Scorer sky(model, sun, weights, truth), ground(model, sun, weights, truth);
    for (std::size_t i = 0; i < truth.directions.size(); ++i) {
        Scorer& side = truth.directions[i].above_horizon ? sky : ground;
        side.ask();
        const Result<RadianceEstimate> found = model.radiance(view_of(truth.condition, truth.directions[i].direction));
        if (!found && verdict.refusal.empty()) verdict.refusal = found.error().what;
        verdict.excess.push_back(found ? side.add(*found, truth.radiance[i]) : std::nullopt);
    }
    verdict.sky = sky.score();
    verdict.ground = ground.score();
    if (!truth.irradiance) return verdict;
    const Result<IrradianceEstimate> light = model.irradiance(truth.condition.altitude, truth.condition.sun_zenith_deg * deg);
    if (light) verdict.horizontal = illuminance(*light, weights);
    else verdict.horizontal_refusal = light.error().what;
    return verdict;
}

}  // namespace airlight
