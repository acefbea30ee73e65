// bruneton2008: all the light in the air, precomputed by altitude, view, sun and the angle between them. [BrunetonNeyret2008]
//
//   computes     single scattering of each constituent apart from its phase function, and all higher orders, in tables of four
//                dimensions, with the paper's maps (of rays to the top of the air, the later ones [Bruneton2017]); light of the
//                ground by the sun and by the sky; aerial perspective by two look-ups, L(x) - T L(x0)
//   leaves out   shadows of terrain; twilight below 11.5 degrees, where its tables end; polarisation; edges of haze, which
//                an eye beside them sees smeared over the texels above and below (at 2 km, where that of earth-clear ends, 11 %)
//   differs      The tables are filled in one pass from the table of the source of all orders (docs/theory.md, section 5), along
//                nodes that follow the density: equal steps, as in the program that was published, give up to 8 % too much
//                aerosol. They keep each wavelength, and each constituent that scatters, rather than RGB and one aerosol. The
//                table of transmittance holds optical depths.
//   horizon      The fixes of the published program [Sperlhofer2011, section 5.1] hide what half floats and radii lose there.
//                Here the losses are not made: altitudes are the arguments, optical depths are subtracted, and both look-ups
//                of an aerial perspective are on the side of the horizon on which the view begins.
//   parameters   ModelOptions::bake: orders and sizes of the source; ModelOptions::bruneton2008: texels, 32 x 128 x 32 x 8 unless
//                given; `four_channels` keeps single Mie scattering at the reddest wavelength of each pack alone and colours it
//                by the rule of proportion, `eight_bits` rounds the scattering tables to 256 levels [Sperlhofer2011, 5.2.2].
//                Users say so by the variant: full, four-channels, eight-bits or four-channels-eight-bits
//   range        any eye; the sun to 101.5 degrees from the zenith (cosine -0.2)
//   cost         a bake of the source, then milliseconds for each row of a table, filled when it is first read; a direction of
//                a dome is four texels of a table that is cut for the eye and the sun
//   reference    the text is physics/models/bruneton2008.glsl
#include "models/bruneton2008.h"

#include <algorithm>
#include <cmath>

#include "models/bruneton2008_dome.h"
#include "models/exponential_sky.h"
#include "models/list.h"

namespace airlight {

namespace {

constexpr ModelCard card{.key = "bruneton2008",
                         .paper = "BrunetonNeyret2008",
                         .scattering = "all orders",
                         .approach = "tables of all light by altitude, view, sun and the angle between them",
                         .precomputation = "seconds a pack of 16 wavelengths; rows of tables when first read",
                         .memory = "192 MiB a pack for two constituents, if all of it is read",
                         .highest_eye = anywhere,
                         .highest_sun_zenith_deg = 101.5,
                         .highest_view_zenith_deg = 180.0,
                         .aerial_perspective = true};

class Bruneton2008Sky : public PublishedSky {
public:
    Bruneton2008Sky(std::shared_ptr<const Tables> tables, const Bruneton2008Settings& settings)
        : PublishedSky(card, tables->atmosphere(), {tables->wavelengths().begin(), tables->wavelengths().end()}),
          tables_(std::move(tables)) {
        auto packs = std::make_shared<std::vector<std::unique_ptr<Bruneton2008Tables>>>();
        for (const Tables::Pack& pack : tables_->packs()) packs->push_back(std::make_unique<Bruneton2008Tables>(pack, settings));
        packs_ = std::move(packs);
    }

    Result<IrradianceEstimate> irradiance(Length altitude, double sun_zenith) const override {
        if (const Result<Done> ok = within_range({altitude, 0.0, sun_zenith, 0.0}); !ok) return ok.error();
        IrradianceEstimate estimate;
        const double h = std::min(altitude.in(m), shell().top_m), mu_s = std::cos(sun_zenith);
        for (const auto& pack : *packs_) {
            const f32::IrradianceSpectrum diffuse = pack->irradiance(h, mu_s);
            const f32::IrradianceSpectrum direct =
                direct_irradiance(pack->pack().air, pack->pack().tables.transmittance, static_cast<float>(h), static_cast<float>(mu_s));
            append(direct, *pack, estimate.direct_W_m2_nm);
            append(altitude.in(m) > shell().top_m ? f32::IrradianceSpectrum(f32::IrradianceSpectrum::Scalar::of(0.0f)) : diffuse, *pack,
                   estimate.diffuse_W_m2_nm);
        }
        estimate.standard_error.assign(wavelengths().size(), 0.0);
        return estimate;
    }

