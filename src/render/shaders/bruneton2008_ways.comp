#version 450 core
// The ways of one altitude: all of them that does not depend on the sun.
#include "bruneton2008_bake.glsl"
layout(std430, binding = 2) readonly buffer Directions { int directions; };

float density_of(AirlightNode node, int scatterer) {
    return scatterer < bake_scatterers ? node.density.of[bake_part_of[scatterer / 4][scatterer % 4]] : 0.0;
}

void main() {
    int direction = int(gl_GlobalInvocationID.x);
    if (direction >= directions) return;
    Way way = ways[bake_first * directions + direction];
    float start = (air.bottom + way.h) * way.mu, length_m = airlight_length(way.h, way.mu, way.grounded > 0.5);
    float end = start + length_m, reach = 0.0;
    AirlightColumns columns;
    for (int p = 0; p < airlight_parts; ++p) columns.of[p] = 0.0;
    int count = 0;
    for (float x = start; x < end && count + air.rule.count <= bake_capacity;) {
        float to = airlight_next_cut(densities, way.h, start, x, end, reach);
        AirlightPiece piece = airlight_piece(way.h, start, x, to);
        for (int k = 0; k < air.rule.count; ++k) {
            AirlightNode node = airlight_node(densities, start, piece, k, columns);
            vec4 scattering = vec4(0.0);
            for (int p = 0; p < air.parts; ++p) scattering += air.scattering[p] * node.density.of[p];
            int at = direction * bake_capacity + count++;
            way_nodes[at].place = vec4(node.h, node.mu, node.distance, 0.0);
            way_nodes[at].seen = node.seen;
            way_nodes[at].scattering = node.seen * scattering;
            for (int i = 0; i < 4; ++i) {
                way_nodes[at].density_low[i] = density_of(node, i);
                way_nodes[at].density_high[i] = density_of(node, i + 4);
            }
        }
        airlight_end_piece(densities, piece, columns);
        x = to;
    }
    ways[bake_first * directions + direction].nodes = float(count);
    ways[bake_first * directions + direction].end = vec4(length_m);
    ways[bake_first * directions + direction].transmittance = airlight_transmittance(columns);
}
