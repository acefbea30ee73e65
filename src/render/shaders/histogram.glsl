// The histogram of a picture's luminance, in twelfths of a stop from 2^-18 cd m-2 (a night without moon has 2^-13) to 2^24.6.
// src/render/exposure_pass.h.
const int bins = 512;
const float darkest = -18.0, bins_per_stop = 12.0;
layout(std430, binding = 0) buffer Histogram { uint pixels_of_bin[bins]; };
layout(std140, binding = 1) uniform Metering {
    vec4 luminance_of_rgb;
    vec4 adapting;       // the share of the way to a brighter and to a darker picture's exposure that is gone now
    float grey;          // what the mean becomes;
    float white_share;   // or if above 0: the share of pixels below what becomes white
    float sun_disk;      // luminance that is left out, from here on
    float least;         // luminance that what is metered counts as at least
};

int bin_of(float luminance) { return clamp(int(floor((log2(luminance) - darkest) * bins_per_stop)), 0, bins - 1); }

// log2 of the luminance in the middle of a bin.
float stops_of(float bin) { return darkest + (bin + 0.5) / bins_per_stop; }