    Result<std::vector<double>> transmittance(Length altitude, double view_zenith, Length distance) const override {
        // Only the way matters, not the sun.
        if (const Result<Done> ok = within_range({altitude, view_zenith, 0.0, 0.0}); !ok) return ok.error();
        const std::optional<AirPiece> piece = piece_of({altitude, view_zenith, 0.0, 0.0}, distance);
        std::vector<double> seen;
        for (const auto& pack : *packs_)
            append(piece ? pack->transmittance(piece->start, piece->length_m) : f32::Spectrum(f32::Number(1.0)), *pack, seen);
        return seen;
    }

    Result<AerialPerspective> aerial_perspective(const View& view, Length distance) const override {
        if (const Result<Done> ok = within_range(view); !ok) return ok.error();
        const std::optional<AirPiece> piece = piece_of(view, distance);
        AerialPerspective air;
        for (const auto& pack : *packs_) {
            f32::Spectrum seen(f32::Number(1.0));
            f32::RadianceSpectrum light(f32::RadianceSpectrum::Scalar::of(0.0f));
            if (piece) {
                seen = pack->transmittance(piece->start, piece->length_m);
                light = pack->radiance(pack->light(piece->start), piece->start.nu);
                if (!piece->whole)
                    light = max(light - pack->radiance(pack->light(piece->end), piece->end.nu) * seen,
                                f32::RadianceSpectrum(f32::RadianceSpectrum::Scalar::of(0.0f)));
            }
            append(seen, *pack, air.transmittance);
            append(light, *pack, air.inscattered_W_m2_sr_nm);
        }
        return air;
    }

    Result<std::unique_ptr<SkyDome>> dome(Length altitude, double sun_zenith) const override {
        if (const Result<Done> ok = within_range({altitude, 0.0, sun_zenith, 0.0}); !ok) return ok.error();
        if (altitude.in(m) > shell().top_m || (*packs_)[0]->four_channels()) return Sky::dome(altitude, sun_zenith);
        return std::unique_ptr<SkyDome>(std::make_unique<Bruneton2008Dome>(*this, packs_, altitude, sun_zenith));
    }

private:
    const Shell& shell() const { return (*packs_)[0]->pack().air.shell; }

    std::optional<AirPiece> piece_of(const View& view, Length distance) const { return air_piece(shell(), view, distance.in(m)); }

    template <class S>
    static void append(const S& spectrum, const Bruneton2008Tables& pack, std::vector<double>& to) {
        for (int w = 0; w < pack.pack().optics.wavelength_count; ++w) to.push_back(static_cast<double>(spectrum.v[w]));
    }

    std::vector<double> sky_radiance(const View& view) const override {
        const std::optional<AirPiece> piece = piece_of(view, 1e30 * m);
        std::vector<double> seen;
        for (const auto& pack : *packs_) {
            f32::RadianceSpectrum light(f32::RadianceSpectrum::Scalar::of(0.0f));
            if (piece) {
                light = pack->radiance(pack->light(piece->start), piece->start.nu);
                if (piece->start.ground) light += pack->ground(piece->end.mu_s) * pack->transmittance(piece->start, piece->length_m);
            }
            append(light, *pack, seen);
        }
        return seen;
    }

    std::shared_ptr<const Tables> tables_;
    std::shared_ptr<const std::vector<std::unique_ptr<Bruneton2008Tables>>> packs_;
};

Result<std::unique_ptr<Sky>> make(const Atmosphere& atmosphere, std::vector<Wavelength> wavelengths, const ModelOptions& options) {
    const Result<std::string> variant = variant_of(card, options, {"full", "four-channels", "eight-bits", "four-channels-eight-bits"});
    if (!variant) return variant.error();
    Bruneton2008Settings s = options.bruneton2008;
    s.four_channels |= variant->starts_with("four-channels");
    s.eight_bits |= variant->ends_with("eight-bits");
    if (std::min({s.altitude, s.sun, s.nu}) < 2 || s.view < 4 || s.view % 2 != 0)
        return Error{"bruneton2008", "its tables have too few texels, or an odd number of views",
                     "Give at least 2 x 4 x 2 x 2 texels (altitude, view, sun, angle), the second number even."};
    Result<Tables> tables = cached_tables(atmosphere, std::move(wavelengths), options.bake, options.cache, options.progress);
    if (!tables) return tables.error();
    return std::unique_ptr<Sky>(std::make_unique<Bruneton2008Sky>(std::make_shared<const Tables>(std::move(*tables)), s));
}

}  // namespace

Model bruneton2008_model() { return {card, make}; }

}  // namespace airlight
