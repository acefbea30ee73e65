// From light to a display's levels: the same curves, gamut, encoding and thresholds as on the CPU, to float's rounding (tests/parity).
// Reads `luminance_of_rgb`, which stands before this.

// The nearest colour towards grey of the same luminance that has no negative amount (RgbConverter::into_gamut).
vec3 into_gamut(vec3 rgb) {
    float lowest = min(rgb.r, min(rgb.g, rgb.b));
    if (lowest >= 0.0) return rgb;
    float grey = dot(rgb, luminance_of_rgb.rgb);
    if (grey <= 0.0) return vec3(0.0);
    return max(grey + grey / (grey - lowest) * (rgb - grey), 0.0);
}

// src/image/tone.h, in its order.
const int tone_linear = 0, tone_exponential = 1, tone_reinhard = 2, tone_filmic = 3;

// 1 - e^-x, to float's precision also where e^-x is nearly 1.
vec3 exponential(vec3 x) {
    vec3 small = x * (1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0)));
    return mix(1.0 - exp(-x), small, lessThan(x, vec3(0.05)));
}

// [Hable2010], as src/image/tone.cpp says.
vec3 filmic(vec3 x) {
    const float A = 0.15, B = 0.50, C = 0.10, D = 0.20, E = 0.02, F = 0.30;
    vec3 y = min(3.9453725 * x, 1e15);
    return y * (A * y * (F - E) + B * (C * F - E)) / ((y * (A * y + B) + D * F) * (F - E));
}

// Display values in [0, 1] of exposed light, which is not negative.
vec3 tone(int curve, vec3 x) {
    if (curve == tone_linear) return min(x, 1.0);
    if (curve == tone_exponential) return exponential(x);
    if (curve == tone_reinhard) return x / (1.0 + x);
    return filmic(x);
}

// IEC 61966-2-1.
vec3 srgb_encoded(vec3 x) { return mix(1.0 + 1.055 * (pow(x, vec3(1.0 / 2.4)) - 1.0), 12.92 * x, lessThanEqual(x, vec3(0.0031308))); }

// Thresholds in [0, 1) that are spread evenly over every neighbourhood (docs/theory.md, eq. 71): as whole 2^-32, which wrap by themselves.
// The first row is the highest.
vec3 threshold(uvec2 pixel) {
    uint red = 0x80000000u + 3242174889u * pixel.x + 2447445414u * pixel.y;
    return vec3(uvec3(red, red + 1431655765u, red + 2863311531u) >> 8u) / 16777216.0;
}

// What 8 bits show of display values: rounded up or down so that neighbours share the error. From 0 to 1.
vec3 level_of(vec3 display, uvec2 pixel) { return min(floor(255.0 * srgb_encoded(display) + threshold(pixel)), 255.0) / 255.0; }
