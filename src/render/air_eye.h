// Where an eye stands in the air, as far as the light of the air depends on it.
#pragma once

namespace airlight::render {

// An eye over the ground sphere and its sun.
struct AirEye {
    double altitude_m;  // >= 0
    double mu_s;        // cosine of the sun's zenith angle

    friend bool operator==(const AirEye&, const AirEye&) = default;
};

// The nearest of those eyes for which tables of light are made: their altitudes are a 10 000th apart; their cosines 2e-5 on the ground and up to
// five times that from 50 km on, where it is 600 m of the planet's ground. So light is off by a thousandth at dusk, by half a percent at the
// terminator seen from space and by less by day, and an eye that hardly moves finds its tables made. It depends on the eye alone: a picture
// is the same whatever was drawn before it.
AirEye settled(const AirEye& eye);

}  // namespace airlight::render
