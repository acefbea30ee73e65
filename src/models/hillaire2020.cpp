// hillaire2020: light marched along each view, all higher orders from one small table; no table of many dimensions. [Hillaire2020]
//
//   computes     single scattering with the phase functions of air and of aerosol; all higher orders as light that comes from
//                everywhere alike, a geometric series of the second; the ground's light under the sun; tables for one eye and sun:
//                the sky by direction (a dome), the air before things by distance (aerial perspective)
//   leaves out   the direction of light scattered twice and more, which makes the sky too dark around the sun and near the
//                horizon; light of the sky on the ground; the penumbra of the planet; polarisation
//   differs      The air is a table by altitude, so that any profile is as good as the paper's exponentials and tent. Constituents
//                with Rayleigh's phase function are air; of the phase functions of the others the mean is taken, weighted by
//                scattering optical depth. The table of transmittance holds optical depths. Rows of the sky-view table stand for
//                the sky or for the ground, never for both.
//   parameters   none
//   range        any eye, any sun; above the air, and for a single view, light is marched, as the paper does it from space
//   cost         some tenths of a second a pack of 16 wavelengths for the tables that know no eye (transmittance 256 x 64, higher
//                orders 32 x 32); then a sky-view table (192 x 108) a frame; a direction is then four texels
//   reference    the text is physics/models/hillaire2020.glsl
#include <algorithm>
#include <cmath>
#include <memory>

#include "models/hillaire2020_tables.h"
#include "models/list.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "hillaire2020",
                         .paper = "Hillaire2020",
                         .scattering = "all orders, isotropic from the second on",
                         .approach = "marched along the view; higher orders as a series from a small table",
                         .precomputation = "tenths of a second a pack of 16 wavelengths; a sky-view table a frame",
                         .memory = "2 MiB a pack, and 1.3 MiB a frame",
                         .highest_eye = anywhere,
                         .highest_sun_zenith_deg = 180.0,
                         .highest_view_zenith_deg = 180.0,
                         .aerial_perspective = true};

// The aerial-perspective volume. [Hillaire2020, section 5.4]
constexpr double volume_range_m = 32e3;
constexpr int volume_slices = 32;

using Packs = std::shared_ptr<const std::vector<std::unique_ptr<Hillaire2020Tables>>>;

template <class S>
void append(const S& spectrum, const Hillaire2020Tables& pack, std::vector<double>& to) {
    for (int w = 0; w < pack.count(); ++w) to.push_back(static_cast<double>(spectrum.v[w]));
}

// One eye and one sun: the sky-view table of each pack.
class SkyViewDome : public SkyDome {
public:
    SkyViewDome(Packs packs, double altitude_m, double sun_zenith) : packs_(std::move(packs)), altitude_m_(altitude_m) {
        for (const auto& pack : *packs_) views_.push_back(pack->sky_view(altitude_m, sun_zenith));
    }

    void radiance(double view_zenith, double relative_azimuth, std::span<float> radiance) const override {
        float* seen = radiance.data();
        for (std::size_t p = 0; p < packs_->size(); ++p) {
            const Hillaire2020Tables& pack = *(*packs_)[p];
            const f32::RadianceSpectrum light = pack.seen_in(views_[p], altitude_m_, std::cos(view_zenith), std::cos(relative_azimuth));
            seen = std::copy(light.v, light.v + pack.count(), seen);
        }
    }

private:
    Packs packs_;
    double altitude_m_;
    std::vector<std::vector<f32::RadianceSpectrum>> views_;
};

class Hillaire2020Sky : public PublishedSky {
public:
    Hillaire2020Sky(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths)
        : PublishedSky(card, atmosphere, std::move(wavelengths)), shell_{atmosphere.bottom_radius.in(m), atmosphere.top_altitude.in(m)} {
        auto tables = std::make_shared<std::vector<std::unique_ptr<Hillaire2020Tables>>>();
        for (const std::vector<Wavelength>& pack : packs(this->wavelengths()))
            tables->push_back(std::make_unique<Hillaire2020Tables>(air_optics(atmosphere, pack)));
        packs_ = std::move(tables);
    }

    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override {
        const Result<AerialPerspective> air = march({altitude, view_zenith, 0.0, 0.0}, distance);
        if (!air) return air.error();
        return air->transmittance;
    }

