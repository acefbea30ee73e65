// Hipiny's sky by altitude: Perez's formula for luminance and chromaticity at a few reference altitudes.
// What it is and leaves out: src/models/hipiny2006.cpp. [Hipiny2006]

// One sky patch's formula, at a reference altitude, a turbidity and a sun: as Preetham's, with coefficients of a fit.
FN ColourYxy hipiny2006_patch(IN(Preetham1999) fit, Number mu, Number nu, Number gamma) {
    return preetham1999_towards(fit, mu, nu, gamma);
}

// The weight of the higher of two reference altitudes at an altitude between: exponential, as the density of the air is.
FN Number hipiny2006_weight(Length altitude, Length low, Length high, Length scale_height) {
    Number part = (altitude - low) / scale_height;
    Number whole = (high - low) / scale_height;
    return part * layer_share(part) / (whole * layer_share(whole));
}

// Between two colours, weight of the second.
FN ColourYxy mix_colours(IN(ColourYxy) a, IN(ColourYxy) b, Number weight) {
    ColourYxy c;
    c.luminance = a.luminance + weight * (b.luminance - a.luminance);
    c.x = a.x + weight * (b.x - a.x);
    c.y = a.y + weight * (b.y - a.y);
    return c;
}
