#include "celestial/night_sky.h"

#include <cmath>

#include "celestial/stars.h"
#include "spectrum/colour_temperature.h"

namespace airlight {

namespace {

// In S10: of the air, at the zenith and at sunspot minimum; of dust between the planets, at the poles of the ecliptic; of dust between the stars
// [BennEllison1998]; of stars fainter than magnitude 6, at the galactic poles [Allen1973].
constexpr double airglow_s10 = 145.0, zodiacal_s10 = 60.0, interstellar_s10 = 15.0, faint_stars_s10 = 30.0;
// Measured through air, which takes more of the blue: B - V = 0.8 is 0.7 above it.
constexpr double colour_index = 0.7;

constexpr double ground_km = 6371.0, layer_km = 90.0;
constexpr double sine_at_layer = ground_km / (ground_km + layer_km);  // of the zenith angle there of a ray along the ground

double cosine_at_layer() { return std::sqrt(1.0 - sine_at_layer * sine_at_layer); }

}  // namespace

double luminance_of_s10() { return lux_of_magnitude_0 * 1e-4 / (deg * deg); }

NightSky night_sky() {
    const Xyz s10 = luminance_of_s10() * black_body_colour(temperature_of_colour_index(colour_index));
    return {(zodiacal_s10 + interstellar_s10 + faint_stars_s10) * s10, airglow_s10 * s10};
}

double van_rhijn(double zenith_angle) {
    const double sine = sine_at_layer * std::sin(zenith_angle);
    return 1.0 / std::sqrt(1.0 - sine * sine);
}

Xyz mean_luminance(const NightSky& sky) { return sky.beyond + std::asinh(sine_at_layer / cosine_at_layer()) / sine_at_layer * sky.airglow; }

Xyz illuminance(const NightSky& sky) {
    return pi * (sky.beyond + 2.0 / (sine_at_layer * sine_at_layer) * (1.0 - cosine_at_layer()) * sky.airglow);
}

}  // namespace airlight
