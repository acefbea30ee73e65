// Nielsen's sky: one average density for each path, so that Hoffman's closed form holds at every altitude.
// What it is and leaves out: src/models/nielsen2003.cpp. [Nielsen2003, ch. 5]

// Both estimates of the columns between two altitudes: by the density at their mean, and by the mean of their densities.
// [Nielsen2003, sec. 5.3.1]
FN AirColumns nielsen2003_by_altitude(IN(ExponentialAir) air, Length from, Length to, Length distance) {
    AirDensities density = air_densities(air, 0.5 * (from + to));
    AirColumns column;
    column.air = density.air * distance;
    column.aerosol = density.aerosol * distance;
    return column;
}
FN AirColumns nielsen2003_by_ends(IN(ExponentialAir) air, Length from, Length to, Length distance) {
    AirDensities eye = air_densities(air, from);
    AirDensities end = air_densities(air, to);
    AirColumns column;
    column.air = 0.5 * (eye.air + end.air) * distance;
    column.aerosol = 0.5 * (eye.aerosol + end.aerosol) * distance;
    return column;
}

// The column of the sky in a direction that does not go down: between that of the zenith, which is exact, and one that is the
// same at every altitude and deep at the horizon, by the fifth root of the cosine. [Nielsen2003, eq. 5.7, 5.8, 5.10, 6.1]
const Length nielsen2003_horizon = 190000.0 * m;
FN Length nielsen2003_sky_column(Length scale_height, Length h, Number mu) {
    Number f = pow(clamp(mu, Number(0.0), Number(1.0)), 0.2);
    Length zenith = scale_height * exponential_density(h, scale_height);
    Length still = (1.05 - f) * nielsen2003_horizon;
    return still + f * (zenith - still);
}
FN AirColumns nielsen2003_sky_columns(IN(ExponentialAir) air, Length h, Number mu) {
    AirColumns column;
    column.air = nielsen2003_sky_column(air.air_scale_height, h, mu);
    column.aerosol = nielsen2003_sky_column(air.aerosol_scale_height, h, mu);
    return column;
}

// The asymmetry by the eye's altitude and the sun's zenith angle, bilinear, for one amount of haze. [Nielsen2003, eq. 5.4]
struct NielsenCorners {
    Number low_zenith;    // on the ground, sun in the zenith
    Number low_horizon;   // on the ground, sun at the horizon
    Number high_zenith;   // at the highest altitude
    Number high_horizon;
};
FN NielsenCorners nielsen2003_corners(Number low_zenith, Number low_horizon, Number high_zenith, Number high_horizon) {
    NielsenCorners corners;
    corners.low_zenith = low_zenith;
    corners.low_horizon = low_horizon;
    corners.high_zenith = high_zenith;
    corners.high_horizon = high_horizon;
    return corners;
}
FN Number nielsen2003_asymmetry(IN(NielsenCorners) corners, Number altitude, Number sun_zenith) {
    Number low = corners.low_zenith + sun_zenith * (corners.low_horizon - corners.low_zenith);
    Number high = corners.high_zenith + sun_zenith * (corners.high_horizon - corners.high_zenith);
    return low + altitude * (high - low);
}
