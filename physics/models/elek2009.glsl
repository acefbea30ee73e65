// All orders of scattering in a small table of three dimensions that knows neither azimuth nor the planet's shadow. [Elek2009]
// What it leaves out: src/models/elek2009.cpp.

struct Elek2009 {
    Length top;  // altitude of the top of the air
    int altitude_size;
    int view_size;
    int sun_size;
};

FN Elek2009 elek2009(Length top, int altitude_size, int view_size, int sun_size) {
    Elek2009 shape;
    shape.top = top;
    shape.altitude_size = altitude_size;
    shape.view_size = view_size;
    shape.sun_size = sun_size;
    return shape;
}

// A cosine by its cube root: texels crowd towards the level, where light changes most. Roots and steps of Newton's in
// place of pow, whose last bits differ from GPU to GPU.
FN Number elek2009_cosine_coordinate(Number c) {
    Number a = clamp(abs(c), Number(1e-12), Number(1.0));
    Number y = sqrt(sqrt(a * sqrt(sqrt(a * sqrt(sqrt(a))))));
    y = (2.0 * y + a / (y * y)) / 3.0;
    y = (2.0 * y + a / (y * y)) / 3.0;
    y = (2.0 * y + a / (y * y)) / 3.0;
    return 0.5 + 0.5 * sign(c) * y;
}
FN Number elek2009_cosine_of_coordinate(Number x) {
    Number y = 2.0 * x - 1.0;
    return y * y * y;
}

// Sun across, of cosine 0 to 1, view down, altitude deep.
FN TexCoord3 elek2009_place(IN(Elek2009) shape, Length h, Number mu, Number mu_s) {
    return TexCoord3(texture_coordinate(2.0 * elek2009_cosine_coordinate(max(mu_s, Number(0.0))) - 1.0, shape.sun_size),
                     texture_coordinate(elek2009_cosine_coordinate(mu), shape.view_size),
                     texture_coordinate(altitude_coordinate(h, shape.top), shape.altitude_size));
}

// One kind of particle's light in the sky, scattered once, which times its phase function is radiance; and that of all other orders.
FN IrradianceSpectrum elek2009_single(IN(TABLE_3D(IrradianceSpectrum)) table, IN(Elek2009) shape, Length h, Number mu, Number mu_s) {
    return look_up(table, elek2009_place(shape, h, mu, mu_s));
}
FN RadianceSpectrum elek2009_multiple(IN(TABLE_3D(RadianceSpectrum)) table, IN(Elek2009) shape, Length h, Number mu, Number mu_s) {
    return look_up(table, elek2009_place(shape, h, mu, mu_s));
}
