// Perez's all-weather sky: which of his formulas a sky is, by how clear and how bright it is.
// What it is and leaves out: src/models/perez1993.cpp. [Perez1993]

// Air mass towards a zenith angle of 0 to pi / 2: 1 in the zenith, 36.5 at the horizon. [Kasten1966]
FN Number relative_air_mass(Number zenith) {
    Number rest = max(93.885 - zenith * (180.0 / pi), Number(1.0));
    return 1.0 / (max(cos(zenith), Number(0.0)) + 0.15 * exp(-1.253 * log(rest)));
}

// Clearness: 1 without a beam. `beam` over `diffuse`: on a plane that faces the sun, and on a level one. [Perez1993, eq. 3]
FN Number sky_clearness(Number beam, Number diffuse, Number sun_zenith) {
    Number k = 1.041 * sun_zenith * sun_zenith * sun_zenith;
    return ((diffuse + beam) / diffuse + k) / (1.0 + k);
}

// Brightness: the part of the sunlight above the air that comes from the sky, times the air mass. [Perez1993, eq. 4]
FN Number sky_brightness(Number diffuse, Number sunlight, Number sun_zenith) {
    return relative_air_mass(sun_zenith) * diffuse / sunlight;
}
