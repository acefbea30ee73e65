#version 450 core
// The light of a grid of rays, marched by the model `airlight`.
#include "air_march.glsl"
#include "air_wavelengths.glsl"

struct Gathered {
    AirlightColumns columns;
    AirlightSums sums;
};

Gathered nothing_gathered() {
    Gathered g;
    for (int p = 0; p < airlight_parts; ++p) g.columns.of[p] = 0.0;
    g.sums = airlight_nothing();
    return g;
}

void gather(Way way, float from, float to, inout Gathered g) {
    AirlightRay ray = AirlightRay(way.h, way.mu, way.mu_s, way.nu, way.extent);
    float start = (air.bottom + way.h) * way.mu, end = start + to, reach = 0.0;
    for (float x = start + from; x < end;) {
        float next = airlight_next_cut(densities, way.h, start, x, end, reach);
        next = airlight_shadow_cut(ray, x, next);
        AirlightPiece piece = airlight_piece(way.h, start, x, next);
        for (int k = 0; k < air.rule.count; ++k) {
            AirlightNode node = airlight_node(densities, start, piece, k, g.columns);
            airlight_gather(transmittance, source, ray, node, g.sums);
        }
        airlight_end_piece(densities, piece, g.columns);
        x = next;
    }
}

Colours colours_of(Way way, Gathered g) {
    AirlightLight light = airlight_summed(g.sums, g.columns);
    RadianceSpectrum once = Spectrum(0.0), peaks = Spectrum(0.0);
    for (int p = 0; p < airlight_parts; ++p)
        if (p < air.parts) {
            RadianceSpectrum scattered = light.single[p] * phase_of(p, way.angle);
            if (peaked[p / 4][p % 4] > 0.0) peaks += scattered;
            else once += scattered;
        }
    return Colours(colour_of(once), colour_of(peaks), colour_of(light.multiple),
                   colour_of(air.solar_irradiance * taken_by(airlight_depth(g.columns))) / colour_of_sun.rgb);
}

#include "air_march_main.glsl"