    // As the volume answers: within its range linear between slices, farther off marched.
    Result<AerialPerspective> aerial_perspective(const View& view, Length distance) const override {
        const double d = distance.in(m);
        if (!(d < volume_range_m) || view.altitude.in(m) > shell_.top_m) return march(view, distance);
        const f32::Hillaire2020Slices place =
            f32::hillaire2020_slices(f32::Length::of(static_cast<float>(d)), f32::Length::of(volume_range_m), volume_slices);
        const Filtered<float> between = filtered(place.coordinate, volume_slices);
        const Result<AerialPerspective> near = march(view, slice_distance(between.low)), far = march(view, slice_distance(between.high));
        if (!near) return near.error();
        if (!far) return far.error();
        AerialPerspective air;
        const auto mixed = [&](double a, double b) { return a + static_cast<double>(between.weight) * (b - a); };
        const double weight = place.weight.value;
        for (std::size_t w = 0; w < wavelengths().size(); ++w) {
            air.transmittance.push_back(1.0 - weight * (1.0 - mixed(near->transmittance[w], far->transmittance[w])));
            air.inscattered_W_m2_sr_nm.push_back(weight * mixed(near->inscattered_W_m2_sr_nm[w], far->inscattered_W_m2_sr_nm[w]));
        }
        return air;
    }

    Result<std::unique_ptr<SkyDome>> dome(Length altitude, double sun_zenith) const override {
        if (const Result<Done> ok = within_range({altitude, 0.0, sun_zenith, 0.0}); !ok) return ok.error();
        if (altitude.in(m) > shell_.top_m) return Sky::dome(altitude, sun_zenith);
        return std::unique_ptr<SkyDome>(std::make_unique<SkyViewDome>(packs_, altitude.in(m), sun_zenith));
    }

private:
    static Length slice_distance(std::size_t slice) {
        return static_cast<double>(
                   f64::hillaire2020_slice_distance(static_cast<int>(slice), f64::Length::of(volume_range_m), volume_slices).value) *
               m;
    }

    Ray ray_of(const View& view) const {
        return {view.altitude.in(m), std::cos(view.view_zenith), std::cos(view.sun_zenith), view_sun_cosine(view)};
    }

    // How far an eye above the air is from it along a ray that enters it as `entered`.
    double empty_way(const Ray& ray, const Ray& entered) const {
        if (ray.altitude_m <= shell_.top_m) return 0.0;
        return -(shell_.bottom_m + ray.altitude_m) * ray.mu + (shell_.bottom_m + shell_.top_m) * entered.mu;
    }

    Result<AerialPerspective> march(const View& view, Length distance) const {
        if (const Result<Done> ok = within_range(view); !ok) return ok.error();
        const Ray ray = ray_of(view);
        Ray entered = ray;
        AerialPerspective air;
        const bool in_air = enter_air(shell_, entered);
        const double length = in_air ? distance.in(m)-empty_way(ray, entered) : 0.0;
        for (const auto& pack : *packs_) {
            if (length > 0.0) entered.limit_m = length;
            const Hillaire2020Tables::Light light = length > 0.0 ? pack->light(entered) : Hillaire2020Tables::Light::none();
            append(light.transmittance, *pack, air.transmittance);
            append(light.inscattered, *pack, air.inscattered_W_m2_sr_nm);
        }
        return air;
    }

    std::vector<double> sky_radiance(const View& view) const override {
        Ray ray = ray_of(view);
        const bool in_air = enter_air(shell_, ray);
        std::vector<double> seen;
        for (const auto& pack : *packs_) append(in_air ? pack->radiance(ray) : Hillaire2020Tables::Light::none().inscattered, *pack, seen);
        return seen;
    }

    Shell shell_;
    Packs packs_;
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions&) {
    return std::unique_ptr<Sky>(std::make_unique<Hillaire2020Sky>(atmosphere, std::move(wavelengths)));
}

}  // namespace

Model hillaire2020_model() { return {card, make}; }

}  // namespace airlight
