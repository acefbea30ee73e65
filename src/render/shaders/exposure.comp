#version 450 core
// From the histogram to the exposure, which follows what is metered (src/image/adaptation.h); empties the histogram. One group.
#include "histogram.glsl"
layout(local_size_x = bins) in;
layout(std430, binding = 1) buffer Exposure {
    float exposure;  // 0 before anything was metered
    float metered;
};
shared uint below[bins];  // pixels of this bin and of darker ones
shared float stops[bins];

void sum_up(int bin) {
    for (int step = 1; step < bins; step *= 2) {
        barrier();
        uint more = bin >= step ? below[bin - step] : 0u;
        float more_stops = bin >= step ? stops[bin - step] : 0.0;
        barrier();
        below[bin] += more;
        stops[bin] += more_stops;
    }
    barrier();
}

void follow(float wished) {
    metered = wished;
    float share = wished < exposure ? adapting.x : adapting.y;
    exposure = exposure > 0.0 ? exposure * pow(wished / exposure, share) : wished;
}

void main() {
    int bin = int(gl_LocalInvocationIndex);
    uint pixels = pixels_of_bin[bin];
    pixels_of_bin[bin] = 0u;
    below[bin] = pixels;
    stops[bin] = float(pixels) * stops_of(float(bin));
    sum_up(bin);
    uint all_pixels = below[bins - 1];
    if (white_share > 0.0) {
        float enough = white_share * float(all_pixels), darker = bin > 0 ? float(below[bin - 1]) : 0.0;
        if (darker < enough && float(below[bin]) >= enough) follow(1.0 / max(exp2(stops_of(float(bin))), least));
    } else if (bin == 0 && all_pixels > 0u) {
        follow(grey / max(exp2(stops[bins - 1] / float(all_pixels)), least));
    }
}
