// Light scattered once, in a table of three dimensions: height, view and sun. [SchafhitzelFalkErtl2007]
// What it leaves out: src/models/schafhitzel2007.cpp.

struct Schafhitzel2007 {
    Length bottom;  // radius of the ground
    Length top;     // altitude of the top of the air
    int altitude_size;
    int view_size;  // even: half of the texels for rays to the ground, half for the rest
    int sun_size;
};

FN Schafhitzel2007 schafhitzel2007(Length bottom, Length top, int altitude_size, int view_size, int sun_size) {
    Schafhitzel2007 shape;
    shape.bottom = bottom;
    shape.top = top;
    shape.altitude_size = altitude_size;
    shape.view_size = view_size;
    shape.sun_size = sun_size;
    return shape;
}

// Sun across, view down, altitude deep, by the maps of bruneton2008.
//   ground  whether the ray meets the ground, asked once for a view: both look-ups of an object are on one side of the horizon
FN TexCoord3 schafhitzel2007_place(IN(Schafhitzel2007) shape, Length h, Number mu, Number mu_s, bool ground) {
    int half_size = shape.view_size / 2;
    Number view = ground ? texture_coordinate(bruneton2008_ground_coordinate(h, mu, shape.bottom), half_size)
                         : 1.0 + texture_coordinate(bruneton2008_sky_coordinate(h, mu, shape.bottom, shape.top), half_size);
    return TexCoord3(texture_coordinate(bruneton2008_sun_coordinate(mu_s), shape.sun_size), 0.5 * view,
                     texture_coordinate(bruneton2008_altitude_coordinate(h, shape.bottom, shape.top), shape.altitude_size));
}

// One kind of particle's light in the sky, which times its phase function is radiance.
FN IrradianceSpectrum schafhitzel2007_light(IN(TABLE_3D(IrradianceSpectrum)) table, IN(Schafhitzel2007) shape, Length h, Number mu,
                                            Number mu_s, bool ground) {
    return look_up(table, schafhitzel2007_place(shape, h, mu, mu_s, ground));
}

// The light between the eye and an object: what is seen from the eye less what is seen, in the same direction, from the object, as
// far as it reaches the eye. The survey's equation [Lopes2015, eq. 60] leaves the transmittance out, and so would make the air
// before a far object darker than none.
FN IrradianceSpectrum schafhitzel2007_between(IN(IrradianceSpectrum) from_eye, IN(IrradianceSpectrum) from_object,
                                              IN(Spectrum) transmittance) {
    return max(from_eye - from_object * transmittance, 0.0 * from_eye);
}
