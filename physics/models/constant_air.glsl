// Air of constant density: the closed forms of fog, of Hoffman and Preetham, of Klassen's layers, and of Nielsen's averages.

// Range fog: what of an object's light comes through at a distance. [Klassen1987; Hoffman2002]
FN Number exponential_fog(InverseLength extinction, Length distance) {
    return exp(-(extinction * distance));
}
// Clear to `first`, nothing beyond `last`, straight between.
FN Number linear_fog(Length first, Length last, Length distance) {
    return clamp((last - distance) / (last - first), Number(0.0), Number(1.0));
}

// (1 - e^-x) / x, the mean along a path of depth x of what comes through from its points. Below x = 0.01, where float would
// lose the difference, by its series from there.
FN Spectrum mean_transmittance(IN(Spectrum) x) {
    Spectrum deep = max(x, Spectrum(0.01));
    Spectrum less = deep - x;
    return (Spectrum(1.0) - exp(-deep)) / deep + less * (Spectrum(0.5) - (deep + x) * (1.0 / 6.0));
}

// Light scattered once along a path with the columns of both constituents, as if they were mixed evenly along it, all of it lit
// through the same air. With columns of one length it is Hoffman's in-scattering. [Hoffman2002, eq. 3; Nielsen2003, eq. 5.1]
FN ScatteredLight even_light(IN(ExponentialAir) air, IN(AirColumns) column, IN(Spectrum) sunlight) {
    ScatteredLight light = no_scattered_light();
    light.depth = optical_depth(air, column);
    Spectrum seen = mean_transmittance(light.depth) * sunlight;
    light.air = seen * column.air;
    light.aerosol = seen * column.aerosol;
    return light;
}
