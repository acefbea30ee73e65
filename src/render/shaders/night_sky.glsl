// The light between the stars (src/celestial/night_sky.h): what is beyond the air, and the shell of air that glows.

// How far a ray from an altitude h goes below another one, if it does not meet the ground.
float way_below(float altitude, float h, float mu, float bottom) {
    if (h <= altitude) return distance_to_top(h, mu, bottom, altitude);
    float p = (bottom + h) * mu, k = (altitude - h) * (2.0 * bottom + altitude + h);
    return mu < 0.0 ? 2.0 * sqrt(max(k + p * p, 0.0)) : 0.0;
}

vec3 night_sky_at(vec3 direction) {
    if (airglow.g == 0.0) return beyond.rgb;
    float bottom = glowing_shell.x, low = glowing_shell.y, high = glowing_shell.z, h = glowing_shell.w, mu = dot(direction, eye_up.xyz);
    return beyond.rgb + airglow.rgb * ((way_below(high, h, mu, bottom) - way_below(low, h, mu, bottom)) / (high - low));
}
